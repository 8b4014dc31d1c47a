/** Which engines this machine has, and how one gets those it lacks. Imports no package. */
import { spawnSync } from "node:child_process";
import { existsSync, readdirSync, statSync } from "node:fs";
import { delimiter, join } from "node:path";

/**
 * @typedef {"chromium" | "firefox" | "webkit"} EngineName
 * @typedef {{ name: EngineName, title: string, programs: Record<string, string>, missing: string | null }} Engine
 *   `programs`: paths of what drives it; `missing`: what is not there and how to install it, or null
 */

const DEBIAN_LIBRARIES = "/usr/lib";

/**
 * The first of some commands that is on the PATH, or the place that a variable of the environment
 * names.
 * @param {string} variable
 * @param {string[]} names
 */
function command(variable, names) {
  const named = process.env[variable];
  if (named) return existsSync(named) ? named : null;
  const folders = (process.env.PATH ?? "").split(delimiter);
  const places = names.flatMap((name) => folders.map((folder) => join(folder, name)));
  return places.find((path) => existsSync(path)) ?? null;
}

/** WebKitGTK's own small browser, which Debian keeps off the PATH, beside the library. */
function miniBrowser() {
  const known = command("MINIBROWSER", ["MiniBrowser"]);
  if (known || process.platform !== "linux") return known;
  const places = readdirSync(DEBIAN_LIBRARIES)
    .map((folder) => join(DEBIAN_LIBRARIES, folder))
    .filter((folder) => statSync(folder).isDirectory())
    .flatMap((folder) => ["webkitgtk-6.0", "webkit2gtk-4.1"].map((name) => join(folder, name)))
    .map((folder) => join(folder, "MiniBrowser"));
  return places.find((path) => existsSync(path)) ?? null;
}

/**
 * @param {EngineName} name
 * @param {string} title
 * @param {Record<string, string | null>} programs
 * @param {string} remedy
 * @returns {Engine}
 */
function engine(name, title, programs, remedy) {
  /** @type {Record<string, string>} */
  const found = {};
  const lacking = [];
  for (const [program, path] of Object.entries(programs)) {
    if (path) found[program] = path;
    else lacking.push(program);
  }
  const missing = lacking.length > 0 ? `${lacking.join(", ")} not found; ${remedy}` : null;
  return { name, title, programs: found, missing };
}

/**
 * The three engines, those that are not installed as well.
 * @param {string | undefined} chromium the Chromium that the other browser tests use
 * @returns {Engine[]}
 */
export function findEngines(chromium) {
  const onDebian = spawnSync("apt-get", ["--version"]).status === 0;
  const apt = (/** @type {string} */ packages) => `apt-get install ${packages}`;
  return [
    engine(
      "chromium",
      "Chromium",
      { chromium: chromium ?? null },
      `${onDebian ? apt("chromium") : "install Chromium or Chrome"}, or name one with CHROMIUM=/path/to/it`,
    ),
    engine(
      "firefox",
      "Firefox",
      { firefox: command("FIREFOX", ["firefox-esr", "firefox"]) },
      `${onDebian ? apt("firefox-esr") : "install Firefox"}, or name one with FIREFOX=/path/to/it`,
    ),
    engine(
      "webkit",
      "WebKitGTK",
      {
        WebKitWebDriver: command("WEBKITWEBDRIVER", ["WebKitWebDriver"]),
        MiniBrowser: miniBrowser(),
        // It has no way to run without a screen.
        Xvfb: command("XVFB", ["Xvfb"]),
      },
      onDebian ? apt("webkit2gtk-driver xvfb") : "WebKitGTK is tested on Linux only",
    ),
  ];
}
