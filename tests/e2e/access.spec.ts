/** No page breaks a rule of WCAG 2.2 AA that axe knows, in either theme, before and after a run. */
import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures.ts";
import { FAILS_ON_LINE_4, LOOK_ROUND } from "./programs.ts";

async function violations(page: Page): Promise<string[]> {
  const tags = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];
  const found = await new AxeBuilder({ page }).withTags(tags).analyze();
  return found.violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${id} at ${target.join(" ")}: ${failureSummary}`),
  );
}

for (const theme of ["Light", "Dark"]) {
  // Colours are the same on every screen.
  const tag = theme === "Dark" ? "@once" : [];

  test(`the home page, ${theme.toLowerCase()}`, { tag }, async ({ page }) => {
    await page.goto("./");
    await page.getByRole("combobox", { name: "Colours" }).selectOption(theme);
    expect(await violations(page)).toEqual([]);
  });

  test(`the lab, ${theme.toLowerCase()}`, { tag }, async ({ app, page }) => {
    await app.openLab("world=empty");
    await page.getByRole("combobox", { name: "Colours" }).selectOption(theme);
    expect(await violations(page)).toEqual([]);
    await app.runToEnd(LOOK_ROUND);
    expect(await violations(page)).toEqual([]);
    await app.runToEnd(FAILS_ON_LINE_4);
    expect(await violations(page)).toEqual([]);
  });

  test(`the lab's menu and panels, ${theme.toLowerCase()}`, { tag }, async ({ app, page }) => {
    await app.openLab("world=empty");
    await page.getByRole("combobox", { name: "Colours" }).selectOption(theme);
    await page.getByRole("button", { name: "More", exact: true }).click();
    expect(await violations(page)).toEqual([]);
    await page.getByRole("button", { name: "Share as a link…" }).click();
    await expect(page.getByRole("dialog")).toBeVisible();
    expect(await violations(page)).toEqual([]);
    await page.getByRole("button", { name: "Close" }).click();
    await app.setProgram(FAILS_ON_LINE_4);
    await app.reset.click();
    await app.more("Earlier versions…");
    await expect(page.getByRole("dialog")).toBeVisible();
    expect(await violations(page)).toEqual([]);
  });
}

test("the chosen colours are remembered", { tag: "@once" }, async ({ page }) => {
  await page.goto("./");
  await page.getByRole("combobox", { name: "Colours" }).selectOption("Dark");
  await page.goto("lab/");
  await expect(page.getByRole("combobox", { name: "Colours" })).toHaveValue("dark");
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
});
