/** The editor helps with the robot's calls, and can be read at any size. */
import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures.ts";

test.use({ device: "small" });

/** From now on, what a screen reader is told by the editor: a line each. It is soon cleared there. */
async function heard(page: Page): Promise<() => Promise<string>> {
  const lines = await page.locator("bugbot-lab").evaluateHandle((lab) => {
    const said: string[] = [];
    const listen = (): unknown =>
      said.push(lab.querySelector("[aria-live=polite].cm-announced")?.textContent ?? "");
    new MutationObserver(listen).observe(lab.querySelector(".cm-announced") as Element, {
      childList: true,
    });
    return said;
  });
  return () => lines.evaluate((said) => said.join("\n"));
}

test("the robot's calls complete, with their own words", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  await app.write("from bugbot import *\n\nrobot = connect()\n");
  await page.keyboard.press("ControlOrMeta+End");
  await page.keyboard.type("robot.odo");
  await expect(page.getByRole("option", { name: /odometry/ })).toBeVisible();
  await page.keyboard.press("ArrowDown");
  await expect(page.locator(".cm-completionInfo")).toContainText("odometry()");
  await page.getByRole("option", { name: /odometry/ }).click();
  expect(await app.text()).toBe("from bugbot import *\n\nrobot = connect()\nrobot.odometry");
});

test("while a call's arguments are written, its parameters are told, until Esc", async ({
  app,
  page,
  isMobile,
}) => {
  const help = page.getByRole("tooltip");
  await app.openLab("world=empty");
  const said = await heard(page);
  await app.write("from bugbot import *\n");
  await page.keyboard.press("ControlOrMeta+End");
  await page.keyboard.type("drive(5");
  await expect(help).toContainText("drive(forward, right, turn)");
  await expect(help.getByText("forward", { exact: true })).toHaveRole("strong");
  await expect
    .poll(said)
    .toMatch(/drive\(forward, right, turn\); forward: speed ahead in per cent/);
  await page.keyboard.type("0, ");
  await expect(help.getByText("right", { exact: true })).toHaveRole("strong");
  await expect.poll(said).toMatch(/\nright: speed to the right in per cent/);
  await expect(help.getByText("speed to the right")).toBeVisible({ visible: !isMobile });
  // Esc puts it away and leaves the way out open; the key brings it back.
  await page.keyboard.press("Escape");
  await expect(help).toBeHidden();
  await page.keyboard.type("3");
  await expect(help).toBeHidden();
  await page.keyboard.press("ControlOrMeta+Shift+Space");
  await expect(help).toBeVisible();
  await page.keyboard.press("End");
  await expect(help).toBeHidden();
  expect(await app.text()).toBe("from bugbot import *\ndrive(50, 3)");
});

// There is no pointing with a finger.
test("pointing at a call tells what it does", { tag: "@once" }, async ({ app, page }) => {
  await app.openLab("world=empty");
  await app.write("from bugbot import *\nwait(1)\n");
  await page.getByText("wait", { exact: true }).hover();
  await expect(page.getByText("wait(seconds)")).toBeVisible();
});

test("the program's text can be made larger, and stays so", { tag: "@once" }, async ({
  app,
  page,
}) => {
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

test("what is selected is marked wherever it stands, and can be searched for", {
  tag: "@once",
}, async ({ app, page }) => {
  await app.openLab("world=empty");
  await app.write("side = 5\nprint(side)\n");
  await page.keyboard.press("ControlOrMeta+f");
  const find = page.getByRole("textbox", { name: "Find" });
  await find.pressSequentially("side");
  await expect(page.locator(".cm-searchMatch")).toHaveCount(2);
  await find.press("Escape");
  await page.keyboard.press("ControlOrMeta+Home");
  await page.keyboard.press("ControlOrMeta+Shift+ArrowRight");
  await expect(page.locator(".cm-selectionMatch")).toHaveCount(1);
});
