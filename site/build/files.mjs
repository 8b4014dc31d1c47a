/** Small helpers over files and hashes for the build. Imports nothing of ours. */
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
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

/**
 * The message of whatever was thrown.
 * @param {unknown} error
 */
export function messageOf(error) {
  return error instanceof Error ? error.message : String(error);
}
