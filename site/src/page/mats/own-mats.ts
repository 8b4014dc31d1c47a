/**
 * The mats that were made on this device, kept as they are drawn. Each has a name of its own for
 * good, `own_` and six signs, that no world of the site has: programs are kept by it.
 *
 * Another tab may have its own mats open: every change starts from what the device holds.
 * May import `trace` and, above, `storage`.
 */
import type { World } from "../../trace/events.ts";
import type { ProgramStore } from "../storage.ts";
import { readDraft, readWorld, WorldError } from "./check-world.ts";
import { isOwnMat } from "./own-name.ts";

const RECORD = "mats";
/** What stood there and was no record at all, before it is written over. */
const ASIDE = "mats:aside";
const FORMAT = 1;

export interface OwnMat {
  world: World;
  /** When it was last changed [ms since 1970]. */
  at: number;
}

export class OwnMats {
  readonly #store: ProgramStore;

  constructor(store: ProgramStore) {
    this.#store = store;
  }

  /** The last changed first. What another program may have left in the record is passed over. */
  all(): OwnMat[] {
    return readRecord(this.#store.load(RECORD)).sort((a, b) => b.at - a.at);
  }

  /** Those that a robot can be put on, in the order of their titles. */
  worlds(): World[] {
    const sound = this.all().map(({ world }) => world);
    return sound.filter(isSound).sort((a, b) => a.title.localeCompare(b.title, "en-GB"));
  }

  find(name: string): World | null {
    return this.all().find(({ world }) => world.name === name)?.world ?? null;
  }

  /** Keeps a mat under its name; says whether the device did. */
  keep(world: World, now = Date.now()): boolean {
    const others = this.all().filter(({ world: { name } }) => name !== world.name);
    return this.#write([{ world, at: now }, ...others]);
  }

  /** Removes a mat; what comes back brings it back. */
  remove(name: string): () => void {
    const all = this.all();
    const gone = all.find(({ world }) => world.name === name);
    this.#write(all.filter((each) => each !== gone));
    return () => {
      if (gone) this.keep(gone.world, gone.at);
    };
  }

  /** A name that no mat has yet. */
  newName(random: () => number = Math.random): string {
    const names = this.all().map(({ world }) => world.name);
    for (;;) {
      const signs = Math.floor(random() * 36 ** 6)
        .toString(36)
        .padStart(6, "0");
      const name = `own_${signs}`;
      if (!names.includes(name)) return name;
    }
  }

  /** Tells when another tab has changed the mats. Returns the function that ends it. */
  onElsewhere(callback: () => void): () => void {
    return this.#store.onElsewhere((name) => {
      if (name === RECORD) callback();
    });
  }

  /** What can't be read here, of a newer version of the site say, stays in the record as it is. */
  #write(mats: readonly OwnMat[]): boolean {
    const text = this.#store.load(RECORD);
    const entries = entriesOf(text);
    if (text !== null && entries === null && !this.#store.keep(ASIDE, text)) return false;
    const foreign = entries?.filter((entry) => readMat(entry).length === 0) ?? [];
    return this.#store.keep(
      RECORD,
      JSON.stringify({ format: FORMAT, mats: [...mats, ...foreign] }),
    );
  }
}

export function isSound(world: World): boolean {
  try {
    readWorld(world);
    return true;
  } catch (error) {
    if (error instanceof WorldError) return false;
    throw error;
  }
}

function readRecord(text: string | null): OwnMat[] {
  return entriesOf(text)?.flatMap(readMat) ?? [];
}

/** What the record lists, whatever it is; null if it lists nothing. */
function entriesOf(text: string | null): unknown[] | null {
  try {
    const { mats } = (JSON.parse(text ?? "null") ?? {}) as { mats?: unknown };
    return Array.isArray(mats) ? mats : null;
  } catch {
    return null;
  }
}

function readMat(value: unknown): OwnMat[] {
  const { world, at } = (value ?? {}) as Record<string, unknown>;
  try {
    const read = readDraft(world);
    return isOwnMat(read.name) && typeof at === "number" ? [{ world: read, at }] : [];
  } catch (error) {
    if (error instanceof WorldError) return [];
    throw error;
  }
}
