/** Finds a Chromium for the browser tests. */
import { existsSync } from "node:fs";
import { delimiter, join } from "node:path";
import { chromium } from "@playwright/test";

/** The shell first: the same engine without a window's furniture, and a third less to do per page. */
export const SHELL = "chromium-headless-shell";
const NAMES = [
  SHELL,
  ...["chromium", "chromium-browser", "google-chrome-stable", "google-chrome", "chrome"],
];
const PLACES = [
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
  "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
];

/** Launch options that keep Chromium from calling home, and let it run as root in CI. */
export const BROWSER_ARGS = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** Path of a browser: CHROMIUM if set, else one of the system's, else Playwright's own. */
export function findBrowser() {
  const folders = (process.env.PATH ?? "").split(delimiter);
  const onPath = NAMES.flatMap((name) => folders.map((folder) => join(folder, name)));
  const candidates = [process.env.CHROMIUM, ...onPath, ...PLACES, chromium.executablePath()];
  return candidates.find((path) => path && existsSync(path));
}

/** How Chromium is launched, wherever it was found. */
export function launchOptions() {
  const executablePath = findBrowser();
  return { args: BROWSER_ARGS, ...(executablePath ? { executablePath } : {}) };
}
