/**
 * The ways out of a program's worker, kind by kind, as stories for each engine, and under Node, which
 * marks for `mark-all`. For each kind the table says how many were tried and closed.
 */
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { messageOf, ROOT } from "../../site/build/files.mjs";
import { KINDS } from "../ways/all.mjs";
import { listen } from "../ways/listener.mjs";
import { sandboxForWays } from "../ways/node.mjs";
import { faultsOf, tryWays } from "../ways/runs.mjs";
import { Lab } from "./lab.mjs";

/**
 * @typedef {import("../ways/tools.mjs").Kind} Kind
 * @typedef {import("./stories.mjs").Story} Story
 * @typedef {import("./tab.mjs").Tab} Tab
 */

/** What the site is asked for as each of its workers starts. */
const OF_A_WORKER = /\/assets\/worker|\/pyodide/;

/** @type {readonly Kind[]} */
export const WAYS = KINDS;

/** Has the page fetch whatever it shows a run with. */
const EVERYTHING = `import numpy, wave
from bugbot import *
plot("x", 1)
draw("x", [(50, 50)], "red", "squares", 5)
wait(1)`;

/** The row of the table that says how long they all took. */
const ALL = "all ways, in as few runs as will do";

/** What the ways said in each place where they were tried. @type {WeakMap<object, Map<string, string>>} */
const told = new WeakMap();

/**
 * @param {readonly Kind[]} kinds
 * @param {readonly string[]} asked what the site has been asked for so far
 * @returns {Story[]}
 */
export function waysAsStories(kinds, asked) {
  const all = {
    name: ALL,
    few: false,
    /** @param {Tab} tab */
    async tell(tab) {
      const lab = new Lab(tab);
      await lab.open("world=empty");
      // Everything the site itself will ever fetch has been fetched: what comes now is an escape.
      await lab.outcome(EVERYTHING);
      const before = await stateOf(lab);
      const start = asked.length;
      await tryAll(kinds, tab, tab.engine, (program) => lab.outcome(program));
      const fetched = asked.slice(start).filter((path) => !OF_A_WORKER.test(path));
      if (fetched.length > 0) throw new Error(`OPEN: the site was asked for ${fetched.join(", ")}`);
      const after = await stateOf(lab);
      if (after !== before) throw new Error(`OPEN: the page was ${before}, and is ${after}`);
      return `${count(kinds)} ways`;
    },
  };
  const each = kinds.map((kind) => ({
    name: kind.kind,
    few: false,
    tell: async (/** @type {Tab} */ tab) => result(kind, tab),
  }));
  return [all, ...each];
}

/**
 * The same under Node.
 * @param {readonly Kind[]} kinds
 * @returns {Promise<import("./table.mjs").Report>}
 */
export async function waysUnderNode(kinds) {
  const title = `Node ${process.versions.node}`;
  console.log(`\n${title}`);
  /** @type {import("./table.mjs").Report} */
  const report = { title, version: title, missing: null, told: [] };
  const sandbox = await sandboxForWays();
  /** @param {string} story @param {() => Promise<string>} work */
  const tell = async (story, work) => {
    const start = Date.now();
    /** @type {{ result: "passed" | "failed", detail: string }} */
    const told = await work().then(
      (detail) => ({ result: "passed", detail }),
      (error) => ({ result: "failed", detail: messageOf(error) }),
    );
    const seconds = (Date.now() - start) / 1000;
    console.log(`  ${told.result}  ${seconds.toFixed(1).padStart(5)} s  ${story}`);
    console.log(`                    ${told.detail.slice(0, 500)}`);
    report.told.push({ story, seconds, ...told });
  };
  try {
    await tell(ALL, async () => {
      await tryAll(kinds, sandbox, "node", sandbox.run);
      return `${count(kinds)} ways`;
    });
    for (const kind of kinds) await tell(kind.kind, async () => result(kind, sandbox));
  } finally {
    sandbox.remove();
  }
  return report;
}

/** @param {readonly Kind[]} kinds */
function count(kinds) {
  return kinds.flatMap(({ ways }) => ways).length;
}

/**
 * Tries all ways, and keeps what they say for `result` and for somebody to read.
 * @param {readonly Kind[]} kinds
 * @param {object} place
 * @param {string} engine
 * @param {(program: string) => Promise<string>} run
 */
async function tryAll(kinds, place, engine, run) {
  const listener = await listen();
  try {
    const ways = kinds.flatMap(({ ways }) => ways);
    const said = await tryWays(ways, listener.port, run);
    told.set(place, said);
    mkdirSync(join(ROOT, "test-results"), { recursive: true });
    const file = join(ROOT, `test-results/ways-${engine}.json`);
    writeFileSync(file, JSON.stringify(Object.fromEntries(said), null, 1));
    if (listener.came() > 0) throw new Error("OPEN: somebody was reached on this machine");
  } finally {
    listener.close();
  }
}

/**
 * What came of a kind; throws if a way is open or was not really tried.
 * @param {Kind} kind
 * @param {object} place
 */
function result({ ways }, place) {
  const said = told.get(place);
  if (!said) throw new Error("they were not tried: see above");
  const faults = faultsOf(new Map(ways.map(({ name }) => [name, said.get(name) ?? "OPEN?"])));
  if (faults.length === 0) return `${ways.length} tried, all closed`;
  throw new Error(`${faults.length} of ${ways.length}: ${faults.join("; ").slice(0, 2000)}`);
}

/**
 * What a program may not change in its page.
 * @param {Lab} lab
 */
async function stateOf(lab) {
  return lab.tab.evaluateOn(lab.its("textbox", "Program"), async () =>
    JSON.stringify({
      title: document.title,
      address: location.href,
      cookies: document.cookie,
      storage: Object.keys(localStorage).filter((key) => !key.startsWith("bugbot")),
      databases: await indexedDB.databases(),
      caches: await caches.keys(),
      globals: Object.keys(window).length,
      shared: [Object, Array, Function].map(({ prototype }) => Reflect.ownKeys(prototype).length),
    }),
  );
}
