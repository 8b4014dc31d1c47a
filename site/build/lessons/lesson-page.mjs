/**
 * One lesson as a whole page: what it assumes and aims at, its contents, its prose, its neighbours,
 * and what search engines are told. Text in, text out.
 *
 * @typedef {import("./folder.mjs").Lesson} Lesson
 * @typedef {import("./prose.mjs").Prose} Prose
 * @typedef {import("markdown-it").Token} Token
 * @typedef {{ slug: string, path: string, code: string | null, title: string }} Link
 * @typedef {{
 *   lesson: Lesson, prose: Prose, tokens: Token[],
 *   taskWords: ReadonlyMap<string, import("./blocks.mjs").TaskWords>,
 *   path: string, katex: string | null,
 *   position: { number: number, of: number } | null,
 *   assumes: Link[], previous: Link | null, next: Link | null,
 * }} PageInput path: of the page from the site's own folder, with a slash at its end
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "../files.mjs";
import { lessonData } from "./blocks.mjs";
import { numberText } from "./figure-value.mjs";
import { escapeHtml, jsonScript } from "./html.mjs";
import { plainText } from "./prose.mjs";
import { headTags, toRoot } from "./site-frame.mjs";

const TEMPLATE = join(ROOT, "site/lesson.html");
const WORDS_A_MINUTE = 220;
const QUESTIONS = "Questions";

/**
 * @param {PageInput} page
 * @returns {string}
 */
export function lessonPage(page) {
  const { lesson, prose, tokens, path } = page;
  const { title, summary } = lesson.about;
  const body = prose.render(tokens);
  const formulas = body.includes('class="katex"');
  const questions = questionsOf(tokens, prose);
  /** @type {Record<string, string>} */
  const parts = {
    HEAD: headTags({ path, title, description: summary, article: true }),
    MATHEMATICS: formulas
      ? mathematicsLinks(page.katex ?? `${toRoot(path)}../node_modules/katex/dist`)
      : "",
    ROOT: toRoot(path),
    LESSON_HEAD: lessonHead(page),
    CONTENTS: contentsHtml(page),
    BODY: body,
    NEIGHBOURS: neighbours(page),
    DATA: jsonScript('type="application/json" id="lesson-data"', lessonData(lesson)),
    QUESTIONS: questions.length > 0 ? faqData(questions) : "",
  };
  // Read anew for each page: in development the template may change.
  const template = readFileSync(TEMPLATE, "utf8");
  return template.replace(/%([A-Z_]+)%/g, (_whole, name) => {
    const part = parts[String(name)];
    if (part === undefined) throw new Error(`site/lesson.html: there is no part %${name}%`);
    return part;
  });
}

/** @param {PageInput} page */
function lessonHead({ lesson, prose, tokens, path, position, assumes }) {
  const { code, title, summary, minutes, goals } = lesson.about;
  /** @param {string} text of lesson.json */
  const inline = (text) => prose.render(prose.parseInline(text, { file: lesson.json, line: 1 }));
  const words = plainText(tokens).split(/\s+/).length;
  const reading = Math.max(1, Math.round(words / WORDS_A_MINUTE));
  const time =
    minutes === null ? `${reading} minutes to read` : `About ${minutes} minutes with the tasks`;
  const place = position ? `Lesson ${position.number} of ${position.of}` : "";
  const over = [code, place].filter(Boolean).join(" · ");
  const links = assumes.map(
    (link) => `<a href="${toRoot(path)}${link.path}">${escapeHtml(linkText(link))}</a>`,
  );
  const before = links.length > 0 ? `<div><dt>Assumes</dt><dd>${links.join(", ")}</dd></div>` : "";
  const list = goals.map((goal) => `<li>${inline(goal)}</li>`).join("\n");
  const tasks = lesson.tasks.size;
  const progress = tasks > 0 ? `<div><dt>Tasks</dt><dd class="task-count">${tasks}</dd></div>` : "";
  return `${over ? `<p class="over">${escapeHtml(over)}</p>\n` : ""}<h1>${escapeHtml(title)}</h1>
<p class="lead">${inline(summary)}</p>
<dl class="lesson-facts"><div><dt>Time</dt><dd>${time}</dd></div>${progress}${before}</dl>
<div class="goals"><p>Afterwards you can</p>
<ul>
${list}
</ul></div>`;
}

