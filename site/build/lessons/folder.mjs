/**
 * Reads a lesson's folder as it lies there: lesson.json, lesson.md, programs, worlds, tasks.
 * What is missing or wrong becomes a fault; whatever can be read is returned all the same, so that
 * one build reports everything. Imports `faults` and `schema`.
 *
 * @typedef {import("./faults.mjs").Fault} Fault
 * @typedef {import("../../src/trace/events.ts").World} World
 * @typedef {{ name: string, title: string, world: string, seed: number, file: string, source: string }} Program
 * @typedef {{
 *   name: string, title: string, statement: string, hints: string[], world: string, seed: number,
 *   practice: string[], stretch: boolean, starter: string, solution: string, check: string,
 *   lineOf: (part: "title" | "statement" | number) => number,
 * }} Task lineOf says on which line of lesson.json the title, the statement or a hint stands
 * @typedef {{
 *   slug: string,
 *   folder: string,
 *   article: boolean,
 *   about: About,
 *   json: string,
 *   markdown: { file: string, text: string },
 *   programs: Map<string, Program>,
 *   tasks: Map<string, Task>,
 *   worlds: World[],
 *   lineOf: (path: (string | number)[]) => number,
 *   faults: Fault[],
 * }} Lesson
 * @typedef {{
 *   code: string | null, title: string, summary: string, minutes: number | null,
 *   goals: string[], assumes: string[],
 * }} About
 */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "../files.mjs";
import { listText, shownPath } from "./faults.mjs";
import { readJson } from "./schema.mjs";

export const ARTICLE = "occupancy-grid-mapping";

const SCHEMA = JSON.parse(readFileSync(join(ROOT, "lessons/lesson.schema.json"), "utf8"));
const COURSE_SCHEMA = {
  type: "object",
  required: ["format", "lessons"],
  properties: {
    format: { const: 1 },
    lessons: { type: "array", uniqueItems: true, items: { type: "string" } },
  },
};

/** A program or a task runs with this noise unless it says otherwise. */
const USUAL_SEED = 1;

/**
 * The folders of the pages: the article, if it has been written, then the lessons of course.json.
 * @param {string} folder that holds course.json
 * @returns {{ slugs: string[], faults: Fault[] }}
 */
export function readCourse(folder) {
  const path = join(folder, "course.json");
  const { data, faults, lineOf } = readJson(path, COURSE_SCHEMA);
  if (faults.length > 0) return { slugs: [], faults };
  /** @type {string[]} */
  const lessons = data.lessons;
  const missing = lessons
    .map((slug, index) => ({ slug, line: lineOf(["lessons", index]) }))
    .filter(({ slug }) => !existsSync(join(folder, slug, "lesson.json")))
    .map(({ slug, line }) => ({
      file: shownPath(path),
      line,
      fault: `there is no lesson ${slug}`,
      remedy: `write ${shownPath(join(folder, slug, "lesson.json"))}, or take the entry out.`,
    }));
  const there = lessons.filter((slug) => existsSync(join(folder, slug, "lesson.json")));
  const article = existsSync(join(folder, ARTICLE, "lesson.md")) ? [ARTICLE] : [];
  return { slugs: [...article, ...there], faults: missing };
}

/**
 * @param {string} folder of the lesson
 * @param {readonly World[]} siteWorlds the worlds that every lesson may use
 * @returns {Lesson}
 */
export function readLesson(folder, siteWorlds) {
  const slug = folder.split(/[\\/]/).at(-1) ?? folder;
  const jsonPath = join(folder, "lesson.json");
  const json = shownPath(jsonPath);
  const reader = new Reader(folder);
  const { data, faults, lineOf } = reader.json(jsonPath);
  const markdownPath = join(folder, "lesson.md");
  const text = reader.text(markdownPath, "write the lesson's prose there.", null);
  const worlds = reader.worlds();
  const lesson = {
    slug,
    folder,
    article: slug === ARTICLE,
    about: aboutOf(data, slug),
    json,
    markdown: { file: shownPath(markdownPath), text },
    programs: new Map(),
    tasks: new Map(),
    worlds,
    lineOf,
    faults: [...faults, ...reader.faults],
  };
  // Of a file with faults of its own, only the words above are of use.
  if (faults.length > 0) return lesson;
  const known = [...siteWorlds, ...worlds].map(({ name }) => name);
  lesson.programs = programsOf(data, reader, lineOf);
  lesson.tasks = tasksOf(data, reader, lineOf);
  const users = [
    ...Object.entries(data.programs).map(([name, { world }]) => ({
      world,
      at: ["programs", name, "world"],
    })),
    ...(data.tasks ?? []).map((/** @type {any} */ { world }, /** @type {number} */ index) => ({
      world,
      at: ["tasks", index, "world"],
    })),
    ...(data.tasks ?? []).flatMap(
      (/** @type {any} */ { practice = [] }, /** @type {number} */ index) =>
        practice.map((/** @type {string} */ world, /** @type {number} */ at) => ({
          world,
          at: ["tasks", index, "practice", at],
        })),
    ),
  ];
  const strange = users
    .filter(({ world }) => !known.includes(world))
    .map(({ world, at }) => ({
      file: json,
      line: lineOf(at),
      fault: `there is no world "${world}"`,
      remedy: `name one of ${listText(known)}, or write ${shownPath(join(folder, "worlds", `${world}.json`))}.`,
    }));
  lesson.faults = [...reader.faults, ...strange];
  return lesson;
}

