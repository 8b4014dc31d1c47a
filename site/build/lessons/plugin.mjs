/**
 * Vite's view of the lessons: every lesson is a page that no file holds. The build makes all of
 * them, or fails with every fault there is; the development server makes one when it is asked for,
 * shows its faults in its place, and has the browser ask again when a file of lessons/ changes.
 *
 * @typedef {Awaited<ReturnType<typeof import("../python.mjs").preparePython>>} PreparedPython
 */
import { join, sep } from "node:path";
import { fillCalls } from "../calls-page.mjs";
import { liveFigures } from "../figures.mjs";
import { ROOT } from "../files.mjs";
import { Course, pathOf } from "./course.mjs";
import { LessonFaults } from "./faults.mjs";
import { faultsPage } from "./faults-page.mjs";
import { readCourse } from "./folder.mjs";
import { fillHome, mapRun } from "./home.mjs";
import { slimMathematics } from "./katex-css.mjs";
import { staleText } from "./kept-figures.mjs";
import { mapImage } from "./map-image.mjs";
import { Measurer } from "./measure.mjs";
import { siteMap, withFrame } from "./site-frame.mjs";

const SITE = join(ROOT, "site");
const KATEX = join(ROOT, "node_modules/katex/dist");

/** Several files saved at once are one change [ms]. */
const QUIET_MS = 80;

/**
 * @param {() => Promise<PreparedPython>} preparePython
 * @param {string} folder of course.json
 * @returns {import("vite").Plugin}
 */
export function lessonPages(preparePython, folder) {
  let dev = false;
  /** The pages of the build by the path of the file they would be. @type {Map<string, string>} */
  const files = new Map();
  /** @type {string[]} */
  let paths = [];
  /** @type {Promise<Omit<import("./course.mjs").CourseOptions, "live" | "katex">> | undefined} */
  let tools;

  /** The course as it is on the disk now. */
  const course = async () => {
    tools ??= preparePython().then((python) => ({
      folder,
      worlds: /** @type {import("./course.mjs").World[]} */ (python.course.worlds),
      measurer: new Measurer(python, (text) => console.log(text)),
    }));
    const katex = dev ? `/@fs${KATEX}` : null;
    return new Course({ ...(await tools), katex, live: await liveFigures() });
  };

  /** What files hold of a page whose words come from elsewhere, made whole. */
  const filled = /** @type {Record<string, (html: string) => string | Promise<string>>} */ ({
    "": async (html) => fillHome(html, await course()),
    "api/": async (html) => fillCalls(html, (await preparePython()).course),
  });

  return {
    name: "bugbot-lessons",
    // Before Vite's own, which would ask the disk for the pages.
    enforce: "pre",

    config(_config, { command }) {
      dev = command === "serve";
      const { slugs } = readCourse(folder);
      paths = slugs.map(pathOf);
      const pages = paths.map((path) => [path, join(SITE, path, "index.html")]);
      // The development server makes a page when it is asked for one.
      const input = dev ? {} : Object.fromEntries(pages);
      return {
        build: { rollupOptions: { input } },
        // Formulas bring fonts and a style sheet from a package.
        server: { fs: { allow: [ROOT] } },
      };
    },

    async buildStart() {
      if (dev) return;
      const made = await course();
      // The run that the home page shows shares the threads with what the lessons need.
      const [pages] = await Promise.all([made.pages(), mapRun(made)]);
      for (const [path, html] of pages) files.set(join(SITE, path, "index.html"), html);
      const stale = made.staleOf(made.lessons.map(({ slug }) => slug));
      if (stale.length > 0) console.log(`Figures were measured anew: ${staleText(stale)}`);
    },

    resolveId(id) {
      return files.has(id) ? id : null;
    },

    load(id) {
      return files.get(id) ?? null;
    },

    transform(code, id) {
      if (dev || id.split("?")[0] !== join(KATEX, "katex.min.css")) return null;
      return { code: slimMathematics(code, [...files.values()]), map: null };
    },

    transformIndexHtml: {
      order: "pre",
      async handler(html, { path }) {
        const place = path.replace(/^\//, "").replace(/index\.html$/, "");
        const fill = filled[place];
        return withFrame(fill ? await fill(html) : html, place);
      },
    },

    async generateBundle() {
      const map = siteMap(["", "lab/", "worlds/", "api/", ...paths]);
      // Only a site that knows its own address can tell others of these.
      if (!map) return;
      this.emitFile({ type: "asset", fileName: "sitemap.xml", source: map });
      const { outcome, world } = await mapRun(await course());
      this.emitFile({ type: "asset", fileName: "map.png", source: mapImage(outcome, world) });
    },

    configureServer(server) {
      server.middlewares.use(async (request, response, next) => {
        const url = (request.url ?? "/").replace(/[?#].*$/, "").replace(/index\.html$/, "");
        const slug = /^\/(?:lessons\/)?([a-z0-9-]+)\/$/.exec(url)?.[1] ?? "";
        if (url !== `/${pathOf(slug)}`) return next();
        try {
          const made = await pageOrFaults(await course(), slug);
          if (made === null) return next();
          response.setHeader("Content-Type", "text/html; charset=utf-8");
          response.end(await server.transformIndexHtml(url, made));
        } catch (error) {
          next(error);
        }
      });
      reloadOnChange(server, folder);
    },
  };
}

/**
 * The lesson's page or, in its place and in the terminal, what is wrong with it.
 * @param {Course} course
 * @param {string} slug
 */
async function pageOrFaults(course, slug) {
  try {
    return await course.page(slug);
  } catch (error) {
    if (!(error instanceof LessonFaults)) throw error;
    console.error(`\n${error.message}\n`);
    return faultsPage(slug, error.faults);
  }
}

/**
 * @param {import("vite").ViteDevServer} server
 * @param {string} folder
 */
function reloadOnChange(server, folder) {
  const template = join(SITE, "lesson.html");
  server.watcher.add([folder, template]);
  /** @type {NodeJS.Timeout | undefined} */
  let timer;
  server.watcher.on("all", (_event, path) => {
    if (path !== template && !path.startsWith(folder + sep)) return;
    clearTimeout(timer);
    timer = setTimeout(() => server.ws.send({ type: "full-reload" }), QUIET_MS);
  });
}
