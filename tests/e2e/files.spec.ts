/** Programs, runs, charts and pictures go out as files, and programs and runs come in. */
import { expect, test } from "./fixtures.ts";
import { LOOK_ROUND } from "./programs.ts";

test.use({ device: "small" });

const OPEN = "Open a .py file…";

test("a program is saved and opened, as one step that can be undone", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  await app.write('print("Grüße")\n');
  const { name, content } = await app.saved("Save as a .py file");
  expect(name).toBe("program.py");
  expect(content.toString()).toBe('print("Grüße")\n');

  await app.openFile(OPEN, "lesson.py", '\ufeffprint("opened")\r\nprint(2)\r\n');
  await expect(app.status).toContainText("This is lesson.py.");
  expect(await app.text()).toBe('print("opened")\nprint(2)\n');
  await page.getByRole("button", { name: "Undo" }).click();
  expect(await app.text()).toBe('print("Grüße")\n');
});

test("a file dropped on the editor is opened", { tag: "@once" }, async ({ app, page }) => {
  await app.openLab("world=empty");
  const files = await page.evaluateHandle(() => {
    const data = new DataTransfer();
    data.items.add(new File(['print("dropped")\n'], "dropped.py"));
    return data;
  });
  await app.program.dispatchEvent("drop", { dataTransfer: files });
  await expect(app.status).toContainText("This is dropped.py.");
  expect(await app.text()).toBe('print("dropped")\n');
});

test("a file that is no program is refused in words; one of a megabyte is not", {
  tag: "@once",
}, async ({ app, page }) => {
  await app.openLab("world=empty");
  const before = await app.text();
  await app.openFile(OPEN, "photo.py", Buffer.from([0x89, 0x50, 0x4e, 0x47, 0, 1, 2, 0xff]));
  await expect(app.status).toContainText("photo.py does not hold text");
  await app.openFile(OPEN, "long.py", "x = 0\n".repeat(200_000));
  await expect(app.status).toContainText("long.py takes 1.2 MB. A program may take 1 MB at most.");
  expect(await app.text()).toBe(before);
  await app.openFile(OPEN, "large.py", "x = 0\n".repeat(170_000));
  await expect(app.status).toContainText("This is large.py.");
  expect(await app.text()).toHaveLength(6 * 170_000);
  await app.program.focus();
  await page.keyboard.press("ControlOrMeta+z");
  expect(await app.text()).toBe(before);
});

test("a run, its chart and its picture are saved; the run opens on its world", {
  tag: "@once",
}, async ({ app }) => {
  await app.openLab("world=doorway&seed=5");
  await app.showEndsAtOnce();
  await app.runToEnd(LOOK_ROUND);

  const chart = await app.saved("Save the chart as CSV");
  expect(chart.name).toBe("doorway-seed-5.csv");
  const [head, ...rows] = chart.content.toString().trim().split("\r\n");
  expect(head).toBe("time [s],beams that found something");
  expect(rows.map((row) => row.split(",")[0])).toEqual(["0.5", "1", "1.5", "2"]);

  const picture = await app.saved("Save the picture as PNG");
  expect(picture.name).toBe("doorway-seed-5.png");
  expect(picture.content.subarray(0, 4).toString("latin1")).toBe("\x89PNG");
  // Width and height stand at the start of a PNG.
  expect(picture.content.readUInt32BE(16)).toBe(1600);
  expect(picture.content.readUInt32BE(20)).toBe(1600);

  const run = await app.saved("Save the run as a file");
  expect(run.name).toBe("doorway-seed-5.trace");

  await app.openLab("world=empty");
  const own = await app.text();
  await app.openFile("Open a saved run…", run.name, run.content);
  await expect(app.status).toContainText("This is a saved run: A doorway, seed 5.");
  await expect(app.status).toContainText("Finished at 2.0 s.");
  await expect(app.world).toHaveValue("doorway");
  await expect(app.seed).toHaveValue("5");
  await expect(app.console).toContainText("looked round");
  await app.world.selectOption("empty");
  expect(await app.text()).toBe(own);
});

test("the program of a saved run can be had", { tag: "@once" }, async ({ app, page }) => {
  await app.openLab("world=empty");
  await app.showEndsAtOnce();
  await app.runToEnd(LOOK_ROUND);
  const { name, content } = await app.saved("Save the run as a file");
  await app.reset.click();
  await app.openFile("Open a saved run…", name, content);
  await page.getByRole("button", { name: "Open its program" }).click();
  expect(await app.text()).toBe(LOOK_ROUND);
});

test("a damaged run is refused, with the line that is wrong", { tag: "@once" }, async ({ app }) => {
  await app.openLab("world=empty");
  await app.showEndsAtOnce();
  await app.runToEnd('print("kept")\n');
  const { content } = await app.saved("Save the run as a file");
  const lines = content.toString().split("\n");
  const open = (text: string) => app.openFile("Open a saved run…", "broken.trace", text);
  await open(lines.with(1, '["pose", 0]').join("\n"));
  await expect(app.status).toContainText(
    "broken.trace is not a saved run, or it is damaged: line 2",
  );
  await open(lines.slice(0, -2).join("\n"));
  await expect(app.status).toContainText("the file is cut short");
  await open("print(1)\n");
  await expect(app.status).toContainText("line 1: not JSON");
  await expect(app.console).toContainText("kept");
});

test("before the first run there is no run and no chart to save", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  await page.getByRole("button", { name: "More", exact: true }).click();
  await expect(page.getByRole("button", { name: "Save the run as a file" })).toBeDisabled();
  await expect(page.getByRole("button", { name: "Save the chart as CSV" })).toBeDisabled();
  await expect(page.getByRole("button", { name: "Save the picture as PNG" })).toBeEnabled();
});

test("the More button by keyboard alone", { tag: "@once" }, async ({ app, page }) => {
  await app.openLab("world=empty");
  const more = page.getByRole("button", { name: "More", exact: true });
  await more.focus();
  await page.keyboard.press("Enter");
  await expect(more).toHaveAttribute("aria-expanded", "true");
  await page.keyboard.press("ArrowDown");
  await expect(page.getByRole("button", { name: "Earlier versions…" })).toBeFocused();
  await page.keyboard.press("End");
  await expect(page.getByRole("button", { name: "Print…" })).toBeFocused();
  await page.keyboard.press("Escape");
  await expect(more).toBeFocused();
  await expect(more).toHaveAttribute("aria-expanded", "false");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Shift+Tab");
  await expect(more).toHaveAttribute("aria-expanded", "false");
});

test("on paper the program is whole, and nothing is left to press", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=empty&seed=3");
  const last = "print('the last line')";
  await app.setProgram(`${"# a line\n".repeat(300)}${last}\n`);
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  await expect(page.getByRole("heading", { name: "An empty mat, seed 3" })).toBeVisible();
  const written = page.getByRole("code").filter({ hasText: last });
  await expect(written).toBeVisible();
  await expect(app.view).toBeVisible();
  await expect(page.getByRole("button")).toHaveCount(0);
  await page.emulateMedia({ media: "screen" });
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await expect(app.run).toBeVisible();
  await expect(written).toHaveCount(0);
});
