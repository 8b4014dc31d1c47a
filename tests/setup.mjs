/** What the tests need beyond the site's own packages: a Python environment and a browser. */
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { messageOf, ROOT, sha256, write } from "../site/build/files.mjs";
import { fail, run } from "../site/build/install.mjs";
import { findPython } from "../site/build/tools.mjs";
import { findBrowser, SHELL } from "./browser.mjs";

const VENV = join(ROOT, ".venv");
const BIN = join(VENV, process.platform === "win32" ? "Scripts" : "bin");

/**
 * A program of the tests' Python environment.
 * @param {string} name
 */
export function venvTool(name) {
  return join(BIN, name);
}

/** Make .venv hold exactly the packages of tests/requirements.txt. */
export function ensureVenv() {
  const requirements = join(ROOT, "tests/requirements.txt");
  const wanted = sha256(readFileSync(requirements));
  const stamp = join(VENV, "installed");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === wanted) return;
  console.log("setting up Python for the tests (.venv)");
  if (!existsSync(venvTool("python")) && !existsSync(venvTool("python.exe"))) {
    try {
      run(findPython(), ["-m", "venv", VENV]);
    } catch (error) {
      fail(messageOf(error));
    }
  }
  run(venvTool("python"), [
    ...["-m", "pip", "install", "--quiet", "--disable-pip-version-check"],
    ...["-r", requirements],
  ]);
  write(stamp, wanted);
}

/**
 * A Chromium for the browser tests: one that is there, Debian's, or Playwright's own. Where packages
 * can be installed, the shell without a window: a whole browser takes half as long again.
 */
export function ensureBrowser() {
  const found = findBrowser();
  if (found?.includes(SHELL)) return;
  const isRoot = process.getuid?.() === 0;
  /** @param {string[]} args */
  const apt = (...args) => spawnSync("apt-get", args, { stdio: "inherit" }).status === 0;
  if (isRoot && spawnSync("apt-get", ["--version"]).status === 0) {
    console.log("installing Chromium (apt-get)");
    apt("update", "-qq");
    const installed = apt("install", "-y", "-qq", SHELL);
    if (!installed && !found) apt("install", "-y", "-qq", "chromium");
  } else if (!found) {
    console.log("installing Chromium (Playwright's own)");
    spawnSync("npx", ["playwright", "install", "chromium"], { cwd: ROOT, stdio: "inherit" });
  }
  if (!findBrowser()) {
    fail(
      "The browser tests need Chromium, and none was found or could be installed.",
      "install Chromium or Chrome, or name one with CHROMIUM=/path/to/it, and start again.",
    );
  }
}
