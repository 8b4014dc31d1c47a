/** No words of the site say "1 cells": every one that takes numbers is asked with ones. */
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";

const UI = join(ROOT, "site/src/ui");
const MODULES = readdirSync(UI).filter(
  (file) => file.endsWith("-words.ts") || file === "strings.ts",
);

/** What the site counts. */
const THINGS =
  "attempts beams boxes calls cells characters checks entries faults files hints hits items kinds lessons " +
  "lines looks mats mistakes mutants obstacles parts places points programs reasons runs " +
  "seeds steps tasks times tries values versions walls words worlds";

/** A 1 before one of these in the plural; not 0.1 or 11. */
const MANY = new RegExp(
  `(?<![\\d.,:–-])1 (?:passes|(?:[a-z]+ )?(?:${THINGS.replaceAll(" ", "|")}))\\b`,
);

type Words = Readonly<Record<string, unknown>>;

/** Everything that a part of the words says of ones, by its name. */
function said(name: string, part: unknown): [name: string, text: string][] {
  if (typeof part === "string") return [[name, part]];
  if (typeof part === "function") {
    return [1, fields].flatMap((first) => {
      try {
        const words = part as (...given: unknown[]) => unknown;
        return [[name, String(words(...[first, first, first, first, first, first]))]];
      } catch {
        return []; // it wants a text, or fields
      }
    });
  }
  if (typeof part !== "object" || part === null) return [];
  return Object.entries(part as Words).flatMap(([key, each]) => said(`${name}.${key}`, each));
}

/** Any field of it is 1. */
const fields = new Proxy({}, { get: (_, key) => (key === Symbol.toPrimitive ? () => "it" : 1) });

test("what is counted once is in the singular", async () => {
  const all = [];
  for (const file of MODULES) {
    const words = (await import(join(UI, file))) as Words;
    all.push(...said(file, words));
  }
  expect(all.length).toBeGreaterThan(400);
  expect(all.filter(([, text]) => MANY.test(text))).toEqual([]);
});

test("the test knows a plural when it sees one", () => {
  for (const text of ["1 cells", "has 1 wrong attempts", "All 1 runs keep", "of 1 tasks passed"]) {
    expect(text).toMatch(MANY);
  }
  for (const text of ["1 cell", "1 pass", "0.1 cells", "11 cells", "at 1 s", "1 run keeps"]) {
    expect(text).not.toMatch(MANY);
  }
});
