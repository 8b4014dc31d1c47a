/** What the device keeps of a learner's progress: as a file, on another device, cleared, refused. */
import { readFile } from "node:fs/promises";
import { expect, test } from "./fixtures.ts";
import { Task } from "./task-page.ts";
import { CELL_OF, openTinyLesson } from "./tiny-lesson.ts";

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
