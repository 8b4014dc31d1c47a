/**
 * A learner's progress, kept on this device and nowhere else. Dispatches "change" when it has
 * changed, here or in another tab. May import `ui`.
 */
import { progressWords } from "../ui/progress-words.ts";
import {
  countedBy,
  keyOf,
  MOST_TASKS,
  merged,
  NO_PROGRESS,
  type Place,
  type ProgressRecord,
  readAll,
  readProgress,
  type TaskRecord,
  writeProgress,
} from "./progress-record.ts";
import type { ProgramStore } from "./storage.ts";

export type { Place, ScoreRecord, TaskRecord } from "./progress-record.ts";

/** The name it is kept under. */
const NAME = "progress";
/** Where it is kept while a newer version of the site has its own under that name. */
const BESIDE = "progress:beside";
/** What stood under the name and could not be read, as it was. */
const ASIDE = "progress:aside";
/** A device where this goes wrong more often than so has other troubles. */
const MOST_ASIDE = 9;

/** What is kept on this device and can't be read: a newer version's, or a damaged record. */
export interface Unread {
  why: "newer" | "damaged";
  /** As it stands there. */
  text: string;
}

/** A text that is no progress; the message is for the reader. */
export class ProgressError extends Error {
  override readonly name = "ProgressError";
}

export class Progress extends EventTarget {
  readonly #store: ProgramStore;
  readonly #now: () => number;
  #record: ProgressRecord;
  #kept = true;
  #place = NAME;

  constructor(store: ProgramStore, now: () => number = Date.now) {
    super();
    this.#store = store;
    this.#now = now;
    this.#record = this.#load();
  }

  /** Hears what other tabs do, for as long as the page lives. */
  listen(): void {
    this.#store.onElsewhere((name) => {
      if (name !== NAME && name !== BESIDE) return;
      this.#record = this.#load();
      this.dispatchEvent(new Event("change"));
    });
  }

  // -- what is known ---------------------------------------------------------------

  /** False once this device has refused to keep it: it lasts as long as the page then. */
  get kept(): boolean {
    return this.#kept;
  }

  /** What is here and can't be read. It is never written over. */
  get unread(): Unread[] {
    const now = this.#store.load(NAME);
    const { whole, wrong } = readAll(now ?? "");
    const asides = this.#asides().map(({ text }): Unread => ({ why: "damaged", text }));
    if (now === null || whole) return asides;
    if (wrong === "newer") return [...asides, { why: "newer", text: now }];
    return asides.some(({ text }) => text === now)
      ? asides
      : [...asides, { why: "damaged", text: now }];
  }

  /** The reader has no use for what was put aside. */
  forgetAsides(): void {
    const forget = (): void => {
      for (const { name } of this.#asides()) this.#store.forget(name);
    };
    forget();
    // A damaged record that nothing has been kept after is still in its own place.
    if (this.#place === NAME) this.#change((record) => record);
    forget();
    this.dispatchEvent(new Event("change"));
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
    this.#add(lesson, task, { state: "tried", hints: 0, solution: false, at, score }, (record) =>
      countedBy(record, of),
    );
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
    if (merged(this.#load(), read).tasks.size > MOST_TASKS) {
      throw new ProgressError(progressWords.tooMany(MOST_TASKS));
    }
    this.#change((record) => merged(record, read));
    const states = [...this.#record.tasks].filter(
      ([key, { state }]) => before.get(key)?.state !== state,
    );
    return { added: states.length };
  }

  /** Forgets all of it. Returns what brings it back. */
  clear(): () => void {
    const before = this.#record;
    const unread = this.#store.load(NAME);
    const isForeign = unread !== null && !readAll(unread).whole;
    for (const name of [NAME, BESIDE]) this.#store.forget(name);
    this.#record = NO_PROGRESS;
    this.dispatchEvent(new Event("change"));
    return () => {
      if (isForeign && this.#store.load(NAME) === null) this.#store.keep(NAME, unread);
      this.#change((record) => merged(record, before));
    };
  }

  // -- keeping -----------------------------------------------------------------------

  #add(
    lesson: string,
    task: string,
    news: TaskRecord,
    also = (record: TaskRecord): TaskRecord => record,
  ): void {
    const key = keyOf(lesson, task);
    const tasks = new Map([[key, news]]);
    this.#change((record) => {
      const both = merged(record, { tasks, last: null });
      return { ...both, tasks: new Map(both.tasks).set(key, also(both.tasks.get(key) ?? news)) };
    });
  }

  /** Changes what is kept now, which another tab may have changed since it was read. */
  #change(change: (record: ProgressRecord) => ProgressRecord): void {
    this.#record = change(this.#load());
    this.#kept = this.#putAside() && this.#store.keep(this.#place, writeProgress(this.#record));
    if (this.#place === NAME) this.#store.forget(BESIDE);
    this.dispatchEvent(new Event("change"));
  }

  /** What this device has, as far as it can be read. */
  #load(): ProgressRecord {
    const text = this.#store.load(NAME);
    const beside = readAll(this.#store.load(BESIDE) ?? "").record;
    const { record, wrong } = text === null ? { record: NO_PROGRESS, wrong: null } : readAll(text);
    this.#place = wrong === "newer" ? BESIDE : NAME;
    return merged(record, beside);
  }

  /** Before a record that can't be read is written over: as it was, under another name. */
  #putAside(): boolean {
    const text = this.#store.load(NAME);
    if (this.#place !== NAME || text === null || readAll(text).whole) return true;
    const asides = this.#asides();
    if (asides.some((aside) => aside.text === text)) return true;
    const used = asides.map(({ name }) => name);
    const free = asideNames().find((name) => !used.includes(name));
    return free !== undefined && this.#store.keep(free, text);
  }

  #asides(): { name: string; text: string }[] {
    return asideNames().flatMap((name) => {
      const text = this.#store.load(name);
      return text === null ? [] : [{ name, text }];
    });
  }
}

function asideNames(): string[] {
  return Array.from({ length: MOST_ASIDE }, (_, index) => `${ASIDE}${index || ""}`);
}
