/**
 * The contents of a page follow the reader: the entry of the section in sight is marked, and kept
 * in sight itself. Imports nothing of ours.
 */

/** A section counts from where its heading has come this far up the window. */
const READING_LINE = 0.3;

export function followContents(page: Document): void {
  const nav = page.querySelector<HTMLElement>(".contents");
  if (!nav) return;
  const entries = [...nav.querySelectorAll<HTMLAnchorElement>("a")].flatMap((link) => {
    const target = page.getElementById(decodeURIComponent(link.hash.slice(1)));
    // The list may hide its tasks: one that can't be seen can't be marked.
    return target ? [{ link, target }] : [];
  });
  let marked: HTMLAnchorElement | null = null;

  const mark = (): void => {
    const line = innerHeight * READING_LINE;
    const shown = entries.filter(({ link }) => link.checkVisibility());
    const here = shown.findLast(({ target }) => target.getBoundingClientRect().top <= line);
    const link = here?.link ?? null;
    if (link === marked) return;
    marked?.removeAttribute("aria-current");
    link?.setAttribute("aria-current", "true");
    marked = link;
    if (link) keepInSight(link);
  };

  let due = false;
  const soon = (): void => {
    if (due) return;
    due = true;
    requestAnimationFrame(() => {
      due = false;
      mark();
    });
  };
  addEventListener("scroll", soon, { passive: true });
  addEventListener("resize", soon);
  mark();
}

/** Scrolls the list, never the page. */
function keepInSight(link: HTMLElement): void {
  const list = scrollerOf(link);
  if (!list) return;
  const [inner, outer] = [link.getBoundingClientRect(), list.getBoundingClientRect()];
  const left = inner.left - outer.left - (outer.width - inner.width) / 2;
  const top = inner.top - outer.top - (outer.height - inner.height) / 2;
  list.scrollBy({ left, top });
}

function scrollerOf(link: HTMLElement): HTMLElement | null {
  let box = link.parentElement;
  while (box && box.scrollWidth <= box.clientWidth && box.scrollHeight <= box.clientHeight) {
    if (box.matches(".contents")) return null;
    box = box.parentElement;
  }
  return box?.closest(".contents") ? box : null;
}
