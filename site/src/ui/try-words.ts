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

/** An end of a line of the chart: 5.4, −0.85, 1,204. */
const value = (number: number): string => {
  const digits = Math.abs(number) < 10 ? 2 : 1;
  const text = number.toLocaleString("en-GB", { maximumFractionDigits: digits });
  return minus(text === "-0" ? "0" : text);
};

const changed = (changes: readonly Change[]): string =>
  `${changes.map(({ name, from, to }) => `${name} = ${minus(to)} in place of ${minus(from)}`).join(", ")}.`;

interface Figure {
  name: string;
  kind: "value" | "cells" | "printed";
  now: string | number;
  before: string | number | null;
}

const shown = ({ kind }: Figure, what: string | number): string =>
  kind === "printed" ? `“${what}”` : value(Number(what));

export const tryWords = {
  changed,
  tried: (changes: readonly Change[]) => `${changed(changes)} Thin lines: the run without it.`,
  same: (changes: readonly Change[]) =>
    `${changes.map(({ name, to }) => `${name} is ${minus(to)}`).join(", ")} in this program already.`,
  undone: (changes: readonly Change[]) =>
    `${changes.map(({ name, from }) => `${name} is ${minus(from)}`).join(", ")} again.`,
  missing: (names: readonly string[]) =>
    `This cannot be tried: the program has no line ${names.map((name) => `${name} = …`).join(" and no line ")} with a number. Nothing has been changed.`,

  /** Beside the button. */
  result: "What came of it",
  running: "Running …",
  seeInLab: "See it in the lab",
  before: "before",
  now: "now",
  mapOf: (which: string) => `The map at the end, ${which}`,
  /** "known %: 5.4, before 72.1." */
  figure: (figure: Figure) => {
    const { name, kind, now, before } = figure;
    const what = kind === "printed" ? "Printed" : name;
    const unit = kind === "cells" ? ` ${now === 1 ? "cell" : "cells"}` : "";
    const compared =
      before === null ? "" : before === now ? ", as before" : `, before ${shown(figure, before)}`;
    return `${what}: ${shown(figure, now)}${unit}${compared}.`;
  },
  changedSince: "The program has been changed since. In the lab, undo takes that back first.",
};
