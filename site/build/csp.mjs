/**
 * The site's Content-Security-Policy, once: in every page as a meta element, for hosts that cannot
 * send headers. Workers are started from blob: addresses in a frame, and inherit that frame's.
 */
const POLICY = {
  "default-src": ["'none'"],
  // 'wasm-unsafe-eval' lets WebAssembly compile; it does not let text become code.
  "script-src": ["'self'", "'wasm-unsafe-eval'"],
  // The editor and the elements make their style sheets at run time.
  "style-src": ["'self'", "'unsafe-inline'"],
  "img-src": ["'self'", "data:", "blob:"],
  "font-src": ["'self'"],
  "connect-src": ["'self'"],
  // blob: for the worker itself; 'self' because what it imports counts as a worker's script.
  "worker-src": ["'self'", "blob:"],
  // Workers are made in a frame with a narrower policy (runtime/worker-frame.ts).
  "frame-src": ["'self'"],
  "manifest-src": ["'self'"],
  "base-uri": ["'none'"],
  "form-action": ["'none'"],
};

/** @param {readonly string[]} scripts the hashes of scripts that stand in the page itself */
export function contentSecurityPolicy(scripts = []) {
  const policy = { ...POLICY, "script-src": [...POLICY["script-src"], ...scripts] };
  return Object.entries(policy)
    .map(([directive, sources]) => `${directive} ${sources.join(" ")}`)
    .join("; ");
}
