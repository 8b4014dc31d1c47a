/**
 * Two projects, one runner: `unit` is plain TypeScript with no page (decode, player, camera, …),
 * `e2e` drives the built site in a browser.
 *
 *     npx playwright test -c tests/playwright.config.ts --project unit
 */
import { defineConfig } from "@playwright/test";

export default defineConfig({
  forbidOnly: Boolean(process.env.CI),
  fullyParallel: true,
  outputDir: "../test-results",
  reporter: process.env.CI ? [["list"], ["html", { open: "never" }]] : "list",
  projects: [
    { name: "unit", testDir: "unit" },
    { name: "e2e", testDir: "e2e" },
  ],
});
