/**
 * The Markdown of one lesson, in two steps. `parse` reads text and notes all that has to be looked
 * up (references, pictures, links) with its file and line; when that has been done, `render` writes
 * HTML. Prose, statements, hints and captions all come through here.
 */
import MarkdownIt from "markdown-it";
import { directivesAndReferences } from "./directives.mjs";
import { GrammarError, parseReference } from "./figure-grammar.mjs";
import { numberText } from "./figure-value.mjs";
import { highlightPython } from "./highlight.mjs";
import { escapeHtml, slugOf } from "./html.mjs";
import { formulaHtml, mathematics } from "./math.mjs";

/**
 * @typedef {import("markdown-it").Token} Token
 * @typedef {import("./faults.mjs").Fault} Fault
 * @typedef {import("./figure-grammar.mjs").Reference} Reference
 * @typedef {import("./directives.mjs").Directive} Directive
 * @typedef {{ file: string, line: number }} Place
 * @typedef {Place & { reference: Reference, label: Token[] | null }} PlacedReference
 * @typedef {Place & Directive & { caption: Token[] }} PlacedDirective
 * @typedef {{ level: number, text: string, id: string }} Heading
 */

/** What a lesson's HTML takes from elsewhere. Filled in between `parse` and `render`. */
export class Prose {
  /** @type {Fault[]} */
  faults = [];
  /** @type {PlacedReference[]} */
  references = [];
  /** @type {PlacedDirective[]} */
  directives = [];
  /** @type {(Place & { href: string })[]} */
  links = [];
  /** @type {Heading[]} */
  headings = [];
  /** Values of figures by their text. @type {Map<string, number>} */
  values = new Map();
  /** What a figure's tooltip says of its run. @type {(figure: import("./figure-grammar.mjs").Figure) => string} */
  runText = ({ program }) => program;
  /** Makes the HTML of a directive. @type {(directive: PlacedDirective) => string} */
  block = () => "";

  #md = markdown(this);

  /**
   * @param {string} text
   * @param {Place} place of its first line
   * @param {{ oneLine?: boolean }} [options] oneLine: all of it stands on that line of its file
   * @returns {Token[]}
   */
  parse(text, place, { oneLine = false } = {}) {
    const tokens = this.#md.parse(guardTables(text), {});
    this.#note(tokens, place, oneLine);
    return tokens;
  }

  /**
   * The same for words inside a line, such as a caption.
   * @param {string} text
   * @param {Place} place
   */
  parseInline(text, place) {
    const tokens = this.#md.parseInline(text, {});
    this.#note(tokens, place, true);
    return tokens;
  }

  /** @param {Token[]} tokens */
  render(tokens) {
    return this.#md.renderer.render(tokens, this.#md.options, {});
  }

  /**
   * @param {Place} place
   * @param {string} fault
   * @param {string} remedy
   */
  wrong({ file, line }, fault, remedy) {
    this.faults.push({ file, line, fault, remedy });
  }

  /**
   * @param {Token[]} tokens
   * @param {Place} start
   * @param {boolean} oneLine
   */
  #note(tokens, { file, line: first }, oneLine) {
    let line = first;
    for (const [index, token] of tokens.entries()) {
      // Cells of a table have no lines of their own: those of the row hold.
      if (token.map && !oneLine) line = first + token.map[0];
      const place = { file, line };
      if (token.type === "paragraph_open") hideIfEmpty(tokens.slice(index, index + 3));
      if (token.type === "heading_open") this.#heading(token, tokens[index + 1], place);
      if (token.type === "displayed") this.#formula(token, place);
      if (token.type === "directive") this.#directive(token, place);
      let down = 0;
      for (const child of token.children ?? []) {
        if (child.type === "softbreak" || child.type === "hardbreak") down += 1;
        this.#inside(child, { file, line: oneLine ? line : line + down });
      }
    }
  }

  /**
   * @param {Token} token
   * @param {Place} place
   */
  #inside(token, place) {
    if (token.type === "text" && token.content.includes("{{")) {
      this.wrong(place, "{{ is never closed in this piece of text", "write }} where it ends.");
    }
    if (token.type === "formula") this.#formula(token, place);
    if (token.type === "reference") this.#reference(token, place);
    if (token.type === "link_open")
      this.links.push({ ...place, href: String(token.attrGet("href")) });
    if (token.type === "image") {
      const remedy = "put a picture into pictures/ and write ::picture NAME on a line by itself.";
      this.wrong(place, "pictures are not put in with ![…](…)", remedy);
    }
  }

  /**
   * @param {Token} token
   * @param {Token | undefined} content
   * @param {Place} place
   */
  #heading(token, content, place) {
    const level = Number(token.tag.slice(1));
    const text = plainText(content?.children ?? []);
    const id = slugOf(text);
    if (level === 1) {
      this.wrong(
        place,
        "a heading of the first level",
        "begin with ##: the page's title is in lesson.json.",
      );
    }
    if (this.headings.some((other) => other.id === id)) {
      const remedy = "word one of them differently: its words are its address.";
      this.wrong(place, `there is another heading "${text}" on this page`, remedy);
    }
    token.meta = { id, text };
    this.headings.push({ level, text, id });
  }

  /**
   * @param {Token} token
   * @param {Place} place
   */
  #formula(token, place) {
    try {
      token.meta = { html: formulaHtml(token.content, token.type === "displayed") };
    } catch (error) {
      const what =
        error instanceof Error ? error.message.replace("KaTeX parse error: ", "") : `${error}`;
      this.wrong(place, `the formula ${token.content} can't be read: ${what}`, "mend the TeX.");
    }
  }

  /**
   * @param {Token} token
   * @param {Place} place
   */
  #reference(token, place) {
    try {
      const reference = parseReference(token.content);
      const words = reference.kind === "try" ? reference.label : null;
      const label = words === null ? null : this.parseInline(words, place);
      const placed = { ...place, reference, label };
      token.meta = { placed };
      this.references.push(placed);
    } catch (error) {
      if (!(error instanceof GrammarError)) throw error;
      this.wrong(place, error.message, error.remedy);
    }
  }

  /**
   * @param {Token} token
   * @param {Place} place
   */
  #directive(token, place) {
    const { name, argument, rest } = /** @type {Directive} */ (token.meta);
    const caption = rest ? this.parseInline(rest, place) : [];
    const placed = { ...place, name, argument, rest, caption };
    token.meta = { placed };
    this.directives.push(placed);
  }
}

