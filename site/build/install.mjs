/**
 * First step of every command: the packages of package-lock.json, installed if they are not.
 * Imports nothing that has to be installed.
 */
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { CACHE, ROOT, sha256, write } from "./files.mjs";

const OLDEST_NODE = { major: 20, minor: 19 };

/** Make sure that Node is new enough and that node_modules is what the lock file says. */
export function ensureInstalled() {
  const [major = 0, minor = 0] = process.versions.node.split(".").map(Number);
  if (major < OLDEST_NODE.major || (major === OLDEST_NODE.major && minor < OLDEST_NODE.minor)) {
    fail(
      `Node ${OLDEST_NODE.major}.${OLDEST_NODE.minor} or newer is needed; this is ${process.versions.node}.`,
      "install it from nodejs.org and start again.",
    );
  }
  const lock = sha256(readFileSync(join(ROOT, "package-lock.json")));
  const stamp = join(CACHE, "installed");
  const current = existsSync(stamp) && readFileSync(stamp, "utf8") === lock;
  if (current && existsSync(join(ROOT, "node_modules"))) return;
  console.log("installing packages");
  // Not `npm ci`: it refuses a lock file that lacks another platform's binaries, and some registries
  // serve only those of their own. This installs what the lock file says all the same.
  run("npm", ["install", "--no-save", "--no-audit", "--no-fund", "--loglevel=error"]);
  write(stamp, lock);
}

/**
 * Run a command in the project's folder, its output shown; end this process if it fails.
 * @param {string} command
 * @param {string[]} args
 * @param {import("node:child_process").SpawnSyncOptions} options
 */
export function run(command, args, options = {}) {
  const shell = process.platform === "win32";
  const done = spawnSync(command, args, { cwd: ROOT, stdio: "inherit", shell, ...options });
  if (done.error) fail(`${command} could not be started: ${done.error.message}`);
  if (done.status !== 0) process.exit(done.status ?? 1);
}

/**
 * End with a message of what is wrong and what to do.
 * @param {string} fault
 * @param {string} [remedy]
 * @returns {never}
 */
export function fail(fault, remedy) {
  console.error(fault + (remedy ? `\nRemedy: ${remedy}` : ""));
  process.exit(1);
}
