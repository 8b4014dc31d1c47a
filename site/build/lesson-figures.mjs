/**
 * npm run lesson:figures [-- SLUG… --again --check --one-in N]: writes what the figures of these lessons,
 * or of the whole course, come to into their figures.json, and says what has changed. Only what is
 * missing or stale is measured; with --again everything is.
 *
 * --check writes nothing, and ends with a fault if a file is not what it should be. With --one-in N it
 * also measures one kept figure in N again, which must come to the same number.
 */
import { existsSync } from "node:fs";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { messageOf, ROOT, sha256 } from "./files.mjs";
import { ensureInstalled, fail } from "./install.mjs";

const FOLDER = join(ROOT, "lessons");

const options = optionsOf(process.argv.slice(2));
ensureInstalled();
const { liveFigures } = await import("./figures.mjs");
const { preparePython } = await import("./python.mjs");
const { Course } = await import("./lessons/course.mjs");
const { staleText } = await import("./lessons/kept-figures.mjs");
const { Measurer } = await import("./lessons/measure.mjs");

/** @param {string} text */
const log = (text) => console.log(text);
const python = await preparePython(log);
const course = new Course(
  {
    folder: FOLDER,
    worlds: /** @type {import("./lessons/course.mjs").World[]} */ (python.course.worlds),
    measurer: new Measurer(python, log),
    live: await liveFigures(),
    katex: null,
    again: (figure) => options.one_in > 0 && isInSample(figure, options.one_in),
  },
  options.slugs,
);
const slugs = options.slugs.length > 0 ? options.slugs : course.lessons.map(({ slug }) => slug);
try {
  await Promise.all(slugs.map((slug) => course.page(slug)));
} catch (error) {
  fail(`The figures could not be measured.\n${messageOf(error)}`);
}
const stale = course.staleOf(slugs);
for (const kept of stale) {
  for (const { figure, was, is } of kept.changes) {
    log(`${kept.file}: ${figure}: ${was ?? "not kept"} -> ${is}`);
  }
}
if (options.check && stale.some(({ isContradicted }) => isContradicted)) {
  fail(
    "A kept figure is not what the same runs come to now. Either the file was changed by hand, or a run depends on something that its hash leaves out (site/build/lessons/figure-inputs.mjs).",
    "put what is missing into the hash, and then `npm run lesson:figures -- --again`.",
  );
}
if (options.check && stale.length > 0) fail(staleText(stale));
if (!options.check) for (const kept of stale) kept.write();
if (options.check) log("the kept figures are what the runs come to");
else log(stale.length > 0 ? `written: ${stale.map(({ file }) => file).join(", ")}` : "nothing new");

/** @param {string[]} args */
function optionsOf(args) {
  /** @type {import("node:util").ParseArgsConfig["options"]} */
  const known = {
    again: { type: "boolean", default: false },
    check: { type: "boolean", default: false },
    "one-in": { type: "string" },
  };
  try {
    const { values, positionals } = parseArgs({ args, allowPositionals: true, options: known });
    for (const slug of positionals) {
      if (existsSync(join(FOLDER, slug, "lesson.json"))) continue;
      fail(`There is no lesson "${slug}".`, "name a folder of lessons/ that has a lesson.json.");
    }
    const one_in = values.again ? 1 : Number(values["one-in"] ?? 0);
    if (!Number.isInteger(one_in) || one_in < 0) fail("--one-in wants a whole number, as 20.");
    return { slugs: positionals, check: values.check === true, one_in };
  } catch (error) {
    return fail(messageOf(error), "npm run lesson:figures [-- SLUG… --again --check --one-in N]");
  }
}

/**
 * The same figures each time, whatever others there are.
 * @param {string} figure
 * @param {number} one_in
 */
function isInSample(figure, one_in) {
  return Number.parseInt(sha256(figure).slice(0, 8), 16) % one_in === 0;
}
