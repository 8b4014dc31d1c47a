/**
 * Earlier versions of a program: a short list, newest first, that never holds a text twice.
 * Pure; what keeps it is `kept-program.ts`. Imports nothing of ours.
 */

export interface Version {
  /** When it was put aside [ms since 1970]. */
  at: number;
  text: string;
}

/** The last moment that a date can tell [ms since 1970]. */
const LAST_MOMENT = 8.64e15;
export const MOST_VERSIONS = 30;
/** All texts together; the newest is kept whatever its length [characters]. */
export const MOST_CHARACTERS = 200_000;

/** The list with one more; the oldest go where there is no room. */
export function withVersion(list: readonly Version[], version: Version): Version[] {
  const others = list.filter(({ text }) => text !== version.text);
  let room = MOST_CHARACTERS - version.text.length;
  const fit = others.findIndex(({ text }) => {
    room -= text.length;
    return room < 0;
  });
  const kept = fit < 0 ? others : others.slice(0, fit);
  return [version, ...kept].slice(0, MOST_VERSIONS);
}

/** What `JSON.stringify` made of a list; whatever is not a version is left out. */
export function readVersions(json: string | null): Version[] {
  let list: unknown;
  try {
    list = JSON.parse(json ?? "[]");
  } catch {
    return [];
  }
  return Array.isArray(list) ? list.filter(isVersion) : [];
}

function isVersion(item: unknown): item is Version {
  return (
    typeof item === "object" &&
    item !== null &&
    "at" in item &&
    "text" in item &&
    Number.isFinite(item.at) &&
    Math.abs(Number(item.at)) <= LAST_MOMENT &&
    typeof item.text === "string"
  );
}

/** So much of a text is worth a version before it goes, and of a short one this [characters]. */
const LARGE = 40;
const LARGE_OF_SHORT = 4;

/** How many characters of a text another has no longer, between what both begin and end with. */
export function lostFrom(text: string, other: string): number {
  const most = Math.min(text.length, other.length);
  let start = 0;
  while (start < most && text[start] === other[start]) start++;
  let end = 0;
  while (end < most - start && text.at(-1 - end) === other.at(-1 - end)) end++;
  return text.length - start - end;
}

/** Whether so much is lost of a text that it should be kept; with `half`, half of a short one too. */
export function isLargeLoss(text: string, lost: number, half: boolean): boolean {
  return lost >= LARGE || (half && lost >= LARGE_OF_SHORT && lost >= text.trim().length / 2);
}

export interface Change {
  /** The first and last line of `text` that are not in the other, 1 first; last < first if none. */
  first: number;
  last: number;
}

/** Where a text differs from another: from the first line that does to the last. Null if nowhere. */
export function changeFrom(other: string, text: string): Change | null {
  if (other === text) return null;
  const theirs = other.split("\n");
  const mine = text.split("\n");
  let start = 0;
  while (start < mine.length && start < theirs.length && mine[start] === theirs[start]) start++;
  let end = 0;
  const most = Math.min(mine.length, theirs.length) - start;
  while (end < most && mine.at(-1 - end) === theirs.at(-1 - end)) end++;
  return { first: start + 1, last: mine.length - end };
}
