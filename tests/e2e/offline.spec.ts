/** Use without a network: what one visit leaves on the device, and how a new version takes over. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Locator, Page } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";
import { App } from "./app.ts";
import { expect } from "./fixtures.ts";
import { test } from "./own-site.ts";
import { Task } from "./task-page.ts";

const WITH_NUMPY = `import numpy
print("sum", numpy.arange(5).sum())
`;
const SOLUTION = join(ROOT, "lessons/u8-1-a-map-of-cells/cell-of-a-point/solution.py");

// All of the site is fetched and checked, while Python runs: on a busy machine that takes a while.
test.describe.configure({ timeout: 120_000 });

async function openPanel(page: Page): Promise<Locator> {
  await page.getByRole("button", { name: "Use offline" }).click();
  return page.getByRole("dialog", { name: "Use offline" });
}

test("after one visit everything works with the network cut, until it is removed @once", async ({
  page,
  app,
  site,
}) => {
  await app.openLab();
  // Before anything is kept: what a program has used belongs to the visit as well.
  await app.runToEnd(WITH_NUMPY);
  await expect(app.console).toContainText("sum 10");
  const panel = await openPanel(page);
  // By itself, a while after Python is up.
  await expect(panel.getByText("Ready: this site works on this device")).toBeVisible({
    timeout: 40_000,
  });
  await expect(panel).toContainText("NumPy is here as well.");
  await expect(panel).toContainText(/On this device: [12]\d\.\d MB/);
  await page.keyboard.press("Escape");

  await site.cut();
  await page.reload();
  await expect.poll(() => app.text()).toBe(WITH_NUMPY);
  await app.run.click();
  await expect(app.console).toContainText("sum 10");

  await page.getByRole("link", { name: "bugbot lessons" }).click();
  await page.getByRole("link", { name: "A map of cells" }).first().click();
  const task = new Task(page, "Cell of a point");
  await task.check.scrollIntoViewIfNeeded();
  await task.marked(readFileSync(SOLUTION, "utf8"));
  await expect(task.mark).toContainText("passed", { ignoreCase: true });

  const again = await openPanel(page);
  await again.getByRole("button", { name: "Remove from this device" }).click();
  await expect(again.getByRole("status")).toContainText("Removed.");
  await expect(again).toContainText("Not kept yet.");
  expect(await page.evaluate(() => caches.keys())).toEqual([]);
});

test("a new version waits until it is wanted, and no page loses what it has @once", async ({
  page,
  app,
  site,
  context,
}) => {
  await app.openLab();
  const panel = await openPanel(page);
  await panel.getByRole("button", { name: "Keep it on this device" }).click();
  await expect(panel.getByText("Ready: this site works on this device")).toBeVisible();
  await expect(panel).toContainText("NumPy (2.9 MB) comes along when a program first imports it");
  await page.keyboard.press("Escape");
  // The focus goes back to the button with it, and not into what is being written.
  await expect(panel).toBeHidden();
  await app.write("print('mine')\n");

  const lab = readFileSync(join(site.folder, "lab/index.html"), "utf8");
  site.publish({
    "lab/index.html": lab.replace(/<title>.*<\/title>/, "<title>The new lab</title>"),
  });
  const second = await context.newPage();
  await second.goto("lab/?world=empty");
  const offer = second.getByRole("status").filter({ hasText: "A new version" });
  await expect(offer).toBeVisible();
  // Until then the old one is given out, in every tab.
  await expect(second).toHaveTitle(/^Lab: /);
  await second.getByRole("button", { name: "Later" }).click();
  await second.reload();
  await expect(new App(second).program).toBeVisible();
  await expect(offer).toHaveCount(0);

  await page.getByRole("button", { name: "Use it now" }).click();
  await expect(page).toHaveTitle("The new lab");
  await expect(app.program).toBeVisible();
  expect(await app.text()).toBe("print('mine')\n");

  // The other tab is what it was, and what it has not used so far is still to be had.
  await expect(second).toHaveTitle(/^Lab: /);
  await second.getByRole("button", { name: "Keys", exact: true }).click();
  await expect(second.getByRole("dialog")).toBeVisible();
  const names = (): Promise<string[]> => page.evaluate(() => caches.keys());
  expect((await names()).length).toBe(3);

  // With its last page the old version goes.
  await second.close();
  await openPanel(page);
  await expect.poll(async () => (await names()).length).toBe(2);
});
