/**
 * One task of every lesson of the course: a wrong attempt, which earns its message and leads to a hint. In
 * every third lesson the solution as well, which passes; in the others that is part of `npm run test:long`.
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

const THIRDS = slugs.filter((_slug, index) => index % 3 === 1);

for (const { slug, tag, isSolved } of [
  ...slugs.map((slug) => ({ slug, tag: [], isSolved: THIRDS.includes(slug) })),
  ...slugs
    .filter((slug) => !THIRDS.includes(slug))
    .map((slug) => ({ slug, tag: ["@long"], isSolved: true })),
]) {
  const way = isSolved ? "from a wrong attempt to the pass" : "a wrong attempt and a hint";
  test(`a task of ${slug}: ${way}`, { tag }, async ({ page }) => {
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

    if (!isSolved) return;
    await task.marked(read(slug, name, "solution.py"));
    await expect(task.mark).toContainText("Passed.");
  });
}
