/**
 * From the outcomes of runs to the number that a figure shows, and how it is written.
 * Imports `faults` (words) and the grammar's types.
 *
 * @typedef {import("./figure-grammar.mjs").Figure} Figure
 * @typedef {import("./figure-grammar.mjs").Quantity} Quantity
 * @typedef {import("./figure-grammar.mjs").CheckReference} CheckReference
 * @typedef {{
 *   status: string, message: string, seconds: number, console: string,
 *   pose: { x: number, y: number, heading: number },
 *   series: Record<string, [number, number][]>,
 *   layers: Record<string, { shape: string, size: number, colour: string, points: [number, number][] }>,
 *   fault: { line: number | null } | null,
 * }} Outcome as bugbot.run.outcome_of makes it
 */
import { listText } from "./faults.mjs";

/** A run has no such quantity; the message says what there is. */
export class NoSuchQuantity extends Error {}

/** Times are written with two decimals at most; a plot may be a rounding error later [s]. */
const SAME_TIME_S = 1e-6;

/**
 * @param {Figure} figure
 * @param {readonly Outcome[]} outcomes one for each of its seeds
 * @returns {number}
 */
export function figureValue(figure, outcomes) {
  const values = outcomes.map((outcome) => quantityOf(figure.quantity, outcome));
  values.sort((a, b) => a - b);
  const low = values[0] ?? Number.NaN;
  const high = values.at(-1) ?? Number.NaN;
  if (figure.over === "highest") return high;
  if (figure.over !== "median") return low;
  const middle = (values.length - 1) / 2;
  return ((values[Math.floor(middle)] ?? low) + (values[Math.ceil(middle)] ?? high)) / 2;
}

/**
 * @param {Quantity} quantity
 * @param {Outcome} outcome
 */
function quantityOf(quantity, outcome) {
  switch (quantity.kind) {
    case "pose":
      return quantity.part === "seconds" ? outcome.seconds : outcome.pose[quantity.part];
    case "count": {
      const layer = outcome.layers[quantity.layer];
      if (layer) return layer.points.length;
      throw missing("draws no layer", quantity.layer, Object.keys(outcome.layers));
    }
    case "printed":
      return printedAfter(quantity.after, outcome.console);
    case "series": {
      const points = outcome.series[quantity.name];
      if (points) return pickFrom(points, quantity);
      throw missing("plots no line", quantity.name, Object.keys(outcome.series));
    }
  }
}

/**
 * @param {readonly [number, number][]} points
 * @param {Extract<Quantity, { kind: "series" }>} quantity
 */
function pickFrom(points, { pick, name, at }) {
  const values = points.map(([, value]) => value);
  switch (pick) {
    case "end":
      return values.at(-1) ?? Number.NaN;
    case "highest":
      return values.reduce((a, b) => Math.max(a, b));
    case "lowest":
      return values.reduce((a, b) => Math.min(a, b));
    case "at": {
      // What the chart shows at that time: the last value plotted up to it.
      const before = points.filter(([t]) => t <= at + SAME_TIME_S);
      const last = before.at(-1);
      if (last) return last[1];
      throw new NoSuchQuantity(
        `"${name}" has no value yet at ${at} s; its first is at ${points[0]?.[0]} s`,
      );
    }
    default: {
      const there = points.find(([, value]) => (pick === "reaches" ? value >= at : value <= at));
      if (there) return there[0];
      const verb = pick === "reaches" ? "reaches" : "falls to";
      const lowest = Math.min(...values);
      const highest = Math.max(...values);
      throw new NoSuchQuantity(
        `"${name}" never ${verb} ${at}: it goes from ${lowest} to ${highest}`,
      );
    }
  }
}

/**
 * @param {string} text
 * @param {string} printed
 */
function printedAfter(text, printed) {
  const at = printed.lastIndexOf(text);
  const rest = at < 0 ? "" : printed.slice(at + text.length);
  const number = /^[^\d\n+-]*([-+]?\d*\.?\d+(?:e[-+]?\d+)?)/i.exec(rest)?.[1];
  if (number !== undefined) return Number(number);
  const last = printed.trimEnd().split("\n").slice(-3).join(" / ");
  const what = at < 0 ? `the run does not print "${text}"` : `no number follows "${text}"`;
  throw new NoSuchQuantity(`${what}; the last it prints is: ${last || "nothing"}`);
}

/**
 * @param {string} what
 * @param {string} name
 * @param {readonly string[]} there
 */
function missing(what, name, there) {
  const names = listText(there.map((each) => `"${each}"`));
  return new NoSuchQuantity(`the run ${what} called "${name}"; there is: ${names}`);
}

/**
 * Whether what a check says is so.
 * @param {CheckReference} check
 * @param {number} left
 * @param {number} right
 */
export function holds({ compare, margin, percent }, left, right) {
  switch (compare) {
    case ">":
      return left > right;
    case "<":
      return left < right;
    case ">=":
      return left >= right;
    case "<=":
      return left <= right;
    case "==":
      return left === right;
    case "within":
      return Math.abs(left - right) <= (percent ? (margin / 100) * Math.abs(right) : margin);
  }
}

/**
 * A number as prose shows it: whole numbers whole, others with one decimal under a hundred and none
 * from there on, unless the author says how many; with a real minus sign.
 * @param {number} value
 * @param {number | null} digits
 */
export function numberText(value, digits = null) {
  const whole = Math.abs(value - Math.round(value)) < 1e-9;
  const places = digits ?? (whole || Math.abs(value) >= 100 ? 0 : 1);
  const text = value.toFixed(places);
  return Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−");
}
