/** Whether an element's content has arrived. Imports nothing of ours. */

/** Calls back once the parser has come to the element's end: at once if it has. */
export function whenParsed(element: HTMLElement, callback: () => void): void {
  const isPast = (): boolean => {
    if (document.readyState !== "loading") return true;
    for (let node: Node | null = element; node; node = node.parentNode) {
      if (node.nextSibling) return true;
    }
    return false;
  };
  if (isPast()) {
    callback();
    return;
  }
  const look = (): void => {
    if (!isPast()) return;
    observer.disconnect();
    document.removeEventListener("readystatechange", look);
    callback();
  };
  const observer = new MutationObserver(look);
  observer.observe(document, { childList: true, subtree: true });
  document.addEventListener("readystatechange", look);
}
