/**
 * The chart's lines as plain numbers: joined on one axis of time, as a table, as CSV.
 * May import `trace`.
 */
import type { Series } from "../trace/store.ts";
import type { Trace } from "../trace/trace.ts";

/** A program may plot under more names than anyone can tell apart; this many are drawn. */
export const MOST_LINES = 12;
/** Points of a median or a band: more than the chart has pixels would be for nothing. */
const SPREAD_POINTS = 600;

/** One pattern a line, besides its colour: solid, dashed, dotted, … */
const DASHES: readonly (readonly number[])[] = [[], [7, 4], [2, 3], [10, 3, 2, 3], [14, 4], [5, 2]];

export const dashOf = (index: number): readonly number[] => DASHES[index % DASHES.length] ?? [];

/** What a line is of: this run, the run before, or many runs. */
export type Role = "run" | "earlier" | "median" | "low" | "high";

export interface Line {
  name: string;
  role: Role;
  t: ArrayLike<number>;
  value: ArrayLike<number>;
}

/** Every line to draw, the ones behind first; lines of one name together. */
export function linesOf(trace: Trace, earlier: Trace | null, runs: readonly Trace[]): Line[] {
  return shownNames(trace, runs).flatMap((name): Line[] => {
    const lines = spread(runs, name);
    for (const [role, run] of [
      ["earlier", earlier],
      ["run", trace],
    ] as const) {
      const series = run?.series.get(name);
      if (series) lines.push({ name, role, t: series.t.view(), value: series.value.view() });
    }
    return lines;
  });
}

/** The names that are drawn, in order of first plotting. */
export function shownNames(trace: Trace, runs: readonly Trace[]): string[] {
  const names = new Set([trace, ...runs].flatMap((run) => [...run.series.keys()]));
  return [...names].slice(0, MOST_LINES);
}

/** Lowest, median and highest value over runs, each run's value held until its next. */
function spread(runs: readonly Trace[], name: string): Line[] {
  const all = runs.flatMap((run) => run.series.get(name) ?? []);
  if (all.length === 0) return [];
  const t = thinned(unionOf(all.map((series) => series.t.view())), SPREAD_POINTS);
  const low: number[] = [];
  const median: number[] = [];
  const high: number[] = [];
  for (const time of t) {
    const values = all.flatMap((series) => valueAt(series, time) ?? []).sort((a, b) => a - b);
    const middle = (values.length - 1) / 2;
    low.push(values[0] as number);
    median.push(
      ((values[Math.floor(middle)] as number) + (values[Math.ceil(middle)] as number)) / 2,
    );
    high.push(values.at(-1) as number);
  }
  return [
    { name, role: "low", t, value: low },
    { name, role: "high", t, value: high },
    { name, role: "median", t, value: median },
  ];
}

/** A line's value at a time: what was plotted last by then. */
export function valueAt(series: Series, t: number): number | null {
  const index = series.t.lastUpTo(t);
  return index < 0 ? null : series.value.at(index);
}

/**
 * The lines on one axis of times: `[times, values, values, …]`, with undefined where a line has no
 * value of its own. Of several values at one time the last counts.
 */
export function joined(
  lines: readonly Pick<Line, "t" | "value">[],
): [Float64Array, ...(number | undefined)[][]] {
  const times = unionOf(lines.map((line) => line.t));
  const columns = lines.map(({ t, value }) => {
    const column = new Array<number | undefined>(times.length).fill(undefined);
    let at = 0;
    for (let i = 0; i < t.length; i++) {
      while ((times[at] as number) < (t[i] as number)) at++;
      column[at] = value[i] as number;
    }
    return column;
  });
  return [times, ...columns];
}

/** The distinct times of several lines, rising. */
function unionOf(lines: readonly ArrayLike<number>[]): Float64Array {
  const all = new Float64Array(lines.reduce((sum, line) => sum + line.length, 0));
  let filled = 0;
  for (const line of lines) {
    all.set(line, filled);
    filled += line.length;
  }
  all.sort();
  return all.filter((time, i) => i === 0 || time !== all[i - 1]);
}

/** At most so many of some times, evenly, the last among them. */
export function thinned(times: Float64Array, most: number): Float64Array {
  if (times.length <= most) return times;
  const last = times.length - 1;
  return Float64Array.from(
    { length: most },
    (_, i) => times[Math.round((i * last) / (most - 1))] as number,
  );
}

export interface Table {
  names: string[];
  rows: { t: number; values: (number | null)[] }[];
  /** How many times there are in all. */
  all: number;
}

/** The values at no more than so many times, each held until the next. */
export function tableOf(trace: Trace, most: number): Table {
  const lines = [...trace.series];
  const times = unionOf(lines.map(([, series]) => series.t.view()));
  return {
    names: lines.map(([name]) => name),
    rows: Array.from(thinned(times, most), (t) => ({
      t,
      values: lines.map(([, series]) => valueAt(series, t)),
    })),
    all: times.length,
  };
}

/** All that was plotted, as CSV (RFC 4180): a row per time, an empty field where nothing was. */
export function csvOf(trace: Trace): string {
  const lines = [...trace.series];
  const [times, ...columns] = joined(
    lines.map(([, series]) => ({ t: series.t.view(), value: series.value.view() })),
  );
  const rows = [["time [s]", ...lines.map(([name]) => name)]];
  times.forEach((t, i) => {
    rows.push([String(t), ...columns.map((column) => String(column[i] ?? ""))]);
  });
  return rows.map((row) => `${row.map(field).join(",")}\r\n`).join("");
}

function field(text: string): string {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** A value in a few signs: 64.1, -0.4, 12345, 1.235e+7. */
export function short(value: number): string {
  const size = Math.abs(value);
  if (size >= 1e6) return value.toExponential(3);
  return size >= 1000 ? value.toFixed(0) : String(Number(value.toPrecision(4)));
}