/**
 * The sections, each with its tasks.
 * @param {PageInput} page
 */
function contentsHtml({ lesson, prose, tokens, taskWords }) {
  /** @type {{ id: string, text: string, tasks: string[] }[]} */
  const sections = [];
  for (const token of tokens) {
    if (token.type === "heading_open" && token.tag === "h2") {
      const { id, text } = /** @type {{ id: string, text: string }} */ (token.meta);
      sections.push({ id, text, tasks: [] });
    }
    if (token.type !== "directive") continue;
    const { placed } = /** @type {{ placed: import("./prose.mjs").PlacedDirective }} */ (
      token.meta
    );
    const task = placed.name === "task" ? lesson.tasks.get(placed.argument) : undefined;
    if (!task) continue;
    const title = prose.render(taskWords.get(task.name)?.title ?? []);
    const link = `<li data-task="${task.name}"><a href="#task-${task.name}">${title}</a></li>`;
    sections.at(-1)?.tasks.push(link);
  }
  const items = sections.map(({ id, text, tasks }) => {
    const inside = tasks.length > 0 ? `<ol class="contents-tasks">${tasks.join("")}</ol>` : "";
    return `<li><a href="#${escapeHtml(id)}">${escapeHtml(text)}</a>${inside}</li>`;
  });
  return `<ol>\n${items.join("\n")}\n</ol>`;
}

/** @param {PageInput} page */
function neighbours({ path, previous, next }) {
  /** @param {Link | null} link @param {string} word @param {string} rel */
  const one = (link, word, rel) =>
    link
      ? `<a rel="${rel}" href="${toRoot(path)}${link.path}"><span>${word}</span> <b>${escapeHtml(linkText(link))}</b></a>`
      : "";
  const links = [one(previous, "Previous", "prev"), one(next, "Next", "next")];
  return links.filter(Boolean).join("\n");
}

/** @param {Link} link */
function linkText({ code, title }) {
  return code ? `${code} ${title}` : title;
}

/**
 * The style sheet and the two fonts that every formula needs, asked for before they are found out.
 * @param {string} katex address of the package's files
 */
function mathematicsLinks(katex) {
  const fonts = ["KaTeX_Main-Regular", "KaTeX_Math-Italic"].map(
    (font) =>
      `<link rel="preload" as="font" type="font/woff2" crossorigin href="${katex}/fonts/${font}.woff2" />`,
  );
  return [`<link rel="stylesheet" href="${katex}/katex.min.css" />`, ...fonts].join("\n    ");
}

/**
 * Each third-level heading under "Questions" with the words up to the next.
 * @param {Token[]} tokens
 * @param {Prose} prose
 * @returns {{ question: string, answer: string }[]}
 */
function questionsOf(tokens, prose) {
  /** @type {{ question: string, tokens: Token[] }[]} */
  const found = [];
  let inside = false;
  for (const token of tokens) {
    if (token.type === "heading_open") {
      const { text } = /** @type {{ text: string }} */ (token.meta);
      if (token.tag === "h2") inside = text === QUESTIONS;
      else if (inside && token.tag === "h3") found.push({ question: text, tokens: [] });
    } else if (inside) {
      found.at(-1)?.tokens.push(token);
    }
  }
  return found.map(({ question, tokens: inner }) => {
    // The first of them are the heading's own words.
    const words = inner.slice(inner.findIndex(({ type }) => type === "heading_close") + 1);
    const answer = plainText(words, (reference) =>
      reference.kind === "figure"
        ? numberText(prose.values.get(reference.figure.text) ?? Number.NaN, reference.digits)
        : "",
    );
    return { question, answer };
  });
}

/** @param {{ question: string, answer: string }[]} questions */
function faqData(questions) {
  return jsonScript('type="application/ld+json"', {
    "@context": "https://schema.org",
    "@type": "FAQPage",
    mainEntity: questions.map(({ question, answer }) => ({
      "@type": "Question",
      name: question,
      acceptedAnswer: { "@type": "Answer", text: answer },
    })),
  });
}
