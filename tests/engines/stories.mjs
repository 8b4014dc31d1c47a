/** The main stories of the site, written once for all engines. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "../../site/build/files.mjs";
import { nativeTrace, partingOf } from "../native-trace.mjs";
import { Lab } from "./lab.mjs";

/**
 * @typedef {import("./tab.mjs").Tab} Tab
 * @typedef {() => Promise<{ url: string, cut: () => Promise<void> }>} Serve a server for the one who asks
 * @typedef {object} Story
 * @property {string} name
 * @property {boolean} few belongs to the few that `npm test` tells
 * @property {(tab: Tab, serve: Serve) => Promise<string>} tell resolves to what was found, in a word or two
 */

/** Thrown by a story that an engine has no means for; the message says which. */
export class NotHere extends Error {}

const ARTICLE = "occupancy-grid-mapping";
const LESSON = "u8-1-a-map-of-cells";
const TASK = "cell-of-a-point";
const WITH_NUMPY = 'import numpy\nprint("sum", numpy.arange(5).sum())\n';
const NEVER_ENDS = 'print("off we go")\nwhile True:\n    pass\n';

/** @param {string[]} path */
const lesson = (...path) => join(ROOT, "lessons", ...path);
/** @param {string[]} path */
const read = (...path) => readFileSync(lesson(...path), "utf8");

/** @type {Story[]} */
export const STORIES = [
  {
    name: "load the lab",
    few: false,
    async tell(tab) {
      const start = Date.now();
      const lab = new Lab(tab);
      await lab.open("world=doorway");
      await tab.see(lab.its("img", "Overhead view"));
      await lab.status(/^Ready/);
      return `Python after ${((Date.now() - start) / 1000).toFixed(1)} s`;
    },
  },
  ...["demo-1", "demo-2", "demo-3", "demo-4"].map(demo),
  {
    name: "stop an endless loop, run another program",
    few: true,
    async tell(tab) {
      const lab = new Lab(tab);
      await lab.open("world=empty");
      await lab.write(NEVER_ENDS);
      await lab.run();
      await lab.status(/^Running/);
      await lab.printed(/off we go/);
      await lab.stop();
      await lab.status(/You stopped the program/);
      await lab.printed(/off we go/);
      await lab.write('print("still here")\n');
      await lab.run();
      await lab.printed(/still here/);
      return "";
    },
  },
  {
    name: "mark a task: wrong, then right",
    few: true,
    async tell(tab) {
      const { tasks } = JSON.parse(read(LESSON, "lesson.json"));
      const { title } = tasks.find((/** @type {{ name: string }} */ task) => task.name === TASK);
      /** @type {import("./look.mjs").Where} */
      const task = { role: "article", name: title };
      const mark = { role: "status", name: "Mark", within: task };
      const check = { role: "button", name: "Check my work", within: task };
      const lab = new Lab(tab, task);
      await tab.open(`lessons/${LESSON}/#task-${TASK}`);

      const wrong = read(LESSON, TASK, "wrong", "swapped.py");
      const earns = wrong.split("\n")[0]?.replace("# earns:", "").trim() ?? "";
      await lab.write(wrong);
      await tab.click(check);
      await tab.see(mark, /^Not yet/);
      await tab.see({ role: "list", name: "Checks", within: task }, new RegExp(earns));

      await lab.write(read(LESSON, TASK, "solution.py"));
      await tab.click(check);
      await tab.see(mark, /^Passed/);
      await tab.reload();
      await tab.see(mark, /You passed this task on/);
      return "";
    },
  },
  {
    name: "NumPy",
    few: false,
    async tell(tab) {
      const lab = new Lab(tab);
      await lab.open("world=empty");
      await lab.write(WITH_NUMPY);
      await lab.run();
      await lab.printed(/sum 10/);
      return "";
    },
  },
  {
    name: "type a program; a reload keeps it",
    few: false,
    async tell(tab) {
      const lab = new Lab(tab);
      await lab.open("world=wall-ahead");
      await lab.type('print("mine")');
      await tab.reload();
      await lab.status(/Your program is back/);
      if ((await lab.text()) !== 'print("mine")') throw new Error("the program is not what it was");
      await lab.run();
      await lab.printed(/mine/);
      return "";
    },
  },
  {
    name: "share a program by a link",
    few: false,
    tell: share,
  },
  {
    name: "work without a network",
    few: false,
    tell: offline,
  },
];

