import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { filesBelow, ROOT } from "../../site/build/files.mjs";

const SOURCES = join(ROOT, "site/src");
const read = (path: string): string => readFileSync(join(SOURCES, path), "utf8");
const assigned = (css: string): string[] =>
  [...css.matchAll(/(?:^|[\s{;])(--[\w-]+)\s*:/g)].map((match) => match[1] ?? "");

test("no style sheet gives a token of the whole site another value", () => {
  const tokens = new Set(assigned(read("ui/tokens.css")));
  expect(tokens.has("--panel")).toBe(true);
  const others = filesBelow(SOURCES, (path) => path.endsWith(".css") && path !== "ui/tokens.css");
  const taken = others.flatMap((path) =>
    assigned(read(path))
      .filter((name) => tokens.has(name))
      .map((name) => `${path} sets ${name}`),
  );
  expect(taken).toEqual([]);
});
