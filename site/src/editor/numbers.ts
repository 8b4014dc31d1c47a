/**
 * The numbers of a program: which can be moved, by how much, and how a new value is written.
 *
 * Found in the editor's syntax tree, so a 5 in a text or a comment is never one. Imports nothing
 * of ours; knows no editor.
 */
import type { SyntaxNode, Tree } from "@lezer/common";

/** A number as it stands in a program, its sign with it. */
export interface WrittenNumber {
  from: number;
  to: number;
  text: string;
  value: number;
  step: number;
  low: number;
  high: number;
}

/** `NAME = number` at the top level. */
export interface Constant extends WrittenNumber {
  name: string;
  /** Its comment gives a range, `(low to high)`. */
  ranged: boolean;
}

/** Plain decimals only: nobody drags 0x1f, 1e-9 or 3j. */
const DECIMAL = /^(\d+\.?\d*|\.\d+)$/;
const BOUND = String.raw`([-−]?(?:\d+\.?\d*|\.\d+))`;
const RANGE = new RegExp(String.raw`\(\s*${BOUND}\s+to\s+${BOUND}\s*\)`);

/** Every constant of the program, in order. `tree` is the parse of `text`. */
export function constantsOf(tree: Tree, text: string): Constant[] {
  const found: Constant[] = [];
  for (let node = tree.topNode.firstChild; node; node = node.nextSibling) {
    const constant = constantAt(node, text);
    if (constant) found.push(constant);
  }
  return found;
}

/**
 * The program with other values for some of its constants. Throws a RangeError that names the first
 * it does not have. Where a name is given a number twice, the first is meant.
 */
export function withValues(
  text: string,
  constants: readonly Constant[],
  values: Readonly<Record<string, number>>,
): string {
  const changes = Object.entries(values).map(([name, value]) => {
    const found = constants.find((constant) => constant.name === name);
    if (!found) throw new RangeError(`the program has no line "${name} = …" with a number`);
    return { from: found.from, to: found.to, insert: writtenLike(found.text, value) };
  });
  // From the end, so that the places before stay where they are.
  return changes
    .sort((a, b) => b.from - a.from)
    .reduce((done, { from, to, insert }) => done.slice(0, from) + insert + done.slice(to), text);
}

function constantAt(statement: SyntaxNode, text: string): Constant | null {
  if (statement.name !== "AssignStatement") return null;
  const target = statement.firstChild;
  const written = statement.lastChild && numberOf(statement.lastChild, text);
  if (target?.name !== "VariableName" || !written) return null;
  // One name, one number: `NAME = n` or `NAME: type = n`, not `A = B = n` or `A, B = 1, 2`.
  const between = target.nextSibling?.name === "TypeDef" ? target.nextSibling : target;
  if (between.nextSibling?.nextSibling?.from !== written.from) return null;
  const name = text.slice(target.from, target.to);
  const range = rangeAfter(statement, text);
  if (!range) return { ...written, name, ranged: false };
  const [low, high] = range;
  return { ...written, name, low, high, step: rangeStep(low, high, written.value), ranged: true };
}

/** The bounds in the comment behind a statement, or null. */
function rangeAfter(statement: SyntaxNode, text: string): [low: number, high: number] | null {
  const comment = statement.nextSibling;
  if (comment?.name !== "Comment") return null;
  if (text.slice(statement.to, comment.from).includes("\n")) return null;
  const match = RANGE.exec(text.slice(comment.from, comment.to));
  if (!match) return null;
  const [low, high] = [match[1], match[2]].map((bound) => Number(bound?.replace("−", "-")));
  return low !== undefined && high !== undefined && low < high ? [low, high] : null;
}

/** The number at a place in the program, the constant's own bounds with it; null if there is none. */
export function numberAt(tree: Tree, text: string, at: number): WrittenNumber | null {
  for (const side of [1, -1] as const) {
    const node = tree.resolveInner(at, side);
    const sign = node.name === "Number" && node.parent?.name === "UnaryExpression";
    const written = (sign && node.parent && numberOf(node.parent, text)) || numberOf(node, text);
    if (!written) {
      // The caret may stand between a minus and its number.
      const unary = node.parent?.name === "UnaryExpression" && numberOf(node.parent, text);
      if (unary) return unary;
      continue;
    }
    const statement = tree.topNode.childAfter(written.from);
    const constant = statement && constantAt(statement, text);
    return constant?.from === written.from ? constant : written;
  }
  return null;
}

/** A node as a number, or null: digits, or a minus and digits. */
function numberOf(node: SyntaxNode, text: string): WrittenNumber | null {
  const digits = node.name === "UnaryExpression" ? node.lastChild : node;
  if (digits?.name !== "Number") return null;
  const sign = text.slice(node.from, digits.from);
  const literal = text.slice(digits.from, digits.to);
  if (!DECIMAL.test(literal) || !(sign === "" || sign === "-")) return null;
  const written = sign + literal;
  return {
    from: node.from,
    to: node.to,
    text: written,
    value: Number(written),
    step: 10 ** -decimals(literal),
    low: Number.NEGATIVE_INFINITY,
    high: Number.POSITIVE_INFINITY,
  };
}

/** Whole numbers go by 1; others by about a hundredth of the range: 1, 2 or 5 times a power of ten. */
function rangeStep(low: number, high: number, value: number): number {
  if ([low, high, value].every(Number.isInteger)) return 1;
  const raw = (high - low) / 100;
  const power = 10 ** Math.floor(Math.log10(raw));
  const share = raw / power;
  const step = power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
  return Number(step.toPrecision(1));
}

/** A value brought onto the number's steps and into its bounds. */
export function onStep({ step, low, high }: WrittenNumber, value: number): number {
  return within(low, high, tidy(Math.round(tidy(value / step)) * step));
}

/** The next value so many steps up, or down if negative; a value between steps goes to the next. */
export function stepped({ step, low, high, value }: WrittenNumber, by: number): number {
  const here = tidy(value / step);
  const from = by > 0 ? Math.floor(here) : Math.ceil(here);
  return within(low, high, tidy((from + by) * step));
}

/**
 * A value as Python text in the style of `like`: with as many decimals, so that the line stays
 * where it is while the value moves, or more if the value needs them.
 */
export function writtenLike(like: string, value: number): string {
  const plain = String(tidy(value));
  // String() writes 1e-7 for what nobody would write so.
  const needed = plain.includes("e") ? 12 : decimals(plain);
  const places = Math.max(decimals(like), needed);
  const text = value.toFixed(places);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

function decimals(text: string): number {
  const point = text.indexOf(".");
  if (point < 0) return 0;
  // `5.` is a float as well: it stays one.
  return Math.max(1, text.length - point - 1);
}

/** Without what binary fractions leave behind: 0.30000000000000004 is 0.3. */
function tidy(value: number): number {
  return Number(value.toPrecision(12));
}

function within(low: number, high: number, value: number): number {
  return Math.min(high, Math.max(low, value));
}
