/**
 * The program of one lab on one world, kept as it is typed, with its earlier versions.
 *
 * Another tab may have the same lab open. What it kept is never written over unseen: it goes into
 * the versions first. May import `storage` and `versions`.
 */
import type { ProgramStore } from "./storage.ts";
import { readVersions, type Version, withVersion } from "./versions.ts";

/** Typing is kept once it pauses for this long; leaving the page keeps it at once. */
const PAUSE_MS = 250;

export class KeptProgram {
  readonly #store: ProgramStore;
  readonly #key: string;
  readonly #starter: string;
  readonly #onRefused: () => void;
  /** What this tab kept or found last. */
  #last: string | null = null;
  #unkept: string | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** `onRefused` is called each time the device would not keep what was typed. */
  constructor(store: ProgramStore, key: string, starter: string, onRefused: () => void) {
    this.#store = store;
    this.#key = key;
    this.#starter = starter;
    this.#onRefused = onRefused;
    this.#last = this.load();
  }

  /** The learner's program as it was kept last, in any tab; null where there is only the starter. */
  load(): string | null {
    return this.#store.load(this.#name("program"));
  }

  /** Whether a text of this name in the store is this program. */
  isNamed(name: string): boolean {
    return name === this.#name("program");
  }

  /** True if the learner began from another starter than this page has now. */
  get outgrown(): boolean {
    const begun = this.#store.load(this.#name("starter"));
    return this.#last !== null && begun !== null && begun !== this.#starter;
  }

  /** From now on the program counts as begun from this page's starter. */
  beginsHere(): void {
    this.#store.keep(this.#name("starter"), this.#starter);
  }

  changed(program: string): void {
    this.#unkept = program;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.flush(), PAUSE_MS);
  }

  /** Keeps what has been typed now. */
  flush(): void {
    clearTimeout(this.#timer);
    const program = this.#unkept;
    if (program === null) return;
    this.#unkept = null;
    const theirs = this.load();
    if (theirs !== null && theirs !== this.#last && theirs !== program) this.putAside(theirs);
    if (program === this.#starter) this.#forget();
    else this.#keep(program);
  }

  /** Keeps a text as a version to go back to. The starter needs none: Reset program has it. */
  putAside(text: string, now = Date.now()): void {
    if (text === this.#starter || text.trim() === "") return;
    const list = withVersion(this.versions(), { at: now, text });
    const keep = (most: number): boolean =>
      this.#store.keep(this.#name("versions"), JSON.stringify(list.slice(0, most)));
    // On a full device the newest few are better than none.
    for (let most = list.length; most > 0; most >>= 1) if (keep(most)) return;
    keep(list.length);
  }

  /** Newest first. */
  versions(): Version[] {
    return readVersions(this.#store.load(this.#name("versions")));
  }

  /** An untouched starter is not kept, so that a better one in a newer site is seen. */
  #forget(): void {
    this.#last = null;
    this.#store.forget(this.#name("program"));
    this.#store.forget(this.#name("starter"));
  }

  #keep(program: string): void {
    const begins = this.load() === null;
    this.#last = program;
    const kept = this.#store.keep(this.#name("program"), program);
    if (begins) this.beginsHere();
    if (!kept) this.#onRefused();
  }

  #name(what: "program" | "starter" | "versions"): string {
    return `${what}:${this.#key}`;
  }
}
