/**
 * The numbers to change at the top of a program: `NAME = number`, alone on its line, at the top
 * level, as the editor's own `numbers.ts` finds them. Imports nothing of ours.
 */
import { parser } from "@lezer/python";

/** @typedef {{ from: number, to: number, value: number, low: number, high: number }} Constant */

const BOUND = String.raw`([-−]?(?:\d+\.?\d*|\.\d+))`;
const RANGE = new RegExp(String.raw`^[^\n]*?#.*\(\s*${BOUND}\s+to\s+${BOUND}\s*\)`);

/**
 * The constants of a program by name; the first of a name counts.
 * @param {string} source
 * @returns {Map<string, Constant>}
 */
export function constantsOf(source) {
  /** @type {Map<string, Constant>} */
  const found = new Map();
  const top = parser.parse(source).topNode;
  for (let node = top.firstChild; node; node = node.nextSibling) {
    if (node.name !== "AssignStatement") continue;
    const text = source.slice(node.from, node.to);
    const match = /^(\w+)(?:\s*:[^=]+)?\s*=\s*(-?(?:\d+\.?\d*|\.\d+))$/.exec(text);
    const [, name = "", number = ""] = match ?? [];
    if (!match || found.has(name)) continue;
    const [, low, high] = RANGE.exec(source.slice(node.to)) ?? [];
    found.set(name, {
      from: node.to - number.length,
      to: node.to,
      value: Number(number),
      low: low ? Number(low.replace("−", "-")) : Number.NEGATIVE_INFINITY,
      high: high ? Number(high.replace("−", "-")) : Number.POSITIVE_INFINITY,
    });
  }
  return found;
}

/**
 * The program with other values for some of its constants, each of which it must have.
 * @param {string} source
 * @param {Readonly<Record<string, string>>} values as written in the program
 */
export function withConstants(source, values) {
  const constants = constantsOf(source);
  const changes = Object.entries(values).map(([name, text]) => {
    const constant = constants.get(name);
    if (!constant) throw new RangeError(`the program has no line ${name} = number`);
    return { ...constant, text };
  });
  // From the end, so that what comes before stays where it was.
  changes.sort((a, b) => b.from - a.from);
  return changes.reduce(
    (program, { from, to, text }) => program.slice(0, from) + text + program.slice(to),
    source,
  );
}
