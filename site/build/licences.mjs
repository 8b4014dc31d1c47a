/**
 * licences.txt of the built site: whose work is in it, and on what terms. It is made from what the
 * bundler has really put in, so that no package can be forgotten; one with terms that nobody has
 * looked at ends the build.
 */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "./files.mjs";

const FILE = "licences.txt";

/** Terms under which a part may be in a site that is given away whole. */
const KNOWN_TERMS = ["0BSD", "Apache-2.0", "BSD-2-Clause", "BSD-3-Clause", "ISC", "MIT", "MPL-2.0"];

/** In the site without going through the bundler: copied files, and formulas made at build time. */
const COPIED = ["pyodide", "katex"];

/** What comes inside Python's files and has no package of its own. */
const INSIDE_PYTHON = `CPython 3.14 (interpreter and standard library, inside Pyodide)
Python Software Foundation License Version 2: https://docs.python.org/3/license.html
Copyright (c) 2001 Python Software Foundation. All rights reserved.

NumPy (loaded when a program imports it)
BSD-3-Clause: https://numpy.org/doc/stable/license.html
Copyright (c) 2005-2026, NumPy Developers. All rights reserved.
The file python/numpy-*.bin is its wheel, a ZIP archive as it was published; the terms of all its
parts are in its folder numpy-*.dist-info/licenses.

PyYAML (loaded when a ROS map is opened)
MIT: https://pyyaml.org
Copyright (c) 2017-2021 Ingy döt Net. Copyright (c) 2006-2016 Kirill Simonov.
The file python/yaml-*.bin is a ZIP archive of its Python files; its terms are in the folder
pyyaml-*.dist-info/licenses.`;

/**
 * @typedef {{ name: string, version: string, license: string, home: string, text: string }} Part
 *
 * @returns {import("vite").Plugin}
 */
export function licences() {
  return {
    name: "bugbot-licences",
    apply: "build",

    generateBundle(_options, bundle) {
      const modules = Object.values(bundle).flatMap((part) =>
        part.type === "chunk" ? part.moduleIds : [],
      );
      const names = new Set([...packagesOf(modules), ...COPIED]);
      const parts = [...names].sort().map(readPart);
      this.emitFile({ type: "asset", fileName: FILE, source: textOf(parts) });
    },
  };
}

/**
 * Names of the packages that modules come from.
 * @param {readonly string[]} modules paths, as the bundler has them
 * @returns {string[]}
 */
export function packagesOf(modules) {
  const found = modules.flatMap((path) => {
    const inside = path.replaceAll("\\", "/").split("/node_modules/").at(-1);
    if (inside === undefined || inside === path) return [];
    const [first = "", second = ""] = inside.split("/");
    return [first.startsWith("@") ? `${first}/${second}` : first];
  });
  return [...new Set(found)];
}

/**
 * @param {string} name of an installed package
 * @returns {Part}
 */
export function readPart(name) {
  const folder = join(ROOT, "node_modules", name);
  const { version, license, homepage, repository } = JSON.parse(
    readFileSync(join(folder, "package.json"), "utf8"),
  );
  if (!KNOWN_TERMS.includes(license)) {
    throw new Error(
      `${name} ${version} has the licence ${JSON.stringify(license)}, which nobody has looked at.\n` +
        "Remedy: if the site may carry it, add its name to KNOWN_TERMS in site/build/licences.mjs.",
    );
  }
  const file = readdirSync(folder).find((each) => /^(licen[cs]e|copying)/i.test(each));
  const text =
    file && existsSync(join(folder, file)) ? readFileSync(join(folder, file), "utf8") : "";
  const source = typeof repository === "string" ? repository : repository?.url;
  return { name, version, license, home: homepage ?? source ?? "", text: text.trim() };
}

/** @param {readonly Part[]} parts */
function textOf(parts) {
  const own = readFileSync(join(ROOT, "LICENSE"), "utf8").trim();
  const others = parts.map(({ name, version, license, home, text }) =>
    [`${name} ${version}`, `${license}${home && `: ${home}`}`, ...(text ? ["", text] : [])].join(
      "\n",
    ),
  );
  const rule = `\n\n${"-".repeat(72)}\n\n`;
  return `${[`bugbot lessons\n\n${own}`, INSIDE_PYTHON, ...others].join(rule)}\n`;
}
