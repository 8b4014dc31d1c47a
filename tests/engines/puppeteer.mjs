/** Chromium and Firefox, driven by puppeteer-core; Firefox over WebDriver BiDi. */
import puppeteer from "puppeteer-core";
import { BROWSER_ARGS } from "../browser.mjs";

/**
 * @typedef {import("./tab.mjs").Driver} Driver
 * @typedef {import("./tab.mjs").Key} Key
 */

const SCREEN = { width: 1280, height: 800 };
/** Of a whole call of the driver, on a busy machine. */
const PATIENCE_MS = 120_000;
/** What Firefox says, often only in the next story, of a download that leaving a page breaks off. */
const BROKEN_OFF = "Error in input stream";

/**
 * @param {"chromium" | "firefox"} name
 * @param {string} executablePath
 * @returns {Promise<Driver>}
 */
export async function openWithPuppeteer(name, executablePath) {
  const browser = await puppeteer.launch({
    browser: name === "firefox" ? "firefox" : "chrome",
    executablePath,
    args: name === "firefox" ? [] : BROWSER_ARGS,
    defaultViewport: SCREEN,
    protocolTimeout: PATIENCE_MS,
    timeout: PATIENCE_MS,
  });
  const page = await browser.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  /** @type {string[]} */
  const complaints = [];
  /** @param {string} text */
  const complain = (text) => {
    if (name !== "firefox" || !text.includes(BROKEN_OFF)) complaints.push(text);
  };
  page.on("console", (message) => {
    if (message.type() === "error") complain(message.text());
  });
  // Firefox tells of the same download now by the one way and now by the other.
  page.on("pageerror", (error) => complain(String(error)));

  return {
    version: (await browser.version()).replace("/", " "),
    complaints,
    open: async (address) => void (await page.goto(address)),
    reload: async () => void (await page.reload()),
    evaluate: (expression) => page.evaluate(expression),
    click: async (element) => {
      const handle = await page.evaluateHandle(element);
      const clicked = /** @type {import("puppeteer-core").ElementHandle<Element> | null} */ (
        handle.asElement()
      );
      await clicked?.click();
      await handle.dispose();
    },
    press: (key) => press(page.keyboard, key),
    type: (text) => page.keyboard.type(text),
    picture: async () => Buffer.from(await page.screenshot()),
    close: () => browser.close(),
  };
}

/**
 * @param {import("puppeteer-core").Keyboard} keyboard
 * @param {Key} key
 */
async function press(keyboard, key) {
  if (key !== "SelectAll") return keyboard.press(key);
  await keyboard.down("Control");
  await keyboard.press("a");
  return keyboard.up("Control");
}
