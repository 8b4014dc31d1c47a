/**
 * npm run lesson:new -- SLUG: begins a lesson. Copies lessons/_template, puts the names in, adds the
 * lesson to the end of the course, and says what to do next.
 */
import { cpSync, existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { filesBelow, messageOf, ROOT, write } from "./files.mjs";
import { ensureInstalled, fail, run } from "./install.mjs";

const SLUG = /^[a-z0-9]+(-[a-z0-9]+)*$/;

/**
 * Begin a lesson in a folder of lessons; throws what is wrong with the name.
 * @param {string} slug
 * @param {string} lessons the folder that holds course.json and _template
 * @returns {string[]} the files of the new lesson, by their paths in its folder
 */
export function newLesson(slug, lessons) {
  if (!SLUG.test(slug)) {
    throw new Error(
      `A lesson's name has small letters, digits and hyphens, as u9-1-doors; it got "${slug}". ` +
        "It becomes the address of the page: keep it short and don't change it later.",
    );
  }
  const folder = join(lessons, slug);
  if (existsSync(folder)) {
    throw new Error(
      `There is a lessons/${slug} already: take another name, or remove that folder.`,
    );
  }
  cpSync(join(lessons, "_template"), folder, {
    recursive: true,
    filter: (path) => !path.includes("__pycache__"),
  });
  const words = slug.replace(/^u\d+-\d+-/, "").replaceAll("-", " ");
  const title = words.charAt(0).toUpperCase() + words.slice(1);
  const about = join(folder, "lesson.json");
  write(about, readFileSync(about, "utf8").replace('"TITLE"', JSON.stringify(title)));
  const path = join(lessons, "course.json");
  const course = JSON.parse(readFileSync(path, "utf8"));
  course.lessons.push(slug);
  write(path, `${JSON.stringify(course, null, 2)}\n`);
  return filesBelow(folder);
}

/** @param {string[]} args */
function main(args) {
  const [slug] = args;
  if (slug === undefined || args.length > 1) {
    fail("One name is wanted.", "npm run lesson:new -- u9-1-the-name-of-your-lesson");
  }
  ensureInstalled();
  const files = tried(() => newLesson(slug, join(ROOT, "lessons")));
  const written = ["lessons/course.json", `lessons/${slug}`];
  run("npx", ["biome", "format", "--write", "--log-level=error", ...written]);
  console.log(`lessons/${slug} is there, and is the last lesson of lessons/course.json:\n`);
  for (const file of files) console.log(`  ${file}`);
  console.log(`
It is a small lesson that works. Next (lessons/README.md has it at length):

  1. npm run dev, and open /lessons/${slug}/: the page follows what you write
  2. lesson.json: title, goals, programs, tasks and their hints
  3. lesson.md: the prose
  4. the folder of each task: starter, solution, check, wrong attempts, right ones
  5. npm run lesson:check -- ${slug}, before you publish

To be rid of it: remove the folder and its line in lessons/course.json.`);
}

/**
 * @template T
 * @param {() => T} work
 */
function tried(work) {
  try {
    return work();
  } catch (error) {
    return fail(messageOf(error));
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) main(process.argv.slice(2));
