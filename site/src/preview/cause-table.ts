/** The causes that a check.py can tell, and the wrong attempts that earn them. May import `ui`. */
import { html, nothing, type TemplateResult } from "lit";
import { icons } from "../ui/icons.ts";
import { previewWords as words } from "../ui/preview-words.ts";
import type { TaskPreview } from "./data.ts";
import { causesOf, type HeldCause } from "./judged.ts";

export function causeTable(task: TaskPreview): TemplateResult {
  const causes = causesOf(task);
  return html`<section class="group causes" aria-label=${words.causes}>
    <h3>${words.causes} <span>${words.causesNote}</span></h3>
    ${
      !causes || causes.length === 0
        ? html`<p class="none">${causes ? words.noCauses : words.causesUnknown}</p>`
        : html`<ul>
            ${causes.map(row)}
          </ul>`
    }
  </section>`;
}

function row({ text, hint, line, declared, earnedBy }: HeldCause): TemplateResult {
  const held = earnedBy.length > 0;
  const origin = !declared ? words.gradersOwn : line === null ? nothing : words.checkLine(line);
  return html`<li data-tone=${held ? "good" : "doubt"}>
    ${held ? icons.passed : icons.notRun}
    <div>
      <p>${text}</p>
      <p class="cause-facts">
        <span class="earned-by">${held ? words.files(earnedBy.map(nameOf)) : words.notHeld}</span>
        <span>${hint === null ? nothing : words.hint(hint + 1)}</span>
        <span>${origin}</span>
      </p>
    </div>
  </li>`;
}

function nameOf(file: string): string {
  return file.replace(/^wrong\//, "");
}
