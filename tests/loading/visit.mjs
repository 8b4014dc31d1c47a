/**
 * A first visit, as far as a reader's first run: what it loads, and what comes of it when one file
 * fails. A page may do without the file, get it at the second try, or say what is wrong; it may not
 * stand there and say nothing.
 *
 * @typedef {import("./failing-server.mjs").Fault} Fault
 * @typedef {{ verdict: "works" | "told" | "silent", words: string }} Outcome
 */
import { FailingServer, SORRY_TITLE } from "./failing-server.mjs";

/** @type {readonly import("./failing-server.mjs").Failure[]} */
export const FAILURES = ["500", "cut", "404", "wrong"];

/** The kinds of page that a first visit can begin with. */
export const PAGES = {
  article: "occupancy-grid-mapping/",
  lesson: "lessons/u8-1-a-map-of-cells/",
  lab: "lab/?world=empty",
};

/** A short program, so that the visit is about loading. */
const PROGRAM = 'import math\nprint("it runs", math.floor(2.5))\n';
/** A page is not held to be silent before it has had so long [ms]. */
const PATIENCE_MS = 40_000;

/**
 * The files that each of a browser's first visits to a page asks for.
 * @param {import("@playwright/test").Browser} browser @param {string} dist @param {string} page
 */
export async function filesOf(browser, dist, page) {
  const server = await new FailingServer(dist).listen();
  const { verdict, words } = await visit(browser, server, page);
  server.close();
  if (verdict !== "works") throw new Error(`${page} does not work as it is: ${verdict} ${words}`);
  return [...server.asked].sort();
}

/**
 * @param {import("@playwright/test").Browser} browser
 * @param {string} dist
 * @param {string} page
 * @param {Fault} fault
 * @returns {Promise<Outcome>}
 */
export async function visitWith(browser, dist, page, fault) {
  const server = await new FailingServer(dist).listen();
  server.fault = { ...fault };
  try {
    return await visit(browser, server, page);
  } finally {
    server.close();
  }
}

/**
 * @param {import("@playwright/test").Browser} browser
 * @param {FailingServer} server
 * @param {string} path
 * @returns {Promise<Outcome>}
 */
async function visit(browser, server, path) {
  const context = await browser.newContext({ serviceWorkers: "block" });
  try {
    const page = await context.newPage();
    const answer = await page.goto(server.url + path, { waitUntil: "commit" });
    // In place of the page the reader has what the server says, and none of our code.
    const isOurs = answer?.ok() && !(await page.title()).startsWith(SORRY_TITLE);
    if (!isOurs) return { verdict: "told", words: `the server: ${answer?.status()}` };
    // No answer of the page's own: the browser says so itself.
    if (!(await page.locator("body").count())) return { verdict: "told", words: "the browser" };
    const told = page.locator(".not-loaded, .lab-status[data-tone=bad]").first();
    const lab = page.locator("bugbot-lab").first();
    await lab.scrollIntoViewIfNeeded({ timeout: PATIENCE_MS }).catch(() => {});
    const ready = lab.getByRole("textbox", { name: "Program" });
    await ready.or(told).first().waitFor({ timeout: PATIENCE_MS });
    if (await ready.isVisible()) {
      await lab.evaluate((element, text) => {
        /** @type {HTMLElement & { program: string }} */ (element).program = text;
      }, PROGRAM);
      await lab.getByRole("button", { name: "Run", exact: true }).click();
    }
    const ran = lab.getByRole("log", { name: "Console" }).getByText("it runs 2");
    await ran.or(told).first().waitFor({ timeout: PATIENCE_MS });
    if (await told.isVisible()) return { verdict: "told", words: (await told.textContent()) ?? "" };
    const bare = await page.evaluate(sheetsMissing);
    if (bare.length > 0) return { verdict: "silent", words: `without ${bare.join(", ")}` };
    return { verdict: "works", words: "" };
  } catch (error) {
    const [words = ""] = String(error).split("\n");
    return { verdict: "silent", words };
  } finally {
    await context.close();
  }
}

/** In the page: the style sheets that it names and does not have. */
function sheetsMissing() {
  const links = [...document.querySelectorAll("link")].filter(({ rel }) => rel === "stylesheet");
  /** @param {string} href */
  const address = (href) => href.split("?")[0] ?? "";
  const whole = links.filter(({ sheet }) => {
    const last = sheet?.cssRules[sheet.cssRules.length - 1];
    return last instanceof CSSStyleRule && last.selectorText === "#whole";
  });
  const there = new Set(whole.map(({ href }) => address(href)));
  return links.map(({ href }) => address(href)).filter((href) => !there.has(href));
}
