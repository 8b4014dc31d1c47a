/**
 * One runner: `unit` is plain TypeScript with no page (decode, player, camera, …),
 * `e2e` and `e2e-phone` drive the built site in a browser, from a plain static host below a folder,
 * or the site at the address SITE if that is set (with its slash at the end).
 *
 *     npx playwright test -c tests/playwright.config.ts --project unit
 *
 * `long` (npm run test:long) is the stories marked @long: long trials of many inputs, of which `e2e` has a
 * sample.
 */
import { defineConfig } from "@playwright/test";
import { launchOptions as findLaunchOptions } from "./browser.mjs";

const PORT = 4174;
const FOLDER = "/some/school/";
const SITE = process.env.SITE;

const browser = {
  testDir: "e2e",
  // A run may wait for an interpreter on a busy machine of two cores.
  timeout: 60_000,
  expect: { timeout: 15_000 },
};
const launchOptions = findLaunchOptions();

export default defineConfig({
  forbidOnly: Boolean(process.env.CI),
  fullyParallel: true,
  outputDir: "../test-results",
  reporter: process.env.CI ? [["list"], ["html", { open: "never" }]] : "list",
  use: {
    baseURL: SITE ?? `http://127.0.0.1:${PORT}${FOLDER}`,
    trace: "on-first-retry",
    // Each story is a first visit: keeping the site on the device would take as long as its runs.
    // The stories of that have a site of their own (own-site.ts), where it is kept.
    serviceWorkers: "block",
    // One page after the other in the same profile, emptied in between: 15 % less of computing than a
    // profile for each. A story that is tried again has one of its own.
    reuseContext: true,
  },
  // A story waits for frames and downloads as long as it computes: two fit on two cores.
  ...(process.env.CI ? { workers: 2 } : {}),
  // A shared machine of two cores: a story that fails twice has failed.
  retries: process.env.CI ? 1 : 0,
  ...(SITE
    ? {}
    : {
        webServer: {
          command: `node tests/static-server.mjs ${PORT} ${FOLDER}`,
          cwd: "..",
          port: PORT,
          reuseExistingServer: !process.env.CI,
        },
      }),
  projects: [
    { name: "unit", testDir: "unit" },
    {
      name: "e2e",
      ...browser,
      // What only a finger does, or is told of where room is short, is marked @phone.
      grepInvert: /@long|@phone/,
      use: { viewport: { width: 1280, height: 800 }, launchOptions },
    },
    {
      name: "long",
      ...browser,
      grep: /@long/,
      use: { viewport: { width: 1280, height: 800 }, launchOptions },
    },
    {
      name: "e2e-phone",
      ...browser,
      // What Python does and says, what is kept and what the address says is the same on every screen:
      // whole files of such stories, and those marked @once in the others.
      testIgnore:
        /(address|bad-input|containment|hostile|keep|keyboard|left-over|python|same-trace|start-up|stop|tasks|told)\.spec/,
      grepInvert: /@once|@long/,
      use: {
        viewport: { width: 390, height: 844 },
        hasTouch: true,
        isMobile: true,
        launchOptions,
      },
    },
  ],
});
