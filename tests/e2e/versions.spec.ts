/** What was written before can be had again. */
import type { Page } from "@playwright/test";
import { App } from "./app.ts";
import { expect, test } from "./fixtures.ts";

test.use({ device: "small" });

const entries = (page: Page) => page.getByRole("list", { name: /Versions/ }).getByRole("button");

test("a run and a reset leave versions; one comes back as one step", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  await app.showEndsAtOnce();
  await app.runToEnd('print("first")\n');
  await app.write('print("second")\n');
  await app.reset.click();
  const starter = await app.text();
  await app.more("Earlier versions…");
  await expect(entries(page)).toHaveCount(2);
  await expect(entries(page).nth(0)).toContainText("Today, ");
  await expect(entries(page).nth(0)).toContainText('line 1: print("second")');
  await entries(page).nth(1).click();
  await expect(page.getByRole("textbox", { name: "Preview" })).toContainText('print("first")');
  await page.getByRole("button", { name: "Bring this one back" }).click();
  expect(await app.text()).toBe('print("first")\n');
  await app.program.focus();
  await page.keyboard.press("ControlOrMeta+z");
  expect(await app.text()).toBe(starter);
});

test("what is replaced by a version is a version itself, also after a reload", {
  tag: "@once",
}, async ({ app, page }) => {
  await app.openLab("world=empty");
  await app.setProgram('print("first")\n');
  await app.setProgram('print("second")\n');
  await app.more("Earlier versions…");
  await page.getByRole("button", { name: "Bring this one back" }).click();
  await expect(app.status).toContainText("The earlier version is back.");
  await page.reload();
  await expect(app.status).toContainText("Your program is back.");
  await app.more("Earlier versions…");
  await expect(entries(page)).toHaveCount(1);
  await expect(entries(page)).toContainText('print("second")');
});

test("without versions the panel says when there will be some", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  await app.more("Earlier versions…");
  await expect(page.getByRole("dialog")).toContainText("this is still the page's own program");
  await page.keyboard.press("Escape");
  await expect(page.getByRole("dialog")).toBeHidden();
  await expect(page.getByRole("button", { name: "More", exact: true })).toBeFocused();

  await app.write("stop()\n");
  await app.more("Earlier versions…");
  await expect(page.getByRole("dialog")).toContainText("There are none yet. A version is kept");
  await page.keyboard.press("Escape");

  // A run has kept this one, and it is no other than what is there.
  await app.runToEnd("stop()\n");
  await app.more("Earlier versions…");
  await expect(page.getByRole("dialog")).toContainText("the program as it is now has been kept");
});

test("where storage is refused versions last as long as the page", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await page.addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
  });
  await app.openLab("world=empty");
  await app.write('print("mine")\n');
  await expect(app.status).toContainText("does not let the site keep your program");
  await app.reset.click();
  await app.more("Earlier versions…");
  await page.getByRole("button", { name: "Bring this one back" }).click();
  expect(await app.text()).toBe('print("mine")\n');
  await app.world.selectOption("doorway");
  await app.world.selectOption("empty");
  expect(await app.text()).toBe('print("mine")\n');
});

test("a page with a newer program keeps the learner's, and shows both", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  const starter = await app.text();
  await app.write(`${starter}print("mine")\n`);
  await page.reload();
  await expect(app.status).toContainText("Your program is back.");
  // As if the site had had another program when this one was begun.
  await page.evaluate(() => {
    for (const key of Object.keys(localStorage)) {
      if (key.startsWith("bugbot:starter:")) localStorage.setItem(key, 'print("as it was")\n');
    }
  });
  await page.reload();
  await expect(app.status).toContainText(
    "This page’s program has changed since you started yours.",
  );
  expect(await app.text()).toBe(`${starter}print("mine")\n`);
  await page.getByRole("button", { name: "See the new one" }).click();
  await page.getByRole("button", { name: "Take the new one" }).click();
  expect(await app.text()).toBe(starter);
  await app.more("Earlier versions…");
  await expect(entries(page)).toContainText('print("mine")');
});

test("two tabs of one lab lose nothing of each other", { tag: "@once" }, async ({
  app,
  page,
  context,
}) => {
  await app.openLab("world=empty");
  const other = new App(await context.newPage());
  await other.openLab("world=empty");
  await other.write('print("other")\n');
  await expect(app.status).toContainText("changed in another tab");
  await app.write('print("here")\n');
  await expect(other.status).toContainText("changed in another tab");
  await app.more("Earlier versions…");
  await expect(entries(page)).toContainText('print("other")');
  await other.page.getByRole("button", { name: "Show that one" }).click();
  expect(await other.text()).toBe('print("here")\n');
});
