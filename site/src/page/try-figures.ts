/**
 * What an experiment has come to, beside the run without it: the end of each line of the chart, how
 * many cells each layer has, and what was printed last. Pure. May import `trace`.
 */
import type { Layer } from "../trace/events.ts";
import type { Trace } from "../trace/trace.ts";

export interface TriedFigure {
  name: string;
  kind: "value" | "cells" | "printed";
  now: string | number;
  /** Null if the run without it has none. */
  before: string | number | null;
}

/** More than these nobody takes in at a glance; the lab has them all. */
export const MOST_FIGURES = 6;

/** Both runs have ended; `before` is null if there is nothing to compare with. */
export function triedFigures(now: Trace, before: Trace | null): TriedFigure[] {
  const ends = before && lastValues(before);
  const counts = before && cellCounts(before);
  const found: TriedFigure[] = [
    ...[...lastValues(now)].map(([name, value]) => {
      return { name, kind: "value" as const, now: value, before: ends?.get(name) ?? null };
    }),
    ...[...cellCounts(now)].map(([name, count]) => {
      return { name, kind: "cells" as const, now: count, before: counts?.get(name) ?? null };
    }),
  ];
  const printed = lastLine(now);
  const printedBefore = before && lastLine(before);
  if (printed !== "" && printed !== printedBefore) {
    found.push({ name: "", kind: "printed", now: printed, before: printedBefore || null });
  }
  return found.slice(0, MOST_FIGURES);
}

function lastValues(trace: Trace): Map<string, number> {
  const ends = Array.from(trace.series, ([name, { value }]): [string, number] => {
    return [name, value.at(value.length - 1)];
  });
  return new Map(ends);
}

const isCells = ({ shape }: Layer): boolean => shape === "squares";

function cellCounts(trace: Trace): Map<string, number> {
  const layers = trace.layersAt(trace.duration).filter(isCells);
  return new Map(layers.map(({ name, count }) => [name, count]));
}

function lastLine(trace: Trace): string {
  return trace.consoleText(trace.duration).trimEnd().split("\n").at(-1) ?? "";
}
