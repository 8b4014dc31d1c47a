/** Python is on its way, or does not come: the page says so, and can be used meanwhile. */
import { expect, test } from "./fixtures.ts";

test("while Python loads there is a progress bar with bytes, and the program can be edited", async ({
  app,
  page,
}) => {
  let letThrough = (): void => {};
  const held = new Promise<void>((resolve) => {
    letThrough = resolve;
  });
  await page.route("**/python/**", async (route) => {
    await held;
    await route.continue();
  });
  await app.openLab("world=empty");
  await expect(app.status).toHaveText(/Python is starting/);
  await expect(page.getByRole("progressbar", { name: "Python is starting" })).toBeVisible();
  await expect(page.getByText(/^\d+\.\d of \d+\.\d MB$/)).toBeVisible();
  await app.write('print("patience")');
  await app.run.click();
  await expect(app.status).toHaveText(/Your program runs as soon as it is up/);
  letThrough();
  await expect(app.console).toContainText("patience");
});

test("if Python cannot be had the page says why, and tries again when asked", async ({
  app,
  page,
  complaints,
}) => {
  await page.route("**/python/**", (route) => route.abort());
  await app.openLab("world=empty");
  await expect(app.status).toHaveText(/Python could not start: .+/);
  await app.write('print("kept")');
  await page.unroute("**/python/**");
  await page.getByRole("button", { name: "Try again" }).click();
  await expect(app.status).toHaveText(/Ready/);
  expect(await app.text()).toBe('print("kept")');
  await app.run.click();
  await expect(app.console).toContainText("kept");
  // The browser itself reports what this story made fail.
  complaints.length = 0;
});
