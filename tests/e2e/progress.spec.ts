/** What the device keeps of a learner's progress: as a file, on another device, cleared, refused. */
import { readFile } from "node:fs/promises";
import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures.ts";
import { Task } from "./task-page.ts";
import { CELL_OF, openTinyLesson } from "./tiny-lesson.ts";

test.use({ device: "small" });

test.slow();

test("saved as a file, cleared, brought back, and opened again", { tag: "@once" }, async ({
  page,
}) => {
  await openTinyLesson(page);
  const task = new Task(page, "The cell of a point");
  const tools = page.getByRole("group", { name: "Your progress" });
  const button = (name: string) => tools.getByRole("button", { name });
  await expect(button("Save progress as a file")).toBeDisabled();
  await task.marked(CELL_OF.solution);
  await expect(task.mark).toContainText("Passed");

  const saving = page.waitForEvent("download");
  await button("Save progress as a file").click();
  const file = await (await saving).path();
  expect(JSON.parse(await readFile(file, "utf8")).tasks["tiny/cell-of"].state).toBe("passed");

  await button("Clear progress").click();
  await expect(tools.getByRole("status")).toContainText("is gone");
  await expect(task.root).toContainText("Not tried yet");
  await expect(button("Undo")).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(tools.getByRole("status")).toContainText("Your progress is back.");
  await expect(task.root.getByText("Passed", { exact: true })).toBeVisible();

  await button("Clear progress").click();
  const open = async (name: string, content: string | Buffer): Promise<void> => {
    const choosing = page.waitForEvent("filechooser");
    await button("Open a file of progress…").click();
    const buffer = Buffer.from(content);
    await (await choosing).setFiles({ name, mimeType: "application/json", buffer });
  };
  await open("notes.json", '{"format":"something else"}');
  await expect(tools.getByRole("status")).toContainText("notes.json was not opened");
  await expect(task.root).toContainText("Not tried yet");
  await open("mine.json", await readFile(file));
  await expect(tools.getByRole("status")).toContainText("1 task further than before");
  await page.reload();
  await expect(task.mark).toContainText("You passed this task on");
});

test("what one tab passes, the other shows", { tag: "@once" }, async ({ page, context }) => {
  await openTinyLesson(page);
  const task = new Task(page, "The cell of a point");
  await expect(task.root).toContainText("Not tried yet");
  const other = await context.newPage();
  await openTinyLesson(other);
  await new Task(other, "The cell of a point").button("Show hint 1 of 3").click();
  await expect(task.root.getByText("A cell is 5 cm wide.", { exact: true })).toBeVisible();
});

test("two tabs at work in one lesson: what each has done is kept, though one hears nothing of the other", {
  tag: "@once",
}, async ({ page, context }) => {
  await openTinyLesson(page);
  const other = await context.newPage();
  // Browsers put tabs to sleep that nobody looks at.
  await other.addInitScript(() => {
    addEventListener("storage", (event) => event.stopImmediatePropagation(), { capture: true });
  });
  await openTinyLesson(other);
  const here = new Task(page, "The cell of a point");
  const there = new Task(other, "Stop in time");
  await expect(there.root).toContainText("Not tried yet");

  await here.marked(CELL_OF.solution);
  await expect(here.mark).toContainText("Passed");
  await there.button("Show hint 1 of 3").click();
  await there.write("print('there')\n");
  await here.button("Show hint 1 of 3").click();

  for (const tab of [page, other]) {
    await tab.reload();
    const [first, second] = ["The cell of a point", "Stop in time"].map((t) => new Task(tab, t));
    await expect(first?.mark ?? tab.locator("none")).toContainText("You passed this task on");
    for (const task of [first, second]) {
      await expect(task?.button("Show hint 2 of 3") ?? tab.locator("none")).toBeVisible();
    }
    expect(await first?.text()).toBe(CELL_OF.solution);
    expect(await second?.text()).toBe("print('there')\n");
  }
});

const RECORD = "bugbot:progress";
const PASSED = { state: "passed", hints: 0, solution: false, at: Date.UTC(2026, 0, 2) };

/** Opens the lesson on a device that has this record of progress. */
async function openWith(page: Page, record: string): Promise<void> {
  await page.goto("");
  await page.evaluate(
    ([name = "", text = ""]) => localStorage.setItem(name, text),
    [RECORD, record],
  );
  await openTinyLesson(page);
}

async function savedBy(page: Page, press: () => Promise<void>): Promise<string> {
  const saving = page.waitForEvent("download");
  await press();
  return readFile(await (await saving).path(), "utf8");
}

test("progress of a newer version stays as it is, is told, and can be saved", {
  tag: "@once",
}, async ({ page }) => {
  const newer = JSON.stringify({ format: "bugbot-progress", version: 2, tasks: [1] });
  await openWith(page, newer);
  const notice = page.locator(".notice", { hasText: "from a newer version of this site" });
  await expect(notice).toBeVisible();
  const task = new Task(page, "The cell of a point");
  await task.button("Show hint 1 of 3").click();
  await page.reload();
  await expect(task.button("Show hint 2 of 3")).toBeVisible();
  expect(await page.evaluate((name) => localStorage.getItem(name), RECORD)).toBe(newer);
  const save = notice.getByRole("button", { name: "Save it as a file" });
  expect(await savedBy(page, () => save.click())).toBe(newer);
});

test("a damaged record of progress is read as far as it goes, put aside and told, until the reader deletes it", {
  tag: "@once",
}, async ({ page }) => {
  const tasks = { "tiny/cell-of": PASSED, "tiny/stop-in-time": { ...PASSED, hints: "many" } };
  const damaged = JSON.stringify({ format: "bugbot-progress", version: 1, tasks });
  await openWith(page, damaged);
  const notice = page.locator(".notice", { hasText: "The progress on this device was damaged" });
  await expect(notice).toBeVisible();
  await expect(new Task(page, "The cell of a point").mark).toContainText("You passed this task on");
  await new Task(page, "Stop in time").button("Show hint 1 of 3").click();
  await page.reload();
  const save = notice.getByRole("button", { name: "Save it as a file" });
  expect(await savedBy(page, () => save.click())).toBe(damaged);
  await notice.getByRole("button", { name: "Delete it" }).click();
  await expect(notice).toBeHidden();
  await page.reload();
  await expect(new Task(page, "Stop in time").button("Show hint 2 of 3")).toBeVisible();
  await expect(notice).toBeHidden();
});

test("a damaged record can be deleted before anything has been done since", {
  tag: "@once",
}, async ({ page }) => {
  await page.goto("");
  await page.evaluate((name) => {
    localStorage.setItem(name, '{"format":"bugbot-progress","version":1,"tasks":{"a/b":');
  }, RECORD);
  await page.reload();
  const notice = page.locator(".notice", { hasText: "The progress on this device was damaged" });
  await notice.getByRole("button", { name: "Delete it" }).click();
  await expect(notice).toBeHidden();
});

test("where storage is refused a note says so, and marks work all the same", {
  tag: "@once",
}, async ({ page }) => {
  await page.addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
  });
  await openTinyLesson(page);
  const task = new Task(page, "The cell of a point");
  await task.marked(CELL_OF.solution);
  await expect(task.mark).toContainText("Passed");
  await expect(page.getByText("does not let the site keep your progress")).toBeVisible();
});
