/**
 * What Python will not be able to read, found while typing and said in plain words.
 *
 * Only the first problem is reported: a parser's opinions after that are guesses about guesses.
 * The tree is the editor's own, so this costs next to nothing; Python has the last word on Run.
 */
import { syntaxTree } from "@codemirror/language";
import { type Diagnostic, linter } from "@codemirror/lint";
import type { EditorState } from "@codemirror/state";
import type { SyntaxNode, Tree } from "@lezer/common";
import { syntaxWords } from "../ui/strings.ts";

export interface Problem {
  from: number;
  to: number;
  message: string;
}

const OPENERS: Record<string, string> = { "(": ")", "[": "]", "{": "}" };
const CLOSERS = new Set(Object.values(OPENERS));
/** Statements whose first line ends with a colon. */
const HEADER = /^\s*(async\s+)?(if|elif|else|for|while|def|class|try|except|finally|with)\b/;
/** Nodes whose text is not code: a bracket in them is only a character. */
const TEXT = new Set(["String", "FormatString", "Comment"]);

/** The first thing in `text` that Python would refuse, or null. `tree` is the parse of `text`. */
export function firstProblem(tree: Tree, text: string): Problem | null {
  const found = [unclosedString(tree, text), bracket(tree, text), misread(tree, text)];
  const problems = found.filter((problem) => problem !== null);
  problems.sort((a, b) => a.from - b.from);
  return problems[0] ?? null;
}

function unclosedString(tree: Tree, text: string): Problem | null {
  let problem: Problem | null = null;
  tree.iterate({
    enter(node) {
      if (problem || !TEXT.has(node.name) || node.name === "Comment") return;
      const body = text.slice(node.from, node.to).replace(/^[a-zA-Z]+/, "");
      const quote = /^("""|'''|"|')/.exec(body)?.[0];
      if (!quote) return;
      const closed = body.length >= 2 * quote.length && body.endsWith(quote);
      if (!closed) {
        const to = Math.min(node.to, lineEnd(text, node.from));
        problem = { from: node.from, to, message: syntaxWords.string(quote) };
      }
    },
  });
  return problem;
}

function bracket(tree: Tree, text: string): Problem | null {
  const skip = textRanges(tree);
  const open: number[] = [];
  let next = 0;
  for (let at = 0; at < text.length; at++) {
    const range = skip[next];
    if (range && at >= range.from) {
      at = range.to - 1;
      next += 1;
      continue;
    }
    const sign = text.charAt(at);
    if (sign in OPENERS) open.push(at);
    if (!CLOSERS.has(sign)) continue;
    const partner = open.pop();
    if (partner === undefined) return { from: at, to: at + 1, message: syntaxWords.stray(sign) };
    const opener = text.charAt(partner);
    if (OPENERS[opener] !== sign) {
      return { from: at, to: at + 1, message: syntaxWords.mismatch(sign, opener) };
    }
  }
  const last = open.at(-1);
  if (last === undefined) return null;
  return { from: last, to: last + 1, message: syntaxWords.unclosed(text.charAt(last)) };
}

/** The stretches of strings and comments, outermost only, in order. */
function textRanges(tree: Tree): { from: number; to: number }[] {
  const ranges: { from: number; to: number }[] = [];
  tree.iterate({
    enter(node) {
      if (!TEXT.has(node.name)) return;
      if (node.to > node.from) ranges.push({ from: node.from, to: node.to });
      return false;
    },
  });
  return ranges;
}

function misread(tree: Tree, text: string): Problem | null {
  let problem: Problem | null = null;
  tree.iterate({
    enter(node) {
      if (problem) return false;
      if (node.name === "PrintStatement") {
        const to = lineEnd(text, node.from);
        problem = { from: node.from, to, message: syntaxWords.print };
      } else if (node.type.isError) {
        problem = explain(node.node, text);
      }
    },
  });
  return problem;
}

function explain(error: SyntaxNode, text: string): Problem {
  // The parser meets some errors only at the next line: the mark belongs where the text stops.
  const at = text.slice(0, error.from).trimEnd().length;
  const wrong = text.slice(error.from, error.to).trim();
  const from = wrong ? error.from : Math.max(0, at - 1);
  const start = text.lastIndexOf("\n", from - 1) + 1;
  const line = text.slice(start, lineEnd(text, from));
  const to = Math.max(from + 1, wrong ? error.to : at);
  return { from, to, message: reason(error, wrong, line) };
}

function reason(error: SyntaxNode, wrong: string, line: string): string {
  const header = HEADER.exec(line)?.[2];
  if (wrong === "=" && header) return syntaxWords.compare;
  if (["else", "elif", "except", "finally"].includes(wrong)) return syntaxWords.orphan(wrong);
  const code = line.replace(/#.*$/, "").trimEnd();
  if (header && code.endsWith(":") && error.parent?.name === "Body") return syntaxWords.empty;
  if (header && !code.includes(":")) return syntaxWords.colon(header);
  return syntaxWords.unreadable;
}

function lineEnd(text: string, from: number): number {
  const end = text.indexOf("\n", from);
  return end < 0 ? text.length : end;
}

function diagnostics(state: EditorState, editing: boolean): Diagnostic[] {
  const tree = syntaxTree(state);
  // A long program is parsed in pieces; half a tree would call its own end an error.
  if (tree.length < state.doc.length) return [];
  const problem = firstProblem(tree, state.doc.toString());
  if (!problem) return [];
  const cursor = state.doc.lineAt(state.selection.main.head).number;
  const line = state.doc.lineAt(problem.from).number;
  // What is still being typed is not yet wrong.
  if (editing && (cursor === line || cursor === line + 1)) return [];
  return [{ ...problem, severity: "error" }];
}

export const syntaxProblems = linter((view) => diagnostics(view.state, view.hasFocus), {
  delay: 600,
  needsRefresh: (update) => update.focusChanged || update.selectionSet,
});
