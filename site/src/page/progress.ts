/**
 * A learner's progress, kept on this device and nowhere else. Dispatches "change" when it has
 * changed, here or in another tab. May import `ui`.
 */
import { progressWords } from "../ui/progress-words.ts";
import {
  keyOf,
  merged,
  NO_PROGRESS,
  type Place,
  type ProgressRecord,
  readProgress,
  type TaskRecord,
  writeProgress,
} from "./progress-record.ts";
import type { ProgramStore } from "./storage.ts";

export type { Place, ScoreRecord, TaskRecord } from "./progress-record.ts";

/** The name it is kept under. */
const NAME = "progress";

/** A text that is no progress; the message is for the reader. */
export class ProgressError extends Error {
  override readonly name = "ProgressError";
}

export class Progress extends EventTarget {
  readonly #store: ProgramStore;
  readonly #now: () => number;
  #record: ProgressRecord;
  #kept = true;

  constructor(store: ProgramStore, now: () => number = Date.now) {
    super();
    this.#store = store;
    this.#now = now;
    this.#record = this.#load();
  }

  /** Hears what other tabs do, for as long as the page lives. */
  listen(): void {
    this.#store.onElsewhere((name) => {
      if (name !== NAME) return;
      this.#record = this.#load();
      this.dispatchEvent(new Event("change"));
    });
  }

  // -- what is known ---------------------------------------------------------------

  /** False once this device has refused to keep it: it lasts as long as the page then. */
  get kept(): boolean {
    return this.#kept;
  }

  get empty(): boolean {
    return this.#record.tasks.size === 0;
  }

  /** How far a task has come; null if it has not been begun. */
  of(lesson: string, task: string): TaskRecord | null {
    return this.#record.tasks.get(keyOf(lesson, task)) ?? null;
  }

  /** How many of these tasks are passed, and how many only tried. */
  count(lesson: string, tasks: readonly string[]): { passed: number; tried: number; of: number } {
    const states = tasks.map((task) => this.of(lesson, task)?.state);
    return {
      passed: states.filter((state) => state === "passed").length,
      tried: states.filter((state) => state === "tried").length,
      of: tasks.length,
    };
  }

  /** Where the learner was last; null before the first visit. */
  get last(): Place | null {
    return this.#record.last;
  }

  // -- what happens ------------------------------------------------------------------

  visit(lesson: string, task: string | null = null): void {
    const { last } = this.#record;
    if (last?.lesson === lesson && last.task === task) return;
    this.#change((record) => ({ ...record, last: { lesson, task } }));
  }

  /** The program has been marked. A task once passed stays so. */
  marked(lesson: string, task: string, passed: boolean): void {
    const state = passed ? "passed" : "tried";
    this.#add(lesson, task, { state, hints: 0, solution: false, at: this.#now() });
  }

  /** The program has been marked, and has a score; the best one is kept. */
  scored(lesson: string, task: string, value: number, of: number): void {
    const at = this.#now();
    const score = { best: value, bestAt: at, last: value, lastAt: at, of };
    this.#add(lesson, task, { state: "tried", hints: 0, solution: false, at, score });
  }

  /** So many hints are open now. */
  hintsOpened(lesson: string, task: string, hints: number): void {
    this.#add(lesson, task, { state: "tried", hints, solution: false, at: this.#now() });
  }

  solutionSeen(lesson: string, task: string): void {
    this.#add(lesson, task, { state: "tried", hints: 0, solution: true, at: this.#now() });
  }

  // -- files -------------------------------------------------------------------------

  /** All of it as the text of a file. */
  export(): string {
    return writeProgress(this.#record);
  }

  /**
   * Adds what is in the text of such a file; nothing here is lost. Says how many tasks are new, or
   * further than before. Throws ProgressError.
   */
  import(text: string): { added: number } {
    const read = readProgress(text);
    if (typeof read === "string") throw new ProgressError(progressWords.unreadable[read]);
    const before = this.#record.tasks;
    this.#change((record) => merged(record, read));
    const states = [...this.#record.tasks].filter(
      ([key, { state }]) => before.get(key)?.state !== state,
    );
    return { added: states.length };
  }

  /** Forgets all of it. Returns what brings it back. */
  clear(): () => void {
    const before = this.#record;
    this.#store.forget(NAME);
    this.#record = NO_PROGRESS;
    this.dispatchEvent(new Event("change"));
    return () => this.#change((record) => merged(record, before));
  }

  // -- keeping -----------------------------------------------------------------------

  #add(lesson: string, task: string, news: TaskRecord): void {
    const tasks = new Map([[keyOf(lesson, task), news]]);
    this.#change((record) => merged(record, { tasks, last: null }));
  }

  /** Changes what is kept now, which another tab may have changed since it was read. */
  #change(change: (record: ProgressRecord) => ProgressRecord): void {
    this.#record = change(this.#load());
    this.#kept = this.#store.keep(NAME, writeProgress(this.#record));
    this.dispatchEvent(new Event("change"));
  }

  #load(): ProgressRecord {
    const text = this.#store.load(NAME);
    const record = text === null ? NO_PROGRESS : readProgress(text);
    // What somebody else wrote under this name is no progress of ours.
    return typeof record === "string" ? NO_PROGRESS : record;
  }
}
