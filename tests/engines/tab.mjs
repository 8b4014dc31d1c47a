/**
 * One page in one engine, as a person uses it. The stories use nothing else; `puppeteer.mjs` and
 * `webdriver.mjs` are the two drivers below it.
 */
import { setTimeout as pause } from "node:timers/promises";
import { inWords, look } from "./look.mjs";

/**
 * @typedef {import("./look.mjs").Where} Where
 *
 * What an engine has to be able to do. An expression is JavaScript for the page; its value is JSON, or
 * for `click` an element in sight.
 * @typedef {object} Driver
 * @property {string} version
 * @property {string[]} complaints errors that the page has logged or thrown
 * @property {(address: string) => Promise<void>} open
 * @property {() => Promise<void>} reload
 * @property {(expression: string) => Promise<unknown>} evaluate
 * @property {(element: string) => Promise<void>} click
 * @property {(key: Key) => Promise<void>} press
 * @property {(text: string) => Promise<void>} type
 * @property {() => Promise<Buffer>} picture
 * @property {() => Promise<void>} close
 *
 * @typedef {"Enter" | "Escape" | "Tab" | "SelectAll"} Key
 */

const LOOK_EVERY_MS = 100;
/** WebKitGTK on a busy machine of two cores takes long to start Python, and longer for NumPy. */
const PATIENCE_MS = 120_000;

export class Tab {
  #driver;
  #home;
  /** Its engine's name. */
  engine;

  /**
   * @param {Driver} driver
   * @param {string} home address of the site
   * @param {import("./find.mjs").EngineName} engine
   */
  constructor(driver, home, engine) {
    this.#driver = driver;
    this.#home = home;
    this.engine = engine;
  }

  /**
   * Leaves the page, and what it says of being left: requests that are broken off are no fault.
   */
  async leave() {
    const before = this.complaints();
    await this.#driver.open("about:blank");
    this.#driver.complaints.splice(0, Infinity, ...before);
  }

  /** @param {string} path */
  async open(path) {
    await this.#driver.open(new URL(path, this.#home).href);
  }

  /**
   * As a reader who does not want the site kept on the device, at this address: a story that is left
   * would break off the keeping, and what the engine says of that would come in the next one.
   */
  async keepNothing() {
    await this.open("");
    await this.#driver.evaluate('localStorage.setItem("bugbot:offline", "no")');
    await this.leave();
  }

  /**
   * Goes on at another address of the site.
   * @param {string} home
   */
  leaveFor(home) {
    this.#home = home;
  }

  async reload() {
    await this.#driver.reload();
  }

  /**
   * What a function gives of a thing in sight and of plain values; null while there is no such thing.
   * @template {unknown[]} Values
   * @template Result
   * @param {Where} where
   * @param {(element: HTMLElement, ...values: Values) => Result} work
   * @param {Values} values
   * @returns {Promise<Awaited<Result> | null>}
   */
  async evaluateOn(where, work, ...values) {
    const given = ["element", ...values.map((value) => JSON.stringify(value))].join(", ");
    return /** @type {Awaited<Result> | null} */ (
      await this.#driver.evaluate(`((element) => element && (${work})(${given}))(${found(where)})`)
    );
  }

  /**
   * The text of a thing in sight; null while there is none.
   * @param {Where} where
   */
  text(where) {
    return this.evaluateOn(where, (element) =>
      (element.textContent ?? "").replace(/\s+/g, " ").trim(),
    );
  }

  /**
   * Waits until something is in sight, and its text is as wanted.
   * @param {Where} where
   * @param {RegExp} [wanted]
   */
  async see(where, wanted = /^/) {
    let last = /** @type {string | null} */ (null);
    await this.until(
      () => `${inWords(where)} ${last === null ? "in sight" : `saying ${wanted}, not “${last}”`}`,
      async () => {
        last = await this.text(where);
        return last !== null && wanted.test(last);
      },
    );
    return last ?? "";
  }

  /**
   * Waits for something; a fault names it if it does not come.
   * @param {() => string} what
   * @param {() => Promise<boolean>} come
   */
  async until(what, come) {
    const end = Date.now() + PATIENCE_MS;
    while (!(await come())) {
      if (Date.now() > end) throw new Error(`waited ${PATIENCE_MS / 1000} s for ${what()}`);
      await pause(LOOK_EVERY_MS);
    }
  }

  /** @param {Where} where */
  async click(where) {
    await this.see(where);
    await this.#driver.click(found(where));
  }

  /**
   * Chooses from a list by what stands there.
   * @param {Where} where
   * @param {string} option
   */
  async choose(where, option) {
    await this.see(where);
    const chosen = await this.evaluateOn(
      where,
      (element, /** @type {string} */ wanted) => {
        const select = /** @type {HTMLSelectElement} */ (element);
        const found = [...select.options].find(({ text }) => text.trim() === wanted);
        if (!found) return false;
        select.value = found.value;
        for (const kind of ["input", "change"]) {
          select.dispatchEvent(new Event(kind, { bubbles: true }));
        }
        return true;
      },
      option,
    );
    if (!chosen) throw new Error(`${inWords(where)} has no “${option}”`);
  }

  /**
   * Puts the focus on something as the Tab key does: a click in the middle of an editor may hit what
   * lies there.
   * @param {Where} where
   */
  async focus(where) {
    await this.see(where);
    await this.evaluateOn(where, (element) => element.focus());
  }

  /** @param {Key} key */
  async press(key) {
    await this.#driver.press(key);
  }

  /**
   * Types as a person does, key by key, wherever the focus is.
   * @param {string} text
   */
  async type(text) {
    await this.#driver.type(text);
  }

  /** Errors that the page has told of since this was last asked. */
  complaints() {
    return this.#driver.complaints.splice(0);
  }

  /** A picture of what is in sight, as PNG. */
  picture() {
    return this.#driver.picture();
  }
}

/**
 * JavaScript that finds a thing in the page.
 * @param {Where} where
 */
function found(where) {
  return `(${look})(${JSON.stringify(where)})`;
}
