/**
 * node site/build/lessons/check.mjs SLUG…: makes these lessons' pages, whether they are in
 * course.json or not, and tells their faults and the value of every figure. Writes nothing.
 */
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { liveFigures } from "../figures.mjs";
import { messageOf, ROOT } from "../files.mjs";
import { fail } from "../install.mjs";
import { preparePython } from "../python.mjs";
import { Course } from "./course.mjs";
import { staleText } from "./kept-figures.mjs";
import { Measurer } from "./measure.mjs";

const slugs = process.argv.slice(2);
if (slugs.length === 0) fail("Which lesson?", "node site/build/lessons/check.mjs SLUG");
/** @param {string} text */
const log = (text) => console.log(text);
const python = await preparePython(log);
const worlds = /** @type {import("./course.mjs").World[]} */ (python.course.worlds);
const measurer = new Measurer(python, log);
const folder = join(ROOT, "lessons");
const written = readdirSync(folder).filter((slug) => existsSync(join(folder, slug, "lesson.json")));
const options = { folder, worlds, measurer, live: await liveFigures(), katex: null };
const course = new Course(options, [...written, ...slugs]);
let faulty = 0;
for (const slug of slugs) {
  const faults = await course.page(slug).then(() => null, messageOf);
  for (const [text, value] of course.valuesOf(slug)) console.log(`${value}\t${text}`);
  console.log(faults ?? `${slug} is well`);
  if (faults !== null) faulty += 1;
  else if (course.staleOf([slug]).length > 0) console.log(staleText(course.staleOf([slug])));
}
process.exit(faulty > 0 ? 1 : 0);
