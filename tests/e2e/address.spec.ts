/** World and seed are in the address, and an address with mistakes in it still opens the lab. */
import { expect, test } from "./fixtures.ts";

test.use({ device: "small" });

test("the address chooses world and seed, and follows the choice", async ({ app, page }) => {
  await app.openLab("world=wall-ahead&seed=7");
  await expect(app.world).toHaveValue("wall-ahead");
  await expect(app.seed).toHaveValue("7");
  await app.world.selectOption("doorway");
  await app.seed.fill("12");
  await app.seed.press("Enter");
  await expect(page).toHaveURL(/\?world=doorway&seed=12$/);
  await page.getByRole("combobox", { name: "Noise" }).selectOption("New noise");
  await app.run.click();
  await expect(app.seed).not.toHaveValue("12");
});

test("an unknown world is named, with those there are", async ({ app, page }) => {
  await app.openLab("world=narnia&seed=3");
  const notice = page.getByRole("alert");
  await expect(notice).toContainText("no world called “narnia”");
  await notice.getByRole("link", { name: "A doorway" }).click();
  await expect(app.world).toHaveValue("doorway");
  await expect(app.seed).toHaveValue("3");
});

test("a bad seed in the address is refused in words", async ({ app, page }) => {
  await app.openLab("world=empty&seed=abc");
  await expect(page.getByRole("alert")).toContainText("“abc” is not a whole number from 0 to");
  await expect(app.seed).toHaveValue("1");
});

test("a seed that is none is put back, with the reason", async ({ app }) => {
  await app.openLab("world=empty&seed=5");
  await app.seed.fill("many");
  await app.seed.press("Enter");
  await expect(app.seed).toHaveValue("5");
  await expect(app.status).toContainText("“many” is not a whole number");
});
