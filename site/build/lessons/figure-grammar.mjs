/**
 * The grammar of what stands in {{ … }}: figures, checks and buttons. Text in, tree out; knows
 * nothing of programs. Imports nothing of ours. lessons/README.md explains it to instructors.
 *
 *   figure   PROGRAM [with NAME = NUMBER, …] [seed N | seeds A to B]: QUANTITY [| DIGITS]
 *   check    check FIGURE > FIGURE-OR-NUMBER          also <  >=  <=  ==  within N [%] of
 *   button   try PROGRAM: NAME = NUMBER, … [| LABEL]
 *
 * @typedef {{ kind: "series", pick: "at" | "end" | "highest" | "lowest" | "reaches" | "falls",
 *             name: string, at: number }
 *   | { kind: "count", layer: string }
 *   | { kind: "pose", part: "seconds" | "x" | "y" | "heading" }
 *   | { kind: "printed", after: string }} Quantity `at` is a time [s], or the value to reach
 * @typedef {{
 *   program: string,
 *   constants: Record<string, string>,
 *   seeds: number[] | null,
 *   over: "median" | "lowest" | "highest" | null,
 *   quantity: Quantity,
 *   text: string,
 * }} Figure seeds: null is the program's own; `over` says what is taken of many seeds
 * @typedef {{ kind: "figure", figure: Figure, digits: number | null }} FigureReference
 * @typedef {{ kind: "check", text: string, left: Figure, right: Figure | number,
 *             compare: ">" | "<" | ">=" | "<=" | "==" | "within", margin: number, percent: boolean }} CheckReference
 * @typedef {{ kind: "try", program: string, constants: Record<string, string>,
 *             label: string | null }} TryReference
 * @typedef {FigureReference | CheckReference | TryReference} Reference
 */

/** What is wrong with the text of a reference; `remedy` says what is wanted. */
export class GrammarError extends Error {
  /**
   * @param {string} message
   * @param {string} remedy
   */
  constructor(message, remedy) {
    super(message);
    this.remedy = remedy;
  }
}

const NUMBER = String.raw`[-−]?(?:\d+\.?\d*|\.\d+)`;
const QUANTITIES =
  "SERIES at 8.5 s, SERIES at the end, highest SERIES, lowest SERIES, first time SERIES reaches 5, " +
  'first time SERIES falls to 5, count of LAYER, seconds, x, y, heading, number after "TEXT"';
const HEAD = /^([a-z0-9-]+)(?:\s+with\s+(.+?))?(?:\s+seed\s+(\d+)|\s+seeds\s+(\d+)\s+to\s+(\d+))?$/;
const CONSTANT = new RegExp(String.raw`^([A-Za-z_]\w*)\s*=\s*(${NUMBER})$`);
const COMPARISON = /^(.*?)\s+(>=|<=|==|>|<|within\s+([\d.]+)\s*(%?)\s+of)\s+(.*)$/;
const MOST_SEEDS = 100;

/**
 * @param {string} text between the braces
 * @returns {Reference}
 */
export function parseReference(text) {
  const words = text.trim().replace(/\s+/g, " ");
  if (words.startsWith("check ")) return parseCheck(words.slice(6));
  if (words.startsWith("try ")) return parseTry(words.slice(4));
  const [, reference = words, digits] = /^(.*?)\s*\|\s*(.*)$/.exec(words) ?? [];
  if (digits !== undefined && !/^\d$/.test(digits)) {
    throw new GrammarError(`"| ${digits}" is no number of digits`, "write | 0 to | 9 at the end.");
  }
  return {
    kind: "figure",
    figure: parseFigure(reference),
    digits: digits === undefined ? null : Number(digits),
  };
}

/**
 * @param {string} text
 * @returns {Figure}
 */
function parseFigure(text) {
  const [, head, rest] = /^(.*?)\s*:\s*(.*)$/.exec(text) ?? [];
  if (head === undefined || rest === undefined) {
    throw new GrammarError(
      `"${text}" has no colon between program and quantity`,
      "write {{ PROGRAM: QUANTITY }}, such as {{ demo-1: known % at 8.5 s }}.",
    );
  }
  const match = HEAD.exec(head);
  if (!match) {
    throw new GrammarError(
      `"${head}" does not name a run`,
      "write PROGRAM, PROGRAM with NAME = 1, PROGRAM seed 3, or PROGRAM seeds 1 to 20.",
    );
  }
  const [, program = "", constants, seed, first, last] = match;
  const seeds = seed ? [Number(seed)] : first && last ? range(Number(first), Number(last)) : null;
  const [, over, one] = /^(median|lowest|highest) of (.*)$/.exec(rest) ?? [];
  const many = first !== undefined;
  if (many && !over) {
    throw new GrammarError(
      "of many seeds one number has to be taken",
      `write "median of ${rest}", or "lowest of", "highest of".`,
    );
  }
  if (!many && over) {
    throw new GrammarError(
      `"${over} of" wants many seeds`,
      "write seeds 1 to 20 before the colon.",
    );
  }
  return {
    program,
    constants: constants ? parseConstants(constants) : {},
    seeds,
    over: /** @type {Figure["over"]} */ (over ?? null),
    quantity: parseQuantity(one ?? rest),
    text,
  };
}

