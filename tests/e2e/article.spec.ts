/** The article keeps its word: its figures come out of its programs, in the reader's own browser. */
import { gzipSync } from "node:zlib";
import type { Locator, Page } from "@playwright/test";
import type { Outcome } from "../../site/src/trace/events.ts";
import { readTraceFile } from "../../site/src/trace/file.ts";
import { outcomeOf } from "../../site/src/trace/outcome.ts";
import { expectAccess } from "./access.ts";
import { figuresOf, isRounded, Runs } from "./article-claims.ts";
import { expect, test } from "./fixtures.ts";

const ARTICLE = "occupancy-grid-mapping/";

/** Each experiment that the article has to have. */
const EXPERIMENTS = {
  "demo-1": [{ L_FREE: 0 }, { CELL: 20 }],
  "demo-2": [{ L_MAX: 100 }, { L_FREE: -0.85 }],
  "demo-3": [{ DRIFT: 1 }, { DRIFT: 0.2 }],
  "demo-4": [{ MIN_REGION: 1 }, { OCC_P: 0.95 }],
};

type Lab = HTMLElement & {
  program: string;
  run(): Promise<Outcome>;
  traceText(): Promise<string | null>;
};

/** The lab of a program, with its ends shown at once. */
async function labOf(page: Page, name: string): Promise<Locator> {
  const lab = page.locator(`#lab-${name}`);
  await lab.scrollIntoViewIfNeeded();
  await lab.getByRole("combobox", { name: "Speed" }).selectOption("to the end");
  return lab;
}

const programOf = (lab: Locator): Promise<string> =>
  lab.evaluate((element: Lab) => element.program);

/** What the run on show has come to. */
async function shownOutcome(lab: Locator): Promise<Outcome> {
  const text = await lab.evaluate((element: Lab) => element.traceText());
  return outcomeOf(readTraceFile(text ?? ""));
}

const statusOf = (lab: Locator): Locator => lab.getByRole("status", { name: "Status of the run" });

/** The program as it stands in the article gives the figures of the prose. */
async function firstRun(page: Page, lab: Locator, name: string, runs: Runs): Promise<Outcome> {
  await lab.getByRole("button", { name: "Run", exact: true }).click();
  // The first run waits for Python as well.
  await expect(statusOf(lab)).toHaveText(/Finished at/, { timeout: 45_000 });
  const outcome = await shownOutcome(lab);
  runs.add(name, {}, outcome);
  const shown = await figuresOf(page);
  expect(runs.measured(shown).length).toBeGreaterThan(2);
  expectMeasured(runs, shown);
  return outcome;
}

function expectMeasured(runs: Runs, shown: Awaited<ReturnType<typeof figuresOf>>): void {
  for (const { of, value, text, measured } of runs.measured(shown)) {
    expect(measured, of).toBeCloseTo(value, 9);
    expect(isRounded(text, measured), `${of}: ${text} is ${measured}`).toBe(true);
  }
}

/** What the buttons of a program's experiments set. */
const settingsOf = (page: Page, name: string): Promise<Record<string, number>[]> =>
  page
    .locator(`button.try[data-program=${name}]`)
    .evaluateAll((all) =>
      all.map((button) => JSON.parse((button as HTMLElement).dataset.constants ?? "")),
    );

const [FIRST = "", ...OTHERS] = Object.keys(EXPERIMENTS);

test(`${OTHERS.join(", ")} give the figures of the prose`, { tag: "@once" }, async ({ page }) => {
  test.slow();
  await page.goto(ARTICLE);
  for (const name of OTHERS) {
    await firstRun(page, await labOf(page, name), name, new Runs());
    expect(await settingsOf(page, name)).toEqual(expect.arrayContaining(experimentsOf(name)));
  }
});

function experimentsOf(name: string): unknown[] {
  return Object.entries(EXPERIMENTS).find(([each]) => each === name)?.[1] ?? [];
}

// The experiments of the first program here, and all of them in `npm run test:long`.
for (const [name, wanted] of Object.entries(EXPERIMENTS)) {
  test(`${name} gives the figures of the prose, and so does each experiment, which is undone`, {
    tag: name === FIRST ? "@once" : "@long",
  }, async ({ page }) => {
    // A run for each experiment, on a machine that may be busy.
    test.slow();
    await page.goto(ARTICLE);
    const lab = await labOf(page, name);
    const status = statusOf(lab);
    const stop = lab.getByRole("button", { name: "Stop", exact: true });
    const undo = lab.getByRole("button", { name: "Undo", exact: true });
    const runs = new Runs();
    const program = await programOf(lab);
    const outcome = await firstRun(page, lab, name, runs);

    const buttons = page.locator(`button.try[data-program=${name}]`);
    const settings = await settingsOf(page, name);
    expect(settings).toEqual(expect.arrayContaining(wanted));
    for (const [index, constants] of settings.entries()) {
      await buttons.nth(index).click();
      await expect(undo).toBeVisible();
      await expect(stop).toBeDisabled({ timeout: 45_000 });
      await expect(status).toHaveText(/Finished at .* in place of /s);
      await expect(lab).toContainText("thin: the run before");
      for (const [constant, value] of Object.entries(constants)) {
        const line = new RegExp(`^${constant} = (\\S+)`, "m").exec(await programOf(lab));
        expect(Number(line?.[1])).toBe(value);
      }
      const tried = await shownOutcome(lab);
      expect(tried.series, `${name} with ${JSON.stringify(constants)}`).not.toEqual(outcome.series);
      runs.add(name, constants, tried);

      await undo.click();
      await expect(status).toHaveText(/ again\./);
      expect(await programOf(lab)).toBe(program);
      expect(await shownOutcome(lab)).toEqual(outcome);
    }

    expectMeasured(runs, await figuresOf(page));
    const { held, broken } = runs.checked();
    expect(broken).toEqual([]);
    for (const constants of wanted) {
      const [constant, value] = Object.entries(constants)[0] ?? [];
      const said = held.filter((check) => check.includes(`${name} with ${constant} = ${value}:`));
      expect(said, `what is said of ${constant} = ${value}`).not.toEqual([]);
    }
  });
}

