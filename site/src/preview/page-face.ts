/**
 * The whole authors' page: an overview of the tasks, then each task with its programs, causes and
 * mutants. May import `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import { unsafeHTML } from "lit/directives/unsafe-html.js";
import { previewWords as words } from "../ui/preview-words.ts";
import { causeTable } from "./cause-table.ts";
import { KINDS, type Kind, type TaskPreview } from "./data.ts";
import { causesOf, TONES, type Tone, verdictOf } from "./judged.ts";
import { mutantPanel } from "./mutant-panel.ts";
import type { Opened } from "./opened.ts";
import { programRow } from "./program-row.ts";
import type { PreviewServer } from "./server.ts";
import "./preview.css";

export interface Context {
  server: PreviewServer;
  opened: Opened;
  redraw(): void;
}

export function pageFace(context: Context): TemplateResult {
  const { lesson } = context.server;
  return html`<header class="preview-head">
      <p class="over">${words.over(lesson.code)}</p>
      <h1>${words.title(lesson.title)}</h1>
      <p class="lead">${words.lead}</p>
      <nav aria-label=${words.lessons}>
        ${lesson.lessons.map(
          ({ slug, code, title }) =>
            html`<a
              href="/preview/${slug}/"
              title=${title}
              aria-current=${slug === lesson.slug ? "page" : nothing}
              >${code || title}</a
            >`,
        )}
        <a class="to-lesson" href="/lessons/${lesson.slug}/">${words.lessonPage}</a>
      </nav>
    </header>
    ${lesson.trouble === null ? tasks(context) : trouble(words.trouble, lesson.trouble)}`;
}

function tasks(context: Context): TemplateResult {
  const all = context.server.tasks;
  if (all.length === 0) return html`<p>${words.noTasks}</p>`;
  return html`${overview(all, context)} ${all.map((task) => taskSection(task, context))}`;
}

export function trouble(title: string, text: string): TemplateResult {
  return html`<div class="trouble" role="alert">
    <p>${title}</p>
    <pre tabindex="0">${text}</pre>
  </div>`;
}

// -- the overview ------------------------------------------------------------------

function overview(all: readonly TaskPreview[], context: Context): TemplateResult {
  return html`<section class="overview" aria-label=${words.overview}>
    <table>
      <thead>
        <tr>
          <th scope="col">${words.columns.task}</th>
          ${KINDS.map((kind) => html`<th scope="col">${words.kinds[kind]}</th>`)}
          <th scope="col">${words.columns.causes}</th>
          <th scope="col">${words.columns.mutants}</th>
        </tr>
      </thead>
      <tbody>
        ${all.map(
          (task) => html`<tr>
            <th scope="row"><a href="#${task.name}">${unsafeHTML(task.title)}</a></th>
            ${KINDS.map((kind) => cell(words.kinds[kind], ...countOf(task, kind)))}
            ${cell(words.columns.causes, ...causeCount(task))}
            ${cell(words.columns.mutants, ...mutantCount(task))}
          </tr>`,
        )}
      </tbody>
    </table>
    ${marking(all, context)}
  </section>`;
}

type Count = readonly [text: string, tone: Tone];

function cell(label: string, text: string, tone: Tone): TemplateResult {
  return html`<td data-label=${label} data-tone=${tone}>${text}</td>`;
}

function countOf(task: TaskPreview, kind: Kind): Count {
  const verdicts = task.files.filter((file) => file.kind === kind).map(verdictOf);
  if (verdicts.length === 0) return [words.nothing, kind === "right" ? "none" : "bad"];
  if (verdicts.every((verdict) => verdict === "unmarked")) return [words.unmarked, "none"];
  const [first] = verdicts;
  const tones = verdicts.map((verdict) => TONES[verdict]);
  const tone = (["bad", "doubt", "none"] as const).find((each) => tones.includes(each)) ?? "good";
  const single = kind === "starter" || kind === "solution";
  if (single && first) return [words.short[first], tone];
  return [words.good(tones.filter((each) => each === "good").length, tones.length), tone];
}

function causeCount(task: TaskPreview): Count {
  const declared = causesOf(task)?.filter((cause) => cause.declared);
  if (!declared) return [words.unmarked, "none"];
  if (declared.length === 0) return [words.nothing, "none"];
  const held = declared.filter(({ earnedBy }) => earnedBy.length > 0).length;
  return [words.good(held, declared.length), held === declared.length ? "good" : "doubt"];
}

function mutantCount({ mutants }: TaskPreview): Count {
  if (!mutants) return [words.notTried, "none"];
  const open = mutants.open.length + mutants.faults.length;
  return [words.openCount(mutants.open.length), open > 0 ? "bad" : "good"];
}

/** The button for everything, and how far that is. */
function marking(all: readonly TaskPreview[], { server, opened }: Context): TemplateResult {
  const busy = all.flatMap(({ name }) => server.work(name, "marks") ?? []);
  const left = all.flatMap(({ files }) => files.filter(({ told }) => !told)).length;
  const done = busy.reduce((sum, work) => sum + work.done, 0);
  const of = busy.reduce((sum, work) => sum + work.of, 0);
  const onMark = async (): Promise<void> => {
    for (const { name } of all) opened.asked.add(name);
    for (const { name } of all) await server.mark(name);
  };
  const text =
    busy.length > 0 ? words.progress(done, of) : left > 0 ? words.waiting(left) : words.allMarked;
  return html`<div class="overview-foot">
    ${
      busy.length === 0 && left > 0
        ? html`<button type="button" class="go" @click=${onMark}>${words.markAll}</button>`
        : nothing
    }
    <p role="status">${text}</p>
  </div>`;
}

