/**
 * The HTML of a lesson's preview: what an instructor sees of `/preview/SLUG/`. The marks come later,
 * one by one, and a few lines of script put them in their places.
 */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import MarkdownIt from "markdown-it";
import { ROOT } from "./files.mjs";
import { highlightPython } from "./lessons/highlight.mjs";
import { escapeHtml } from "./lessons/html.mjs";
import { formulaHtml, mathematics } from "./lessons/math.mjs";

/**
 * @typedef {{ world: { name: string, obstacles: { x: number, y: number, width: number, height: number }[] },
 *             cells: [number, number][], cell_cm: number, seconds: number | null }} Where
 * @typedef {{ title: string, status: string, expected: string, got: string, likely: string | null,
 *             hint: number | null, where: Where | null }} Check
 * @typedef {{ passed: boolean, ours: string | null, checks: Check[] }} Mark
 */

/** The mat's side [cm]. */
const MAT_CM = 200;

const STYLE = `
body { font: 16px/1.5 system-ui, sans-serif; margin: 1.5rem auto; max-width: 80rem; padding: 0 1rem; color-scheme: light dark; }
article { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; border-top: 1px solid #8886; padding: .6rem 0; }
article h3 { grid-column: 1 / -1; margin: 0; }
pre { overflow-x: auto; background: #8881; padding: .6rem; margin: 0; font-size: .85rem; }
dt { font-weight: 600; } dd { margin: 0 0 .3rem 1rem; white-space: pre-wrap; }
.bad { color: #c02626; font-weight: 600; }
svg { max-width: 16rem; border: 1px solid #8886; }
@media (max-width: 50rem) { article { grid-template-columns: 1fr; } }`;

/** Reads the marks as they come, and puts each into its place. */
const SCRIPT = `
(async () => {
const reader = (await fetch("marks")).body.pipeThrough(new TextDecoderStream()).getReader();
let rest = "";
for (let part = await reader.read(); !part.done; part = await reader.read()) {
  const lines = (rest + part.value).split("\\n");
  rest = lines.pop();
  for (const { id, html } of lines.map((line) => JSON.parse(line))) {
    const place = document.getElementById(id);
    if (place) place.innerHTML = html;
  }
}
document.getElementById("state").textContent = "All marked.";
})();`;

/**
 * The page, its marks still to come.
 * @param {string} folder of the lesson
 * @param {string} slug
 */
export function previewPage(folder, slug) {
  const { code, title, tasks = [] } = JSON.parse(readFileSync(join(folder, "lesson.json"), "utf8"));
  const markdown = new MarkdownIt().use(mathematics);
  for (const kind of ["formula", "displayed"]) {
    markdown.renderer.rules[kind] = (tokens, index) =>
      formulaHtml(tokens[index]?.content ?? "", kind === "displayed");
  }
  const sections = tasks.map(
    (/** @type {{ name: string, title: string, statement: string }} */ task) => {
      const programs = programsOf(join(folder, task.name));
      const articles = programs.map(({ file, name, source }) => {
        const id = escapeHtml(`${task.name}/${file}`);
        return `<article aria-label="${id}"><h3>${escapeHtml(name)}</h3>
<pre><code>${highlightPython(source)}</code></pre>
<div id="${id}" class="result">not marked yet …</div></article>`;
      });
      return `<section aria-label="${escapeHtml(task.title)}"><h2>${escapeHtml(task.title)}</h2>
${markdown.render(task.statement)}${articles.join("\n")}</section>`;
    },
  );
  const none = "<p>This lesson has no tasks.</p>";
  return `<!doctype html>
<html lang="en-GB"><head><meta charset="utf-8"><title>Preview of ${escapeHtml(title)}</title>
<meta name="viewport" content="width=device-width, initial-scale=1"><link rel="icon" href="data:,">
<link rel="stylesheet" href="/@fs${join(ROOT, "node_modules/katex/dist/katex.min.css")}">
<style>${STYLE}</style></head><body>
<h1>${escapeHtml(code)} ${escapeHtml(title)}: what learners are told</h1>
<p><a href="/lessons/${slug}/">The lesson's page</a>. <span id="state" role="status">Marking …</span></p>
<div id="trouble"></div>
${sections.join("\n") || none}
<script>${SCRIPT}</script></body></html>`;
}

