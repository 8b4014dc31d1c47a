/**
 * Mathematics: `$…$` in a line and `$$…$$` by itself, made into HTML and MathML by KaTeX when the
 * site is built. The rules only find the formulas; `formulaHtml` makes them.
 */
import katex from "katex";

/**
 * @typedef {import("markdown-it").MarkdownIt} MarkdownIt
 * @typedef {import("markdown-it").StateInline} StateInline
 * @typedef {import("markdown-it").StateBlock} StateBlock
 */

/** @param {MarkdownIt} md */
export function mathematics(md) {
  md.inline.ruler.after("escape", "formula", formula);
  md.block.ruler.before("fence", "displayed", displayed, { alt: ["paragraph", "list"] });
  md.renderer.rules.formula = (tokens, index) => String(tokens[index]?.meta?.html ?? "");
  md.renderer.rules.displayed = (tokens, index) =>
    `<div class="displayed">${String(tokens[index]?.meta?.html ?? "")}</div>\n`;
}

/**
 * `$…$`: no space just inside the dollars, no digit just behind them, so that "$5 and $6" is money.
 * @param {StateInline} state
 * @param {boolean} silent
 */
function formula(state, silent) {
  const match = /^\$(?![\s$])((?:[^$\\]|\\.)*?[^\s\\$]|[^\s\\$])\$(?!\d)/s.exec(
    state.src.slice(state.pos),
  );
  if (!match) return false;
  if (!silent) state.push("formula", "", 0).content = match[1] ?? "";
  state.pos += match[0].length;
  return true;
}

/**
 * `$$` at the beginning of a line, to the next `$$` at the end of one.
 * @param {StateBlock} state
 * @param {number} start
 * @param {number} end
 * @param {boolean} silent
 */
function displayed(state, start, end, silent) {
  /** @param {number} line */
  const lineText = (line) =>
    state.src.slice((state.bMarks[line] ?? 0) + (state.tShift[line] ?? 0), state.eMarks[line]);
  if (!lineText(start).startsWith("$$")) return false;
  let last = start;
  let text = lineText(start).slice(2);
  while (!text.trimEnd().endsWith("$$") && last + 1 < end) {
    last += 1;
    text += `\n${lineText(last)}`;
  }
  if (!text.trimEnd().endsWith("$$")) return false;
  if (silent) return true;
  state.line = last + 1;
  const token = state.push("displayed", "", 0);
  token.block = true;
  token.content = text.trimEnd().slice(0, -2).trim();
  token.map = [start, state.line];
  return true;
}

/**
 * Throws KaTeX's own error for a formula it can't read.
 * @param {string} tex
 * @param {boolean} displayMode
 */
export function formulaHtml(tex, displayMode) {
  return katex.renderToString(tex, { displayMode, output: "htmlAndMathml", strict: "error" });
}
