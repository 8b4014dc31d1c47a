/**
 * Building a lab takes the browser a good part of a second on a slow device, and a lesson has a dozen
 * of them. So they are built one at a time: at once those near the screen and those that somebody
 * asks something of, the others when the page has nothing else to do. May import `when-wanted`.
 */
import { NEAR, whenIdle } from "./when-wanted.ts";

const waiting = new Map<Element, () => void>();

const observer = new IntersectionObserver(
  (entries) => {
    for (const { isIntersecting, target } of entries) if (isIntersecting) takeTurn(target);
  },
  { rootMargin: NEAR },
);

/** Resolves when it is this element's turn to be built. */
export function inTurn(element: Element): Promise<void> {
  return new Promise((resolve) => {
    if (waiting.size === 0) whenIdle(buildNext);
    waiting.set(element, resolve);
    observer.observe(element);
  });
}

/** It is wanted now: its turn has come. Nothing happens if it has had it. */
export function takeTurn(element: Element): void {
  waiting.get(element)?.();
  waiting.delete(element);
  observer.unobserve(element);
}

function buildNext(): void {
  const [next] = waiting.keys();
  if (!next) return;
  takeTurn(next);
  if (waiting.size > 0) whenIdle(buildNext);
}