/**
 * In a row of a table, the | of a reference is not the end of a cell.
 * @param {string} text
 */
function guardTables(text) {
  return text.replace(/^\s*\|.*$/gm, (row) =>
    row.replace(/\{\{.*?\}\}/g, (reference) => reference.replace(/(?<!\\)\|/g, "\\|")),
  );
}

/**
 * A paragraph of checks alone shows nothing.
 * @param {Token[]} paragraph its opening, its words, its end
 */
function hideIfEmpty([open, words, close]) {
  const shown = words?.children?.some(({ type, content }) =>
    type === "reference" ? !/^\s*check\s/.test(content) : type !== "softbreak" && content !== "",
  );
  if (shown || !open || !close) return;
  open.hidden = true;
  close.hidden = true;
}

/**
 * @param {Prose} prose
 * @returns {import("markdown-it").MarkdownIt}
 */
function markdown(prose) {
  const md = new MarkdownIt({ typographer: true, quotes: "“”‘’" });
  // Of the typographer only the quotes: (c), -- and ... are left as they are written.
  md.disable("replacements");
  directivesAndReferences(md);
  mathematics(md);
  const { rules } = md.renderer;
  rules.reference = (tokens, index) => {
    const placed = tokens[index]?.meta?.placed;
    return placed ? referenceHtml(prose, /** @type {PlacedReference} */ (placed)) : "";
  };
  rules.directive = (tokens, index) => {
    const placed = tokens[index]?.meta?.placed;
    return prose.block(/** @type {PlacedDirective} */ (placed));
  };
  rules.heading_open = (tokens, index) => {
    const { tag, meta } = tokens[index] ?? {};
    return `<div class="heading"><${tag} id="${escapeHtml(String(meta?.id))}">`;
  };
  rules.heading_close = (tokens, index) => {
    const { tag } = tokens[index] ?? {};
    const { id, text } = /** @type {Heading} */ (tokens[index - 2]?.meta ?? {});
    // Beside the heading, not in it: a heading's name is its words.
    const name = escapeHtml(`Link to “${text}”`);
    return `</${tag}><a class="anchor" href="#${escapeHtml(id)}" aria-label="${name}">#</a></div>\n`;
  };
  rules.fence = (tokens, index) => {
    const { info = "", content = "" } = tokens[index] ?? {};
    const python = info.trim() === "python";
    const text = content.trimEnd();
    const html = python ? highlightPython(text) : escapeHtml(text);
    return `<pre class="code" tabindex="0"><code>${html}</code></pre>\n`;
  };
  // A wide table scrolls by itself, not the page.
  rules.table_open = () => `<div class="table" role="group" tabindex="0"><table>\n`;
  rules.table_close = () => "</table></div>\n";
  return md;
}

/**
 * @param {Prose} prose
 * @param {PlacedReference} placed
 */
function referenceHtml(prose, { reference, label }) {
  if (reference.kind === "check") return "";
  if (reference.kind === "figure") {
    const { figure, digits } = reference;
    const value = prose.values.get(figure.text) ?? Number.NaN;
    const run = escapeHtml(`Measured: ${prose.runText(figure)}`);
    const of = escapeHtml(figure.text);
    return `<data value="${value}" data-of="${of}" title="${run}">${numberText(value, digits)}</data>`;
  }
  const { program, constants } = reference;
  const numbers = Object.entries(constants).map(([name, text]) => [name, Number(text)]);
  const data = escapeHtml(JSON.stringify(Object.fromEntries(numbers)));
  const settings = Object.entries(constants).map(([name, text]) => `${name} = ${text}`);
  const words = label ? prose.render(label) : `Try <code>${escapeHtml(settings.join(", "))}</code>`;
  // A script makes it work; until then it reads as words.
  return `<button type="button" class="try" disabled data-program="${program}" data-constants="${data}">${words}</button>`;
}

/**
 * The words of tokens, without marks: for ids, structured data and counting.
 * @param {readonly Token[]} tokens
 * @param {(reference: Reference) => string} [figureText]
 * @returns {string}
 */
export function plainText(tokens, figureText = () => "") {
  return tokens
    .map((token) => {
      if (token.children && token.type !== "image")
        return `${plainText(token.children, figureText)} `;
      if (token.type === "reference") {
        const placed = /** @type {PlacedReference | undefined} */ (token.meta?.placed);
        return placed ? figureText(placed.reference) : "";
      }
      if (token.type === "softbreak" || token.type === "hardbreak") return " ";
      if (["text", "code_inline", "formula", "displayed"].includes(token.type))
        return token.content;
      return "";
    })
    .join("")
    .replace(/ {2,}/g, " ")
    .trim();
}
