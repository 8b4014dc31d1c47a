/**
 * Programs kept on this device, one for each lab and world. Imports nothing of ours.
 */

/** Typing is kept once it pauses for this long; leaving the page keeps it at once. */
const PAUSE_MS = 250;

const PREFIX = "bugbot:program:";

export class ProgramStore {
  readonly #storage: () => Storage;

  /** `storage` is asked for each time: where it is forbidden, even naming it throws. */
  constructor(storage: () => Storage = () => localStorage) {
    this.#storage = storage;
  }

  /** The kept program, or null where there is none or storage is refused. */
  load(key: string): string | null {
    try {
      return this.#storage().getItem(PREFIX + key);
    } catch {
      return null;
    }
  }

  /** Keeps a program; says whether that worked, so that the page can tell. */
  keep(key: string, program: string): boolean {
    try {
      this.#storage().setItem(PREFIX + key, program);
      return true;
    } catch {
      return false;
    }
  }

  forget(key: string): void {
    try {
      this.#storage().removeItem(PREFIX + key);
    } catch {
      // Where nothing may be stored, nothing was.
    }
  }
}

/** The program of one lab on one world, kept as it is typed. */
export class KeptProgram {
  readonly #store: ProgramStore;
  readonly #key: string;
  readonly #starter: string;
  readonly #onRefused: () => void;
  #unkept: string | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** `onRefused` is called each time the device would not keep what was typed. */
  constructor(store: ProgramStore, key: string, starter: string, onRefused: () => void) {
    this.#store = store;
    this.#key = key;
    this.#starter = starter;
    this.#onRefused = onRefused;
  }

  /** The learner's version, or null where there is none but the starter. */
  load(): string | null {
    return this.#store.load(this.#key);
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
    // An untouched starter is not kept, so that a better one in a newer site is seen.
    if (program === this.#starter) this.#store.forget(this.#key);
    else if (!this.#store.keep(this.#key, program)) this.#onRefused();
  }
}
