/**
 * The bench's static host: the built site and the yardstick side by side, compressed as hosts do.
 * Counts the bytes it sends, by site.
 */
import { existsSync, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { gzipSync } from "node:zlib";
import { ROOT } from "../../site/build/files.mjs";

/** Address -> folder, longest address first. */
const TREES = [
  ["/bare/pyodide/", join(ROOT, "node_modules/pyodide")],
  ["/bare/", join(ROOT, "tests/bench/bare")],
  ["/site/", join(ROOT, "dist")],
];

/** @type {Record<string, string>} */
const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".css": "text/css",
  ".json": "application/json",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};

/**
 * Start the server on a free port.
 * @returns {Promise<{ url: string, sent: Map<string, number>, close: () => void }>} `sent` maps
 *   an address to the bytes of its last answer's body
 */
export async function serve() {
  /** @type {Map<string, { body: Buffer, headers: Record<string, string> }>} */
  const ready = new Map();
  /** @type {Map<string, number>} */
  const sent = new Map();
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? "/", "http://localhost");
    const answer = ready.get(pathname) ?? prepare(pathname);
    if (!answer) return response.writeHead(404).end();
    ready.set(pathname, answer);
    sent.set(pathname, answer.body.length);
    return response.writeHead(200, answer.headers).end(answer.body);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(undefined)));
  const address = server.address();
  const port = typeof address === "object" && address ? address.port : 0;
  return { url: `http://127.0.0.1:${port}`, sent, close: () => server.close() };
}

/**
 * The answer for an address, compressed once, before anything is measured a second time.
 * @param {string} pathname
 */
function prepare(pathname) {
  const tree = TREES.find(([prefix]) => pathname.startsWith(prefix ?? ""));
  if (!tree || pathname.includes("..")) return null;
  let file = join(tree[1] ?? "", pathname.slice(tree[0]?.length));
  if (existsSync(file) && statSync(file).isDirectory()) file = join(file, "index.html");
  if (!existsSync(file)) return null;
  const type = TYPES[extname(file)] ?? "application/octet-stream";
  /** @type {Record<string, string>} */
  const headers = { "Content-Type": type, "Cache-Control": "max-age=3600" };
  let body = readFileSync(file);
  if (type !== "application/octet-stream") {
    body = gzipSync(body, { level: 9 });
    headers["Content-Encoding"] = "gzip";
  }
  return { body, headers };
}
