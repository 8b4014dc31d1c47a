/** A program fails: the learner sees what, where and why, and mends it. */
import { expect, test } from "./fixtures.ts";
import { FAILS_ON_LINE_4 } from "./programs.ts";

test("an error names its line, goes there, and shows Python's own words on demand", async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  await app.runToEnd(FAILS_ON_LINE_4);
  await expect(app.status).toHaveText("An error on line 4 ended the program.");
  await expect(app.problem).toContainText("nothing_of_this_name");
  await expect(app.time).toHaveAttribute("aria-valuetext", "1.0 s");

  await expect(app.problem.getByText(/Traceback/)).toBeHidden();
  await app.problem
    .getByText(/NameError/)
    .first()
    .click();
  await expect(app.problem.getByText(/Traceback/)).toBeVisible();

  await page.getByRole("button", { name: "Go to line 4" }).click();
  await expect(app.program).toBeFocused();
  await page.keyboard.press("Shift+End");
  await page.keyboard.insertText("pass");
  expect(await app.text()).toBe(FAILS_ON_LINE_4.replace("print(nothing_of_this_name)", "pass"));

  await app.run.click();
  await app.ended();
  await expect(app.problem).toBeHidden();

  // What is not yet Python is marked while it is written.
  await app.write("for i in range(3)\n    print(i)\n\n\n\n");
  const mark = page.locator(".cm-lintRange-error, .cm-lintPoint-error").first();
  await expect(mark).toBeVisible();
  await app.write("for i in range(3):\n    print(i)\n\n\n\n");
  await expect(mark).toBeHidden();
});
