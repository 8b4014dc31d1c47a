/**
 * What the home page has from the lessons: the path through the course, and a real map as its
 * picture. site/index.html holds the comments `<!-- course -->` and `<!-- map -->` in their place.
 *
 * @typedef {import("./course.mjs").Course} Course
 * @typedef {import("./folder.mjs").Lesson} Lesson
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "../files.mjs";
import { pathOf } from "./course.mjs";
import { numberText } from "./figure-value.mjs";
import { escapeHtml } from "./html.mjs";
import { mapPicture } from "./map-picture.mjs";
import { headTags } from "./site-frame.mjs";

const TITLE = "Occupancy grid mapping with programs that run";
const DESCRIPTION =
  "Learn how a robot builds a map: an article and lessons with real Python programs for a small simulated robot, run in your own browser.";

/**
 * @param {string} html
 * @param {Course} course
 */
export async function fillHome(html, course) {
  const head = headTags({ path: "", title: TITLE, description: DESCRIPTION, article: false });
  return html
    .replace("<!-- head -->", head)
    .replace("<!-- map -->", await mapFigure(course))
    .replace("<!-- course -->", courseHtml(course.lessons));
}

/**
 * The run that the map is of: the first program of the lab.
 * @param {Course} course
 */
export async function mapRun(course) {
  const folder = join(ROOT, "lessons/lab");
  const [first] = JSON.parse(readFileSync(join(folder, "lab.json"), "utf8"));
  const world = course.worlds.find(({ name }) => name === first.world);
  if (!world) throw new Error(`lessons/lab/lab.json: there is no world ${first.world}`);
  const program = readFileSync(join(folder, first.program), "utf8");
  return { outcome: await course.outcome(program, world), world };
}

/** @param {Course} course */
async function mapFigure(course) {
  const { outcome, world } = await mapRun(course);
  const { free, occupied } = outcome.layers;
  const counts = `${free?.points.length} cells are free, ${occupied?.points.length} are occupied`;
  const svg = mapPicture(outcome, world, {
    title: "A map that the robot made in one turn on the spot",
    description: `The mat from above. Round the robot the floor is known to be free, with dark cells along the edge of the mat, the post and the shelf, and nothing known in the shadows behind them. ${counts}.`,
  });
  const seconds = numberText(outcome.seconds);
  return `<figure class="home-map">${svg}<figcaption>What the robot knows of its mat after turning for ${seconds} seconds: ${counts}, and what it never saw is bare.</figcaption></figure>`;
}

/** @param {readonly Lesson[]} lessons */
function courseHtml(lessons) {
  return lessons
    .map((lesson) => {
      const { slug, article, about, tasks } = lesson;
      const before = about.assumes.flatMap((each) => {
        const other = lessons.find((one) => one.slug === each);
        return other ? [other.about.code ?? other.about.title] : [];
      });
      const minutes = about.minutes === null ? "" : `${about.minutes} minutes`;
      const needs = before.length > 0 ? `after ${before.join(", ")}` : "";
      const count = tasks.size > 0 ? `${tasks.size} ${tasks.size === 1 ? "task" : "tasks"}` : "";
      const facts = [minutes, count, needs].filter(Boolean).join(" · ");
      const names = escapeHtml(JSON.stringify([...tasks.keys()]));
      const label = about.code ?? (article ? "Read first" : "");
      return `<li data-lesson="${slug}" data-tasks="${names}">
<span class="code">${escapeHtml(label)}</span>
<a href="./${pathOf(slug)}">${escapeHtml(about.title)}</a>
<span class="done"></span>
<span class="summary">${escapeHtml(about.summary)}</span>
<span class="facts">${escapeHtml(facts)}</span>
</li>`;
    })
    .join("\n");
}
