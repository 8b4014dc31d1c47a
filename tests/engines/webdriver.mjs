/**
 * WebKitGTK, driven through its WebKitWebDriver on a screen that only the memory has (Xvfb). WebDriver
 * is JSON over HTTP, so this is all the client there needs to be.
 */
import { spawn } from "node:child_process";
import { createServer } from "node:net";
import { setTimeout as pause } from "node:timers/promises";

/**
 * @typedef {import("./tab.mjs").Driver} Driver
 * @typedef {import("./tab.mjs").Key} Key
 */

const SCREEN = { width: 1280, height: 800 };
const START_MS = 60_000;
/** Without one, a machine of no language gives pages the language "C", which Intl refuses. */
const LANGUAGE = { LANG: "en_GB.UTF-8", LANGUAGE: "en_GB", LC_ALL: "en_GB.UTF-8" };
const SCRIPT_MS = 120_000;
/** The name under which an answer holds a reference to an element (W3C WebDriver, section 12). */
const ELEMENT = "element-6066-11e4-a52e-4f735466cecf";
/** Keys in the private part of Unicode that WebDriver takes (section 17.4.2). */
const KEYS = { Control: "\uE009", Enter: "\uE007", Escape: "\uE00C", Tab: "\uE004" };

/**
 * @param {Record<string, string>} programs
 * @returns {Promise<Driver>}
 */
export async function openWebKit({ WebKitWebDriver = "", MiniBrowser = "", Xvfb = "" }) {
  const screen = await openScreen(Xvfb);
  const port = await freePort();
  const driver = spawn(WebKitWebDriver, [`--port=${port}`, "--host=127.0.0.1"], {
    env: { ...process.env, ...LANGUAGE, DISPLAY: screen.display, GDK_BACKEND: "x11" },
    stdio: ["ignore", "pipe", "pipe"],
  });
  const complaints = /** @type {string[]} */ ([]);
  for (const stream of [driver.stdout, driver.stderr]) listen(stream, complaints);
  const call = client(`http://127.0.0.1:${port}`);
  let session = "";
  const close = async () => {
    if (session) await call("DELETE", session).catch(() => {});
    driver.kill();
    screen.close();
  };
  process.once("exit", () => {
    driver.kill();
    screen.close();
  });

  try {
    await answering(call);
    const options = {
      binary: MiniBrowser,
      args: ["--automation", "--enable-write-console-messages-to-stdout=true"],
    };
    const capabilities = { alwaysMatch: { "webkitgtk:browserOptions": options } };
    const opened = /** @type {{ sessionId: string, capabilities: Record<string, string> }} */ (
      await call("POST", "/session", { capabilities })
    );
    session = `/session/${opened.sessionId}`;
    await call("POST", `${session}/timeouts`, { script: SCRIPT_MS, pageLoad: SCRIPT_MS });
    await call("POST", `${session}/window/rect`, { x: 0, y: 0, ...SCREEN });
    const { browserName, browserVersion } = opened.capabilities;

    /** @param {string} path @param {object} [body] */
    const ask = (path, body = {}) => call("POST", session + path, body);
    /** @param {string} expression */
    const evaluate = async (expression) => {
      const script = `const done = arguments[0];
        Promise.resolve().then(() => ${expression})
          .then((value) => done({ value }), (error) => done({ error: String(error) }));`;
      const answer = /** @type {{ value?: unknown, error?: string }} */ (
        await ask("/execute/async", { script, args: [] })
      );
      if (answer.error) throw new Error(answer.error);
      return answer.value;
    };
    /** @param {object[]} actions */
    const keys = (actions) => ask("/actions", { actions: [{ type: "key", id: "keys", actions }] });

    return {
      version: `${browserName} ${browserVersion}`,
      complaints,
      open: async (url) => void (await ask("/url", { url })),
      reload: async () => void (await ask("/refresh")),
      evaluate,
      click: async (element) => {
        const reference = /** @type {Record<string, string>} */ (await evaluate(element));
        await ask(`/element/${reference[ELEMENT]}/click`);
      },
      press: async (key) => void (await keys(strokes(key))),
      type: async (text) => void (await keys([...text].flatMap(stroke))),
      picture: async () =>
        Buffer.from(String(await call("GET", `${session}/screenshot`)), "base64"),
      close,
    };
  } catch (error) {
    await close();
    throw error;
  }
}

/** @param {string} value */
function stroke(value) {
  return [
    { type: "keyDown", value },
    { type: "keyUp", value },
  ];
}

/** @param {Key} key */
function strokes(key) {
  if (key !== "SelectAll") return stroke(KEYS[key]);
  return [
    { type: "keyDown", value: KEYS.Control },
    ...stroke("a"),
    { type: "keyUp", value: KEYS.Control },
  ];
}

/**
 * One call of the protocol: its value, or an error in the driver's words.
 * @param {string} base
 */
function client(base) {
  /** @param {string} method @param {string} path @param {object} [body] */
  return async (method, path, body) => {
    const response = await fetch(base + path, {
      method,
      ...(body ? { body: JSON.stringify(body) } : {}),
    });
    const { value } = /** @type {{ value: unknown }} */ (await response.json());
    if (response.ok) return value;
    const { error, message } = /** @type {{ error: string, message: string }} */ (value);
    throw new Error(`${method} ${path}: ${error}${message ? `: ${message}` : ""}`);
  };
}

/** @param {ReturnType<typeof client>} call */
async function answering(call) {
  const end = Date.now() + START_MS;
  for (;;) {
    try {
      return await call("GET", "/status");
    } catch (error) {
      if (Date.now() > end) throw error;
      await pause(100);
    }
  }
}

/**
 * Errors of the page, which WebKit writes among its output.
 * @param {import("node:stream").Readable} stream
 * @param {string[]} complaints
 */
function listen(stream, complaints) {
  stream.setEncoding("utf8").on("data", (/** @type {string} */ text) => {
    for (const line of text.split("\n")) {
      if (/^CONSOLE .*\bERROR\b/.test(line)) complaints.push(line);
    }
  });
}

/**
 * A screen in memory. Xvfb picks a number that is free and says which.
 * @param {string} Xvfb
 */
async function openScreen(Xvfb) {
  const size = `${SCREEN.width}x${SCREEN.height}x24`;
  const server = spawn(Xvfb, ["-displayfd", "3", "-screen", "0", size, "-nolisten", "tcp"], {
    stdio: ["ignore", "ignore", "ignore", "pipe"],
  });
  const number = await new Promise((resolve, reject) => {
    server.stdio[3]?.once("data", (data) => resolve(String(data).trim()));
    server.once("exit", (code) => reject(new Error(`Xvfb has ended with ${code}`)));
  });
  return { display: `:${number}`, close: () => server.kill() };
}

/** @returns {Promise<number>} */
function freePort() {
  return new Promise((resolve) => {
    const server = createServer().listen(0, "127.0.0.1", () => {
      const address = server.address();
      server.close(() => resolve(typeof address === "object" && address ? address.port : 0));
    });
  });
}
