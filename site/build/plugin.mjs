/**
 * Vite's view of the project's own data: two virtual modules and the folder of Python's files;
 * and, beside it, the pages made from the lessons (lessons/plugin.mjs).
 *
 * virtual:bugbot        the worlds, the ready programs and the robot's calls
 * virtual:python-files  where the browser finds Python, and how large each file is
 */
import { createReadStream, existsSync, readFileSync } from "node:fs";
import { join, normalize } from "node:path";
import { early } from "./early.mjs";
import { filesBelow, ROOT } from "./files.mjs";
import { lessonPages } from "./lessons/plugin.mjs";
import { licences } from "./licences.mjs";
import { offline } from "./offline.mjs";
import { preview } from "./preview/plugin.mjs";
import { preparePython } from "./python.mjs";
import { standalone } from "./standalone.mjs";

const FOLDER = "python";

/** @typedef {Awaited<ReturnType<typeof preparePython>>} PreparedPython */

/**
 * @param {{ lessons?: string }} [options] lessons: the folder of another course.json
 * @returns {import("vite").Plugin[]}
 */
export function bugbot({ lessons = join(ROOT, "lessons") } = {}) {
  /** @type {Promise<PreparedPython> | undefined} */
  let preparing;
  const prepare = () => {
    preparing ??= preparePython((text) => console.log(text));
    return preparing;
  };
  return [
    siteData(prepare),
    early(),
    preview(lessons),
    lessonPages(prepare, lessons),
    licences(),
    offline(),
  ];
}

/**
 * @param {() => Promise<PreparedPython>} prepare
 * @returns {import("vite").Plugin}
 */
function siteData(prepare) {
  /** @type {PreparedPython} */
  let python;
  let dev = false;

  return {
    name: "bugbot",

    async config(_config, { command }) {
      dev = command === "serve";
      python = await prepare();
    },

    resolveId(id) {
      if (id === "virtual:bugbot" || id === "virtual:python-files") return `\0${id}`;
      return null;
    },

    load(id) {
      if (id === "\0virtual:bugbot") {
        const { worlds, api } = python.course;
        return exportsOf({ worlds, api, readyPrograms: readyPrograms() });
      }
      if (id === "\0virtual:python-files") {
        const { files, loader, numpy } = python.manifest;
        // Scripts lie in assets/, beside the folder of Python's files, wherever the site lies.
        const base = dev ? `/${FOLDER}/` : `../${FOLDER}/`;
        return exportsOf({ base, loader, numpyVersion: numpy, files });
      }
      return null;
    },

    async generateBundle() {
      for (const path of filesBelow(python.folder, isServed)) {
        const source = readFileSync(join(python.folder, path));
        this.emitFile({ type: "asset", fileName: `${FOLDER}/${path}`, source });
      }
      // Other sites' pages name it: its address stays the same.
      const source = await standalone(join(ROOT, "site/src/embed/embed.ts"));
      this.emitFile({ type: "asset", fileName: "embed.js", source });
    },

    configureServer(server) {
      server.middlewares.use(`/${FOLDER}/`, (request, response, next) => {
        const path = normalize(decodeURIComponent((request.url ?? "/").replace(/\?.*/, "")));
        const file = join(python.folder, path);
        if (!file.startsWith(python.folder) || !existsSync(file)) return next();
        const script = path.endsWith(".mjs");
        response.setHeader("Content-Type", script ? "text/javascript" : "application/octet-stream");
        createReadStream(file).pipe(response);
      });
    },
  };
}

/**
 * What the site serves of the prepared folder: not what only the build reads.
 * @param {string} path
 */
function isServed(path) {
  return !path.endsWith(".json");
}

/**
 * The programs of lessons/lab/, whole. Throws, naming file and remedy, if one is missing.
 * @returns {{ world: string, title: string, source: string }[]}
 */
function readyPrograms() {
  const folder = join(ROOT, "lessons/lab");
  const index = join(folder, "lab.json");
  if (!existsSync(index)) throw new Error(`${index} is missing: it lists the lab's programs`);
  /** @type {{ world: string, program: string, title: string }[]} */
  const entries = JSON.parse(readFileSync(index, "utf8"));
  return entries.map(({ world, program, title }) => {
    const file = join(folder, program);
    if (!existsSync(file)) {
      throw new Error(
        `${index}: there is no program ${program}. Write ${file}, or mend the entry.`,
      );
    }
    return { world, title, source: readFileSync(file, "utf8") };
  });
}

/** @param {Record<string, unknown>} values */
function exportsOf(values) {
  return Object.entries(values)
    .map(([name, value]) => `export const ${name} = ${JSON.stringify(value)};`)
    .join("\n");
}
