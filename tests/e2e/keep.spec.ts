/** Nothing a learner writes is lost. */
import { expect, test } from "./fixtures.ts";

test.use({ device: "small" });

const MINE = 'print("mine")\n';

test("a reset can be undone, each world keeps its own program, and a reload brings it back", async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  const starter = await app.text();
  await app.write(MINE);
  await app.reset.click();
  expect(await app.text()).toBe(starter);
  await page.getByRole("button", { name: "Undo" }).click();
  expect(await app.text()).toBe(MINE);
  await app.reset.click();
  await app.program.focus();
  await page.keyboard.press("ControlOrMeta+z");
  expect(await app.text()).toBe(MINE);

  // One can be brought along to another world.
  await app.world.selectOption("doorway");
  expect(await app.text()).not.toBe(MINE);
  await page.getByRole("button", { name: "Use the one from An empty mat here" }).click();
  expect(await app.text()).toBe(MINE);
  await app.program.focus();
  await page.keyboard.press("ControlOrMeta+z");
  await app.world.selectOption("empty");
  expect(await app.text()).toBe(MINE);

  await page.reload();
  await expect(app.program).toBeVisible();
  expect(await app.text()).toBe(MINE);
  await expect(app.status).toContainText("Your program is back.");
});

test("where storage is refused a note says so, and everything else works", async ({
  app,
  page,
}) => {
  await page.addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
  });
  await app.openLab("world=empty");
  await app.write(MINE);
  await expect(app.status).toContainText("does not let the site keep your program");
  await app.run.click();
  await expect(app.console).toContainText("mine");
});
