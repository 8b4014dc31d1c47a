/** npm run picture: takes the README's picture of the lab, site/lab.png, from the built site. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { build } from "../site/build/build.mjs";
import { ROOT } from "../site/build/files.mjs";

await build();
const { chromium } = await import("@playwright/test");
const { launchOptions } = await import("./browser.mjs");
const { ensureBrowser } = await import("./setup.mjs");
const { serve } = await import("./bench/server.mjs");
ensureBrowser();

const DEMO = join(ROOT, "lessons/occupancy-grid-mapping/programs/demo-4-frontiers.py");
/** The moment that is shown, in simulated seconds: most of the map is there. */
const MOMENT_S = "30";

const server = await serve();
const browser = await chromium.launch(launchOptions());
const page = await browser.newPage({ viewport: { width: 1280, height: 940 } });
await page.goto(`${server.url}/site/lab/?world=doorway`);
await page.getByRole("combobox", { name: "Speed" }).selectOption("to the end");
await page.locator("bugbot-lab").evaluate(
  async (lab, program) => {
    await Object.assign(/** @type {any} */ (lab), { program }).run();
  },
  readFileSync(DEMO, "utf8"),
);
await page.getByRole("slider", { name: "Time" }).fill(MOMENT_S);
// Without the ring round what was touched last.
await page.getByRole("slider", { name: "Time" }).blur();
await page.evaluate(() => scrollTo(0, 0));
await page.screenshot({ path: join(ROOT, "site/lab.png") });
await browser.close();
server.close();
console.log("site/lab.png");
