/**
 * npm run lesson:new -- SLUG: begins a lesson. Copies lessons/_template, puts the names in, adds the
 * lesson to the end of the course, and says what to do next.
 */
import { cpSync, existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { filesBelow, ROOT, write } from "./files.mjs";
import { ensureInstalled, fail, run } from "./install.mjs";

ensureInstalled();
const SLUG = /^[a-z0-9]+(-[a-z0-9]+)*$/;
const LESSONS = join(ROOT, "lessons");

const [slug, ...more] = process.argv.slice(2);
if (slug === undefined || more.length > 0) {
  fail("One name is wanted.", "npm run lesson:new -- u9-1-the-name-of-your-lesson");
}
if (!SLUG.test(slug)) {
  fail(
    `A lesson's name has small letters, digits and hyphens, as u9-1-doors; it got "${slug}".`,
    "it becomes the address of the page, so keep it short and don't change it later.",
  );
}
const folder = join(LESSONS, slug);
if (existsSync(folder)) {
  fail(`There is a lessons/${slug} already.`, "take another name, or remove that folder.");
}

cpSync(join(LESSONS, "_template"), folder, {
  recursive: true,
  filter: (path) => !path.includes("__pycache__"),
});
const words = slug.replace(/^u\d+-\d+-/, "").replaceAll("-", " ");
const title = words.charAt(0).toUpperCase() + words.slice(1);
const about = join(folder, "lesson.json");
write(about, readFileSync(about, "utf8").replace('"TITLE"', JSON.stringify(title)));
const path = join(LESSONS, "course.json");
const course = JSON.parse(readFileSync(path, "utf8"));
course.lessons.push(slug);
write(path, JSON.stringify(course));
run("npx", ["biome", "format", "--write", "--log-level=error", path, about]);

console.log(`lessons/${slug} is there, and is the last lesson of lessons/course.json:\n`);
for (const file of filesBelow(folder)) console.log(`  ${file}`);
console.log(`
It is a small lesson that works. Next (lessons/README.md has it at length):

  1. npm run dev                         and open /lessons/${slug}/: it follows what you write
  2. lessons/${slug}/lesson.json         title, goals, programs, tasks and their hints
  3. lessons/${slug}/lesson.md           the prose
  4. the folder of each task             starter, solution, check and wrong attempts
  5. npm run lesson:check -- ${slug}     before you publish

To be rid of it: remove the folder and its line in lessons/course.json.`);
