/**
 * The words of the Try buttons. Imports nothing of ours.
 *
 * The same voice as `strings.ts`: say what happened, then what to do.
 */

const minus = (number: string): string => number.replace("-", "−");

export interface Change {
  name: string;
  /** As they stand in the program. */
  from: string;
  to: string;
}

export const tryWords = {
  tried: (changes: readonly Change[]) =>
    `${changes.map(({ name, from, to }) => `${name} = ${minus(to)} in place of ${minus(from)}`).join(", ")}. Thin lines: the run without it.`,
  same: (changes: readonly Change[]) =>
    `${changes.map(({ name, to }) => `${name} is ${minus(to)}`).join(", ")} in this program already.`,
  undone: (changes: readonly Change[]) =>
    `${changes.map(({ name, from }) => `${name} is ${minus(from)}`).join(", ")} again.`,
  missing: (names: readonly string[]) =>
    `This cannot be tried: the program has no line ${names.map((name) => `${name} = …`).join(" and no line ")} with a number. Nothing has been changed.`,
};
