/**
 * All pages made from lessons/: reads the folders, measures, and writes HTML. The way in for
 * the build (every page, or every fault), for the development server (one page, newly read) and for
 * `check.mjs` (one lesson's faults and figures).
 *
 * @typedef {import("./folder.mjs").Lesson} Lesson
 * @typedef {import("./faults.mjs").Fault} Fault
 * @typedef {import("../../src/trace/events.ts").World} World
 * @typedef {{
 *   folder: string,
 *   worlds: readonly World[],
 *   measurer: import("./measure.mjs").Measurer,
 *   live: Readonly<Record<string, string>>,
 *   katex: string | null,
 *   again?: (figure: string) => boolean,
 * }} CourseOptions folder: that of course.json; worlds: those of the site; katex: the address of the
 *   package's folder, if it is not beside the site's; again: figures to measure though they are kept
 * @typedef {{ lesson: Lesson, prose: Prose, tokens: import("markdown-it").Token[],
 *             taskWords: Map<string, import("./blocks.mjs").TaskWords>, kept: KeptFigures }} Draft
 */
import { existsSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "../files.mjs";
import { blockWriter, checkDirectives } from "./blocks.mjs";
import { LessonFaults, listText } from "./faults.mjs";
import { simulatorHash } from "./figure-inputs.mjs";
import { ARTICLE, readCourse, readLesson } from "./folder.mjs";
import { KeptFigures } from "./kept-figures.mjs";
import { lessonPage } from "./lesson-page.mjs";
import { lookUp } from "./look-up.mjs";
import { picturesOf } from "./pictures.mjs";
import { Prose } from "./prose.mjs";

/** Where a lesson's page lies in the site. @param {string} slug */
export function pathOf(slug) {
  return slug === ARTICLE ? `${slug}/` : `lessons/${slug}/`;
}

export class Course {
  #options;
  /** The lessons as they are now, read and parsed. @type {Draft[]} */
  #drafts;
  /** What is wrong with course.json. @type {Fault[]} */
  #faults;

  /**
   * @param {CourseOptions} options
   * @param {readonly string[]} [only] these lessons instead of those of course.json
   */
  constructor(options, only) {
    this.#options = options;
    const { slugs, faults } = readCourse(options.folder);
    this.#faults = faults;
    this.#drafts = [...new Set([...slugs, ...(only ?? [])])].map((slug) => {
      const lesson = readLesson(join(options.folder, slug), options.worlds);
      return draft(lesson, new KeptFigures(lesson.folder, simulatorHash()));
    });
  }

  /** Lessons in the order of the course, the article first if there is one. */
  get lessons() {
    return this.#drafts.map(({ lesson }) => lesson);
  }

  /**
   * Every page by its path. Throws LessonFaults with all that is wrong.
   * @returns {Promise<Map<string, string>>}
   */
  async pages() {
    /** @type {Map<string, string>} */
    const pages = new Map();
    const faults = [...this.#faults];
    // Side by side: what has to be measured for any of them shares the threads.
    const slugs = this.lessons.map(({ slug }) => slug);
    const made = await Promise.all(slugs.map((slug) => this.#make(slug)));
    made.forEach((page, index) => {
      pages.set(pathOf(slugs[index] ?? ""), page.html);
      faults.push(...page.faults);
    });
    if (faults.length > 0) throw new LessonFaults(faults);
    return pages;
  }

  /**
   * One page; throws LessonFaults with what is wrong with it. Null if there is no such lesson.
   * @param {string} slug
   */
  async page(slug) {
    if (!this.#drafts.some(({ lesson }) => lesson.slug === slug)) return null;
    const { html, faults } = await this.#make(slug);
    if (faults.length > 0) throw new LessonFaults(faults);
    return html;
  }

  /**
   * What a program comes to on a world, with noise 1, as `bugbot.run.outcome_of` tells it.
   * @param {string} program
   * @param {World} world
   * @returns {Promise<import("./figure-value.mjs").Outcome>}
   */
  async outcome(program, world) {
    const job = {
      kind: /** @type {const} */ ("run"),
      program,
      world: JSON.stringify(world),
      seed: 1,
    };
    const [answer] = await this.#options.measurer.answers([job]);
    if (answer && "outcome" in answer) return JSON.parse(answer.outcome);
    throw new Error(`a program could not be run on ${world.name}`);
  }

  get worlds() {
    return this.#options.worlds;
  }

  /**
   * The figures of a lesson with their values, once it has been made.
   * @param {string} slug
   */
  valuesOf(slug) {
    return this.#drafts.find(({ lesson }) => lesson.slug === slug)?.prose.values ?? new Map();
  }

  /**
   * The kept figures of these lessons, which have been made, where the file is not what it should be.
   * @param {readonly string[]} slugs
   */
  staleOf(slugs) {
    const made = this.#drafts.filter(({ lesson }) => slugs.includes(lesson.slug));
    return made.map(({ kept }) => kept).filter(({ isCurrent }) => !isCurrent);
  }

  /** @param {string} slug */
  async #make(slug) {
    const index = this.#drafts.findIndex(({ lesson }) => lesson.slug === slug);
    const { lesson, prose, tokens, taskWords, kept } = /** @type {Draft} */ (this.#drafts[index]);
    const { live, measurer, worlds, again } = this.#options;
    const pictures = await picturesOf(lesson, prose, measurer);
    const parts = { lesson, prose, taskWords, pictures, live };
    checkDirectives(parts);
    this.#checkLinks(lesson, prose);
    const assumes = this.#assumed(lesson, prose);
    await lookUp(lesson, prose, [...worlds, ...lesson.worlds], { measurer, kept, again });
    prose.block = blockWriter(parts);
    const lessons = this.#drafts.filter((each) => !each.lesson.article);
    const number = lessons.findIndex((each) => each.lesson === lesson) + 1;
    const html = lessonPage({
      lesson,
      prose,
      tokens,
      taskWords,
      path: pathOf(slug),
      katex: this.#options.katex,
      position: number > 0 ? { number, of: lessons.length } : null,
      assumes,
      previous: this.#link(index - 1),
      next: this.#link(index + 1),
    });
    return { html, faults: [...lesson.faults, ...prose.faults] };
  }

  /** @param {number} index */
  #link(index) {
    const lesson = this.#drafts[index]?.lesson;
    if (!lesson) return null;
    const { slug, about } = lesson;
    return { slug, path: pathOf(slug), code: about.code, title: about.title };
  }

  /**
   * @param {Lesson} lesson
   * @param {Prose} prose
   */
  #assumed(lesson, prose) {
    return lesson.about.assumes.flatMap((slug, at) => {
      const index = this.#drafts.findIndex((each) => each.lesson.slug === slug);
      const link = this.#link(index);
      if (link) return [link];
      const place = { file: lesson.json, line: lesson.lineOf(["assumes", at]) };
      const there = listText(this.lessons.map((each) => each.slug));
      prose.wrong(place, `there is no lesson "${slug}" in the course`, `name one of: ${there}.`);
      return [];
    });
  }

  /**
   * A link within the site leads to a page that is there, and to a heading on it.
   * @param {Lesson} lesson
   * @param {Prose} prose
   */
  #checkLinks(lesson, prose) {
    const site = "http://site/";
    for (const { href, ...place } of prose.links) {
      const url = URL.canParse(href, site) ? new URL(href, `${site}${pathOf(lesson.slug)}`) : null;
      if (!url) {
        prose.wrong(place, `the link ${href} is no address`, "mend the address.");
        continue;
      }
      if (url.origin !== new URL(site).origin) continue;
      const path = decodeURIComponent(url.pathname.slice(1));
      const target = this.#drafts.find((each) => pathOf(each.lesson.slug) === path);
      if (!target && !existsSync(join(ROOT, "site", path, "index.html"))) {
        const pages = listText(["lab/", ...this.lessons.map(({ slug }) => pathOf(slug))]);
        const remedy = `write the way from this page, ${pathOf(lesson.slug)}, to one of: ${pages}.`;
        prose.wrong(place, `the link ${href} leads to no page of the site`, remedy);
      } else if (target && url.hash) {
        const ids = idsOf(target);
        if (ids.includes(decodeURIComponent(url.hash.slice(1)))) continue;
        const remedy = `on ${path} there are: ${ids.map((id) => `#${id}`).join(", ")}.`;
        prose.wrong(place, `nothing on that page is called ${url.hash}`, remedy);
      }
    }
  }
}

/** @param {Draft} draft */
function idsOf({ prose }) {
  const blocks = prose.directives.map(({ name, argument }) => {
    const kind = name === "program" ? "lab" : name;
    return `${kind}-${argument}`;
  });
  return [...prose.headings.map(({ id }) => id), ...blocks];
}

/**
 * @param {Lesson} lesson
 * @param {KeptFigures} kept
 * @returns {Draft}
 */
function draft(lesson, kept) {
  const prose = new Prose();
  const { file, text } = lesson.markdown;
  const tokens = prose.parse(text, { file, line: 1 });
  const taskWords = new Map(
    [...lesson.tasks.values()].map((task) => {
      /** @param {string} words @param {"title" | "statement" | number} part */
      const parse = (words, part) =>
        prose.parse(words, { file: lesson.json, line: task.lineOf(part) }, { oneLine: true });
      const hints = task.hints.map((hint, index) => parse(hint, index));
      const title = prose.parseInline(task.title, {
        file: lesson.json,
        line: task.lineOf("title"),
      });
      return [task.name, { title, statement: parse(task.statement, "statement"), hints }];
    }),
  );
  return { lesson, prose, tokens, taskWords, kept };
}
