/** The live figures of the article: by mouse or finger, by keys, and in words. */
import type { Locator, Page } from "@playwright/test";
import { expect, test } from "./fixtures.ts";

/** A finger put on one place and drawn to another. */
async function swipe(page: Page, from: { x: number; y: number }, to: typeof from): Promise<void> {
  const browser = await page.context().newCDPSession(page);
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", at: (typeof from)[]) =>
    browser.send("Input.dispatchTouchEvent", { type, touchPoints: at });
  await touch("touchStart", [from]);
  for (const share of [0.3, 0.6, 1]) {
    const [x, y] = [from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)];
    await touch("touchMove", [{ x, y }]);
  }
  await touch("touchEnd", []);
}

async function drag(page: Page, from: { x: number; y: number }, to: typeof from): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await page.mouse.up();
}

/** Where a place of the figure's mat [cm] is on the screen. */
async function onScreen(picture: Locator, x: number, y: number) {
  const box = await picture.boundingBox();
  if (!box) throw new Error("the picture is not on the screen");
  return { x: box.x + (x / 200) * box.width, y: box.y + (1 - y / 120) * box.height };
}

test("a beam is dragged, moved by keys, and looked at under each rule", async ({
  page,
  hasTouch,
}) => {
  await page.goto("occupancy-grid-mapping/");
  const picture = page.getByRole("img", { name: "Beam over a grid of cells" });
  const end = page.getByRole("slider", { name: "End of the beam" });
  const says = page.locator("bugbot-beam").getByRole("status");
  await picture.scrollIntoViewIfNeeded();
  await expect(end).toHaveAttribute("aria-valuetext", /^141 cm right, 97 cm up/);
  await expect(picture).toHaveAccessibleDescription(/28 looks, 5 cm apart, name 16 cells/);

  await page.getByRole("radio", { name: /Whole-cell steps/ }).check();
  await expect(says).toContainText("14 looks, 10 cm apart, name 13 cells. The beam crosses 6 more");
  await page.getByRole("radio", { name: /Bresenham/ }).check();
  await expect(says).toContainText("The line names 13 cells, each once.");

  // A whole number of cells along a row, by keys: the robot, then the end of its beam.
  await page.getByRole("button", { name: "Along a row" }).click();
  await end.focus();
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Shift+ArrowDown");
  await expect(end).toHaveAttribute("aria-valuetext", /^164 cm right, 45 cm up/);
  await page.keyboard.press("Shift+ArrowUp");
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  const robot = page.getByRole("slider", { name: "Robot" });
  await expect(robot).toBeFocused();
  await page.keyboard.press("ArrowLeft");
  await expect(robot).toHaveAttribute("aria-valuetext", /^24 cm right, 55 cm up.* 140 cm$/);
  await expect(says).toContainText("free for 130 cm, one cell short of the hit");

  // Out of the sensor's reach, and over the edge of the mat.
  await picture.scrollIntoViewIfNeeded();
  const [from, to] = [await onScreen(picture, 164, 55), await onScreen(picture, 260, 55)];
  const scrolled = await page.evaluate(() => scrollY);
  if (hasTouch) await swipe(page, from, { ...to, x: Math.min(to.x, 385) });
  else await drag(page, from, to);
  await expect(end).toHaveAttribute("aria-valuetext", /^195 cm right, 55 cm up/);
  await expect(says).toContainText("there is no hit, and the floor counts as free for 170 cm");
  expect(await page.evaluate(() => scrollY)).toBe(scrolled);
});

test("a cell is hit and passed with the numbers of several systems", { tag: "@once" }, async ({
  page,
}) => {
  await page.goto("occupancy-grid-mapping/");
  const figure = page.locator("bugbot-evidence");
  const says = figure.getByRole("status");
  const press = (name: string): Promise<void> =>
    figure.getByRole("button", { name, exact: true }).click();
  await figure.scrollIntoViewIfNeeded();
  await expect(figure.getByRole("button", { name: "Hit", exact: true })).toBeEnabled();

  await press("Start again");
  await expect(says).toHaveText(/^No evidence yet/);
  await press("Hit");
  await press("Hit");
  await expect(says).toHaveText(
    "2 hits and 0 passes come to log odds of 1.70, a probability of 0.846: occupied. 5 passes in a row would undo it.",
  );
  await press("10 passes");
  await press("10 passes");
  await expect(says).toContainText("2 hits and 20 passes come to log odds of −6.30");
  await press("Undo");
  await press("Pass");
  await expect(says).toContainText("2 hits and 11 passes come to log odds of −2.70");
  const lines = figure.getByRole("img", { name: "on two number lines" });
  await expect(lines).toHaveAccessibleDescription(/: free\./);

  // The same evidence, with other numbers.
  await figure.getByRole("combobox", { name: "Numbers of" }).selectOption("OctoMap");
  await expect(figure).toContainText("A hit adds +0.85, a pass −0.41. The sum is kept between −2");
  await expect(says).toContainText(
    "come to log odds of −2.00, a probability of 0.119: free. That is",
  );
  await figure.getByRole("combobox", { name: "Numbers of" }).selectOption("Cartographer (2D)");
  await press("Start again");
  await press("10 hits");
  await press("10 hits");
  await expect(says).toContainText("That is as far as it goes. 55 passes in a row would undo it.");
});
