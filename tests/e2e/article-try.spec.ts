/** A Try button: the lab comes into sight, tells what is tried, and leads back. */
import { expect, test } from "./fixtures.ts";

type Lab = HTMLElement & { program: string };

test("an experiment from the keys: seen, told, compared and undone, twice", async ({ page }) => {
  await page.goto("occupancy-grid-mapping/");
  const lab = page.locator("#lab-demo-1");
  const status = lab.getByRole("status", { name: "Status of the run" });
  const view = lab.getByRole("img", { name: "Overhead view" });
  const first = page.getByRole("button", { name: "Try L_FREE = 0" });
  const second = page.getByRole("button", { name: "Try CELL = 20" });
  const program = (): Promise<string> => lab.evaluate((element: Lab) => element.program);
  await first.scrollIntoViewIfNeeded();
  await expect(first).toBeEnabled();
  const before = await program();

  // Nothing has been run: the run to compare with is made by and by.
  await first.focus();
  await page.keyboard.press("Enter");
  await expect(status).toContainText("L_FREE = 0.0 in place of −0.4");
  await expect(view).toBeInViewport({ ratio: 0.5 });
  await expect(status).toBeFocused();
  await expect(status).toHaveText(/Finished at 13.0 s/);
  await expect(lab).toContainText("thin: the run before");

  // The next one starts from the same program, and is compared with the same run.
  await second.focus();
  await page.keyboard.press("Enter");
  await expect(status).toHaveText(/Finished.* CELL = 20 in place of 5/s);
  expect(await program()).toBe(before.replace("CELL = 5 ", "CELL = 20 "));

  // From the status one Tab leads to the way back.
  await status.focus();
  await page.keyboard.press("Tab");
  await expect(lab.getByRole("button", { name: "Undo", exact: true })).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(status).toContainText("CELL is 5 again.");
  await expect(status).toBeFocused();
  expect(await program()).toBe(before);
  await expect(view).toHaveAccessibleDescription(/free/);

  // Where the reader has taken the number out, nothing happens to their program.
  const own = before.replace(/^L_FREE.*$/m, "L_FREE = min(0, -0.4)");
  await lab.evaluate((element: Lab, text) => {
    element.program = text;
  }, own);
  await first.click();
  await expect(status).toContainText("the program has no line L_FREE = … with a number");
  expect(await program()).toBe(own);
  await lab.getByRole("button", { name: "Reset program" }).last().click();
  expect(await program()).toBe(before);
});
