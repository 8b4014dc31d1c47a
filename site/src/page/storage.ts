/**
 * Texts kept on this device, by name. Where the device refuses, in private browsing or because its
 * storage is full, they last as long as the page. Imports nothing of ours.
 */
const PREFIX = "bugbot:";

export class ProgramStore {
  readonly #storage: () => Storage;
  readonly #prefix: string;
  /** What the device would not keep; newer than what it may still hold under the same name. */
  readonly #refused = new Map<string, string>();

  /**
   * `storage` is asked for each time: where it is forbidden, even naming it throws. What is kept for
   * somebody by name is apart from what is kept for everybody else; for somebody without a name (an
   * empty text) nothing is kept, as nobody knows who comes next.
   */
  constructor(storage: () => Storage = () => localStorage, keptFor?: string) {
    this.#storage = keptFor === "" ? nothing : storage;
    this.#prefix = keptFor ? `${PREFIX}${keptFor}:` : PREFIX;
  }

  load(name: string): string | null {
    const refused = this.#refused.get(name);
    if (refused !== undefined) return refused;
    try {
      return this.#storage().getItem(this.#prefix + name);
    } catch {
      return null;
    }
  }

  /** Keeps a text; says whether the device did, so that the page can tell. */
  keep(name: string, text: string): boolean {
    try {
      this.#storage().setItem(this.#prefix + name, text);
      this.#refused.delete(name);
      return true;
    } catch {
      this.#refused.set(name, text);
      return false;
    }
  }

  forget(name: string): void {
    this.#refused.delete(name);
    try {
      this.#storage().removeItem(this.#prefix + name);
    } catch {
      // Where nothing may be stored, nothing was.
    }
  }

  /** Tells when another tab keeps or forgets a text. Returns the function that ends it. */
  onElsewhere(callback: (name: string) => void): () => void {
    const listener = ({ key }: StorageEvent): void => {
      if (key?.startsWith(this.#prefix)) callback(key.slice(this.#prefix.length));
    };
    addEventListener("storage", listener);
    return () => removeEventListener("storage", listener);
  }
}

function nothing(): Storage {
  throw new Error("nothing is kept for somebody without a name");
}
