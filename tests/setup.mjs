/** What the tests need beyond the site's own packages: a Python environment and a browser. */
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join, relative } from "node:path";
import { messageOf, ROOT, sha256, write } from "../site/build/files.mjs";
import { fail, run } from "../site/build/install.mjs";
import { findPython } from "../site/build/tools.mjs";
import { findBrowser, SHELL } from "./browser.mjs";

const VENV = join(ROOT, ".venv");

/**
 * A program of the tests' Python environment.
 * @param {string} name
 * @param {string} [venv] another environment than the tests'
 */
export function venvTool(name, venv = VENV) {
  return join(venv, process.platform === "win32" ? "Scripts" : "bin", name);
}

/**
 * Make an environment hold exactly the packages of tests/requirements.txt, and a few more.
 * @param {string} [venv]
 * @param {string[]} [more] requirements, as pip takes them
 */
export function ensureVenv(venv = VENV, more = []) {
  const requirements = join(ROOT, "tests/requirements.txt");
  const wanted = sha256([readFileSync(requirements, "utf8"), ...more].join("\n"));
  const stamp = join(venv, "installed");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === wanted) return;
  console.log(`setting up Python for the tests (${relative(ROOT, venv)})`);
  const python = venvTool("python", venv);
  if (!existsSync(python) && !existsSync(`${python}.exe`)) {
    try {
      run(findPython(), ["-m", "venv", venv]);
    } catch (error) {
      fail(messageOf(error));
    }
  }
  run(python, [
    ...["-m", "pip", "install", "--quiet", "--disable-pip-version-check"],
    ...["-r", requirements, ...more],
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
