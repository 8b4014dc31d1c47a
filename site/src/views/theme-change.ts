/**
 * Tells when colours may have changed: the device's theme, or the reader's choice on the root
 * element. For canvases, which have to be painted again. Imports nothing of ours.
 */

/** Returns the function that ends it. */
export function onThemeChange(callback: () => void): () => void {
  const device = matchMedia("(prefers-color-scheme: dark)");
  const root = new MutationObserver(callback);
  device.addEventListener("change", callback);
  root.observe(document.documentElement, { attributeFilter: ["data-theme"] });
  return () => {
    device.removeEventListener("change", callback);
    root.disconnect();
  };
}
