/**
 * `/preview/SLUG/`, in the development server alone: what learners will be told, for whoever writes a
 * lesson. Every program of every task with its mark, the causes, and the small changes of solutions.
 * The page is site/src/preview; marks come from CPython on this machine.
 *
 * GET  /preview/SLUG/                the page, with the marks that are still good
 * POST /preview/SLUG/marks?task=…    marks the files named in the body; a line of JSON for each
 * POST /preview/SLUG/mutants?task=…  tries the changes of the solution; lines of JSON
 * GET  /preview/SLUG/run?key=…       the run in which a check failed
 */
import { existsSync } from "node:fs";
import { join } from "node:path";
import { messageOf } from "../files.mjs";
import { readPreview } from "./folder.mjs";
import { forgetOld, keptRun, sendMarks } from "./marks.mjs";
import { sendMutants } from "./mutants.mjs";
import { previewPage } from "./page.mjs";

const ADDRESS = /^\/preview\/([a-z0-9-]+)\/(marks|mutants|run)?$/;

/**
 * @param {string} lessons the folder of course.json
 * @returns {import("vite").Plugin}
 */
export function preview(lessons) {
  return {
    name: "bugbot-preview",
    apply: "serve",
    // Found only when the page is asked for, they would have it loaded twice.
    config: () => ({
      optimizeDeps: {
        include: ["lit", "lit/directives/unsafe-html.js", "lit/directives/until.js"],
      },
    }),
    configureServer(server) {
      forgetOld();
      server.middlewares.use(async (request, response, next) => {
        const url = new URL(request.url ?? "/", "http://site");
        const [, slug, what] = ADDRESS.exec(url.pathname) ?? [];
        if (!slug || !existsSync(join(lessons, slug, "lesson.json"))) return next();
        const task = url.searchParams.get("task") ?? "";
        try {
          if (what === "run") return sendJson(response, keptRun(url.searchParams.get("key") ?? ""));
          if (what) {
            if (request.method !== "POST") return next();
            const files = what === "marks" ? await bodyOf(request) : [];
            response.setHeader("Content-Type", "application/x-ndjson; charset=utf-8");
            if (what === "marks") await sendMarks(lessons, slug, task, files, response);
            else await sendMutants(lessons, slug, task, response);
            return response.end();
          }
          const html = previewPage(readPreview(lessons, slug));
          response.setHeader("Content-Type", "text/html; charset=utf-8");
          response.end(await server.transformIndexHtml(url.pathname, html));
        } catch (error) {
          if (!response.headersSent) return next(error);
          response.end(`${JSON.stringify({ trouble: messageOf(error) })}\n`);
        }
      });
    },
    transformIndexHtml(html, { path }) {
      // From a lesson's page, for whoever writes it.
      const [, slug] = /^\/lessons\/([a-z0-9-]+)\//.exec(path) ?? [];
      if (!slug) return html;
      const link = `<p class="preview-link"><a href="/preview/${slug}/">What learners are told</a></p>`;
      return html.replace(/<\/header>\s*<nav class="contents"/, (end) => `${link}${end}`);
    },
  };
}

/**
 * The files to mark, a JSON list of texts.
 * @param {import("node:http").IncomingMessage} request
 * @returns {Promise<string[]>}
 */
async function bodyOf(request) {
  let text = "";
  for await (const part of request) text += part;
  const files = JSON.parse(text);
  if (Array.isArray(files)) return files.map(String);
  throw new Error(`a list of files is wanted, not ${text.slice(0, 80)}`);
}

/**
 * @param {import("node:http").ServerResponse} response
 * @param {string | null} text
 */
function sendJson(response, text) {
  response.statusCode = text === null ? 404 : 200;
  response.setHeader("Content-Type", "application/json; charset=utf-8");
  response.end(text ?? "null");
}
