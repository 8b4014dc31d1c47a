/** A Try button: what comes of it is shown beside its words, and the page stays where it is. */
import { expect, test } from "./fixtures.ts";

type Lab = HTMLElement & { program: string };

test("experiments from the keys: told beside the words, compared and undone", async ({
  page,
  isMobile,
}) => {
  await page.goto("occupancy-grid-mapping/");
  const lab = page.locator("#lab-demo-1");
  const first = page.getByRole("button", { name: "Try L_FREE = 0" });
  const second = page.getByRole("button", { name: "Try CELL = 20" });
  const result = page.getByRole("group", { name: "What came of it" });
  const told = result.getByRole("status");
  const program = (): Promise<string> => lab.evaluate((element: Lab) => element.program);
  await first.scrollIntoViewIfNeeded();
  await expect(first).toBeEnabled();
  const before = await program();
  const placed = () => first.evaluate((button) => Math.round(button.getBoundingClientRect().top));

  // Nothing has been run: the run to compare with is made by and by.
  await first.focus();
  const place = await placed();
  await page.keyboard.press("Enter");
  await expect(told).toHaveText(
    /^L_FREE = 0\.0 in place of −0\.4\. Finished at 13\.0 s.* known %: [\d.]+, before [\d.]+\..*free: 0 cells, before \d+\./s,
  );
  await expect(result.getByRole("img", { name: /^The map at the end/ })).toHaveCount(2);
  await expect(told).toBeInViewport();
  await expect(first).toBeFocused();
  // A fraction of a pixel is lost when it scrolls.
  expect(Math.abs((await placed()) - place)).toBeLessThan(3);

  // What a small screen may change has been seen.
  if (isMobile) return;
  // The next one starts from the same program, is compared with the same run, and takes its place.
  await second.focus();
  await page.keyboard.press("Enter");
  await expect(told).toHaveText(/^CELL = 20 in place of 5\./);
  expect(await program()).toBe(before.replace("CELL = 5 ", "CELL = 20 "));
  await expect(second).toBeFocused();

  // One Tab further is the lab, two are the way back, which leaves the focus on the experiment.
  await page.keyboard.press("Tab");
  await expect(result.getByRole("link", { name: "See it in the lab" })).toBeFocused();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await expect(told).toHaveText("CELL is 5 again.");
  await expect(second).toBeFocused();
  expect(await program()).toBe(before);

  // The lab tells it too, and leads back as well.
  await first.click();
  const status = lab.getByRole("status", { name: "Status of the run" });
  await expect(status).toHaveText(/Finished.* L_FREE = 0\.0 in place of −0\.4.* Thin lines/s);
  await expect(lab).toContainText("thin: the run before");
  await result.getByRole("link").click();
  await expect(lab.getByRole("img", { name: "Overhead view" })).toBeInViewport({ ratio: 0.5 });
  await lab.getByRole("button", { name: "Undo", exact: true }).click();
  await expect(status).toContainText("L_FREE is −0.4 again.");
  await expect(status).toBeFocused();
  expect(await program()).toBe(before);
  await result.getByRole("button", { name: "Undo", exact: true }).click();
  await expect(told).toContainText("The program has been changed since.");

  // Where the reader has taken the number out, nothing happens to their program.
  const own = before.replace(/^L_FREE.*$/m, "L_FREE = min(0, -0.4)");
  await lab.evaluate((element: Lab, text) => {
    element.program = text;
  }, own);
  await first.click();
  await expect(told).toContainText("the program has no line L_FREE = … with a number");
  await expect(status).toContainText("the program has no line L_FREE = … with a number");
  expect(await program()).toBe(own);
  await lab.getByRole("button", { name: "Reset program" }).last().click();
  expect(await program()).toBe(before);
});
