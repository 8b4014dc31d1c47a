/**
 * npm run bench [-- NAME…]: how fast the built site is, against yardsticks measured in the same run.
 *
 * Timings on a shared machine are noisy, so what is judged is ratios: each figure stands beside its
 * yardstick, taken in turns. Prints a table and, unless only some measures are named (such as
 * `stopping sliding`), writes bench/results.json.
 */
import { mkdirSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";
import { build } from "../../site/build/build.mjs";
import { ROOT } from "../../site/build/files.mjs";

await build();
const { chromium } = await import("@playwright/test");
const { launchOptions } = await import("../browser.mjs");
const { ensureBrowser, ensureVenv } = await import("../setup.mjs");
const { serve } = await import("./server.mjs");
const measures = await import("./measures.mjs");
ensureVenv();
ensureBrowser();

const server = await serve();
const launch = () => chromium.launch(launchOptions());

/** @type {import("./measures.mjs").Row[]} */
const rows = [];
const named = process.argv.slice(2);
for (const measure of measures.ALL) {
  if (named.length > 0 && !named.includes(measure.name)) continue;
  console.log(`measuring: ${measure.name}`);
  rows.push(...(await measure(launch, server)));
}
server.close();

const width = Math.max(...rows.map((row) => row.what.length));
console.log(`\n${"what".padEnd(width)}  measured    goal      detail`);
for (const row of rows) {
  const verdict = row.goal === null ? "" : row.measured <= row.goal ? "met" : "MISSED";
  const measured = `${row.measured} ${row.unit}`.padEnd(10);
  const goal = (row.goal === null ? "-" : `${row.goal} ${row.unit}`).padEnd(8);
  console.log(
    `${row.what.padEnd(width)}  ${measured}  ${goal}  ${verdict.padEnd(6)} ${row.detail}`,
  );
}

if (named.length === 0) {
  mkdirSync(join(ROOT, "bench"), { recursive: true });
  const machine = `${cpus().length} cores, ${cpus()[0]?.model ?? "unknown"}`;
  const results = { date: new Date().toISOString().slice(0, 10), machine, rows };
  writeFileSync(join(ROOT, "bench/results.json"), `${JSON.stringify(results, null, 2)}\n`);
}
