/** Two runs side by side: this one with the one before it, and with one the page shows instead. */
import { expect, test } from "./fixtures.ts";
import { LOOK_ROUND } from "./programs.ts";

test.use({ device: "small" });

/** Of the two free cells of LOOK_ROUND one is occupied here, and another one is free. */
const OTHER_MAP = `from bugbot import *

wait(1)
draw("free", [(102.5, 102.5), (112.5, 102.5)], colour="#9ecae1", shape="squares", size=5)
draw("occupied", [(107.5, 102.5)], colour="black", shape="squares", size=5)
plot("beams that found something", 0)
`;

/** What the lab's own parts hold, as a page can reach them. */
type Lab = HTMLElement & {
  showRun(trace: unknown, guest: object): void;
  querySelector(name: "overhead-view"): HTMLElement & { earlier: unknown };
};

test("the run before: a ghost on the chart, and a switch for the cells that differ", {
  tag: "@once",
}, async ({ app, page }) => {
  const differs = page.getByRole("checkbox", { name: /^unlike the run before/ });
  const picture = (): Promise<string> =>
    app.view.evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
  await app.openLab("world=empty");
  await app.showEndsAtOnce();
  await app.runToEnd(LOOK_ROUND);
  await expect(differs).toHaveCount(0);
  await app.runToEnd(OTHER_MAP);
  await expect(page.getByText("thin: the run before")).toBeVisible();
  await expect(differs).toHaveAccessibleName("unlike the run before 2");
  await expect(differs).not.toBeChecked();
  const without = await picture();
  await differs.check();
  await expect.poll(picture).not.toBe(without);
  await differs.uncheck();
  await expect.poll(picture).toBe(without);
  // At half a second neither run's maps are the same: that one has drawn, this one has not.
  await app.time.press("Home");
  await app.time.press("ArrowRight");
  await expect(app.time).toHaveAttribute("aria-valuetext", "0.5 s");
  await expect(differs).toHaveAccessibleName("unlike the run before 2");

  // A page shows another run here, the one before in place of one on a hidden world.
  await page.locator("bugbot-lab").evaluate((lab: Lab) =>
    lab.showRun(lab.querySelector("overhead-view").earlier, {
      note: "This is the run the check made.",
      outlined: [{ x: 105, y: 100, size: 5 }],
      seconds: 1.5,
    }),
  );
  await expect(app.status).toHaveText(/Finished at 2\.0 s\.\s+This is the run the check made\./);
  await expect(app.time).toHaveAttribute("aria-valuetext", "1.5 s");
  await expect(app.view).toHaveAccessibleDescription(
    /; 2 free; .*; pointed out: the cell at \(107\.5, 102\.5\) cm/,
  );
  await expect(page.getByRole("group", { name: "Shown on the mat" })).toContainText("pointed out");
  await page.getByRole("button", { name: "Back to your run" }).click();
  await expect(app.status).toHaveText("Finished at 1.0 s.");
  await expect(app.time).toHaveAttribute("aria-valuetext", "0.5 s");
  await expect(app.view).not.toHaveAccessibleDescription(/pointed out/);
  await expect(differs).toBeVisible();
});