/**
 * The solution, the starter and the wrong attempts, in the order in which they are marked.
 * @param {string} task its folder
 */
function programsOf(task) {
  const wrong = join(task, "wrong");
  const attempts = existsSync(wrong)
    ? readdirSync(wrong).filter((file) => file.endsWith(".py"))
    : [];
  return [
    { file: "solution.py", name: "The solution" },
    { file: "starter.py", name: "The starter" },
    ...attempts.sort().map((file) => ({ file: `wrong/${file}`, name: `Wrong: ${file}` })),
  ]
    .filter(({ file }) => existsSync(join(task, file)))
    .map((each) => ({ ...each, source: readFileSync(join(task, each.file), "utf8") }));
}

/**
 * What a learner is told of a program; and, for whoever writes the lesson, whether it is what a wrong
 * attempt must earn.
 * @param {Mark} mark
 * @param {string | null} earns
 */
export function resultHtml(mark, earns) {
  if (mark.ours !== null)
    return `<p class="bad">A fault of the lesson: ${escapeHtml(mark.ours)}</p>`;
  const passed = mark.checks.filter(({ status }) => status === "passed").length;
  const parts = [
    `<p>${mark.passed ? "Passed" : "Not passed"}: ${passed} of ${mark.checks.length} checks.</p>`,
  ];
  const failed = mark.checks.find(({ status }) => status === "failed");
  if (failed) parts.push(checkHtml(failed));
  if (earns !== null) {
    const said = failed ? (failed.likely ?? failed.got) : "";
    const right = said.includes(earns);
    parts.push(
      right
        ? "<p>That is what it must earn.</p>"
        : `<p class="bad">It must earn: ${escapeHtml(earns)}</p>`,
    );
  }
  return parts.join("");
}

/** @param {Check} check */
function checkHtml({ title, expected, got, likely, hint, where }) {
  const rows = [
    ["Expected", expected],
    ["Got", got],
    ...(likely === null ? [] : [["Likely mistake", likely]]),
    ...(hint === null ? [] : [["Helps", `hint ${hint + 1}`]]),
  ];
  const told = rows.map(([name, text = ""]) => `<dt>${name}</dt><dd>${escapeHtml(text)}</dd>`);
  return `<h4>${escapeHtml(title)}</h4><dl>${told.join("")}</dl>${where ? placeHtml(where) : ""}`;
}

/** Where on the mat it is wrong. @param {Where} where */
function placeHtml({ world, cells, cell_cm, seconds }) {
  const at = seconds === null ? "" : `, at ${seconds.toFixed(1)} s`;
  const words = `<p>In the world ${escapeHtml(world.name)}${at}.</p>`;
  if (cells.length === 0) return words;
  /** @param {number} x @param {number} y @param {number} w @param {number} h @param {string} look */
  const box = (x, y, w, h, look) =>
    `<rect x="${x}" y="${MAT_CM - y - h}" width="${w}" height="${h}" ${look}/>`;
  const things = world.obstacles.map(({ x, y, width, height }) =>
    box(x, y, width, height, 'fill="#8888"'),
  );
  const wrong = cells.map(([column, row]) =>
    box(
      column * cell_cm,
      row * cell_cm,
      cell_cm,
      cell_cm,
      'fill="none" stroke="#c02626" stroke-width="1.5"',
    ),
  );
  const name = `${cells.length} cells outlined on the mat`;
  return `${words}<svg viewBox="-2 -2 ${MAT_CM + 4} ${MAT_CM + 4}" role="img" aria-label="${name}">${things.join("")}${wrong.join("")}</svg>`;
}
