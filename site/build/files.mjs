/** Small helpers over files and hashes for the build. Imports nothing of ours. */
import { createHash } from "node:crypto";
import {
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import { dirname, join, relative, sep } from "node:path";
import { fileURLToPath } from "node:url";

/** The project's top folder. */
export const ROOT = fileURLToPath(new URL("../..", import.meta.url));
/** Where set-up and build keep what they can make again. */
export const CACHE = join(ROOT, ".cache");

/**
 * Hexadecimal SHA-256 of bytes or text.
 * @param {string | Uint8Array} data
 */
export function sha256(data) {
  return createHash("sha256").update(data).digest("hex");
}

/**
 * Every file below a folder, as paths from it with forward slashes, sorted.
 * @param {string} folder
 * @param {(path: string) => boolean} keep
 */
export function filesBelow(folder, keep = (_path) => true) {
  if (!existsSync(folder)) return [];
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).split(sep).join("/"))
    .filter((path) => !path.includes("__pycache__") && keep(path))
    .sort();
}

/**
 * One hash over the names and contents of files, to tell whether anything changed.
 * @param {string[]} paths
 */
export function hashOfFiles(paths) {
  const hash = createHash("sha256");
  for (const path of paths) {
    hash.update(relative(ROOT, path)).update("\0").update(readFileSync(path)).update("\0");
  }
  return hash.digest("hex");
}

/**
 * Write a file, making its folder.
 * @param {string} path
 * @param {string | Uint8Array} data
 */
export function write(path, data) {
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, data);
}

/** Of what was prepared in one place, so much is kept: another process may be reading its own. */
const KEPT = 3;

/**
 * A folder named by what went into it, made if it isn't there. It is written elsewhere and then
 * moved, so whoever finds it finds it whole, however many processes prepare it side by side.
 * @param {string} home
 * @param {string} key
 * @param {(folder: string) => Promise<void>} make writes all of it into the folder it is given
 * @returns {Promise<string>}
 */
export async function preparedFolder(home, key, make) {
  const folder = join(home, key);
  if (existsSync(folder)) return folder;
  const draft = `${folder}.${process.pid}`;
  mkdirSync(draft, { recursive: true });
  await make(draft);
  try {
    renameSync(draft, folder);
  } catch (error) {
    rmSync(draft, { recursive: true, force: true });
    // Another process was quicker: what it made is the same.
    if (!existsSync(folder)) throw error;
  }
  const age = (/** @type {string} */ path) => statSync(path).mtimeMs;
  const all = readdirSync(home).map((name) => join(home, name));
  for (const old of all.sort((a, b) => age(b) - age(a)).slice(KEPT)) {
    rmSync(old, { recursive: true, force: true });
  }
  return folder;
}

/**
 * The message of whatever was thrown.
 * @param {unknown} error
 */
export function messageOf(error) {
  return error instanceof Error ? error.message : String(error);
}
