/** The built site says whose work is in it. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";
import { packagesOf, readPart } from "../../site/build/licences.mjs";

test("packages are known by where their modules lie", () => {
  const modules = [
    "/home/me/site/src/main.ts",
    "/home/me/node_modules/lit/index.js",
    "/home/me/node_modules/@codemirror/view/dist/index.js",
    "/home/me/node_modules/lit/node_modules/lit-html/lit-html.js",
    "C:\\me\\node_modules\\uplot\\dist\\uPlot.esm.js",
    "\0virtual:bugbot",
  ];
  expect(packagesOf(modules)).toEqual(["lit", "@codemirror/view", "lit-html", "uplot"]);
});

test("every package that the site depends on has terms that have been looked at", () => {
  const { dependencies } = JSON.parse(readFileSync(join(ROOT, "package.json"), "utf8"));
  for (const name of Object.keys(dependencies)) {
    const part = readPart(name);
    expect(part.license).not.toBe("");
    // Pyodide's package comes without the text, which its licence does not ask for.
    if (name !== "pyodide") expect(part.text, name).toContain("Copyright");
  }
});

test("a package whose terms nobody has looked at is refused by name", () => {
  expect(() => readPart("argparse")).toThrow(/^argparse .* "PSF-2.0", which nobody has looked at/);
});