// -- a task ------------------------------------------------------------------------

function taskSection(task: TaskPreview, context: Context): TemplateResult {
  const { server, opened } = context;
  const { name } = task;
  const work = server.work(name, "marks");
  const failed = server.trouble(name, "marks");
  const left = task.files.filter(({ told }) => !told);
  const onMark = (): void => {
    opened.asked.add(name);
    void server.mark(name, left.length > 0 ? undefined : task.files.map(({ file }) => file));
  };
  return html`<section class="preview-task" id=${name} aria-labelledby="${name}-title">
    <header>
      <h2 id="${name}-title">${unsafeHTML(task.title)}</h2>
      <p class="folder">${name}/</p>
      ${
        work
          ? html`<p class="count">${words.progress(work.done, work.of)}</p>
              <button type="button" @click=${() => server.cancel(name, "marks")}>
                ${words.cancel}
              </button>`
          : html`<button type="button" @click=${onMark}>
              ${left.length > 0 ? words.markTask : words.again}
            </button>`
      }
      <progress
        aria-label=${words.markTask}
        ?hidden=${!work}
        max=${work?.of ?? 1}
        .value=${work?.done ?? 0}
      ></progress>
    </header>
    ${failed === null ? nothing : trouble(words.failed, failed)} ${taskWords(task, context)}
    ${KINDS.map((kind) => group(task, kind, context))} ${causeTable(task, context)}
    ${mutantPanel(task, context)}
  </section>`;
}

function taskWords(task: TaskPreview, { opened }: Context): TemplateResult {
  const part = `${task.name} words`;
  return html`<details
    class="task-words"
    ?open=${opened.open.has(part)}
    @toggle=${(event: Event) => opened.set(part, (event.target as HTMLDetailsElement).open)}
  >
    <summary>${words.statement}</summary>
    <div class="statement">${unsafeHTML(task.statement)}</div>
    <ol>
      ${task.hints.map((hint) => html`<li>${unsafeHTML(hint)}</li>`)}
    </ol>
  </details>`;
}

function group(task: TaskPreview, kind: Kind, context: Context): TemplateResult {
  const files = task.files.filter((file) => file.kind === kind);
  const none = kind === "right" || kind === "wrong" ? words.none[kind] : "";
  return html`<section class="group" aria-label=${words.groups[kind]}>
    <h3>${words.groups[kind]} <span>${words.groupNotes[kind]}</span></h3>
    ${files.length === 0 ? html`<p class="none">${none}</p>` : nothing}
    ${files.map((file) => programRow(task, file, context))}
  </section>`;
}
