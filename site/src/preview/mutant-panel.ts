/**
 * The small changes of a task's solution: how many fail, how many have a reason, and each that is
 * open as a change of a line. May import `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import { previewWords as words } from "../ui/preview-words.ts";
import type { Change, Mutants, Reason, TaskPreview } from "./data.ts";
import { type Context, trouble } from "./page-face.ts";
import type { Work } from "./server.ts";

export function mutantPanel(task: TaskPreview, { server }: Context): TemplateResult {
  const { name, mutants, reasons } = task;
  const work = server.work(name, "mutants");
  const failed = server.trouble(name, "mutants");
  return html`<section class="group mutants" aria-label=${words.mutants}>
    <h3>${words.mutants} <span>${words.mutantsNote}</span></h3>
    ${failed === null ? nothing : trouble(words.failed, failed)}
    ${mutants && !work ? found(mutants) : nothing}
    <div class="mutant-acts">
      ${
        work
          ? html`<button type="button" @click=${() => server.cancel(name, "mutants")}>
                ${words.cancel}
              </button>
              <p class="count">${progressOf(work)}</p>
              ${bar(work)}`
          : html`<button type="button" @click=${() => void server.tryMutants(name)}>
              ${mutants ? words.tryAgain : words.tryMutants}
            </button>`
      }
    </div>
    ${!mutants && reasons.length > 0 ? reasonList(reasons) : nothing}
  </section>`;
}

function progressOf({ done, of }: Work): string {
  return of > 0 ? words.tried(done, of) : words.trying;
}

function bar({ done, of }: Work): TemplateResult {
  return of > 0
    ? html`<progress aria-label=${words.mutants} max=${of} .value=${done}></progress>`
    : html`<progress aria-label=${words.mutants}></progress>`;
}

function found({ mutants, killed, explained, open, faults, seconds }: Mutants): TemplateResult {
  const kinds = [
    ["killed", killed],
    ["explained", explained.length],
    ["open", open.length],
  ] as const;
  return html`<p class="mutant-counts">
      <span><b>${mutants}</b> ${words.countOf(mutants)}</span>
      ${kinds.map(
        ([kind, count]) =>
          html`<span class=${kind}><i></i><b>${count}</b> ${words[kind](count)}</span>`,
      )}
      <span>${words.seconds(seconds)}</span>
    </p>
    <div class="mutant-bar" aria-hidden="true">
      ${kinds.map(([kind, count]) =>
        count > 0 ? html`<i class=${kind} style="flex-grow: ${count}"></i>` : nothing,
      )}
    </div>
    ${open.length > 0 || faults.length === 0 ? said(words.opened(open.length), open.length) : nothing}
    ${faults.map((fault) => said(fault, 1))}
    ${open.length > 0 ? html`<ol class="changes" aria-label=${words.openList}>${open.map(change)}</ol>` : nothing}
    ${
      explained.length > 0
        ? html`<details class="more">
            <summary>${words.whyNot(explained.length)}</summary>
            <ol class="changes">
              ${explained.map(change)}
            </ol>
          </details>`
        : nothing
    }`;
}

function said(text: string, faults: number): TemplateResult {
  return html`<p class="mutant-said" data-tone=${faults > 0 ? "bad" : "good"}>${text}</p>`;
}

function change({ line, in: name, kind, before, after, why }: Change): TemplateResult {
  return html`<li>
    <p class="where">
      <b>${words.line(line)}</b>
      <span>${name === "" ? nothing : words.inFunction(name)}</span>
      <span>${kind}</span>
    </p>
    <div>${diff(before, after)} ${why === null ? nothing : html`<p>${why}</p>`}</div>
  </li>`;
}

function diff(before: string, after: string): TemplateResult {
  return html`<code class="diff"
    ><del><span class="out-of-sight">${words.removed}: </span>${before}</del
    ><ins><span class="out-of-sight">${words.added}: </span>${after}</ins></code
  >`;
}

/** The entries as they are written, before anything has been tried. */
function reasonList(reasons: readonly Reason[]): TemplateResult {
  return html`<details class="more">
    <summary>${words.reasons(reasons.length)}</summary>
    <ol class="changes">
      ${reasons.map((each) => {
        const [before = "", ...after] = (each.change ?? "").split(" -> ");
        return html`<li>
          <p class="where">
            <span>${each.in ? words.inFunction(each.in) : nothing}</span>
            <span>${each.kinds?.join(", ") ?? nothing}</span>
          </p>
          <div>
            ${each.change ? diff(before, after.join(" -> ")) : words.anyChange}
            <p>${each.why}</p>
          </div>
        </li>`;
      })}
    </ol>
  </details>`;
}
