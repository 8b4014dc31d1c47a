/**
 * The robot's calls as data, and what of a program is one of them. The data come from the
 * docstrings of `py/bugbot`: a sentence, then a line `parameter: meaning, unit, range` for each.
 * Imports nothing of ours; knows no editor.
 */
import type { SyntaxNode, Tree } from "@lezer/common";

export interface Call {
  name: string;
  /** As in Python: `beep(freq, ms=200)`. */
  signature: string;
  summary: string;
  doc: string;
}

export interface Parameter {
  name: string;
  /** As it stands in the signature, with its default value. */
  text: string;
  /** Its line of the docstring without the name; empty if it has none. */
  meaning: string;
}

/** Arguments of a call of the robot's, as they are being written. */
export interface WrittenCall {
  call: Call;
  /** Where the call's name starts. */
  from: number;
  /** Which of its parameters the place is at, counted from 0; null if it has none there. */
  parameter: number | null;
}

/** Names that hold the robot: `robot = connect()`, `with Robot() as robot`, `import bugbot`. */
const HOLDS_ROBOT =
  /\b(\w+)\s*=\s*(?:bugbot\.)?(?:connect|Robot)\(|(?:connect|Robot)\([^)\n]*\)\s+as\s+(\w+)|\bimport\s+(bugbot)\b/g;

export function robotNames(program: string): Set<string> {
  const names = new Set<string>();
  for (const match of program.matchAll(HOLDS_ROBOT)) {
    const name = match[1] ?? match[2] ?? match[3];
    if (name) names.add(name);
  }
  return names;
}

/** The parameters of a call, in order; those with stars are any number and have no place. */
export function parametersOf({ name, signature, doc }: Call): Parameter[] {
  return splitAtCommas(signature.slice(name.length + 1, -1))
    .filter((text) => !text.startsWith("*"))
    .map((text) => {
      const parameter = text.split("=", 1)[0] ?? text;
      const line = doc.split("\n").find((one) => one.startsWith(`${parameter}: `));
      return { name: parameter, text, meaning: line?.slice(parameter.length + 2) ?? "" };
    });
}

/** At the commas that are in no bracket and no text: a default may be `(0, 0)` or `","`. */
function splitAtCommas(text: string): string[] {
  const parts = text.match(/(?:\([^)]*\)|\[[^\]]*\]|'[^']*'|"[^"]*"|[^,])+/g) ?? [];
  return parts.map((part) => part.trim()).filter((part) => part !== "");
}

/** The innermost call of the robot's whose arguments a place in the program is in, or null. */
export function callAround(
  tree: Tree,
  text: string,
  at: number,
  calls: ReadonlyMap<string, Call>,
): WrittenCall | null {
  for (let node: SyntaxNode | null = tree.resolveInner(at, -1); node; node = node.parent) {
    if (node.name !== "ArgList" || at <= node.from) continue;
    const closed = text[node.to - 1] === ")";
    if (closed && at >= node.to) continue;
    const callee = node.prevSibling;
    const name = callee?.name === "MemberExpression" ? callee.lastChild : callee;
    const call = name && robotCall(name, text, calls);
    if (!call) return null;
    return { call, from: name.from, parameter: parameterAt(node, text, at, parametersOf(call)) };
  }
  return null;
}

/** The robot's call that a name in the program stands for, or null: `wait`, `robot.wait`. */
export function robotCall(
  name: SyntaxNode,
  text: string,
  calls: ReadonlyMap<string, Call>,
): Call | null {
  const word = text.slice(name.from, name.to);
  const call = calls.get(word);
  if (!call) return null;
  if (name.name === "PropertyName") {
    const owner = name.parent?.firstChild;
    return owner && robotNames(text).has(text.slice(owner.from, owner.to)) ? call : null;
  }
  // A function of the learner's own may have the same name.
  const isOwn = new RegExp(String.raw`^[ \t]*def\s+${word}\b`, "m").test(text);
  return name.name === "VariableName" && !isOwn ? call : null;
}

/** By its place among the commas, or by its name: `beep(440, ms=`. */
function parameterAt(
  args: SyntaxNode,
  text: string,
  at: number,
  parameters: readonly Parameter[],
): number | null {
  let place = 0;
  let named: string | null = null;
  for (let node = args.firstChild; node && node.from < at; node = node.nextSibling) {
    if (node.name === ",") {
      place += 1;
      named = null;
    } else if (node.name === "VariableName" && node.nextSibling?.name === "AssignOp") {
      named = text.slice(node.from, node.to);
    }
  }
  const index = named === null ? place : parameters.findIndex(({ name }) => name === named);
  return index in parameters ? index : null;
}
