/**
 * The program of one lab on one world, kept as it is typed, with its earlier versions.
 *
 * Another tab may have the same lab open. What it kept is never written over unseen: it goes into
 * the versions first. May import `storage` and `versions`.
 */
import type { ProgramStore } from "./storage.ts";
import { isLargeLoss, lostFrom, readVersions, type Version, withVersion } from "./versions.ts";

/** Typing is kept once it pauses for this long; leaving the page keeps it at once. */
const PAUSE_MS = 250;
/** Who types without a pause has it kept so often. */
const LONGEST_MS = 1000;

export class KeptProgram {
  readonly #store: ProgramStore;
  readonly #key: string;
  readonly #starter: string;
  readonly #onRefused: () => void;
  /** What this tab kept or found last. */
  #last: string | null = null;
  #unkept: string | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** When the text that waits to be kept has to be, however fast the typing goes on. */
  #latest: number | null = null;
  /** The fullest text since the last version, and the one before this change. */
  #fullest: string;
  #before: string;
  /** What the other tab had when it was last put aside. */
  #theirs: string | null = null;

  /** `onRefused` is called each time the device would not keep what was typed. */
  constructor(store: ProgramStore, key: string, starter: string, onRefused: () => void) {
    this.#store = store;
    this.#key = key;
    this.#starter = starter;
    this.#onRefused = onRefused;
    this.#last = this.load();
    this.#before = this.#last ?? starter;
    this.#fullest = this.#before;
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

  changed(program: string, now = Date.now()): void {
    this.#guard(program, now);
    this.#unkept = program;
    this.#latest ??= now + LONGEST_MS;
    clearTimeout(this.#timer);
    const wait = Math.max(0, Math.min(PAUSE_MS, this.#latest - now));
    this.#timer = setTimeout(() => this.flush(), wait);
  }

  /** Before much of a text goes, at one stroke or one by one, it is put aside. */
  #guard(program: string, now: number): void {
    const lost = lostFrom(this.#fullest, program);
    const atOnce = lostFrom(this.#before, program);
    if (isLargeLoss(this.#before, atOnce, true)) this.putAside(this.#before, now);
    else if (isLargeLoss(this.#fullest, lost, program.trim() === "")) {
      this.putAside(this.#fullest, now);
    } else if (program.length < this.#fullest.length) {
      this.#before = program;
      return;
    }
    this.#before = program;
    this.#fullest = program;
  }

  /** Keeps what has been typed now. */
  flush(): void {
    clearTimeout(this.#timer);
    const program = this.#unkept;
    if (program === null) return;
    this.#unkept = null;
    this.#latest = null;
    const theirs = this.load();
    if (theirs !== null && theirs !== this.#last && theirs !== program)
      this.#putTheirsAside(theirs);
    if (program === this.#starter) this.#forget();
    else this.#keep(program);
  }

  /** Where both tabs are typed in, the other's text grows: one version of it is enough. */
  #putTheirsAside(theirs: string): void {
    const before = this.#theirs;
    const isGrown = before !== null && !isLargeLoss(before, lostFrom(before, theirs), true);
    this.#theirs = theirs;
    this.putAside(theirs, Date.now(), isGrown ? before : null);
  }

  /**
   * Keeps a text as a version to go back to, in the place of another if it is more of the same. The
   * starter needs none: Reset program has it.
   */
  putAside(text: string, now = Date.now(), inPlaceOf: string | null = null): void {
    if (text === this.#starter || text.trim() === "") return;
    const others = this.versions().filter((version) => version.text !== inPlaceOf);
    const list = withVersion(others, { at: now, text });
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
