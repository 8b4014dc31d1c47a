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

/** Somebody is there. Until then a page that was only opened, or only looked at, costs little. */
const SIGNS = ["pointermove", "pointerdown", "keydown", "wheel", "scroll"];

/** Whether the reader has asked the browser to save data. */
export function savesData(): boolean {
  return (navigator as Navigator & Connection).connection?.saveData === true;
}

/**
 * Call `start` once: when one of the labs comes near the screen, or the page has nothing else to do
 * and somebody has begun to read it. Where the reader saves data, only when they reach for a lab.
 * (A lab's Run starts Python in any case.)
 */
export function whenWanted(labs: readonly Element[], start: () => void): void {
  const { once, signal } = single(start);
  if (savesData()) {
    for (const lab of labs) {
      lab.addEventListener("pointerdown", once, { signal });
      lab.addEventListener("focusin", once, { signal });
    }
    return;
  }
  onNear(labs, once, signal);
  for (const sign of SIGNS) {
    addEventListener(sign, () => whenIdle(once), { once: true, passive: true, signal });
  }
}

/**
 * Call `start` once: when one of the labs comes near the screen, or the page has loaded and has
 * nothing else to do.
 */
export function whenNear(labs: readonly Element[], start: () => void): void {
  const { once, signal } = single(start);
  onNear(labs, once, signal);
  whenIdle(once);
}

/** `start` for one call; the signal says that it has been made. */
function single(start: () => void): { once: () => void; signal: AbortSignal } {
  const started = new AbortController();
  const once = (): void => {
    if (started.signal.aborted) return;
    started.abort();
    start();
  };
  return { once, signal: started.signal };
}

function onNear(labs: readonly Element[], callback: () => void, signal: AbortSignal): void {
  const observer = new IntersectionObserver(
    (entries) => {
      if (entries.some((entry) => entry.isIntersecting)) callback();
    },
    { rootMargin: NEAR },
  );
  for (const lab of labs) observer.observe(lab);
  signal.addEventListener("abort", () => observer.disconnect());
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
