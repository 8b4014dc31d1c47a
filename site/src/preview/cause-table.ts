/** The causes that a check.py can tell, and the wrong attempts that earn them. May import `ui`. */
import { html, nothing, type TemplateResult } from "lit";
import { icons } from "../ui/icons.ts";
import { previewWords as words } from "../ui/preview-words.ts";
import type { TaskPreview } from "./data.ts";
import { causesOf, type HeldCause } from "./judged.ts";
import type { Context } from "./page-face.ts";

export function causeTable(task: TaskPreview, { opened }: Context): TemplateResult {
  const causes = causesOf(task);
  const open = causes?.filter(({ earnedBy }) => earnedBy.length === 0) ?? [];
  const held = causes?.filter(({ earnedBy }) => earnedBy.length > 0) ?? [];
  const part = `${task.name} causes`;
  return html`<section class="group causes" aria-label=${words.causes}>
    <h3>${words.causes} <span>${words.causesNote}</span></h3>
    ${
      !causes || causes.length === 0
        ? html`<p class="none">${causes ? words.noCauses : words.causesUnknown}</p>`
        : nothing
    }
    ${open.length > 0 ? html`<ul>${open.map(row)}</ul>` : nothing}
    ${
      held.length > 0
        ? html`<details
            class="more"
            ?open=${opened.open.has(part)}
            @toggle=${(event: Event) => opened.set(part, (event.target as HTMLDetailsElement).open)}
          >
            <summary>${words.held(held.length)}</summary>
            <ul>${held.map(row)}</ul>
          </details>`
        : nothing
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
