/**
 * npm run lighthouse [-- ADDRESS]: what Lighthouse says of the built article, on a desktop and on a
 * slow phone; ends with a fault if a desktop figure is below the goal.
 *
 * Lighthouse brings some 200 packages that nothing else here needs, so it is installed, in one fixed
 * version, when it is first asked for. Of three runs the one in the middle counts: a busy machine
 * makes the figure for performance a matter of luck.
 */
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { build } from "../../site/build/build.mjs";
import { CACHE } from "../../site/build/files.mjs";
import { ensureInstalled, run } from "../../site/build/install.mjs";

/** The last version that runs on the oldest Node.js we take. */
const VERSION = "12.8.2";
const GOAL = 95;
const RUNS = 3;
const ARTICLE = "/site/occupancy-grid-mapping/";

/**
 * What is read of Lighthouse's report.
 * @typedef {{ score: number | null, title: string, displayValue?: string }} Audit
 * @typedef {{ id: string, title: string, score: number, auditRefs: { id: string, weight: number }[] }} Category
 * @typedef {{ categories: Record<string, Category>, audits: Record<string, Audit> }} Report
 */

ensureInstalled();
const { BROWSER_ARGS, findBrowser } = await import("../browser.mjs");
const { ensureBrowser } = await import("../setup.mjs");
const { serve } = await import("./server.mjs");
ensureBrowser();
const { lighthouse, desktopConfig, launch } = await loadLighthouse();
const asked = process.argv[2];
if (!asked) await build();
const server = asked ? null : await serve();
const address = asked ?? `${server?.url}${ARTICLE}`;

let below = 0;
for (const form of ["desktop", "mobile"]) {
  const report = await inTheMiddle(form);
  console.log(`\n${form}: ${address}`);
  for (const { id, title, score, auditRefs } of Object.values(report.categories)) {
    const points = Math.round(100 * score);
    if (form === "desktop" && points < GOAL) below++;
    console.log(`  ${String(points).padStart(3)}  ${title}`);
    const measures = auditRefs.filter((ref) => ref.weight > 0).map((ref) => report.audits[ref.id]);
    for (const audit of measures) {
      const shown = id === "performance" || (audit?.score ?? 1) < 1;
      if (audit && shown) console.log(`         ${audit.title} ${audit.displayValue ?? "failed"}`);
    }
  }
}
server?.close();
if (below > 0) {
  console.error(`\n${below} of the desktop figures are below ${GOAL}.`);
  process.exitCode = 1;
}

/**
 * @param {string} form
 * @returns {Promise<Report>}
 */
async function inTheMiddle(form) {
  const reports = [];
  for (let i = 0; i < RUNS; i++) reports.push(await measured(form));
  reports.sort((a, b) => speedOf(a) - speedOf(b));
  const middle = reports[RUNS >> 1];
  if (!middle) throw new Error("Lighthouse was not run");
  return middle;
}

/** @param {Report} report */
function speedOf({ categories }) {
  return categories.performance?.score ?? 0;
}

/**
 * One run, in a browser that has seen nothing yet.
 * @param {string} form
 * @returns {Promise<Report>}
 */
async function measured(form) {
  const chrome = await launch({
    chromePath: findBrowser(),
    chromeFlags: ["--headless=new", ...BROWSER_ARGS],
  });
  try {
    const config = form === "desktop" ? desktopConfig : undefined;
    const result = await lighthouse(address, { port: chrome.port, logLevel: "error" }, config);
    return result.lhr;
  } finally {
    chrome.kill();
  }
}

async function loadLighthouse() {
  const folder = join(CACHE, "lighthouse");
  const packages = join(folder, "node_modules");
  const about = join(packages, "lighthouse/package.json");
  if (!existsSync(about) || JSON.parse(readFileSync(about, "utf8")).version !== VERSION) {
    console.log(`installing Lighthouse ${VERSION} into ${folder}`);
    const quiet = ["--no-audit", "--no-fund", "--loglevel=error"];
    run("npm", ["install", "--prefix", folder, ...quiet, `lighthouse@${VERSION}`]);
  }
  const load = (/** @type {string} */ path) => import(pathToFileURL(join(packages, path)).href);
  const [core, launcher] = await Promise.all([
    load("lighthouse/core/index.js"),
    load("chrome-launcher/dist/index.js"),
  ]);
  return { lighthouse: core.default, desktopConfig: core.desktopConfig, launch: launcher.launch };
}
