/**
 * <bugbot-task name="…">: a task of a lesson. Its statement and hints are in the page already and
 * are taken over; a lab with the starter, marks, hints one at a time, and a solution come with it.
 *
 * Asks its lab for the program, and shows a failed check's run there. `defineTask` makes the
 * element known. May import every room of the site but `worker`.
 */
import { LitElement, type TemplateResult } from "lit";
import type { Runtime } from "../runtime/client.ts";
import type { Where } from "../runtime/marks.ts";
import type { Result } from "../runtime/results.ts";
import { part } from "../ui/part.ts";
import { solutionWords, whereWords } from "../ui/task-words.ts";
import type { BugbotLab } from "./lab.ts";
import type { LessonData, TaskData } from "./lesson-data.ts";
import { TaskMarking } from "./marking.ts";
import type { Progress, TaskRecord } from "./progress.ts";
import { cellsOf } from "./task-checks.ts";
import { type TaskFace, taskFace } from "./task-face.ts";
import { type TaskParts, takeOver } from "./task-parts.ts";
import { TaskResults } from "./task-results.ts";
import { showSolution } from "./task-solution.ts";

/** What every task of a page shares. */
export interface TaskServices {
  runtime: Runtime;
  progress: Progress;
  lesson: LessonData;
}

export class BugbotTask extends LitElement {
  static override properties = { name: { type: String } };
  declare name: string;

