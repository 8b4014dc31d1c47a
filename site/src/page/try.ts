/**
 * The Try buttons of a page: each sets constants of a program on the page and runs it, in that
 * program's own lab. The build writes them disabled, which is how they read without scripts.
 * May import `lab`.
 */
import { BugbotLab } from "./lab.ts";
import type { Values } from "./lab-try.ts";

/** A picture of which less than this share is on the screen is not in sight. */
const SEEN = 0.6;

export function startTries(root: ParentNode): void {
  for (const button of root.querySelectorAll<HTMLButtonElement>("button.try")) {
    const { program, constants } = button.dataset;
    const lab = root.querySelector(`#lab-${program}`);
    if (!(lab instanceof BugbotLab)) throw new Error(`there is no lab "lab-${program}" to try on`);
    const values: Values = JSON.parse(constants ?? "{}");
    button.addEventListener("click", async () => {
      void lab.try(values);
      await lab.updateComplete;
      if (inSight(lab)) return;
      const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
      lab.scrollIntoView({ block: "start", behavior: still ? "auto" : "smooth" });
      // The keys go on from here, where the button to undo it is, and not from far away.
      lab.focusStatus();
    });
    button.disabled = false;
  }
}

/** Whether the reader sees what happens: the status line and most of the picture. */
function inSight(lab: BugbotLab): boolean {
  const shown = (selector: string): number => {
    const box = lab.querySelector(selector)?.getBoundingClientRect();
    if (!box || box.height === 0) return 0;
    return (Math.min(box.bottom, innerHeight) - Math.max(box.top, 0)) / box.height;
  };
  return shown(".lab-status") > SEEN && shown("overhead-view") > SEEN;
}
