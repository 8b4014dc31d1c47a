/** Why is this cell so? Asked with a mouse, with a finger and with the arrow keys. */
import type { Locator } from "@playwright/test";
import type { App } from "./app.ts";
import { expect, test } from "./fixtures.ts";

test.use({ device: "small" });

/**
 * Looks twice from (100, 40) straight up the mat. The beams at 2.8 and 8.4 degrees to the right go
 * through the cell from (100, 60) to (105, 65); the wall they end at is 110 cm away.
 */
const TWO_LOOKS = `from bugbot import *

draw("free", [(102.5, 62.5)], colour="#9ecae1", shape="squares", size=5)
scan()
wait(1)
scan()
wait(0.5)
`;

const story = (app: App): Locator => app.page.getByText(/^Cell \([\d., ]+\) cm/).first();

/** Which cell is asked about, by the words beside the mat. */
async function cellShown(app: App): Promise<[x: number, y: number]> {
  const [x, y] = ((await story(app).textContent()) ?? "").match(/[\d.]+/g) ?? [];
  return [Number(x), Number(y)];
}

/** Goes to a cell as a person does: points somewhere, sees which cell that is, and corrects it. */
async function ask(app: App, x: number, y: number, point: (x: number, y: number) => Promise<void>) {
  await app.view.scrollIntoViewIfNeeded();
  const box = await app.view.boundingBox();
  if (!box) throw new Error("the mat is not in sight");
  let [left, top] = [box.x + box.width / 2, box.y + box.height / 2];
  for (let tries = 0; tries < 6; tries++) {
    await point(left, top);
    await expect(story(app)).toBeVisible();
    const [shownX, shownY] = await cellShown(app);
    if (shownX === x && shownY === y) return;
    left += ((x - shownX) * box.width) / 215;
    top -= ((y - shownY) * box.width) / 215;
  }
  throw new Error(`the cell (${x}, ${y}) was not to be found`);
}

test("the beams that speak for a cell, up to the shown time", async ({ app, page, isMobile }) => {
  await app.openLab("world=wall-ahead");
  await app.showEndsAtOnce();
  await app.runToEnd(TWO_LOOKS);
  await ask(app, 102.5, 62.5, async (x, y) => {
    if (isMobile) await page.touchscreen.tap(x, y);
    else await page.mouse.move(x, y);
  });
  const said = page.getByText(/Cell \(102\.5, 62\.5\) cm\s+is drawn as free; really floor/).first();
  await expect(said).toContainText(
    /So far 4 beams passed through it and none ended in it; the last, at 1\.0 s, read 1\d\d(\.\d)? cm/,
  );
  if (!isMobile) {
    // A click keeps it when the pointer leaves.
    await page.mouse.down();
    await page.mouse.up();
    await page.mouse.move(0, 0);
  }
  await app.time.press("Home");
  await app.time.press("ArrowRight");
  await expect(app.time).toHaveAttribute("aria-valuetext", "0.5 s");
  await expect(said).toContainText("So far 2 beams passed through it");

  // The arrow keys go on from there, and the cell they rest on is read out.
  const cursor = page.getByRole("application", { name: "Cell cursor" });
  await cursor.press("ArrowUp");
  await cursor.press("Shift+ArrowLeft");
  await expect(
    page.getByRole("status").filter({ hasText: /^Cell \(77\.5, 67\.5\) cm/ }),
  ).toHaveText(/No beam of this run has touched it so far/);
  await cursor.press("Escape");
  await expect(story(app)).toBeHidden();
});
