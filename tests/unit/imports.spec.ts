/** Holds the import arrows of ARCHITECTURE.md for the site's rooms, by reading every import. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { filesBelow, ROOT } from "../../site/build/files.mjs";

const SRC = join(ROOT, "site/src");

/** Room -> rooms it may import, besides itself. A path of two parts names one file of a room. */
const MAY_IMPORT: Record<string, string[]> = {
  trace: [],
  ui: [],
  player: ["trace"],
  runtime: ["trace"],
  worker: ["runtime/messages.ts"],
  views: ["trace", "player", "ui"],
  editor: ["ui"],
  figures: ["ui", "trace/frames.ts"],
  offline: [],
  early: ["offline/drop.ts", "embed/messages.ts"],
  embed: ["trace/events.ts"],
  page: [
    "trace",
    "ui",
    "player",
    "runtime",
    "views",
    "editor",
    "offline/drop.ts",
    "offline/messages.ts",
    "offline/site-files.ts",
    "embed/messages.ts",
  ],
  preview: ["page", "runtime", "trace", "ui"],
  scorm: ["page/progress.ts", "page/progress-record.ts"],
  "main.ts": ["page", "figures", "runtime", "ui"],
};

/** What the file's imports name, relative to site/src, without packages and virtual modules. */
function importsOf(path: string): string[] {
  const text = readFileSync(join(SRC, path), "utf8");
  const found = text.matchAll(/(?:from|import)\s*\(?\s*"(\.[^"]+)"/g);
  return [...found].map(([, target]) => {
    const url = new URL(target ?? "", new URL(path, "file:///"));
    return url.pathname.slice(1);
  });
}

function room(path: string): string {
  return path.split("/")[0] ?? path;
}

const files = filesBelow(SRC, (path: string) => path.endsWith(".ts") && !path.endsWith(".d.ts"));

test("every room of site/src has its arrows stated", () => {
  expect([...new Set(files.map(room))].sort()).toEqual(Object.keys(MAY_IMPORT).sort());
});

for (const file of files) {
  test(`${file} imports only what its room may`, () => {
    const own = room(file);
    const allowed = MAY_IMPORT[own] ?? [];
    const wrong = importsOf(file).filter((target) => {
      // The pool names the worker's script by its address; nothing of it is loaded.
      if (file === "runtime/pool.ts" && target === "worker/worker.ts") return false;
      return room(target) !== own && !allowed.includes(room(target)) && !allowed.includes(target);
    });
    expect(wrong).toEqual([]);
  });
}

/** What may ask for a part by itself: it tells of a failure in its own way, or nobody waits for it. */
const OWN_WAY = [
  "early/arrivals.ts",
  "page/offline.ts",
  "runtime/worker-frame.ts",
  "worker/interpreter.ts",
];

test("what is fetched later is asked for by part(), which tries again and tells", () => {
  const bare = files
    .filter((path) => !OWN_WAY.includes(path))
    .filter((path) => {
      const code = readFileSync(join(SRC, path), "utf8").replaceAll(
        /\/\*[\s\S]*?\*\/|typeof import\(/g,
        "",
      );
      return /(?<!part\(\(\) =>\s*)(?<![.\w])import\((?!text)/.test(code);
    });
  expect(bare).toEqual([]);
});
