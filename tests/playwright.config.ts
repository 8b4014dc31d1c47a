/**
 * Two projects, one runner: `unit` is plain TypeScript with no page (decode, player, camera, …),
 * `e2e` drives the built site in a browser, from a plain static host below a folder.
 *
 *     npx playwright test -c tests/playwright.config.ts --project unit
 */
import { defineConfig } from "@playwright/test";
import { BROWSER_ARGS, findBrowser } from "./browser.mjs";

const PORT = 4174;
const FOLDER = "/some/school/";
const executablePath = findBrowser();

export default defineConfig({
  forbidOnly: Boolean(process.env.CI),
  fullyParallel: true,
  outputDir: "../test-results",
  reporter: process.env.CI ? [["list"], ["html", { open: "never" }]] : "list",
  use: { baseURL: `http://127.0.0.1:${PORT}${FOLDER}`, trace: "retain-on-failure" },
  webServer: {
    command: `node tests/static-server.mjs ${PORT} ${FOLDER}`,
    cwd: "..",
    port: PORT,
    reuseExistingServer: !process.env.CI,
  },
  projects: [
    { name: "unit", testDir: "unit" },
    {
      name: "e2e",
      testDir: "e2e",
      // A run may wait for an interpreter on a busy machine of two cores.
      timeout: 60_000,
      expect: { timeout: 15_000 },
      use: {
        launchOptions: { args: BROWSER_ARGS, ...(executablePath ? { executablePath } : {}) },
      },
    },
  ],
});
