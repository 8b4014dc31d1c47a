/**
 * The Try buttons of a page: each sets constants of a program on the page and runs it, in that
 * program's own lab. What comes of it is shown beside the button's own words, where the reader is. The
 * build writes the buttons disabled, which is how they read without scripts. May import `lab`.
 */
import { part } from "../ui/part.ts";
import { tryWords } from "../ui/try-words.ts";
import { holdStill, inPlace } from "./hold-still.ts";
import { BugbotLab } from "./lab.ts";
import type { Values } from "./lab-try.ts";
import type { TryResult } from "./try-result.ts";

export function startTries(root: ParentNode): void {
  /** One result a lab: the one before tells of a program that is no more. */
  const results = new WeakMap<BugbotLab, { result: TryResult; stopHolding(): void }>();
  for (const button of root.querySelectorAll<HTMLButtonElement>("button.try")) {
    const { program, constants } = button.dataset;
    const lab = root.querySelector(`#lab-${program}`);
    if (!(lab instanceof BugbotLab)) throw new Error(`there is no lab "lab-${program}" to try on`);
    const values: Values = JSON.parse(constants ?? "{}");
    button.addEventListener("click", async () => {
      const { TryResult } = await part(() => import("./try-result.ts"));
      const before = results.get(lab);
      before?.stopHolding();
      const result = new TryResult();
      result.lab = lab.id;
      result.onUndo = () => undo(lab, result, button);
      inPlace(button, () => {
        before?.result.remove();
        putBeside(button, result);
      });
      results.set(lab, { result, stopHolding: holdStill(button, lab) });
      void lab.experiment(values).then((tried) => {
        result.tried = tried;
      });
    });
    button.disabled = false;
  }
}

function undo(lab: BugbotLab, result: TryResult, button: HTMLElement): void {
  result.words = lab.undoExperiment() ?? tryWords.changedSince;
  result.tried = null;
  // The button that was pressed is no more.
  button.focus({ preventScroll: true });
}

/** After the words that say what there is to notice. */
function putBeside(button: HTMLElement, result: TryResult): void {
  const item = button.closest("li");
  if (item) item.append(result);
  else (button.closest(".table") ?? button.closest("p") ?? button).after(result);
}
