/**
 * Panels that show a program before anything happens to the learner's own: one that is offered
 * (in a link, or by a newer page), and the earlier versions. They only ask; the lab acts.
 * May import `editor` and `ui`.
 */
import { html, nothing } from "lit";
import { ProgramPreview } from "../editor/preview.ts";
import { Dialog } from "../ui/dialog.ts";
import { versionWords } from "../ui/file-words.ts";
import "./program-dialogs.css";
import { changeFrom, type Version } from "./versions.ts";

export interface Offer {
  title: string;
  lead: string;
  program: string;
  /** The learner's own: lines of `program` that differ from it are marked; null marks none. */
  mine: string | null;
  take: string;
  keep: string;
}

/** True to take the program; false to keep one's own; null if the panel was closed. */
export async function offerProgram(offer: Offer): Promise<boolean | null> {
  const { title, lead, program, mine, take, keep } = offer;
  const dialog = new Dialog<boolean>(title);
  dialog.show(
    html`<p>${lead}</p>
      <div class="preview"></div>
      <footer>
        <button type="button" autofocus @click=${() => dialog.answer(false)}>${keep}</button>
        <button type="button" class="go" @click=${() => dialog.answer(true)}>${take}</button>
      </footer>`,
  );
  const preview = new ProgramPreview(dialog.part(".preview"));
  preview.show(program, mine === null ? null : changeFrom(mine, program));
  return dialog.answered;
}

/** The text of the version to bring back, or null. `starter` is the page's own program. */
export async function chooseVersion(
  all: readonly Version[],
  mine: string,
  starter: string,
): Promise<string | null> {
  const versions = all.filter(({ text }) => text !== mine);
  const dialog = new Dialog<string>(versionWords.title);
  let chosen = versions[0];
  if (!chosen) {
    dialog.element.classList.add("narrow");
    dialog.show(html`<p>${noneWords(all, mine, starter)}</p>`);
    return dialog.answered;
  }
  const draw = (): void => {
    dialog.show(
      html`<p>${versionWords.lead}</p>
        <div class="versions">
          <ol aria-label=${versionWords.list}>
            ${versions.map(
              (version) => html`<li>
                <button
                  type="button"
                  ?autofocus=${version === chosen}
                  aria-pressed=${version === chosen ? "true" : "false"}
                  @click=${() => choose(version)}
                >
                  ${entry(version, mine)}
                </button>
              </li>`,
            )}
          </ol>
          <div class="preview"></div>
        </div>
        <footer>
          <button type="button" class="go" @click=${() => chosen && dialog.answer(chosen.text)}>
            ${versionWords.restore}
          </button>
        </footer>`,
    );
  };
  draw();
  const preview = new ProgramPreview(dialog.part(".preview"));
  const choose = (version: Version): void => {
    chosen = version;
    draw();
    preview.show(version.text, changeFrom(mine, version.text));
  };
  choose(chosen);
  return dialog.answered;
}

/** Why there is no version to go back to. */
function noneWords(all: readonly Version[], mine: string, starter: string): string {
  if (all.length > 0) return versionWords.onlyThis;
  return mine === starter ? versionWords.untouched : versionWords.none;
}

function entry({ at, text }: Version, mine: string) {
  const date = new Date(at);
  const change = changeFrom(mine, text);
  return html`<b>${versionWords.day(date, new Date())}, ${versionWords.time(date)}</b>
    <span>${versionWords.size(text)}</span>
    ${change ? html`<code>${inWords(change, text)}</code>` : nothing}`;
}

function inWords({ first, last }: { first: number; last: number }, text: string): string {
  if (last < first) return versionWords.removed(first);
  return versionWords.change(first, text.split("\n")[first - 1] ?? "");
}
