/** The reference page: every call, with an example that opens in the lab and runs there. */
import { expectAccess } from "./access.ts";
import { expect, test } from "./fixtures.ts";

test("from the header to a call, and its example into the lab", async ({ app, page }) => {
  await page.goto("./");
  await page.getByRole("navigation", { name: "Site" }).getByRole("link", { name: "Calls" }).click();
  await expect(page.getByRole("heading", { name: "The robot’s calls" })).toBeVisible();
  await expect(page.getByRole("article")).toHaveCount(22);
  await expectAccess(page);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(wide, "nothing is wider than the screen").toBeLessThanOrEqual(0);

  const call = page.getByRole("article", { name: "forward(speed=50, distance=None)" });
  await expect(call).toContainText("how far in cm, 0 or more");
  await call.getByRole("link", { name: "Open the example of forward in the lab" }).click();
  await page.getByRole("button", { name: "Open this program" }).click();
  expect(await app.text()).toContain("forward(50, distance=20)");
  await app.run.click();
  await app.ended();
  await expect(app.status).toContainText("Finished");
});
