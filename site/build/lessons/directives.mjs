/**
 * Finds the two signs of our own in Markdown: a line `::program NAME` (a directive), and `{{ … }}`
 * inside a line (a reference). What they mean is for others to say. Imports nothing of ours.
 */

/**
 * @typedef {import("markdown-it").MarkdownIt} MarkdownIt
 * @typedef {import("markdown-it").StateInline} StateInline
 * @typedef {import("markdown-it").StateBlock} StateBlock
 * @typedef {{ name: string, argument: string, rest: string }} Directive
 */

/** @param {MarkdownIt} md */
export function directivesAndReferences(md) {
  const alt = ["paragraph", "reference", "blockquote", "list"];
  md.block.ruler.before("fence", "directive", directive, { alt });
  // After code spans: what stands in one is left alone.
  md.inline.ruler.after("backticks", "reference", reference);
}

/**
 * @param {StateBlock} state
 * @param {number} start
 * @param {number} _end
 * @param {boolean} silent
 */
function directive(state, start, _end, silent) {
  const from = (state.bMarks[start] ?? 0) + (state.tShift[start] ?? 0);
  const text = state.src.slice(from, state.eMarks[start]).trim();
  const match = /^::(\S*)\s*(\S*)\s*(.*)$/.exec(text);
  if (!match) return false;
  if (silent) return true;
  state.line = start + 1;
  const token = state.push("directive", "", 0);
  token.block = true;
  token.map = [start, state.line];
  token.meta = { name: match[1] ?? "", argument: match[2] ?? "", rest: match[3] ?? "" };
  return true;
}

/**
 * @param {StateInline} state
 * @param {boolean} silent
 */
function reference(state, silent) {
  if (!state.src.startsWith("{{", state.pos)) return false;
  const end = state.src.indexOf("}}", state.pos);
  if (end < 0) return false;
  if (!silent) state.push("reference", "", 0).content = state.src.slice(state.pos + 2, end);
  state.pos = end + 2;
  return true;
}
