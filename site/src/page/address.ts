/**
 * The lab's address: `?world=NAME&seed=N`, read with care and written back.
 * May import `trace` and `ui`.
 */
import type { World } from "../trace/events.ts";
import { pickerWords } from "../ui/strings.ts";

/** The largest seed the pickers offer. */
export const MOST_SEED = 999_999;
export const FIRST_SEED = 1;

export interface Place {
  world: string;
  seed: number;
}

export interface ReadAddress extends Place {
  /** The name asked for, where there is no such world. */
  unknownWorld: string | null;
  /** What is wrong with the seed, or null. */
  seedProblem: string | null;
}

/** What an address asks for; whatever it gets wrong is replaced and reported. */
export function readAddress(search: string, worlds: readonly World[]): ReadAddress {
  const query = new URLSearchParams(search);
  const first = worlds[0];
  if (!first) throw new Error("readAddress: the site was built without a world");
  const asked = query.get("world");
  const world = asked === null ? first : worlds.find(({ name }) => name === asked);
  const seedText = query.get("seed");
  const seed = seedText === null ? FIRST_SEED : readSeed(seedText);
  return {
    world: (world ?? first).name,
    seed: seed ?? FIRST_SEED,
    unknownWorld: world ? null : asked,
    seedProblem: seed === null ? pickerWords.badSeed(seedText ?? "", MOST_SEED, FIRST_SEED) : null,
  };
}

/** A seed as typed, or null if it is not a whole number in range. */
export function readSeed(text: string): number | null {
  const trimmed = text.trim();
  if (!/^\d{1,9}$/.test(trimmed)) return null;
  const seed = Number(trimmed);
  return seed <= MOST_SEED ? seed : null;
}

/** The query that leads back to a world and seed; a world that the link brings along has no name. */
export function writeAddress({ world, seed }: { world?: string; seed: number }): string {
  return `?${new URLSearchParams({ ...(world === undefined ? {} : { world }), seed: String(seed) })}`;
}
