/**
 * One task of every lesson of the course, from its starter to the pass: first a wrong attempt, which
 * earns its message and leads to a hint, then the solution.
 */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "../../site/build/files.mjs";
import { expect, test } from "./fixtures.ts";
import { Task } from "./task-page.ts";

test.slow();

const LESSONS = join(ROOT, "lessons");
const read = (...path: string[]): string => readFileSync(join(LESSONS, ...path), "utf8");
const { lessons: slugs } = JSON.parse(read("course.json")) as { lessons: string[] };

/** The lesson's first task, with the first of its wrong attempts that fails by what it does. */
function taskOf(slug: string) {
  const { tasks } = JSON.parse(read(slug, "lesson.json"));
  const { name, title, hints } = tasks[0] as { name: string; title: string; hints: string[] };
  const wrong = readdirSync(join(LESSONS, slug, name, "wrong")).sort()[0] ?? "";
  const attempt = read(slug, name, "wrong", wrong);
  const earns = attempt.split("\n")[0]?.replace("# earns:", "").trim() ?? "";
  return { name, title, hints: hints.length, attempt, earns, count: tasks.length as number };
}

for (const slug of slugs) {
  test(`a task of ${slug}`, async ({ page }) => {
    const { name, title, hints, attempt, earns, count } = taskOf(slug);
    await page.goto(`lessons/${slug}/`);
    const task = new Task(page, title);
    await task.root.scrollIntoViewIfNeeded();
    await expect(task.root).toContainText(`Task 1 of ${count}`);
    expect(await task.text()).toBe(read(slug, name, "starter.py"));

    await task.marked(attempt);
    await expect(task.mark).toContainText("Not yet");
    await expect(task.checks.filter({ hasText: earns })).toHaveCount(1);
    const hint = task.checks.getByRole("button", { name: "Next hint" });
    if (await hint.isVisible()) await hint.click();
    else await task.button(`Show hint 1 of ${hints}`).click();
    await expect(page.locator(":focus")).toContainText(`Hint 1 of ${hints}`);

    await task.marked(read(slug, name, "solution.py"));
    await expect(task.mark).toContainText("Passed.");
  });
}
