/** The pages of text: read without scripts, painted before anything heavy comes, and steady. */
import { gzipSync } from "node:zlib";
import type { Page, Response } from "@playwright/test";
import { expect, test } from "./fixtures.ts";

const ARTICLE = "occupancy-grid-mapping/";
const LESSON = "lessons/u8-2-inverse-sensor-model/";

/** What the article and lessons have before Python comes, at most [bytes, gzip]. */
const SCRIPT_AND_STYLE = 250_000;
/** A reader notices a page that has moved by more than this (a share of the window). */
const STEADY = 0.02;

interface Shift extends PerformanceEntry {
  value: number;
  hadRecentInput: boolean;
  sources: { node: Node | null }[];
}

type Moved = Window & { moves: { share: number; what: string }[] };

/** Has the page note what of it moves by itself, from its first moment on. */
async function watchShifts(page: Page): Promise<(most: number) => Promise<void>> {
  await page.addInitScript(() => {
    const { moves } = Object.assign(window as unknown as Moved, { moves: [] as Moved["moves"] });
    new PerformanceObserver((list) => {
      for (const { hadRecentInput, value, sources } of list.getEntries() as Shift[]) {
        const what = sources.map(({ node }) => node?.textContent?.trim().slice(0, 40)).join(", ");
        if (!hadRecentInput) moves.push({ share: value, what });
      }
    }).observe({ type: "layout-shift", buffered: true });
  });
  return async (most) => {
    const moves = await page.evaluate(() => (window as unknown as Moved).moves);
    const sum = moves.reduce((total, { share }) => total + share, 0);
    expect(sum, `what moved: ${JSON.stringify(moves)}`).toBeLessThan(most);
  };
}

test.describe("with scripts switched off", () => {
  test.use({ javaScriptEnabled: false });

  test("the article and a lesson are there whole", async ({ page }) => {
    await page.goto(ARTICLE);
    await expect(page.getByText("All of the text, the pictures and the programs")).toBeVisible();
    for (const name of ["Log odds", "Questions", "References"]) {
      await expect(page.getByRole("heading", { name, level: 2, exact: true })).toBeVisible();
    }
    // The four programs to their last lines, and not in a box that has to be scrolled.
    const programs = page.getByRole("region", { name: /^Program: / });
    await expect(programs).toHaveCount(4);
    for (const program of await programs.all()) {
      const rest = await program.evaluate((box) => box.scrollHeight - box.clientHeight);
      expect(rest).toBeLessThanOrEqual(1);
    }
    await expect(page.getByRole("img").first()).toBeVisible();
    await expect(page.locator("math").first()).toBeAttached();
    expect(await page.getByRole("button").count()).toBeGreaterThan(0);
    for (const button of await page.getByRole("button").all()) await expect(button).toBeDisabled();

    await page.goto(LESSON);
    const task = page.locator("bugbot-task").first();
    await expect(task.getByRole("heading", { level: 3 })).toBeVisible();
    await expect(task.getByRole("region", { name: /^Program to start from/ })).toBeVisible();
    await expect(task.locator(".task-hint > :not(summary)").first()).toBeHidden();
    await task.getByText("Hint 1").click();
    await expect(task.locator(".task-hint > :not(summary)").first()).toBeVisible();
  });
});

test("the article is painted before Python is asked for, is light, and stays where it is", async ({
  page,
}) => {
  const expectSteady = await watchShifts(page);
  const sizes: Promise<number>[] = [];
  const python: string[] = [];
  page.on("request", (request) => {
    if (request.url().includes("/python/")) python.push(request.url());
  });
  const weigh = (response: Response): void => {
    if (!/\.(js|css)$/.test(response.url()) || response.url().includes("/python/")) return;
    sizes.push(response.body().then((body) => gzipSync(body).length));
  };
  page.on("response", weigh);
  await page.goto(ARTICLE);
  await expect(page.getByRole("button", { name: "Run", exact: true })).toHaveCount(4);
  page.off("response", weigh);
  const bytes = (await Promise.all(sizes)).reduce((sum, size) => sum + size, 0);
  expect(bytes).toBeLessThan(SCRIPT_AND_STYLE);

  expect(python, "what was asked for before anybody read").toEqual([]);
  await expectSteady(STEADY);

  // All of it fits, and the contents follow the reader.
  const width = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(width).toBeLessThanOrEqual(0);
  const contents = page.getByRole("navigation", { name: "On this page" });
  await contents.getByRole("link", { name: "Log odds" }).click();
  await expect(page.getByRole("heading", { name: "Log odds", exact: true })).toBeInViewport();
  await expect.poll(() => python.length).toBeGreaterThan(0);
  await expect(contents.locator("[aria-current]")).toHaveText("Log odds");
  await page.getByRole("heading", { name: "Questions", exact: true }).scrollIntoViewIfNeeded();
  await page.mouse.wheel(0, 600);
  await expect(contents.locator("[aria-current]")).toHaveText("Questions");
  await expect(contents.locator("[aria-current]")).toBeInViewport();
});

test("a link to a task far down leads there, and it stays in sight while the rest comes", async ({
  page,
}) => {
  await page.goto(`${LESSON}#task-a-whole-scan`);
  const task = page.locator("#task-a-whole-scan");
  await expect(task.getByRole("button", { name: "Check my work" })).toBeVisible();
  await expect(task.getByRole("heading", { level: 3 })).toBeInViewport();
});

test("the home page shows the way through the lessons, and back to where one was", async ({
  page,
}) => {
  const expectSteady = await watchShifts(page);
  await page.goto("./");
  const course = page.getByRole("region", { name: "The way through" });
  await expect(course.getByRole("listitem").first()).toContainText("Occupancy grid mapping");
  await expect(page.getByRole("img", { name: "A map that the robot made" })).toBeVisible();
  await expect(page.getByRole("link", { name: "Read the article" })).toBeVisible();
  await expect(page.getByRole("button", { name: "Save progress as a file" })).toBeVisible();
  await expectSteady(STEADY);

  await course.getByRole("link", { name: "The inverse sensor model" }).click();
  await expect(page).toHaveURL(new RegExp(`${LESSON}$`));
  await page.getByRole("link", { name: "Next U8.3" }).click();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Log odds");
  await page.getByRole("link", { name: "bugbot lessons" }).click();
  await page.getByRole("link", { name: "Continue where you left: Log odds" }).click();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Log odds");
});
