/**
 * Takes the site's copy for offline use off the device without the help of the service worker, which
 * may be what is broken. What the reader has made stays. May import `site-files`.
 */
import { cachePrefix } from "./site-files.ts";

/** Resolves when it is gone; what the browser refuses to clear is left. */
export async function dropOfflineCopy(): Promise<void> {
  try {
    const registration = await navigator.serviceWorker.getRegistration();
    if (!registration) return;
    await registration.unregister();
    await clearCaches(registration.scope);
  } catch {
    // The page is loaded anew in any case.
  }
}

/** Deletes the caches of the site with this address. */
export async function clearCaches(scope: string): Promise<void> {
  const prefix = cachePrefix(scope);
  const names = (await caches.keys()).filter((name) => name.startsWith(prefix));
  await Promise.all(names.map((name) => caches.delete(name)));
}
