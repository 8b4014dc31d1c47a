/** Noise: the same or another, and one program with twenty seeds. */
import { expect, test } from "./fixtures.ts";

/** Its end depends on the noise. */
const NOISY = `from bugbot import *

plot("reading", distance())
wait(0.1)
plot("reading", distance())
`;

test("same noise is the same run, new noise is another", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=wall-ahead&seed=4");
  await app.showEndsAtOnce();
  await app.runToEnd("from bugbot import *\nprint(distance())\n");
  const first = (await app.console.getByText(/^\d+\.\d$/).textContent()) ?? "";
  await app.run.click();
  await app.ended();
  await expect(app.seed).toHaveValue("4");
  await expect(app.console).toContainText(first);
  await page.getByRole("combobox", { name: "Noise" }).selectOption("New noise");
  await app.run.click();
  await app.ended();
  await expect(app.seed).not.toHaveValue("4");
  await expect(app.console).not.toContainText(first);
  // Who names a seed wants that one again.
  await app.seed.fill("4");
  await app.seed.press("Enter");
  await expect(page.getByRole("combobox", { name: "Noise" })).toHaveValue("same");
});

test("twenty seeds: progress, a line a run, the spread and a summary", { tag: "@once" }, async ({
  app,
  page,
}) => {
  test.slow(true, "twenty interpreters one after the other, on a machine that may be busy");
  await app.openLab("world=wall-ahead&seed=5");
  await app.write(NOISY);
  await page.getByRole("button", { name: "Repeat 20 times" }).click();
  await expect(app.status).toHaveText("Repeating with other noise…");
  const progress = page.getByRole("progressbar", { name: "Repeating with other noise…" });
  await expect(progress).toHaveAttribute("max", "20");
  await expect(page.getByText(/^\d+ of 20$/)).toBeVisible();
  await expect(app.console).toContainText("20 runs end at:", { timeout: 90_000 });
  await expect(app.console).toContainText(/Seed 5 finished: reading [\d.]+/);
  await expect(app.console).toContainText(/Seed 24 finished: reading [\d.]+/);
  await expect(app.console).toContainText(/reading: median [\d.]+, from [\d.]+ to [\d.]+/);
  await expect(page.getByText("band: 20 runs, their median in the middle")).toBeVisible();
  await expect(progress).toHaveCount(0);
  // The next run is one run again.
  await app.run.click();
  await app.ended();
  await expect(page.getByText("band: 20 runs")).toHaveCount(0);
  await expect(app.console).not.toContainText("Seed");
});

test("cancel keeps the runs there are", { tag: "@once" }, async ({ app, page }) => {
  await app.openLab("world=wall-ahead");
  await app.write(NOISY);
  const repeat = page.getByRole("button", { name: "Repeat 20 times" });
  await repeat.click();
  await expect(app.console).toContainText("Seed 2 finished");
  await page.getByRole("button", { name: "Cancel" }).click();
  await expect(repeat).toBeFocused();
  await expect(app.status).toHaveText(/Finished at/);
  await expect(app.console).toContainText(/\d+ runs end at:/);
});

test("a fault ends the series and shows the run it happened in", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=wall-ahead&seed=8");
  // The first number drawn is 0.23 with seed 8, 0.46 with 9 and 0.57 with 10.
  await app.write("import random\nif random.random() > 0.5:\n    print(nothing_of_this_name)\n");
  await page.getByRole("button", { name: "Repeat 20 times" }).click();
  await expect(app.problem).toContainText("nothing_of_this_name");
  await expect(app.console).toContainText("Seed 9 finished");
  await expect(app.console).toContainText("Seed 10 ended with an error");
  await expect(app.status).toContainText("An error on line 3");
  await expect(app.status).toContainText("The run with seed 10 ended like this");
  await expect(app.seed).toHaveValue("10");
});
