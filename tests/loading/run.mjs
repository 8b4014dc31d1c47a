/**
 * npm run test:loading: every file that a first visit of the article, of a lesson and of the lab asks
 * for fails once (with --always: for good), in four ways. No page may stay silent. A file that several
 * of these pages load fails on the first of them.
 *
 *     node tests/loading/run.mjs [--always] [--only PART-OF-A-PATH] [--dist FOLDER]
 */
import { cpus } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { chromium } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";
import { launchOptions } from "../browser.mjs";
import { FAILURES, filesOf, PAGES, visitWith } from "./visit.mjs";

/** For good, as far as a visit goes. */
const ALWAYS = 1000;

const { values } = parseArgs({
  options: {
    always: { type: "boolean" },
    only: { type: "string" },
    dist: { type: "string" },
  },
});
const times = values.always ? ALWAYS : 1;
const dist = values.dist ?? join(ROOT, "dist");
const browser = await chromium.launch(launchOptions());

const cases = [];
/** @type {Set<string>} */
const seen = new Set();
for (const [name, page] of Object.entries(PAGES)) {
  for (const path of await filesOf(browser, dist, page)) {
    if (seen.has(path) || (values.only && !path.includes(values.only))) continue;
    seen.add(path);
    for (const failure of FAILURES) cases.push({ name, page, path, failure });
  }
}
console.log(`${cases.length} visits`);

/** @type {Record<string, number>} */
const counts = { works: 0, told: 0, silent: 0 };
const waiting = [...cases];
const next = async () => {
  for (let one = waiting.shift(); one; one = waiting.shift()) {
    const { name, page, path, failure } = one;
    const { verdict, words } = await visitWith(browser, dist, page, { path, failure, times });
    counts[verdict] = (counts[verdict] ?? 0) + 1;
    const said = words.replaceAll(/\s+/g, " ").trim();
    console.log(`${verdict.padEnd(6)} ${name}: ${path}, ${failure}${said && `: ${said}`}`);
  }
};
await Promise.all(Array.from({ length: Math.max(1, cpus().length) }, next));
await browser.close();
console.log(
  Object.entries(counts)
    .map(([verdict, count]) => `${verdict}: ${count}`)
    .join(", "),
);
if (counts.silent) process.exit(1);
