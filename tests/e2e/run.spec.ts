/** A learner opens the lab, runs a program, changes it and runs it again. */
import { expect, test } from "./fixtures.ts";
import { LOOK_ROUND } from "./programs.ts";

test("from the home page into the lab and to a finished run", async ({ app, page }) => {
  await page.goto("./");
  await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
  await page.getByRole("link", { name: "Open the lab" }).click();
  await app.run.click();
  await app.ended();
  await expect(app.status).toHaveText(/Finished at \d+\.\d s/);
});

test("a world chosen on the home page is open in the lab", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await page.goto("./");
  await page.getByRole("link", { name: /A doorway/ }).click();
  await expect(app.world).toHaveValue("doorway");
});

test("a run shows in the console, the view, the chart and the time; Ctrl+Enter runs the next", {
  tag: "@once",
}, async ({ app, page }) => {
  await app.openLab("world=empty");
  await app.showEndsAtOnce();
  await app.runToEnd(LOOK_ROUND);
  await expect(app.status).toHaveText("Finished at 2.0 s.");
  await expect(app.console).toContainText("looked round");
  await expect(app.view).toHaveAccessibleDescription(/heading 2\d\d°; 2 free/);
  await expect(app.time).toHaveAttribute("aria-valuetext", "2.0 s");
  await expect(page.getByText("beams that found something").first()).toBeVisible();

  await app.write('print("second")');
  await page.keyboard.press("ControlOrMeta+Enter");
  await expect(app.console).toContainText("second");
  await expect(app.console).not.toContainText("looked round");
});

test("run pressed before Python is up waits for it and says so", { tag: "@once" }, async ({
  app,
}) => {
  await app.openLab();
  await app.run.click();
  await expect(app.status).toHaveText(/Your program runs as soon as it is up|Running|Finished/);
  await app.ended();
  await expect(app.status).toHaveText(/Finished at/);
});

test("the lab's promise: run() resolves to the outcome", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  await app.write(LOOK_ROUND);
  const outcome = await page
    .locator("bugbot-lab")
    .evaluate((lab: HTMLElement & { run(): Promise<Record<string, unknown>> }) => lab.run());
  expect(outcome).toMatchObject({
    status: "finished",
    console: "looked round\n",
    fault: null,
    layers: {
      free: {
        shape: "squares",
        points: [
          [102.5, 102.5],
          [107.5, 102.5],
        ],
      },
    },
  });
});

test("nothing moves when Python arrives or a run ends", async ({ app, page }) => {
  await app.openLab();
  const lab = page.locator("bugbot-lab");
  await expect(app.view).toBeVisible();
  const before = await lab.boundingBox();
  await expect(app.status).toHaveText(/Ready/);
  expect(await lab.boundingBox()).toEqual(before);
  await app.run.click();
  await app.ended();
  expect(await lab.boundingBox()).toEqual(before);
});
