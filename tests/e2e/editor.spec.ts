/** The editor helps with the robot's calls, and can be read at any size. */
import { expect, test } from "./fixtures.ts";

test("the robot's calls complete, with their own words", async ({ app, page }) => {
  await app.openLab("world=empty");
  await app.write("from bugbot import *\n\nrobot = connect()\n");
  await page.keyboard.press("ControlOrMeta+End");
  await page.keyboard.type("robot.odo");
  await expect(page.getByRole("option", { name: /odometry/ })).toBeVisible();
  await expect(page.locator(".cm-completionInfo")).toContainText("odometry()");
  await page.keyboard.press("Enter");
  expect(await app.text()).toBe("from bugbot import *\n\nrobot = connect()\nrobot.odometry");
});

test("pointing at a call tells what it does", async ({ app, page, isMobile }) => {
  test.skip(isMobile, "there is no pointing with a finger");
  await app.openLab("world=empty");
  await app.write("from bugbot import *\nwait(1)\n");
  await page.getByText("wait", { exact: true }).hover();
  await expect(page.getByText("wait(seconds)")).toBeVisible();
});

test("the program's text can be made larger, and stays so", async ({ app, page }) => {
  const size = (): Promise<number> =>
    app.program.evaluate((element) => Number.parseFloat(getComputedStyle(element).fontSize));
  await app.openLab("world=empty");
  const before = await size();
  await page.getByRole("button", { name: "Larger text" }).click();
  const after = await size();
  expect(after).toBeGreaterThan(before);
  await page.reload();
  await expect(app.program).toBeVisible();
  expect(await size()).toBe(after);
});