/**
 * @param {string} text
 * @returns {Quantity}
 */
function parseQuantity(text) {
  let match = /^(seconds|x|y|heading)$/.exec(text);
  if (match) return { kind: "pose", part: /** @type {"seconds"} */ (match[1]) };
  match = /^number after ["“](.+)["”]$/.exec(text);
  if (match) return { kind: "printed", after: match[1] ?? "" };
  match = /^count of (.+)$/.exec(text);
  if (match) return { kind: "count", layer: match[1] ?? "" };
  match = new RegExp(`^first time (.+) (reaches|falls to) (${NUMBER})$`).exec(text);
  if (match) {
    const pick = match[2] === "reaches" ? "reaches" : "falls";
    return { kind: "series", pick, name: match[1] ?? "", at: toNumber(match[3]) };
  }
  match = /^(highest|lowest) (.+)$/.exec(text);
  if (match) {
    const pick = match[1] === "highest" ? "highest" : "lowest";
    return { kind: "series", pick, name: match[2] ?? "", at: 0 };
  }
  match = /^(.+) at the end$/.exec(text);
  if (match) return { kind: "series", pick: "end", name: match[1] ?? "", at: 0 };
  match = new RegExp(`^(.+) at (${NUMBER}) s$`).exec(text);
  if (match) return { kind: "series", pick: "at", name: match[1] ?? "", at: toNumber(match[2]) };
  throw new GrammarError(`"${text}" is no quantity`, `write one of: ${QUANTITIES}.`);
}

/**
 * @param {string} text
 * @returns {CheckReference}
 */
function parseCheck(text) {
  const match = COMPARISON.exec(text);
  if (!match) {
    throw new GrammarError(
      `"${text}" compares nothing`,
      "write check A > B with >, <, >=, <=, ==, or check A within 5 % of B; spaces around the sign.",
    );
  }
  const [, left = "", sign = "", margin = "0", percent, right = ""] = match;
  const number = new RegExp(`^${NUMBER}$`).test(right);
  return {
    kind: "check",
    text,
    left: parseFigure(left),
    right: number ? toNumber(right) : parseFigure(right),
    compare: /** @type {CheckReference["compare"]} */ (sign.startsWith("within") ? "within" : sign),
    margin: Number(margin),
    percent: percent === "%",
  };
}

/**
 * @param {string} text
 * @returns {TryReference}
 */
function parseTry(text) {
  const [, program, constants, label] =
    /^([a-z0-9-]+)\s*:\s*([^|]+?)\s*(?:\|\s*(.+))?$/.exec(text) ?? [];
  if (!program || !constants) {
    throw new GrammarError(
      `"${text}" does not say what to try`,
      "write {{ try PROGRAM: NAME = NUMBER }}, with | and a label of your own if you like.",
    );
  }
  return { kind: "try", program, constants: parseConstants(constants), label: label ?? null };
}

/**
 * @param {string} text
 * @returns {Record<string, string>}
 */
function parseConstants(text) {
  const pairs = text.split(",").map((part) => {
    const match = CONSTANT.exec(part.trim());
    if (!match) {
      throw new GrammarError(
        `"${part.trim()}" changes no number`,
        "write NAME = NUMBER, with commas between several.",
      );
    }
    return [match[1], match[2]?.replace("−", "-")];
  });
  return Object.fromEntries(pairs);
}

/**
 * @param {number} first
 * @param {number} last
 */
function range(first, last) {
  const count = last - first + 1;
  if (count < 2 || count > MOST_SEEDS) {
    throw new GrammarError(
      `seeds ${first} to ${last} are ${Math.max(0, count)} runs`,
      `name from 2 to ${MOST_SEEDS} of them.`,
    );
  }
  return Array.from({ length: count }, (_, index) => first + index);
}

/** @param {string | undefined} text */
function toNumber(text) {
  return Number(text?.replace("−", "-"));
}
