/**
 * Brings the live figures of a page to life, each when it comes near the screen.
 * May import each figure's element and `ui`.
 */
import { part } from "../ui/part.ts";

/** A figure this far below the screen will be on it soon. */
const NEAR = "600px";

const ELEMENTS: Readonly<Record<string, () => Promise<unknown>>> = {
  "bugbot-beam": () => part(() => import("./beam/element.ts")),
  "bugbot-evidence": () => part(() => import("./evidence/element.ts")),
};

export function startFigures(root: ParentNode): void {
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        observer.unobserve(target);
        void ELEMENTS[target.localName]?.();
      }
    },
    { rootMargin: NEAR },
  );
  for (const name of Object.keys(ELEMENTS)) {
    for (const figure of root.querySelectorAll(name)) observer.observe(figure);
  }
}
