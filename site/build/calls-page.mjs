/**
 * The reference page of the robot's calls, from their docstrings: site/api/index.html holds the
 * comments `<!-- contents -->` and `<!-- calls -->` in their place. Text in, text out.
 *
 * @typedef {{ name: string, signature: string, summary: string, doc: string }} Call
 * @typedef {{ title: string, names: string[] }} Group
 * @typedef {{ kind: "text", text: string }
 *   | { kind: "arguments", list: { name: string, meaning: string }[] }
 *   | { kind: "example", program: string }} Part
 */
import { deflateRawSync } from "node:zlib";
import { programHtml } from "./lessons/highlight.mjs";
import { escapeHtml, slugOf } from "./lessons/html.mjs";
import { headTags } from "./lessons/site-frame.mjs";

const TITLE = "The robot’s calls";
const DESCRIPTION =
  "Every call of the bugbot library: what it does, its arguments with units and ranges, and an example to run.";

/** A mat on which every example has room. */
const WORLD = "empty";

/**
 * @param {string} html
 * @param {{ api: readonly Call[], groups: readonly Group[] }} course
 */
export function fillCalls(html, { api, groups }) {
  const calls = new Map(api.map((call) => [call.name, call]));
  const links = groups.map(
    ({ title, names }) =>
      `<li><a href="#${slugOf(title)}">${escapeHtml(title)}</a><ol class="contents-tasks">${names
        .map((name) => `<li><a href="#${name}">${name}()</a></li>`)
        .join("")}</ol></li>`,
  );
  const sections = groups.map(({ title, names }) => {
    const inside = names.map((name) => {
      const call = calls.get(name);
      if (!call) throw new Error(`The group "${title}" names ${name}, which is no call`);
      return callHtml(call);
    });
    return `<h2 id="${slugOf(title)}">${escapeHtml(title)}</h2>\n${inside.join("\n")}`;
  });
  return html
    .replace(
      "<!-- head -->",
      headTags({ path: "api/", title: TITLE, description: DESCRIPTION, article: false }),
    )
    .replace("<!-- contents -->", `<ol>${links.join("\n")}</ol>`)
    .replace("<!-- calls -->", sections.join("\n"));
}

/** @param {Call} call */
function callHtml({ name, signature, doc }) {
  const parts = partsOf(doc).map((part) => {
    if (part.kind === "text") return `<p>${inline(part.text)}</p>`;
    if (part.kind === "example") return exampleHtml(name, part.program);
    const rows = part.list.map(
      (each) =>
        `<div><dt><code>${escapeHtml(each.name)}</code></dt><dd>${inline(each.meaning)}</dd></div>`,
    );
    return `<dl class="arguments">${rows.join("\n")}</dl>`;
  });
  return `<article class="call" id="${name}" aria-labelledby="call-${name}">
<h3 id="call-${name}"><a href="#${name}"><code>${escapeHtml(signature)}</code></a></h3>
${parts.join("\n")}
</article>`;
}

/** @param {string} name @param {string} program */
function exampleHtml(name, program) {
  const whole = program.includes("import bugbot") ? program : `from bugbot import *\n\n${program}`;
  const code = deflateRawSync(whole).toString("base64url");
  return `<div class="example">
${programHtml(program, `Example of ${name}`)}
<a href="../lab/?world=${WORLD}&amp;seed=1#code=${code}" aria-label="Open the example of ${name} in the lab">Open in the lab</a>
</div>`;
}

/**
 * A docstring's paragraphs, its list of arguments and its example.
 * @param {string} doc
 * @returns {Part[]}
 */
export function partsOf(doc) {
  return doc
    .split("\n\n")
    .map((block) => block.trim())
    .filter(Boolean)
    .map((block) => {
      const lines = block.split("\n");
      if (lines.every((line) => /^(>>>|\.\.\.)( |$)/.test(line))) {
        const program = lines.map((line) => line.slice(4).replace(/ {2}# doctest:.*$/, ""));
        return { kind: "example", program: `${program.join("\n")}\n` };
      }
      const list = lines.map((line) => /^(\w+): (.+)$/.exec(line));
      if (list.every((match) => match !== null)) {
        return {
          kind: "arguments",
          list: list.map((match) => ({ name: match?.[1] ?? "", meaning: match?.[2] ?? "" })),
        };
      }
      return { kind: "text", text: lines.join(" ") };
    });
}

/**
 * Calls, pairs and quoted words in running text are code.
 * @param {string} text
 */
function inline(text) {
  return escapeHtml(text.replace(/(\w)'(\w)/g, "$1’$2")).replace(
    /`([^`]+)`|\b([a-z_]+\(\))/g,
    (_whole, code, call) => `<code>${code ?? call}</code>`,
  );
}
