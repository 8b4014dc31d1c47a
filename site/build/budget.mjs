/**
 * What a visitor downloads, held against what we allow ourselves. Reads the built site only; sizes
 * are gzip, as most hosts send them, of files that are not packed already.
 *
 *     node site/build/budget.mjs [FOLDER]
 *
 * @typedef {{ what: string, bytes: number, limit: number }} Row
 */
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { filesBelow, ROOT } from "./files.mjs";
import { fail } from "./install.mjs";

/** A page's own words, pictures and tasks. */
const PAGE = 70_000;
/** Script and style that stand in a page: all it has before somebody comes near a lab. */
const BEFORE_A_LAB = 40_000;
/** Script and style of a page with labs; the article's story in a browser holds it. */
const WITH_LABS = 250_000;
/** All that comes before the first program's output, and what it may need later. */
const FIRST_RUN = 10_000_000;
const NUMPY = 3_200_000;
const WHOLE_SITE = 20_000_000;

/**
 * @param {string} folder of the built site
 * @returns {Row[]} the largest of each kind
 */
export function budget(folder) {
  const files = filesBelow(folder);
  /** @type {Map<string, number>} */
  const sizes = new Map();
  /** @param {string} path */
  const size = (path) => {
    const known = sizes.get(path);
    if (known !== undefined) return known;
    const data = readFileSync(join(folder, path));
    const bytes = /\.(html|js|mjs|css|svg|json|xml)$/.test(path)
      ? gzipSync(data).length
      : data.length;
    sizes.set(path, bytes);
    return bytes;
  };
  /** @param {string[]} paths */
  const sum = (paths) => paths.reduce((total, path) => total + size(path), 0);
  /** @param {string} what @param {number} limit @param {{ path: string, bytes: number }[]} each */
  const largest = (what, limit, each) => {
    const [most] = each.toSorted((a, b) => b.bytes - a.bytes);
    return { what: `${what} (${most?.path ?? "none"})`, bytes: most?.bytes ?? 0, limit };
  };

  const pages = files.filter((path) => path.endsWith(".html"));
  const parts = pages.map((path) => ({ path, files: standsIn(folder, path) }));
  const python = files.filter((path) => path.startsWith("python/"));
  const later = /\/(?:numpy|stdlib|yaml|judging)-/;
  return [
    largest(
      "the largest page",
      PAGE,
      pages.map((path) => ({ path, bytes: size(path) })),
    ),
    largest(
      "script and style before a lab",
      BEFORE_A_LAB,
      parts.map(({ path, files: own }) => ({ path, bytes: sum(own) })),
    ),
    {
      what: "Python up to the first output",
      bytes: sum(python.filter((path) => !later.test(path))),
      limit: FIRST_RUN - WITH_LABS,
    },
    {
      what: "NumPy",
      bytes: sum(python.filter((path) => path.includes("/numpy-"))),
      limit: NUMPY,
    },
    { what: "the whole site", bytes: sum(files), limit: WHOLE_SITE },
  ];
}

/**
 * The scripts and style sheets that a page's HTML names.
 * @param {string} folder @param {string} page
 */
function standsIn(folder, page) {
  const html = readFileSync(join(folder, page), "utf8");
  const named = [...html.matchAll(/(?:src|href)="([^"]+\.(?:js|css))"/g)].map((match) =>
    join(dirname(page), match[1] ?? "").replaceAll("\\", "/"),
  );
  return [...new Set(named)];
}

/**
 * Prints the table; ends the process with a fault if something is over its limit.
 * @param {string} folder
 */
export function holdBudget(folder = join(ROOT, "dist")) {
  const rows = budget(folder);
  const width = Math.max(...rows.map(({ what }) => what.length));
  for (const { what, bytes, limit } of rows) {
    const verdict = bytes <= limit ? "" : "  OVER";
    console.log(`${what.padEnd(width)}  ${kilobytes(bytes)} of ${kilobytes(limit)}${verdict}`);
  }
  const over = rows.filter(({ bytes, limit }) => bytes > limit);
  if (over.length > 0) {
    fail(
      `The built site is heavier than it may be: ${over.map(({ what }) => what).join("; ")}.`,
      "load the part later, or make it smaller; a limit is changed in site/build/budget.mjs, with a reason.",
    );
  }
}

/** @param {number} bytes */
function kilobytes(bytes) {
  return `${Math.round(bytes / 1000)} kB`.padStart(9);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) holdBudget(process.argv[2]);
