/**
 * A lesson's folder as its authors' page shows it: the tasks, their programs with what is known of
 * their marks, and the reasons of equivalent.json.
 *
 * @typedef {import("../../src/preview/data.ts").LessonPreview} LessonPreview
 * @typedef {import("../../src/preview/data.ts").TaskPreview} TaskPreview
 * @typedef {import("../../src/preview/data.ts").ProgramFile} ProgramFile
 * @typedef {import("../../src/preview/data.ts").Kind} Kind
 * @typedef {{ name: string, title: string, statement: string, hints: string[] }} Entry of lesson.json
 */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import MarkdownIt from "markdown-it";
import { messageOf } from "../files.mjs";
import { highlightPython } from "../lessons/highlight.mjs";
import { formulaHtml, mathematics } from "../lessons/math.mjs";
import { keptTold, keyOf, mutantsKey } from "./marks.mjs";
import { keptMutants } from "./mutants.mjs";

/**
 * @param {string} lessons the folder of course.json
 * @param {string} slug
 * @returns {LessonPreview}
 */
export function readPreview(lessons, slug) {
  const folder = join(lessons, slug);
  const known = { slug, code: "", title: slug, lessons: lessonsOf(lessons) };
  try {
    const { code = "", title, tasks = [] } = readJson(join(folder, "lesson.json"));
    const made = tasks.map((/** @type {Entry} */ entry) => taskOf(folder, entry));
    return { ...known, code, title, tasks: made, trouble: null };
  } catch (error) {
    return { ...known, tasks: [], trouble: messageOf(error) };
  }
}

/** @param {string} path */
function readJson(path) {
  try {
    return JSON.parse(readFileSync(path, "utf8"));
  } catch (error) {
    throw new Error(`${path}: ${messageOf(error)}`);
  }
}

/**
 * Those that have tasks.
 * @param {string} lessons
 */
function lessonsOf(lessons) {
  /** @type {string[]} */
  const slugs = readJson(join(lessons, "course.json")).lessons ?? [];
  return slugs.flatMap((slug) => {
    try {
      const { code = "", title = slug, tasks = [] } = readJson(join(lessons, slug, "lesson.json"));
      return tasks.length > 0 ? [{ slug, code, title }] : [];
    } catch {
      return [{ slug, code: "", title: slug }];
    }
  });
}

const markdown = new MarkdownIt().use(mathematics);
for (const kind of ["formula", "displayed"]) {
  markdown.renderer.rules[kind] = (tokens, index) =>
    formulaHtml(tokens[index]?.content ?? "", kind === "displayed");
}

/**
 * @param {string} folder of the lesson
 * @param {Entry} entry
 * @returns {TaskPreview}
 */
function taskOf(folder, { name, title, statement, hints }) {
  const path = join(folder, name);
  return {
    name,
    title: markdown.renderInline(title),
    statement: markdown.render(statement),
    hints: hints.map((hint) => markdown.render(hint)),
    files: [
      ...programs(path, "starter", ["starter.py"]),
      ...programs(path, "solution", ["solution.py"]),
      ...programs(path, "right", filesOf(path, "right")),
      ...programs(path, "wrong", filesOf(path, "wrong")),
    ],
    reasons: existsSync(join(path, "equivalent.json"))
      ? readJson(join(path, "equivalent.json"))
      : [],
    mutants: keptMutants(mutantsKey(path)),
  };
}

/**
 * @param {string} task
 * @param {"right" | "wrong"} kind
 */
function filesOf(task, kind) {
  if (!existsSync(join(task, kind))) return [];
  const names = readdirSync(join(task, kind)).filter((file) => file.endsWith(".py"));
  return names.sort().map((file) => `${kind}/${file}`);
}

/**
 * @param {string} task
 * @param {Kind} kind
 * @param {string[]} files
 * @returns {ProgramFile[]}
 */
function programs(task, kind, files) {
  const there = files.filter((file) => existsSync(join(task, file)));
  return there.map((file) => {
    const source = readFileSync(join(task, file), "utf8");
    const [, note = ""] = /^# (?:earns|style): *(.*)/.exec(source) ?? [];
    const key = keyOf(task, file);
    const html = highlightPython(source.trimEnd());
    return { kind, file, note: note.trim(), html, key, told: keptTold(key) };
  });
}