test("without scripts all of it is there: words, pictures, programs, and what search engines read", {
  tag: "@once",
}, async ({ browser, baseURL }) => {
  const context = await browser.newContext({ javaScriptEnabled: false, baseURL: baseURL ?? "" });
  const page = await context.newPage();
  await page.goto(ARTICLE);
  await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
  for (const text of [/^What an occupancy grid is/, /^Log odds/, /^Questions/]) {
    await expect(page.getByRole("heading", { level: 2, name: text })).toBeVisible();
  }
  const programs = page.locator("bugbot-lab pre");
  await expect(programs).toHaveCount(4);
  for (const program of await programs.all()) {
    await expect(program).toBeVisible();
    await expect(program).toContainText("def add_beam(x, y, angle, reading):");
  }
  const pictures = page.locator("figure svg[role=img], .live-figure svg[role=img]");
  expect(await pictures.count()).toBeGreaterThan(7);
  for (const picture of await pictures.all()) await expect(picture).toBeVisible();
  await expect(page.getByText(/name 16 cells. The beam crosses 3 more/)).toBeVisible();
  await expect(page.getByText(/5 passes in a row would undo it/)).toBeVisible();
  // What could not work is not there to be pressed.
  for (const button of await page.getByRole("button").all()) await expect(button).toBeDisabled();

  const data = await page.locator('script[type="application/ld+json"]').allTextContents();
  const questions = data
    .map((text) => JSON.parse(text))
    .find((each) => each["@type"] === "FAQPage");
  expect(questions.mainEntity.length).toBeGreaterThan(10);
  for (const { name, acceptedAnswer } of questions.mainEntity) {
    await expect(page.getByRole("heading", { name, exact: true })).toBeVisible();
    expect(acceptedAnswer.text.length).toBeGreaterThan(60);
  }
  for (const meta of ["meta[name=description]", 'meta[property="og:title"]']) {
    await expect(page.locator(meta)).toHaveAttribute("content", /.{20,}/);
  }
  await context.close();
});

test("text is painted before Python is asked for, on less than 250 kB of script and style", {
  tag: "@once",
}, async ({ page }) => {
  const sizes = new Map<string, number>();
  const bodies: Promise<unknown>[] = [];
  page.on("response", (response) => {
    const { pathname } = new URL(response.url());
    if (!/\.(js|css)$/.test(pathname) || pathname.includes("/python/")) return;
    const size = response.body().then((body) => sizes.set(pathname, gzipSync(body).length));
    bodies.push(size);
  });
  const painted = new Promise<number>((resolve) => {
    void page.route("**/python/**", async (route) => {
      const paints = await page.evaluate(
        () => performance.getEntriesByName("first-contentful-paint").length,
      );
      resolve(paints);
      await route.continue();
    });
  });
  await page.goto(ARTICLE);
  await page.locator("#lab-demo-1").scrollIntoViewIfNeeded();
  expect(await painted, "paints before Python is asked for").toBe(1);
  // All that a reader of the whole page gets: every lab, and both figures.
  for (const live of ["bugbot-beam", "bugbot-evidence"]) {
    await page.locator(live).scrollIntoViewIfNeeded();
    await expect(page.locator(live).getByRole("button").first()).toBeEnabled();
  }
  await expect(page.getByRole("textbox", { name: "Program" })).toHaveCount(4);
  await Promise.all(bodies);
  const total = [...sizes.values()].reduce((sum, size) => sum + size, 0);
  expect(total, JSON.stringify([...sizes])).toBeLessThan(250_000);
});

test("no rule of WCAG that axe knows is broken, in either theme", async ({ page }) => {
  // Thousands of words to look at, on a machine that may be busy.
  test.slow();
  await page.goto(ARTICLE);
  await expect(page.getByRole("textbox", { name: "Program" })).toHaveCount(4);
  // One lab stands for the four: they have stories of their own.
  await expectAccess(page, ["#lab-demo-2", "#lab-demo-3", "#lab-demo-4"]);
});
