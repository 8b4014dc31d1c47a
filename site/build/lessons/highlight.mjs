/**
 * Python as HTML with its words coloured, by the same parser and the same kinds of words as the
 * editor's. Imports `html` and the editor's `word-kinds`.
 */
import { highlightCode, tagHighlighter } from "@lezer/highlight";
import { parser } from "@lezer/python";
import { wordKinds } from "../../src/editor/word-kinds.mjs";
import { escapeHtml } from "./html.mjs";

const highlighter = tagHighlighter(
  wordKinds.flatMap(({ kind, tags }) => tags.map((tag) => ({ tag, class: `code-${kind}` }))),
);

/**
 * @param {string} source
 * @returns {string} what goes into a <code>; the lines end as in the source
 */
export function highlightPython(source) {
  let html = "";
  highlightCode(
    source,
    parser.parse(source),
    highlighter,
    (text, kinds) => {
      html += kinds ? `<span class="${kinds}">${escapeHtml(text)}</span>` : escapeHtml(text);
    },
    () => {
      html += "\n";
    },
  );
  return html;
}

/**
 * A whole program or a piece of one, to be read where no script runs.
 * @param {string} source
 * @param {string} [label] what it is called
 */
export function programHtml(source, label) {
  const name = label ? ` role="region" aria-label="${escapeHtml(label)}"` : "";
  // A box that scrolls can be scrolled with the keys if it can have the focus.
  return `<pre class="code"${name} tabindex="0"><code>${highlightPython(source.trimEnd())}</code></pre>`;
}
