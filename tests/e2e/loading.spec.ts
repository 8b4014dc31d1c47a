/**
 * A file that does not arrive at a first visit. A sample of `npm run test:loading`, which has every file
 * fail in every way.
 */
import { expect, test } from "@playwright/test";
import { filesBelow } from "../../site/build/files.mjs";
import type { Failure } from "../loading/failing-server.mjs";
import { PAGES, visitWith } from "../loading/visit.mjs";
import { DIST } from "./own-site.ts";

const FILES = filesBelow(DIST);

function file(pattern: RegExp): string {
  const found = FILES.filter((path) => pattern.test(path));
  if (!found[0]) throw new Error(`the built site has no file like ${pattern}`);
  return found[0];
}

const ONCE: [page: keyof typeof PAGES, file: RegExp, failure: Failure][] = [
  ["article", /^assets\/lesson-page-.*\.css$/, "cut"],
  ["article", /^assets\/element-.*\.js$/, "404"],
  ["lesson", /^assets\/lab-[\w-]{8}\.css$/, "wrong"],
  ["lab", /^assets\/worker-.*\.js$/, "500"],
  ["lab", /\/interpreter-.*\.bin$/, "cut"],
  ["lab", /\/sources-.*\.bin$/, "wrong"],
];

for (const [page, pattern, failure] of ONCE) {
  test(`${page}: ${pattern.source} fails once (${failure}) and is had at the second try @once`, async ({
    browser,
  }) => {
    const path = file(pattern);
    expect(await visitWith(browser, DIST, PAGES[page], { path, failure, times: 1 })).toEqual({
      verdict: "works",
      words: "",
    });
  });
}

const FOR_GOOD: [page: keyof typeof PAGES, file: RegExp, failure: Failure, words: string][] = [
  ["lab", /^assets\/main-.*\.js$/, "404", "The site may have been updated"],
  ["article", /^assets\/main-.*\.css$/, "wrong", "not as text/css"],
  ["article", /^occupancy-grid-mapping\/index\.html$/, "cut", "Reload to try again."],
  ["lab", /^assets\/worker-.*\.js$/, "wrong", "not as text/javascript"],
  ["lab", /\/interpreter-.*\.bin$/, "cut", "did not arrive as it was published"],
];

for (const [page, pattern, failure, words] of FOR_GOOD) {
  test(`${page}: ${pattern.source} fails for good (${failure}), and the page says so @once`, async ({
    browser,
  }) => {
    const path = file(pattern);
    const outcome = await visitWith(browser, DIST, PAGES[page], { path, failure, times: 1000 });
    expect(outcome.verdict).toBe("told");
    expect(outcome.words).toContain(words);
  });
}
