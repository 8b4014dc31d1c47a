/**
 * The solution beside the learner's own program, the lines in which they differ marked.
 * May import `editor` and `ui`.
 */
import { html, nothing } from "lit";
import { ProgramPreview } from "../editor/preview.ts";
import { Dialog } from "../ui/dialog.ts";
import { solutionWords as words } from "../ui/task-words.ts";
import { lineDiff } from "./line-diff.ts";
import "./task-solution.css";

/** True if the solution is to go into the editor. */
export async function showSolution(mine: string, solution: string): Promise<boolean> {
  const same = mine === solution;
  const dialog = new Dialog<boolean>(words.title);
  dialog.element.classList.add("wide");
  dialog.show(
    html`<p>${same ? words.same : words.lead}</p>
      <div class="solution-sides">
        <section class="solution-theirs" aria-label=${words.theirs}>
          <h3>${words.theirs}</h3>
          <div class="preview"></div>
        </section>
        <section class="solution-mine" aria-label=${words.mine}>
          <h3>${words.mine}</h3>
          <div class="preview"></div>
        </section>
      </div>
      <footer>
        <button type="button" autofocus @click=${() => dialog.answer(false)}>${words.close}</button>
        ${
          same
            ? nothing
            : html`<button type="button" class="go" @click=${() => dialog.answer(true)}>
                ${words.take}
              </button>`
        }
      </footer>`,
  );
  const differ = lineDiff(mine, solution);
  const side = (part: string, label: string, text: string, lines: readonly number[]): void => {
    const first = lines[0] ?? 1;
    new ProgramPreview(dialog.part(`${part} .preview`), label).show(
      text,
      { first, last: first },
      lines,
    );
  };
  side(".solution-theirs", words.theirs, solution, differ.second);
  side(".solution-mine", words.mine, mine, differ.first);
  return (await dialog.answered) === true;
}
