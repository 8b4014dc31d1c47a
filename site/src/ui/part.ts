/**
 * Parts of the page that are fetched when they are wanted. One that does not arrive is asked for
 * once more; then the page is told (site/src/early shows it), and whoever asked gets the error.
 * Imports nothing of ours.
 */

/** What `load` gives, an `import()`. Rejects if it can't be had twice in a row. */
export async function part<Module>(load: () => Promise<Module>): Promise<Module> {
  try {
    return await load();
  } catch {
    // The next moment may be a better one.
  }
  try {
    return await load();
  } catch (error) {
    tellMissing(error);
    throw error;
  }
}

/** The page can't go on as it should: the reader is told, with a way to reload. */
export function tellMissing(error: unknown): void {
  document.dispatchEvent(new CustomEvent("bugbot-missing", { detail: String(error) }));
}
