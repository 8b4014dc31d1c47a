/** Everything by keyboard alone: from opening the lab to reading why a cell is what it is. */
import { expect, test } from "./fixtures.ts";
import { LOOK_ROUND } from "./programs.ts";

test("write, run, leave the editor, replay and look at a cell, without a mouse", async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  const { keyboard } = page;

  await keyboard.press("Tab");
  await expect(page.getByRole("link", { name: "Skip to the lab" })).toBeFocused();
  await keyboard.press("Enter");
  await tabTo("textbox", "Program");

  await keyboard.press("ControlOrMeta+a");
  await keyboard.insertText(LOOK_ROUND);
  await keyboard.press("ControlOrMeta+Enter");
  await app.ended();
  await expect(app.status).toHaveText("Finished at 2.0 s.");
  await expect(app.program).toBeFocused();

  // Tab indents; Esc and then Tab leaves.
  await keyboard.press("ControlOrMeta+Home");
  await keyboard.press("Tab");
  expect(await app.text()).toBe(`    ${LOOK_ROUND}`);
  await keyboard.press("Shift+Tab");
  expect(await app.text()).toBe(LOOK_ROUND);
  await keyboard.press("Escape");
  await keyboard.press("Tab");
  await expect(app.program).not.toBeFocused();

  await tabTo("application", "Cell cursor");
  await keyboard.press("Space");
  await expect(app.pause).toBeVisible();
  await keyboard.press("Space");
  await expect(app.play).toBeVisible();
  await keyboard.press("ArrowUp");
  await expect(page.getByText(/^Cell \(\d/).first()).toBeVisible();

  await tabTo("slider", "Time");
  await keyboard.press("Home");
  await expect(app.time).toHaveAttribute("aria-valuetext", "0.0 s");
  await keyboard.press("ArrowRight");
  await expect(app.time).toHaveAttribute("aria-valuetext", "0.5 s");

  async function tabTo(role: "textbox" | "slider" | "application", name: string): Promise<void> {
    const goal = page.getByRole(role, { name });
    for (let presses = 0; presses < 30; presses++) {
      if (await goal.evaluate((element) => element === document.activeElement)) return;
      await keyboard.press("Tab");
    }
    throw new Error(`30 times Tab did not lead to the ${role} "${name}"`);
  }
});
