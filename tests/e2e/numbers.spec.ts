/** Numbers that move: by slider, by dragging, by keys; the end of the run follows them. */
import type { Locator } from "@playwright/test";
import type { App } from "./app.ts";
import { expect, test } from "./fixtures.ts";

/** Draws as many squares as SIZE says, so that the end of a run shows which value it had. */
const SQUARES = `from bugbot import *

SIZE = 3  # squares (1 to 20)
FAR = 0.85  # not used here (0 to 2)

wait(1)
draw("square", [(10 * i, 100) for i in range(SIZE)], colour="black", shape="squares", size=5)
plot("squares", SIZE)
print("drew", SIZE)
turn(90)
`;

const sizeSlider = (app: App): Locator => app.page.getByRole("slider", { name: "SIZE" });

/** The end of a run with this SIZE is on show, everywhere. */
async function expectEndWith(app: App, size: number): Promise<void> {
  await expect(app.view).toHaveAccessibleDescription(new RegExp(`heading 90°; ${size} square`));
  await expect(app.console).toContainText(new RegExp(`drew ${size}\\b`));
  expect(await app.text()).toContain(`SIZE = ${size}  # squares`);
}

async function open(app: App): Promise<void> {
  await app.openLab("world=empty");
  await app.showEndsAtOnce();
  await app.runToEnd(SQUARES);
  await expectEndWith(app, 3);
}

test("a slider is dragged: the number, the map and the chart follow; undo is one step", {
  tag: "@once",
}, async ({ app, page }) => {
  await open(app);
  const box = await sizeSlider(app).boundingBox();
  if (!box) throw new Error("the slider is not in sight");
  const middle = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width * 0.2, middle);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.5, middle, { steps: 5 });
  await page.mouse.move(box.x + box.width, middle, { steps: 5 });
  // Before it is let go.
  await expectEndWith(app, 20);
  await expect(page.getByText("thin: the run before")).toBeVisible();
  await page.mouse.up();
  await expectEndWith(app, 20);
  await page.keyboard.press("ControlOrMeta+z");
  expect(await app.text()).toBe(SQUARES);
  await page.keyboard.press("ControlOrMeta+Shift+Z");
  expect(await app.text()).toContain("SIZE = 20  #");
  // There and back again is no step: undo takes back what was before it.
  await page.mouse.move(box.x + box.width - 3, middle);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.4, middle, { steps: 3 });
  await expect(sizeSlider(app)).not.toHaveValue("20");
  await page.mouse.move(box.x + box.width + 40, middle, { steps: 3 });
  await page.mouse.up();
  expect(await app.text()).toContain("SIZE = 20  #");
  await page.keyboard.press("ControlOrMeta+z");
  expect(await app.text()).toBe(SQUARES);
});

test("a tap on a slider moves it; it is tall enough for a finger", { tag: "@phone" }, async ({
  app,
  page,
}) => {
  await open(app);
  await sizeSlider(app).scrollIntoViewIfNeeded();
  const box = await sizeSlider(app).boundingBox();
  if (!box) throw new Error("the slider is not in sight");
  expect(box.height).toBeGreaterThanOrEqual(44);
  await page.touchscreen.tap(box.x + box.width - 3, box.y + box.height / 2);
  await expectEndWith(app, 20);
});

test("a slider moves by keys, by typing and by the page; each is a step for undo", {
  tag: "@once",
}, async ({ app, page }) => {
  await open(app);
  const slider = sizeSlider(app);
  await slider.focus();
  await expect(slider).toHaveAttribute("aria-valuetext", "3");
  await page.keyboard.press("ArrowRight");
  await expectEndWith(app, 4);
  await page.keyboard.press("PageUp");
  await expect(slider).toHaveAttribute("aria-valuetext", "14");
  await page.keyboard.press("Home");
  await expectEndWith(app, 1);
  await page.keyboard.press("ControlOrMeta+z");
  expect(await app.text()).toContain("SIZE = 14  #");
  await expect(slider).toHaveValue("14");
  const far = page.getByRole("slider", { name: "FAR" });
  await far.press("ArrowUp");
  expect(await app.text()).toContain("FAR = 0.86  #");
  await far.press("Escape");
  await expect(app.program).toBeFocused();

  // Typing a number moves its slider; without a range there is none.
  await app.write("SIZE = 7  # squares (1 to 20)\n");
  await expect(slider).toHaveValue("7");
  await app.write("SIZE = 7  # squares\n");
  await expect(slider).toHaveCount(0);

  // A page can set constants, as one step, all or none.
  await app.write(SQUARES);
  const set = (values: Record<string, number>): Promise<void> =>
    page
      .locator("bugbot-lab")
      .evaluate(
        (
          lab: HTMLElement & { setConstants(values: Record<string, number>): void },
          to: Record<string, number>,
        ) => lab.setConstants(to),
        values,
      );
  await set({ FAR: 1.5, SIZE: 10 });
  expect(await app.text()).toContain("SIZE = 10  # squares (1 to 20)\nFAR = 1.50  #");
  await app.program.press("ControlOrMeta+z");
  expect(await app.text()).toBe(SQUARES);
  await expect(set({ SIZE: 4, NEAR: 1 })).rejects.toThrow(/no line "NEAR = …" with a number/);
  expect(await app.text()).toBe(SQUARES);
});

test("with Alt the arrows change the number at the caret, or move lines, and any number can be dragged", {
  tag: "@once",
}, async ({ app, page }) => {
  await open(app);
  await app.write("from bugbot import *\nwait(1)\nturn(90)\n");
  await page.keyboard.press("ControlOrMeta+Home");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Alt+ArrowDown");
  expect(await app.text()).toBe("from bugbot import *\nturn(90)\nwait(1)\n");
  await page.keyboard.press("End");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Alt+ArrowUp");
  expect(await app.text()).toBe("from bugbot import *\nturn(90)\nwait(2)\n");
  await expect(app.view).toHaveAccessibleDescription(/heading 90°/);
  await expect(app.time).toHaveAttribute("aria-valuetext", /^[3-5]\.\d s$/);

  await app.write('print("at", 10)\n');
  const box = await page.getByText("10", { exact: true }).boundingBox();
  if (!box) throw new Error("the number is not in sight");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.keyboard.down("Alt");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y, { steps: 4 });
  await expect(app.console).toContainText("at 20");
  await page.mouse.up();
  await page.keyboard.up("Alt");
  await page.keyboard.press("ControlOrMeta+z");
  expect(await app.text()).toBe('print("at", 10)\n');
});