/** Reads files of one folder and gathers what is wrong with them. */
class Reader {
  /** @param {string} folder */
  constructor(folder) {
    this.folder = folder;
    /** @type {Fault[]} */
    this.faults = [];
  }

  /** @param {string} path */
  json(path) {
    if (existsSync(path)) return readJson(path, SCHEMA);
    const remedy = "write it; lessons/README.md says what belongs in it.";
    const fault = { file: shownPath(path), line: null, fault: "the file is missing", remedy };
    return { data: undefined, faults: [fault], lineOf: () => 1 };
  }

  /**
   * @param {string} path
   * @param {string} remedy if it is not there
   * @param {{ file: string, line: number } | null} named where the file is asked for
   */
  text(path, remedy, named) {
    if (existsSync(path))
      return readFileSync(path, "utf8")
        .replace(/^\uFEFF/, "")
        .replaceAll("\r\n", "\n");
    const file = shownPath(path);
    this.faults.push(
      named
        ? { ...named, fault: `${file} is missing`, remedy }
        : { file, line: null, fault: "the file is missing", remedy },
    );
    return "";
  }

  /** @returns {World[]} */
  worlds() {
    const folder = join(this.folder, "worlds");
    if (!existsSync(folder)) return [];
    return readdirSync(folder)
      .filter((file) => file.endsWith(".json"))
      .sort()
      .flatMap((file) => {
        const path = join(folder, file);
        const { data, faults } = readJson(path, { type: "object", required: ["name"] });
        this.faults.push(...faults);
        if (faults.length > 0) return [];
        if (`${data.name}.json` === file) return [data];
        const remedy = `make its name "${file.replace(/\.json$/, "")}", as the file is called.`;
        const fault = `the world's name is "${data.name}"`;
        this.faults.push({ file: shownPath(path), line: 1, fault, remedy });
        return [];
      });
  }
}

/**
 * The lesson's own words. They are wanted of a file with faults as well, where they may be anything.
 * @param {any} data
 * @param {string} slug
 * @returns {About}
 */
function aboutOf(data, slug) {
  /** @param {unknown} value */
  const text = (value) => (typeof value === "string" ? value : null);
  /** @param {unknown} value */
  const texts = (value) => (Array.isArray(value) ? value.flatMap((each) => text(each) ?? []) : []);
  return {
    code: text(data?.code),
    title: curly(text(data?.title) ?? slug),
    summary: curly(text(data?.summary) ?? ""),
    minutes: typeof data?.minutes === "number" ? data.minutes : null,
    goals: texts(data?.goals),
    assumes: texts(data?.assumes),
  };
}

/**
 * Apostrophes as in the prose, for words that go where no Markdown does.
 * @param {string} text
 */
function curly(text) {
  return text.replace(/(?<=\p{L})'/gu, "’");
}

/**
 * @param {any} data
 * @param {Reader} reader
 * @param {Lesson["lineOf"]} lineOf
 * @returns {Map<string, Program>}
 */
function programsOf(data, reader, lineOf) {
  const file = shownPath(join(reader.folder, "lesson.json"));
  return new Map(
    Object.entries(data.programs).map(([name, entry]) => {
      const path = join(reader.folder, "programs", entry.file ?? `${name}.py`);
      const remedy = "write it, or mend the entry.";
      const source = reader.text(path, remedy, { file, line: lineOf(["programs", name]) });
      const { title, world, seed = USUAL_SEED } = entry;
      return [name, { name, title, world, seed, file: shownPath(path), source }];
    }),
  );
}

/**
 * @param {any} data
 * @param {Reader} reader
 * @param {Lesson["lineOf"]} lineOf
 * @returns {Map<string, Task>}
 */
function tasksOf(data, reader, lineOf) {
  const file = shownPath(join(reader.folder, "lesson.json"));
  return new Map(
    (data.tasks ?? []).map((/** @type {any} */ entry, /** @type {number} */ index) => {
      const { name, title, statement, hints, world, seed = USUAL_SEED } = entry;
      const { practice = [], stretch = false } = entry;
      const named = { file, line: lineOf(["tasks", index, "name"]) };
      const [starter, solution, check] = ["starter.py", "solution.py", "check.py"].map((part) =>
        reader.text(join(reader.folder, name, part), "write it, or take the task out.", named),
      );
      /** @param {"title" | "statement" | number} part */
      const at = (part) =>
        lineOf(["tasks", index, ...(typeof part === "string" ? [part] : ["hints", part])]);
      const words = { name, title, statement, hints, world, seed, practice, stretch };
      return [name, { ...words, starter, solution, check, lineOf: at }];
    }),
  );
}
