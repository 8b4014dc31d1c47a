/**
 * When to fetch what a page's labs need: the editor, which is the largest of the scripts, and Python,
 * some 10 MB that a reader who never runs a program should not pay for at once.
 * Imports nothing of ours.
 */

/** A lab this far below the screen will be on it soon. */
export const NEAR = "600px";

/** What browsers with a data saver tell; others tell nothing. */
interface Connection {
  connection?: { saveData?: boolean };
}

/**
 * Call `start` once: as `whenNear` does or, where the reader saves data, only when they reach for a
 * lab. (A lab's Run starts Python in any case.)
 */
export function whenWanted(labs: readonly Element[], start: () => void): void {
  if (!(navigator as Navigator & Connection).connection?.saveData) {
    whenNear(labs, start);
    return;
  }
  const reached = new AbortController();
  const once = (): void => {
    reached.abort();
    start();
  };
  for (const lab of labs) {
    lab.addEventListener("pointerdown", once, { signal: reached.signal });
    lab.addEventListener("focusin", once, { signal: reached.signal });
  }
}

/**
 * Call `start` once: when one of the labs comes near the screen, or the page has loaded and has
 * nothing else to do.
 */
export function whenNear(labs: readonly Element[], start: () => void): void {
  let started = false;
  const once = (): void => {
    observer.disconnect();
    if (started) return;
    started = true;
    start();
  };
  const observer = new IntersectionObserver(
    (entries) => {
      if (entries.some((entry) => entry.isIntersecting)) once();
    },
    { rootMargin: NEAR },
  );
  for (const lab of labs) observer.observe(lab);
  whenIdle(once);
}

/** Once the page has loaded and has nothing else to do. */
export function whenIdle(callback: () => void): void {
  const ask = (): void => {
    // Safari has no requestIdleCallback; a while after loading is near enough.
    if ("requestIdleCallback" in window) requestIdleCallback(callback);
    else setTimeout(callback, 2000);
  };
  if (document.readyState === "complete") ask();
  else addEventListener("load", ask, { once: true });
}
