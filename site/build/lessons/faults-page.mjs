/** What the development server shows in place of a page with faults: what they are. */
import { placeText } from "./faults.mjs";
import { escapeHtml } from "./html.mjs";

/**
 * @param {string} slug
 * @param {readonly import("./faults.mjs").Fault[]} faults
 */
export function faultsPage(slug, faults) {
  const items = faults.map(
    ({ file, line, fault, remedy }) => `<li>
        <p><code>${escapeHtml(placeText(file, line))}</code></p>
        <p><b>${escapeHtml(fault)}</b></p>
        <p>${escapeHtml(remedy)}</p>
      </li>`,
  );
  const title = faults.length === 1 ? "1 fault" : `${faults.length} faults`;
  return `<!doctype html>
<html lang="en-GB">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <title>${title} in ${escapeHtml(slug)}</title>
    <link rel="icon" href="/favicon.svg" type="image/svg+xml" />
    <link rel="stylesheet" href="/src/ui/base.css" />
    <link rel="stylesheet" href="/src/page/lesson-page.css" />
  </head>
  <body>
    <main class="faults" role="alert">
      <h1>${title} in ${escapeHtml(slug)}</h1>
      <p>Save the file and this page follows.</p>
      <ol>
      ${items.join("\n      ")}
      </ol>
    </main>
  </body>
</html>
`;
}
