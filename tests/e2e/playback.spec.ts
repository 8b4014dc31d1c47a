/** A finished run is played, stepped and scrubbed, and everything shows the same moment. */
import { expect, test } from "./fixtures.ts";
import { LOOK_ROUND } from "./programs.ts";

test.use({ device: "small" });

test.beforeEach(async ({ app }) => {
  await app.openLab("world=empty");
  await app.showEndsAtOnce();
  await app.runToEnd(LOOK_ROUND);
});

test("the slider goes to any moment, by keyboard, and step by what the program did", {
  tag: "@once",
}, async ({ app, page }) => {
  await app.time.focus();
  await page.keyboard.press("Home");
  await expect(app.time).toHaveAttribute("aria-valuetext", "0.0 s");
  await expect(app.console).not.toContainText("looked round");
  await page.keyboard.press("ArrowRight");
  await expect(app.time).toHaveAttribute("aria-valuetext", "0.5 s");
  await expect(app.view).toHaveAccessibleDescription(/2 free/);
  await page.keyboard.press("PageUp");
  await expect(app.time).toHaveAttribute("aria-valuetext", "0.7 s");
  await page.keyboard.press("End");
  await expect(app.time).toHaveAttribute("aria-valuetext", "2.0 s");
  await expect(app.console).toContainText("looked round");

  await app.stepBack.click();
  await expect(app.time).toHaveAttribute("aria-valuetext", "1.5 s");
  await app.stepBack.click();
  await expect(app.time).toHaveAttribute("aria-valuetext", "1.0 s");
  await app.step.click();
  await expect(app.time).toHaveAttribute("aria-valuetext", "1.5 s");

  // The speed is remembered.
  await app.speed.selectOption("8×");
  await page.reload();
  await expect(app.speed).toHaveValue("8");
});

test("play runs to the end and is Play again; the line being carried out is marked", async ({
  app,
  page,
}) => {
  await app.speed.selectOption("0.5×");
  await app.play.click();
  await expect(app.pause).toBeVisible();
  await expect(page.locator(".cm-playing")).toBeVisible();
  await app.speed.selectOption("16×");
  await expect(app.play).toBeVisible();
  await expect(app.time).toHaveAttribute("aria-valuetext", "2.0 s");
  await expect(page.locator(".cm-playing")).toBeHidden();
});
