/** A task of a lesson, from the starter to the pass, and everything that can go wrong on the way. */
import { expectAccess } from "./access.ts";
import { expect, test } from "./fixtures.ts";
import { Task } from "./task-page.ts";
import { CELL_OF, DRIVE, openTinyLesson } from "./tiny-lesson.ts";

test.slow();

test("from the starter over a failure and a hint to a pass, which is still there after a reload", {
  tag: "@once",
}, async ({ page }) => {
  await openTinyLesson(page);
  const task = new Task(page, "The cell of a point");
  const next = new Task(page, "Stop in time");
  await expect(task.root).toContainText("Not tried yet");
  await expect(task.mark).toContainText("The robot tries your program on mats and noise");
  await expect(task.root).not.toContainText("the starter", { ignoreCase: false });
  expect(await task.text()).toBe(CELL_OF.starter);

  await task.marked(CELL_OF.swapped);
  await expect(task.mark).toContainText("Not yet: 1 of 3 checks pass. Look at “A point in a cell”");
  await expect(task.root).toContainText("Tried");
  await expect(task.checks).toContainText([
    /The corner of the mat\s+passed/,
    /A point in a cell\s+not passed/,
    /Points all over the mat\s+not passed/,
  ]);
  const failure = task.checks.nth(1);
  await expect(failure.getByRole("definition")).toContainText([
    "(2, 1)",
    "(1, 2)",
    "row and column look swapped",
  ]);
  await expect(failure.getByRole("img")).toHaveAccessibleName(
    /2 cells outlined.*\(1, 2\), \(2, 1\)/,
  );

  await failure.getByRole("button", { name: "Next hint" }).click();
  await expect(task.root.getByText("A cell is 5 cm wide.", { exact: true })).toBeVisible();
  await expect(page.locator(":focus")).toContainText("Hint 1 of 3");
  await expect(task.root.getByText("The column goes by")).toBeHidden();
  await task.button("Show hint 2 of 3").click();
  await expect(task.root.getByText("The column goes by")).toBeVisible();
  await failure.getByRole("button", { name: "Go to hint 2" }).click();
  await expect(page.locator(":focus")).toContainText("Hint 2 of 3");

  await task.write(CELL_OF.solution);
  await expect(task.mark).toContainText("Your program has changed since this mark.");
  await task.program.press("ControlOrMeta+Shift+Enter");
  await expect(task.mark).toContainText("Passed. All 3 checks pass.");
  expect(await task.text()).toBe(CELL_OF.solution);

  await task.root.getByRole("link", { name: "Next task: Stop in time" }).click();
  await expect(next.root.getByRole("heading", { name: "Stop in time" }).first()).toBeInViewport();

  await page.reload();
  await expect(task.mark).toContainText("You passed this task on");
  await expect(task.root.getByText("The column goes by")).toBeVisible();
  expect(await task.text()).toBe(CELL_OF.solution);
  await expect(task.runStatus).toContainText("Your program is back.");
});

// Where room is short; the project's story (results.spec.ts) shows a run on a desktop's screen.
test("a failed run is shown on its hidden mat, and there is a way back to one's own", {
  tag: "@phone",
}, async ({ page }) => {
  await openTinyLesson(page);
  const task = new Task(page, "Stop in time");
  await task.run.click();
  await expect(task.runStatus).toContainText("Finished");
  await task.check.click();
  await expect(task.mark).toContainText("Not yet: 0 of 1 check passes.");
  const failure = task.checks.first();
  await expect(failure.getByRole("definition")).toContainText([
    "a stop 20 to 40 cm",
    "60 cm before",
  ]);
  await expect(failure.getByRole("img")).toHaveAccessibleName(
    /On “A pillar” at the end of the run/,
  );

  await failure.getByRole("button", { name: "Show this run" }).click();
  await expect(task.runStatus).toContainText("the check’s run on “A pillar”");
  const view = task.root.getByRole("img", { name: "Overhead view" });
  await expect(view).toBeInViewport();
  await expect(view).toHaveAccessibleDescription(/pointed out: the cell at \(102.5, 122.5\) cm/);
  await task.button("Back to your run").click();
  await expect(view).not.toHaveAccessibleDescription(/pointed out/);

  await task.marked(DRIVE.solution);
  await expect(task.mark).toContainText("Passed. The check passes.");
});

