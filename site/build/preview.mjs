/**
 * `/preview/SLUG/`, in the development server alone: what learners will be told. Of every task the
 * statement, how the solution and the starter are marked, and each wrong attempt beside its
 * feedback. Marks come from CPython on this machine, and again when a file has changed.
 */
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { ROOT } from "./files.mjs";
import { escapeHtml } from "./lessons/html.mjs";
import { previewPage, resultHtml } from "./preview-page.mjs";
import { findPython } from "./tools.mjs";

const ADDRESS = /^\/preview\/([a-z0-9-]+)\/(marks)?$/;

/**
 * @param {string} lessons the folder of course.json
 * @returns {import("vite").Plugin}
 */
export function preview(lessons) {
  return {
    name: "bugbot-preview",
    apply: "serve",
    configureServer(server) {
      server.middlewares.use(async (request, response, next) => {
        const [, slug, marks] = ADDRESS.exec((request.url ?? "").replace(/\?.*$/, "")) ?? [];
        if (!slug || !existsSync(join(lessons, slug, "lesson.json"))) return next();
        response.setHeader("Content-Type", "text/html; charset=utf-8");
        try {
          if (marks) await sendMarks(lessons, slug, response);
          else {
            const page = previewPage(join(lessons, slug), slug);
            response.end(await server.transformIndexHtml(`/preview/${slug}/`, page));
          }
        } catch (error) {
          next(error);
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
 * One line of HTML for each program, as it is marked; the page puts it in its place.
 * @param {string} lessons
 * @param {string} slug
 * @param {import("node:http").ServerResponse} response
 */
async function sendMarks(lessons, slug, response) {
  const child = spawn(python(), ["-m", "grader.classes.preview", lessons, slug], {
    env: { ...process.env, PYTHONPATH: join(ROOT, "py") },
    stdio: ["ignore", "pipe", "pipe"],
  });
  response.on("close", () => child.kill());
  let complaint = "";
  child.stderr.on("data", (text) => {
    complaint += text;
  });
  for await (const line of createInterface({ input: child.stdout })) {
    const { task, file, earns, mark } = JSON.parse(line);
    const html = resultHtml(mark, earns);
    response.write(`${JSON.stringify({ id: `${task}/${file}`, html })}\n`);
  }
  if (complaint) {
    const html = `<pre>${escapeHtml(complaint)}</pre>`;
    response.write(`${JSON.stringify({ id: "trouble", html })}\n`);
  }
  response.end();
}

/** That of the tests' environment, which has NumPy, or else the system's. */
function python() {
  const own = join(ROOT, ".venv/bin/python");
  return existsSync(own) ? own : findPython();
}