/**
 * A demo of the article, event for event as under CPython.
 * @param {string} name
 * @returns {Story}
 */
function demo(name) {
  return {
    name: `${name} as under CPython`,
    few: false,
    async tell(tab) {
      const { file, world, title } = JSON.parse(read(ARTICLE, "lesson.json")).programs[name];
      const program = lesson(ARTICLE, "programs", file);
      const expected = nativeTrace({ file: program, world, seed: 1 });
      const lab = new Lab(tab, { role: "region", name: title });
      await tab.open(`${ARTICLE}/#lab-${name}`);
      await tab.choose(lab.its("combobox", "Speed"), "to the end");
      await lab.run();
      await lab.status(/^Finished at/);
      const parting = partingOf(await lab.trace(), expected);
      if (parting) throw new Error(`the trace parts from CPython's: ${parting.slice(0, 300)}`);
      return firstSeries(expected);
    },
  };
}

/**
 * The first series that a run has plotted, with its last value.
 * @param {string} trace
 */
function firstSeries(trace) {
  const rows = trace.trimEnd().split("\n").slice(1);
  const points = rows.map((row) => JSON.parse(row)).filter(([kind]) => kind === "plot");
  const name = points[0]?.[2];
  const last = points.filter(([, , series]) => series === name).at(-1);
  return last ? `${name} ${last[3].toFixed(1)}` : "";
}

/** @param {Tab} tab */
async function share(tab) {
  const shared = '# ø, 世界, 🤖\nprint("shared")\n';
  const lab = new Lab(tab);
  await lab.open("world=post-and-shelf&seed=7");
  await lab.write(shared);
  await tab.click(lab.its("button", "More"));
  await tab.click({ role: "button", name: "Share as a link…" });
  const link = { role: "textbox", name: "Link" };
  await tab.see(link);
  const address = await tab.evaluateOn(
    link,
    (element) => /** @type {HTMLInputElement} */ (element).value,
  );
  await tab.click({ role: "button", name: "Close" });
  await lab.write('print("of somebody else")\n');

  await tab.open("about:blank");
  await tab.open(address ?? "");
  await tab.see({ role: "dialog", name: "Somebody shared a program" }, /2 lines/);
  await tab.click({ role: "button", name: "Open this program" });
  await tab.until(
    () => "the shared program in the editor",
    async () => (await lab.text()) === shared,
  );
  return "";
}

/**
 * @param {Tab} tab
 * @param {Serve} serve
 */
async function offline(tab, serve) {
  const site = await serve();
  tab.leaveFor(site.url);
  try {
    const lab = new Lab(tab);
    await lab.open("world=empty");
    await lab.write(WITH_NUMPY);
    await lab.run();
    await lab.printed(/sum 10/);

    const panel = { role: "dialog", name: "Use offline" };
    const keep = { role: "button", name: "Keep it on this device", within: panel };
    await tab.click({ role: "button", name: "Use offline" });
    const said = await tab.see(panel, /Not kept yet|are here|Ready|does not keep/);
    if (/does not keep/.test(said)) throw new NotHere(said.replace(/\s+/g, " "));
    if ((await tab.text(keep)) !== null) await tab.click(keep);
    await tab.see(panel, /Ready: this site works/);
    await site.cut();
    await tab.reload();
    await lab.run();
    await lab.printed(/sum 10/);
    await tab.open(`${ARTICLE}/`);
    await tab.see({ role: "heading", name: "Occupancy grid mapping explained" });
    return "with NumPy";
  } finally {
    await site.cut();
  }
}
