/** No page breaks a rule of WCAG 2.2 AA that axe knows, in either theme, before and after a run. */
import { expectAccess } from "./access.ts";
import { expect, test } from "./fixtures.ts";
import { FAILS_ON_LINE_4, LOOK_ROUND } from "./programs.ts";

test("the home page", async ({ page }) => {
  await page.goto("./");
  await expectAccess(page);
});

test("the lab before a run, after one, and after a fault; its menu and panels", async ({
  app,
  page,
  isMobile,
}) => {
  test.slow();
  await app.openLab("world=empty");
  await expectAccess(page);
  if (!isMobile) {
    await app.runToEnd(LOOK_ROUND);
    await expectAccess(page);
  }
  await app.runToEnd(FAILS_ON_LINE_4);
  await expectAccess(page);

  await page.getByRole("button", { name: "More", exact: true }).click();
  await expectAccess(page);
  await page.getByRole("button", { name: "Share as a link…" }).click();
  await expect(page.getByRole("dialog")).toBeVisible();
  await expectAccess(page);
  await page.getByRole("button", { name: "Close" }).click();
  // Not on a phone, which has no keys to speak of.
  const keys = page.getByRole("button", { name: "Keys", exact: true });
  if (await keys.isVisible()) {
    await keys.click();
    await expect(page.getByRole("dialog")).toBeVisible();
    await expectAccess(page);
    await page.getByRole("button", { name: "Close" }).click();
  }
  await app.reset.click();
  await app.more("Earlier versions…");
  await expect(page.getByRole("dialog")).toBeVisible();
  await expectAccess(page);
});

test("the chosen colours are remembered", { tag: "@once" }, async ({ page }) => {
  await page.goto("./");
  await page.getByRole("combobox", { name: "Colours" }).selectOption("Dark");
  await page.goto("lab/");
  await expect(page.getByRole("combobox", { name: "Colours" })).toHaveValue("dark");
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
});
