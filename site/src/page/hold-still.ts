/** Keeps what the reader looks at in its place on the screen. Imports nothing of ours. */

/**
 * While something further up the page changes its height, the page scrolls with it, so that `element`
 * stays where it is on the screen as long as it is in sight. Browsers promise this by themselves, but
 * not all of them do it, nor each time. Ends with the call of what is returned.
 */
export function holdStill(element: HTMLElement, changing: Element): () => void {
  const place = (): { onPage: number; scrolled: number } => {
    return { onPage: element.getBoundingClientRect().top + scrollY, scrolled: scrollY };
  };
  let last = place();
  const onScroll = (): void => {
    last = place();
  };
  const observer = new ResizeObserver(() => {
    const { top, bottom } = element.getBoundingClientRect();
    const now = place();
    // Where the page has been scrolled meanwhile, the browser or the reader has seen to it.
    const isMoved = now.onPage !== last.onPage && now.scrolled === last.scrolled;
    if (isMoved && bottom > 0 && top < innerHeight) {
      scrollBy({ top: now.onPage - last.onPage, behavior: "instant" });
    }
    last = place();
  });
  observer.observe(changing);
  addEventListener("scroll", onScroll, { passive: true });
  return () => {
    observer.disconnect();
    removeEventListener("scroll", onScroll);
  };
}

/** Changes the page at once, and leaves an element where it is on the screen. */
export function inPlace(element: HTMLElement, change: () => void): void {
  const before = element.getBoundingClientRect().top;
  change();
  scrollBy({ top: element.getBoundingClientRect().top - before, behavior: "instant" });
}
