/** The HTML of a lesson's authors' page; what it holds is drawn by site/src/preview. */
import { join } from "node:path";
import { ROOT } from "../files.mjs";
import { escapeHtml, jsonScript } from "../lessons/html.mjs";

/** @param {import("../../src/preview/data.ts").LessonPreview} lesson */
export function previewPage(lesson) {
  return `<!doctype html>
<html lang="en-GB">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <title>What learners are told: ${escapeHtml(lesson.title)}</title>
    <link rel="icon" href="/favicon.svg" type="image/svg+xml" />
    <script src="/theme.js"></script>
    <link rel="stylesheet" href="/src/ui/base.css" />
    <link rel="stylesheet" href="/@fs${join(ROOT, "node_modules/katex/dist/katex.min.css")}" />
    <script type="module" src="/src/preview/main.ts"></script>
  </head>
  <body>
    <!-- header -->
    <main id="main" class="preview"></main>
    ${jsonScript('type="application/json" id="preview-data"', lesson)}
  </body>
</html>`;
}
