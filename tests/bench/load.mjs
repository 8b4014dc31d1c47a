/**
 * node tests/bench/load.mjs [--runs 200] [--markings 100] [--labs 50]: what a page takes
 * of memory before and after much use: runs and stops in one page, markings in a row, many labs embedded
 * in one page of another site. Prints, for each, the workers alive, the JavaScript heap and the documents
 * after a collection, and the memory of the browser's processes (Linux). Ends with 1 if workers or heap
 * have grown.
 */
import { existsSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { chromium } from "@playwright/test";
import { build } from "../../site/build/build.mjs";
import { ROOT } from "../../site/build/files.mjs";
import { launchOptions } from "../browser.mjs";
import { processMemory } from "./memory.mjs";
import { serve } from "./server.mjs";

/** @typedef {import("@playwright/test").Page} Page */
/** @typedef {HTMLElement & { program: string, run(): Promise<{ status: string, console: string }>, stop(): void, ready(): Promise<void> }} Lab */
/** @typedef {{ workers: number, heap: number, documents: number, nodes: number, listeners: number, resident: number | null }} Size */

const ENDLESS = 'from bugbot import *\nprint("it runs")\nwhile True:\n    wait(0.1)\n';
/** Some is compiled, cached and kept on purpose: what counts is growth after so many. */
const BEFORE = 5;
/** So much may a heap have grown by chance [MB]. */
const CHANCE_MB = 4;

const { values } = parseArgs({
  options: {
    runs: { type: "string", default: "200" },
    markings: { type: "string", default: "100" },
    labs: { type: "string", default: "50" },
  },
});
const [runs, markings, labs] = [values.runs, values.markings, values.labs].map(Number);

if (!existsSync(join(ROOT, "dist"))) await build();
const server = await serve();
const browser = await chromium.launch(launchOptions());
let grown = false;

/** @param {Page} page @returns {Promise<Size>} */
async function sizeOf(page) {
  const devtools = await page.context().newCDPSession(page);
  await devtools.send("HeapProfiler.collectGarbage");
  await devtools.send("Performance.enable");
  const { metrics } = await devtools.send("Performance.getMetrics");
  const of = (/** @type {string} */ name) => metrics.find((one) => one.name === name)?.value ?? 0;
  await devtools.detach();
  return {
    workers: page.workers().length,
    heap: of("JSHeapUsedSize") / 1e6,
    documents: of("Documents"),
    nodes: of("Nodes"),
    listeners: of("JSEventListeners"),
    resident: await processMemory(browser),
  };
}

/** @param {string} what @param {Size} size */
function show(what, { workers, heap, documents, nodes, listeners, resident }) {
  const memory = resident === null ? "?" : `${Math.round(resident / 1e6)} MB`;
  console.log(
    `${what.padEnd(34)} ${String(workers).padStart(3)} workers  heap ${heap.toFixed(1).padStart(6)} MB` +
      `  ${documents} documents  ${nodes} nodes  ${listeners} listeners  processes ${memory}`,
  );
}

/**
 * Does something a few times, then many times, and compares.
 * @param {Page} page @param {string} what @param {number} times @param {() => Promise<void>} once
 */
async function compare(page, what, times, once) {
  for (let i = 0; i < BEFORE; i++) await once();
  const before = await sizeOf(page);
  show(`${what}: after ${BEFORE}`, before);
  const began = Date.now();
  for (let i = 0; i < times; i++) await once();
  const each = (Date.now() - began) / times;
  const after = await sizeOf(page);
  show(`${what}: ${times} more, ${Math.round(each)} ms each`, after);
  if (after.workers > before.workers || after.heap > before.heap + CHANCE_MB) grown = true;
}

async function runsAndStops() {
  const page = await browser.newPage({ serviceWorkers: "block" });
  await page.goto(`${server.url}/site/lab/?world=empty`);
  const lab = page.locator("bugbot-lab");
  await lab.getByRole("textbox", { name: "Program" }).waitFor();
  await lab.evaluate((element, text) => {
    /** @type {Lab} */ (element).program = text;
  }, ENDLESS);
  await compare(page, "runs and stops", runs ?? 0, async () => {
    const status = await lab.evaluate(async (element) => {
      const lab = /** @type {Lab} */ (element);
      await lab.ready();
      const run = lab.run();
      const log = lab.querySelector("[role=log]");
      const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
      await frame();
      while (!log?.textContent?.includes("it runs")) await frame();
      lab.stop();
      return (await run).status;
    });
    if (status !== "stopped") throw new Error(`a run that was stopped ended as ${status}`);
  });
  await page.close();
}

async function markingsInARow() {
  const page = await browser.newPage({ serviceWorkers: "block" });
  await page.goto(`${server.url}/site/lessons/u8-1-a-map-of-cells/`);
  const task = page.locator("bugbot-task").first();
  await task.scrollIntoViewIfNeeded();
  await task.getByRole("button", { name: "Check my work" }).waitFor();
  await task.locator("bugbot-lab").evaluate((element) => {
    /** @type {Lab} */ (element).program = "def cell_of(x, y):\n    return (1, 2)\n";
  });
  await compare(page, "markings", markings ?? 0, () =>
    task.evaluate(
      (element) =>
        new Promise((resolve) => {
          let begun = false;
          const named = (/** @type {string} */ name) =>
            [...element.querySelectorAll("button")].find(
              (button) => button.textContent?.trim() === name,
            );
          new MutationObserver((_, observer) => {
            const isMarking = named("Cancel") !== undefined;
            begun ||= isMarking;
            if (!begun || isMarking) return;
            observer.disconnect();
            resolve(undefined);
          }).observe(element, { childList: true, subtree: true, characterData: true });
          named("Check my work")?.click();
        }),
    ),
  );
  await page.close();
}

async function manyLabs() {
  const tags = Array.from(
    { length: labs ?? 0 },
    (_, n) => `<bugbot-lab world="empty" name="lab ${n}"><pre>print("lab ${n}")</pre></bugbot-lab>`,
  );
  const body = `<!doctype html><link rel="icon" href="data:,"><script src="${server.url}/site/embed.js"></script>${tags.join("")}`;
  const host = createServer((_request, response) => {
    response.writeHead(200, { "Content-Type": "text/html" }).end(body);
  });
  await new Promise((resolve) => host.listen(0, () => resolve(undefined)));
  const address = host.address();
  const page = await browser.newPage({ serviceWorkers: "block" });
  await page.goto(`http://localhost:${typeof address === "object" ? address?.port : 0}/`);
  show(`${labs} embedded labs, none used`, await sizeOf(page));
  for (let n = 0; n < (labs ?? 0); n++) {
    const { console: said } = await page
      .locator("bugbot-lab")
      .nth(n)
      .evaluate((element) => /** @type {Lab} */ (element).run());
    if (said !== `lab ${n}\n`) throw new Error(`lab ${n} said ${said}`);
    if (n + 1 === 1 || n + 1 === 10 || n + 1 === labs)
      show(`${n + 1} of them have run`, await sizeOf(page));
  }
  await page.close();
  host.close();
  host.closeAllConnections();
}

if (runs) await runsAndStops();
if (markings) await markingsInARow();
if (labs) await manyLabs();
await browser.close();
server.close();
process.exit(grown ? 1 : 0);
