/** Text into HTML. Imports nothing of ours. */

/** @type {Record<string, string>} */
const ENTITIES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };

/**
 * Text as it goes between tags or into a quoted attribute.
 * @param {string | number} text
 */
export function escapeHtml(text) {
  return String(text).replace(/[&<>"]/g, (character) => ENTITIES[character] ?? character);
}

/**
 * Data for a script element of a page: nothing in it can end the element.
 * @param {string} attributes
 * @param {unknown} data
 */
export function jsonScript(attributes, data) {
  const json = JSON.stringify(data).replaceAll("<", "\\u003c");
  return `<script ${attributes}>${json}</script>`;
}

/**
 * A heading's text as the fragment of an address: "What is log odds?" -> "what-is-log-odds".
 * @param {string} text
 */
export function slugOf(text) {
  return text
    .toLowerCase()
    .replace(/['’]/g, "")
    .replace(/[^\p{L}\p{N}]+/gu, "-")
    .replace(/^-+|-+$/g, "");
}
