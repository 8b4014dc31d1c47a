/** What is kept on the device is damaged, does not fit, or is taken away: no page is worse off for it. */
import { readdirSync, renameSync } from "node:fs";
import { join } from "node:path";
import type { Locator, Page } from "@playwright/test";
import { expect } from "./fixtures.ts";
import { test } from "./own-site.ts";

test.describe.configure({ timeout: 120_000 });

async function keepAll(page: Page): Promise<Locator> {
  await page.getByRole("button", { name: "Use offline" }).click();
  const panel = page.getByRole("dialog", { name: "Use offline" });
  await panel.getByRole("button", { name: "Keep it on this device" }).click();
  return panel;
}

const cacheNames = (page: Page): Promise<string[]> => page.evaluate(() => caches.keys());

test("a device with little storage has the site and Python all the same @once", async ({
  page,
  app,
  context,
}) => {
  for (const quotaSize of [1_000_000, 6_000_000]) {
    await app.openLab();
    const devtools = await context.newCDPSession(page);
    const { origin } = new URL(page.url());
    await devtools.send("Storage.overrideQuotaForOrigin", { origin, quotaSize });
    const panel = await keepAll(page);
    await expect(panel.getByRole("status")).toContainText("This device has no room for it.");
    await page.reload();
    await app.runToEnd('print("with little storage")');
    await expect(app.console).toContainText("with little storage");
    await page.evaluate(async () => {
      await (await navigator.serviceWorker.getRegistration())?.unregister();
      for (const name of await caches.keys()) await caches.delete(name);
    });
  }
});

test("damaged files are fetched anew, a page that does not come up offers a way out, and what is removed stays away @once", async ({
  page,
  app,
  site,
  complaints,
}) => {
  await app.openLab();
  const panel = await keepAll(page);
  await expect(panel.getByText("Ready: this site works on this device")).toBeVisible();
  await page.keyboard.press("Escape");
  await app.write("print('mine')\n");

  // A page, scripts, a style sheet, Python, the workers' frame: emptied or altered, all of them at once.
  const damaged = await page.evaluate(async () => {
    const some = [
      /\/lab\/$/,
      /main-.*\.js$/,
      /lit-.*\.js$/,
      /main-.*\.css$/,
      /interpreter-/,
      /worker-[^/]*\.js$/,
      /worker-frame-/,
    ];
    let count = 0;
    for (const name of await caches.keys()) {
      const cache = await caches.open(name);
      for (const request of await cache.keys()) {
        if (!some.some((kind) => kind.test(request.url))) continue;
        const headers = (await cache.match(request))?.headers ?? new Headers();
        await cache.put(request, new Response(count % 2 ? "" : "damaged", { headers }));
        count += 1;
      }
    }
    return count;
  });
  expect(damaged).toBe(7);
  await page.reload();
  await app.run.click();
  await expect(app.console).toContainText("mine");

  // A file of the version that is kept is lost, and the server has it no longer.
  const assets = join(site.folder, "assets");
  const lost = readdirSync(assets).find((name) => /^lit-.*\.js$/.test(name)) ?? "";
  renameSync(join(assets, lost), join(site.folder, lost));
  await page.evaluate(async (name) => {
    for (const key of await caches.keys()) {
      const cache = await caches.open(key);
      for (const request of await cache.keys()) {
        if (request.url.endsWith(name)) await cache.delete(request);
      }
    }
  }, lost);
  await page.reload();
  const note = page.getByRole("alert").filter({ hasText: "Part of this page didn’t load" });
  await expect(note).toContainText("The site may have been updated since you opened the page.");
  renameSync(join(site.folder, lost), join(assets, lost));
  await note.getByRole("button", { name: "Reload without the offline copy" }).click();
  await expect(app.program).toBeVisible();
  await expect.poll(() => app.text()).toBe("print('mine')\n");
  expect(await cacheNames(page)).toEqual([]);
  // The browser itself tells of the file that was lost.
  complaints.length = 0;

  // Removed while an update installs.
  await keepAll(page);
  await expect(panel.getByText("Ready: this site works on this device")).toBeVisible();
  site.publish({ "favicon.svg": "<svg xmlns='http://www.w3.org/2000/svg'/>" });
  await page.evaluate(async () => {
    void (await navigator.serviceWorker.getRegistration())?.update();
  });
  await panel.getByRole("button", { name: "Remove from this device" }).click();
  await expect(panel.getByRole("status")).toContainText("Removed.");
  await expect
    .poll(async () => [
      await cacheNames(page),
      await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length),
    ])
    .toEqual([[], 0]);
});