  readonly #services: TaskServices;
  readonly #marking: TaskMarking;
  /** Made with the first mark: the task's name is known by then. */
  #results: TaskResults | null = null;
  #parts: TaskParts | null = null;
  /** How the task stood when the page was opened. */
  #before: TaskRecord | null = null;
  /** The program in the editor, as of its last change. */
  #program = "";
  #warned = false;
  #passedNow = false;
  #note: TaskFace["note"] = null;
  readonly #redraw = (): void => this.requestUpdate();
  readonly #onRun = {
    onShow: (where: Where): void => this.#show(where),
    onRosMap: (result: Result): void => void this.#saveRosMap(result),
  };

  constructor(services: TaskServices) {
    super();
    this.#services = services;
    this.#marking = new TaskMarking(services.runtime);
    this.#marking.addEventListener("change", this.#redraw);
    this.addEventListener("program-change", () => this.#edited());
    this.addEventListener("focusin", () => this.#visited());
    this.addEventListener("keydown", (event) => this.#onKey(event), { capture: true });
  }

  /** In the page itself, not in a shadow: one style sheet, and the page's own nodes stay in it. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    this.#parts ??= takeOver(this);
    super.connectedCallback();
    const { runtime, progress, lesson } = this.#services;
    runtime.addEventListener("change", this.#redraw);
    progress.addEventListener("change", this.#redraw);
    this.#before = progress.of(lesson.lesson, this.name);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    const { runtime, progress } = this.#services;
    runtime.removeEventListener("change", this.#redraw);
    progress.removeEventListener("change", this.#redraw);
    this.#marking.cancel();
  }

  // -- what a person does ------------------------------------------------------------

  async #check(): Promise<void> {
    if (this.#marking.phase === "marking") return;
    const { lesson, progress } = this.#services;
    const { check, starter } = this.#data;
    const { program } = this.#lab;
    this.#program = program;
    this.#note = null;
    const request = { lesson: lesson.lesson, task: this.name, check, program, starter };
    const mark = await this.#marking.mark({ ...request, worlds: lesson.worlds });
    if (!mark || mark.ours !== null) return;
    this.#passedNow = mark.passed && this.#record?.state !== "passed";
    if (mark.passed) this.#warned = false;
    progress.marked(lesson.lesson, this.name, mark.passed);
    this.#results ??= new TaskResults(progress, lesson.lesson, this.name);
    await this.#results.take(mark);
    this.requestUpdate();
    await this.updateComplete;
    const shown = this.querySelector(mark.passed ? ".task-status" : ".check-why");
    shown?.scrollIntoView({ block: "nearest" });
  }

  #cancel(): void {
    this.#marking.cancel();
    // The Cancel button goes with the marking; the focus must not go with it.
    this.querySelector<HTMLElement>(".task-status .check")?.focus();
  }

  /** Opens the next hint and goes to it. */
  #openHint(): void {
    const { lesson, progress } = this.#services;
    const opened = this.#opened + 1;
    progress.hintsOpened(lesson.lesson, this.name, opened);
    void this.#goToHint(opened - 1);
  }

  async #goToHint(index: number): Promise<void> {
    await this.updateComplete;
    const hint = this.querySelectorAll<HTMLElement>(".task-hints .task-hint")[index];
    hint?.focus({ preventScroll: true });
    hint?.scrollIntoView({ block: "nearest" });
  }

  /** The solution is for those who have passed, or who ask twice. */
  async #askForSolution(): Promise<void> {
    const { lesson, progress } = this.#services;
    const record = this.#record;
    if (record?.state !== "passed" && !record?.solution && !this.#warned) {
      this.#warned = true;
      this.#note = null;
      this.requestUpdate();
      return;
    }
    this.#warned = false;
    progress.solutionSeen(lesson.lesson, this.name);
    const lab = this.#lab;
    const mine = lab.program;
    if (!(await showSolution(mine, this.#data.solution))) return;
    lab.program = this.#data.solution;
    this.#say(solutionWords.taken, () => {
      lab.program = mine;
      this.#say(solutionWords.undone, null);
      this.querySelector<HTMLElement>(".task-foot .solution")?.focus();
    });
  }

  /** Shows the check's run, or the place on the mat if there was none, in the lab. */
  #show(where: Where): void {
    const { trace, isRun } = this.#marking.shown(where);
    const { title } = where.world;
    const lab = this.#lab;
    lab.showRun(trace, {
      note: isRun ? whereWords.shown(title) : whereWords.shownMat(title),
      outlined: cellsOf(where),
      seconds: where.seconds,
    });
    lab.scrollIntoView({ block: "start" });
    lab.querySelector<HTMLElement>(".overhead-mat")?.focus({ preventScroll: true });
  }

  async #saveRosMap(result: Result): Promise<void> {
    const { saveResultMap } = await part(() => import("./result-map-file.ts"));
    this.#say(await saveResultMap(this.#services.runtime, result), null);
  }

  #edited(): void {
    this.#program = this.#lab.program;
    this.#passedNow = false;
    this.requestUpdate();
  }

  #visited(): void {
    const { lesson, progress } = this.#services;
    progress.visit(lesson.lesson, this.name);
  }

  #onKey(event: KeyboardEvent): void {
    const both = event.shiftKey && (event.ctrlKey || event.metaKey);
    if (event.key !== "Enter" || !both) return;
    event.preventDefault();
    event.stopPropagation();
    void this.#check();
  }

  #say(text: string, undo: (() => void) | null): void {
    this.#note = { text, undo };
    this.requestUpdate();
  }

  // -- how it stands -----------------------------------------------------------------

  get #lab(): BugbotLab {
    const lab = this.querySelector<BugbotLab>("bugbot-lab");
    if (!lab) throw new Error(`<bugbot-task name="${this.name}"> was asked before it had its lab`);
    return lab;
  }

  get #data(): TaskData {
    const { tasks } = this.#services.lesson;
    const data = tasks[this.name];
    if (data) return data;
    const names = Object.keys(tasks).join(", ");
    throw new RangeError(`<bugbot-task>: no task "${this.name}". This lesson has: ${names}`);
  }

  get #record(): TaskRecord | null {
    const { progress, lesson } = this.#services;
    return progress.of(lesson.lesson, this.name);
  }

  get #opened(): number {
    return Math.min(this.#record?.hints ?? 0, this.#parts?.hints.length ?? 0);
  }

  override render(): TemplateResult {
    const { tasks } = this.#services.lesson;
    const names = Object.keys(tasks);
    const parts = this.#parts ?? takeOver(this);
    const marks = this.#marking.marks;
    const stale = marks !== null && marks.program !== this.#program;
    const opened = this.#opened;
    return taskFace({
      ...parts,
      name: this.name,
      data: this.#data,
      number: names.indexOf(this.name) + 1,
      of: names.length,
      state: this.#record?.state ?? "new",
      fresh: this.#passedNow,
      status: this.#status(stale),
      checks: marks && {
        mark: marks.mark,
        shown: (where) => this.#marking.shown(where),
        hints: { opened, of: parts.hints.length },
        onShow: (where) => this.#show(where),
        onNextHint: () => this.#openHint(),
        onHint: (index) => void this.#goToHint(index),
      },
      results: marks && (this.#results?.card(marks.mark, this.#onRun) ?? null),
      stale,
      opened,
      solution: this.#warned ? "warned" : "closed",
      note: this.#note,
      next: this.#next,
      onOpenHint: () => this.#openHint(),
      onSolution: () => void this.#askForSolution(),
    });
  }

  #status(stale: boolean): TaskFace["status"] {
    const { phase, progress, note, marks, error } = this.#marking;
    return {
      phase,
      ready: this.#services.runtime.state === "ready",
      progress,
      waits: note,
      mark: marks?.mark ?? null,
      stale,
      error,
      before: this.#before,
      onCheck: () => void this.#check(),
      onCancel: () => this.#cancel(),
    };
  }

  /** The first task after this one that is not passed, once this one is. */
  get #next(): TaskFace["next"] {
    const { progress, lesson } = this.#services;
    if (this.#record?.state !== "passed") return null;
    const later = Object.entries(lesson.tasks).slice(
      Object.keys(lesson.tasks).indexOf(this.name) + 1,
    );
    const next = later.find(([name]) => progress.of(lesson.lesson, name)?.state !== "passed");
    return next ? { name: next[0], title: next[1].title } : null;
  }
}

/** Makes the element known, with what all tasks of the page share. */
export function defineTask(services: TaskServices): void {
  customElements.define(
    "bugbot-task",
    class extends BugbotTask {
      constructor() {
        super(services);
      }
    },
  );
}
