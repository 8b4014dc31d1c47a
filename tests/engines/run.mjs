/**
 * npm run test:engines [-- OPTIONS]: the main stories of the site in Chromium, Firefox and WebKitGTK.
 *
 *     --only firefox    this engine only (may be given several times)
 *     --need firefox    a fault if this engine is not installed (several times; `--need all`)
 *     --few             the few stories that npm test tells
 *     --story WORDS     only the stories whose names have these words in them
 *     --ways            in place of the stories, the ways out of a program's worker, kind by kind;
 *                       under Node as well (`--only node`: there alone)
 *     --dist FOLDER     a site that is built already; without it, dist/ is built first
 *     --pictures FOLDER a picture of the lab, the article and a task in each engine, as PNG
 *
 * An engine that is not installed is named, with what installs it. Prints a table, and writes it to
 * bench/engines.md when all stories have been told in all engines
 * (the ways: to bench/ways.md).
 */
import { mkdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { parseArgs } from "node:util";
import { messageOf, ROOT } from "../../site/build/files.mjs";
import { ensureInstalled, fail } from "../../site/build/install.mjs";
import { findEngines } from "./find.mjs";

ensureInstalled();
const { values: options } = parseArgs({
  options: {
    only: { type: "string", multiple: true, default: [] },
    need: { type: "string", multiple: true, default: [] },
    few: { type: "boolean", default: false },
    story: { type: "string" },
    ways: { type: "boolean", default: false },
    dist: { type: "string" },
    pictures: { type: "string" },
  },
});
const { findBrowser } = await import("../browser.mjs");
const { ensureVenv } = await import("../setup.mjs");
const { takePictures } = await import("./pictures.mjs");
const { serve } = await import("./site.mjs");
const { NotHere, STORIES } = await import("./stories.mjs");
const { Tab } = await import("./tab.mjs");
const { tableOf } = await import("./table.mjs");
const { WAYS, waysAsStories, waysUnderNode } = await import("./ways.mjs");
ensureVenv();

const known = findEngines(findBrowser());
const names = known.map(({ name }) => String(name));
for (const name of [...options.only, ...options.need]) {
  if (!names.includes(name) && name !== "all" && !(options.ways && name === "node")) {
    fail(`There is no engine “${name}”.`, `name one of ${names.join(", ")}.`);
  }
}
const { only, need } = options;
const engines = known.filter(({ name }) => only.length === 0 || only.includes(name));
/** @type {string[]} */
const asked = [];
/** @param {string} name */
const named = (name) => !options.story || name.includes(options.story);
const kinds = WAYS.filter(({ kind }) => named(kind));
const all = options.ways ? waysAsStories(kinds, asked) : STORIES;
const stories = options.ways
  ? all
  : all.filter(({ name, few }) => (options.story ? named(name) : few || !options.few));
if (stories.length === 0) {
  fail(`No story has “${options.story}” in its name.`, all.map(({ name }) => name).join("; "));
}

if (!options.dist) {
  const { build } = await import("../../site/build/build.mjs");
  await build();
}
// So that the servers and the screen go as well.
for (const signal of ["SIGINT", "SIGTERM"]) process.once(signal, () => process.exit(1));
const dist = resolve(options.dist ?? join(ROOT, "dist"));
const site = await serve(dist, asked);

/** @type {import("./table.mjs").Report[]} */
const reports = [];
for (const engine of engines) reports.push(await inEngine(engine));
await site.cut();
if (options.ways && (only.length === 0 || only.includes("node"))) {
  reports.push(await waysUnderNode(kinds));
}

const table = tableOf(
  reports,
  stories.map(({ name }) => name),
);
console.log(`\n${table}`);
const whole = !options.story && stories.length === all.length && engines.length === known.length;
if (whole && reports.every(({ missing }) => !missing)) {
  const [file, head] = options.ways
    ? [
        "ways.md",
        "# The ways out of a worker, engine by engine\n\nWritten by `npm run test:engines -- --ways`.\n\n",
      ]
    : [
        "engines.md",
        "# The main stories, engine by engine\n\nWritten by `npm run test:engines`.\n\n",
      ];
  mkdirSync(join(ROOT, "bench"), { recursive: true });
  writeFileSync(join(ROOT, "bench", file), `${head}${table}\n`);
}
const failed = reports.flatMap(({ told }) => told).filter(({ result }) => result === "failed");
const lacking = engines.filter(({ name, missing }) => {
  return missing && (need.includes(name) || need.includes("all"));
});
for (const { title, missing } of lacking) console.error(`\nneeded: ${title}: ${missing}`);
if (failed.length > 0) console.error(`\n${failed.length} of the stories have failed.`);
process.exit(failed.length + lacking.length > 0 ? 1 : 0);

/**
 * All stories in one engine.
 * @param {import("./find.mjs").Engine} engine
 * @returns {Promise<import("./table.mjs").Report>}
 */
async function inEngine(engine) {
  const { name, title, missing } = engine;
  /** @type {import("./table.mjs").Report} */
  const report = { title, version: "", missing, told: [] };
  if (missing) {
    console.log(`\n${title} can't be tested: ${missing}`);
    return report;
  }
  const driver = await openEngine(engine).catch((error) => {
    const detail = `it could not be started: ${messageOf(error)}`;
    console.log(`\n${title}: ${detail}`);
    report.told.push({ story: stories[0]?.name ?? "", result: "failed", seconds: 0, detail });
  });
  if (!driver) return report;
  report.version = `${title} ${driver.version.replace(/^\D*/, "")}`;
  console.log(`\n${report.version}`);
  try {
    const tab = new Tab(driver, site.url, name);
    await tab.keepNothing();
    for (const story of stories) {
      tab.leaveFor(site.url);
      const told = await tell(story, tab, join(ROOT, "test-results", `engines-${name}.png`));
      const { result, seconds, detail } = told;
      console.log(`  ${result.padEnd(8)} ${seconds.toFixed(1).padStart(5)} s  ${story.name}`);
      if (detail) console.log(`                    ${detail.slice(0, 500)}`);
      await tab.leave();
      report.told.push(told);
    }
    if (options.pictures) {
      tab.leaveFor(site.url);
      await takePictures(tab, resolve(options.pictures), name);
    }
  } catch (error) {
    // The engine itself has gone, or a picture could not be taken.
    const detail = messageOf(error);
    console.log(`  ${title}: ${detail}`);
    report.told.push({ story: stories.at(-1)?.name ?? "", result: "failed", seconds: 0, detail });
  } finally {
    await driver.close().catch(() => {});
  }
  return report;
}

/**
 * @param {import("./stories.mjs").Story} story
 * @param {import("./tab.mjs").Tab} tab
 * @param {string} picture where to keep what was on the screen when it failed
 * @returns {Promise<import("./table.mjs").Told>}
 */
async function tell(story, tab, picture) {
  const start = Date.now();
  /** @type {Omit<import("./table.mjs").Told, "story" | "seconds">} */
  let told;
  try {
    told = { result: "passed", detail: await story.tell(tab, () => serve(dist)) };
    const complaints = tab.complaints();
    if (complaints.length > 0) throw new Error(`the page complains: ${complaints.join("; ")}`);
  } catch (error) {
    const here = error instanceof NotHere;
    const complaints = tab.complaints().map((each) => `; the page complains: ${each}`);
    told = {
      result: here ? "not here" : "failed",
      detail: messageOf(error) + (here ? "" : complaints.join("")),
    };
    if (!here) await keepPicture(tab, picture);
  }
  return { story: story.name, seconds: (Date.now() - start) / 1000, ...told };
}

/** @param {import("./tab.mjs").Tab} tab @param {string} path */
async function keepPicture(tab, path) {
  mkdirSync(join(path, ".."), { recursive: true });
  try {
    writeFileSync(path, await tab.picture());
  } catch (error) {
    console.log(`  (no picture of it: ${messageOf(error)})`);
  }
}

/** @param {import("./find.mjs").Engine} engine */
async function openEngine({ name, programs }) {
  if (name === "webkit") {
    const { openWebKit } = await import("./webdriver.mjs");
    return openWebKit(programs);
  }
  const { openWithPuppeteer } = await import("./puppeteer.mjs");
  return openWithPuppeteer(name, programs[name] ?? "");
}
