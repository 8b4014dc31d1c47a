/**
 * The small changes of a task's solution: how many fail, how many have a reason, and each that is
 * open as a change of a line. May import `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import { previewWords as words } from "../ui/preview-words.ts";
import type { Mutants, Reason, TaskPreview } from "./data.ts";
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
    ${reasons.length > 0 ? reasonList(reasons) : nothing}
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
    ["explained", explained],
    ["open", open.length],
  ] as const;
  return html`<p class="mutant-counts">
      <span><b>${mutants}</b> ${words.countOf(mutants).replace(/^\d+ /, "")}</span>
      ${kinds.map(([kind, count]) => html`<span class=${kind}><i></i><b>${count}</b> ${words[kind]}</span>`)}
      <span>${words.seconds(seconds)}</span>
    </p>
    <div class="mutant-bar" aria-hidden="true">
      ${kinds.map(([kind, count]) => (count > 0 ? html`<i class=${kind} style="flex-grow: ${count}"></i>` : nothing))}
    </div>
    <p class="mutant-said" data-tone=${open.length > 0 ? "bad" : "good"}>${words.opened(open.length)}</p>
    ${
      open.length > 0
        ? html`<ol class="changes">
            ${open.map(
              ({ line, before, after }) => html`<li>
                <span class="line">${words.line(line)}</span>${diff(before, after)}
              </li>`,
            )}
          </ol>`
        : nothing
    }
    ${faults.map((fault) => html`<p class="mutant-said" data-tone="bad">${fault}</p>`)}`;
}

function diff(before: string, after: string): TemplateResult {
  return html`<code class="diff">
    <del><span class="out-of-sight">${words.removed}: </span>${before}</del>
    <ins><span class="out-of-sight">${words.added}: </span>${after}</ins>
  </code>`;
}

function reasonList(reasons: readonly Reason[]): TemplateResult {
  const text = (pattern: string): string => (pattern === "*" ? words.anything : pattern);
  return html`<details class="reasons">
    <summary>${words.reasons(reasons.length)}</summary>
    <ol class="changes">
      ${reasons.map(
        ({ before, after, reason }) => html`<li>
          ${diff(text(before), text(after))}
          <p>${reason}</p>
        </li>`,
      )}
    </ol>
  </details>`;
}