test("a solution is shown to who asks twice, beside one's own program, and can be taken back", {
  tag: "@once",
}, async ({ page }) => {
  await openTinyLesson(page);
  const task = new Task(page, "The cell of a point");
  const ask = task.button("Show a solution");
  await ask.click();
  await expect(page.getByRole("dialog")).toBeHidden();
  await expect(task.root).toContainText("You learn most by getting there yourself");
  await task.button("Show it all the same").click();
  const panel = page.getByRole("dialog", { name: "A solution" });
  await expect(panel.getByRole("region", { name: "The solution" })).toContainText(
    "return (column, row)",
  );
  await expect(panel.getByRole("region", { name: "Your program" })).toContainText("return (0, 0)");
  await panel.getByRole("button", { name: "Put it into the editor" }).click();
  expect(await task.text()).toBe(CELL_OF.solution);
  await expect(task.root).toContainText("The solution is in the editor.");
  await task.button("Undo").click();
  expect(await task.text()).toBe(CELL_OF.starter);
  await ask.click();
  await expect(panel).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(panel).toBeHidden();
});

test("marking can be cancelled, and a function that never returns does not stop it", {
  tag: "@once",
}, async ({ page }) => {
  await openTinyLesson(page);
  const task = new Task(page, "The cell of a point");
  await task.write(CELL_OF.endless);
  await task.check.click();
  await task.cancel.click();
  await expect(task.mark).toContainText("Checking was cancelled.");
  await expect(task.check).toBeFocused();
  await expect(task.checks).toHaveCount(0);
  await task.check.click();
  await expect(task.mark).toContainText("Not yet", { timeout: 40_000 });
  await expect(task.checks.first()).toContainText(/never|still|ended/);
});

const ATTEMPTS: readonly (readonly [what: string, program: string, got: RegExp])[] = [
  ["nothing", "", /cell_of/],
  ["another name", "def cell_off(x, y):\n    return (0, 0)\n", /cell_off/],
  ["one parameter", "def cell_of(x):\n    return (0, 0)\n", /parameter/],
  ["no return", "def cell_of(x, y):\n    (0, 0)\n", /return/],
  ["an error", "def cell_of(x, y):\n    return x // 0\n", /line 2/],
  ["a slip of the pen", "def cell_of(x, y)\n    return (0, 0)\n", /line 1/],
  ["a call of itself", "def cell_of(x, y):\n    return cell_of(x, y)\n", /itself|recursion/i],
  ["printing", 'def cell_of(x, y):\n    print("PASSED")\n', /return|print/],
  ["the grader", "import grader\ndef cell_of(x, y):\n    return (0, 0)\n", /grader/],
  ["JavaScript", "import js\ndef cell_of(x, y):\n    return (0, 0)\n", /js/],
];

for (const { which, tag, attempts } of [
  {
    which: "every other attempt",
    tag: ["@once"],
    attempts: ATTEMPTS.filter((_, at) => at % 2 === 1),
  },
  { which: "all attempts", tag: ["@long"], attempts: ATTEMPTS },
]) {
  test(`whatever is handed in gets a truthful mark and plain words: ${which}`, { tag }, async ({
    page,
  }) => {
    await openTinyLesson(page);
    const task = new Task(page, "The cell of a point");
    for (const [what, program, got] of attempts) {
      await test.step(what, async () => {
        await task.marked(program);
        await expect(task.mark).toContainText("Not yet");
        const told = (await task.root.getByRole("definition").allTextContents()).join("\n");
        expect(told).toMatch(got);
        expect(told).not.toMatch(/Traceback|site-packages|AssertionError/);
      });
    }
  });
}

test("a fault of ours is told as ours", { tag: "@once" }, async ({ page }) => {
  await openTinyLesson(page, { check: "from grader import check\n1 / 0\n" });
  const task = new Task(page, "The cell of a point");
  await task.marked(CELL_OF.solution);
  await expect(task.mark).toContainText("a fault of this site, not of your program");
  await expect(task.root).toContainText("Not tried yet");
  await task.root.getByText("What went wrong").click();
  await expect(task.root.getByText("ZeroDivisionError")).toBeVisible();
});

test("no rule of WCAG is broken, in either theme", async ({ page, isMobile }) => {
  await openTinyLesson(page);
  const task = new Task(page, "The cell of a point");
  await expect(task.check).toBeVisible();
  // On a phone the states that have more to show stand for this one and the last.
  if (!isMobile) await expectAccess(page);
  await task.marked(CELL_OF.swapped);
  await task.button("Next hint").click();
  await task.write(CELL_OF.starter);
  await task.button("Show a solution").click();
  await expectAccess(page);
  await task.button("Show it all the same").click();
  await expect(page.getByRole("dialog")).toBeVisible();
  await expectAccess(page);
  await page.keyboard.press("Escape");
  if (!isMobile) {
    await task.marked(CELL_OF.solution);
    await expectAccess(page);
  }
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(wide, "nothing is wider than the screen").toBeLessThanOrEqual(0);
});
