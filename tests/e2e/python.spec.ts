/** Python itself, as a learner meets it: starting, NumPy, the standard library, other packages. */
import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures.ts";

/** Addresses of Python's files that the page has asked for. */
function askedOf(page: Page): string[] {
  const asked: string[] = [];
  page.on("request", (request) => {
    if (request.url().includes("/python/")) asked.push(request.url());
  });
  return asked;
}

test("NumPy is loaded when a program imports it, and not before", async ({ app, page }) => {
  const asked = askedOf(page);
  await app.openLab("world=empty");
  await app.showEndsAtOnce();
  await app.runToEnd("print('no numpy yet')\n");
  expect(asked.filter((url) => url.includes("numpy"))).toEqual([]);
  await app.runToEnd("import numpy as np\nprint(np.arange(5).sum(), np.__version__)\n");
  await expect(app.console).toContainText("10 2.4.3");
  expect(asked.filter((url) => url.includes("numpy"))).toHaveLength(1);
  await app.runToEnd("from numpy.linalg import norm\nprint(norm([3, 4]))\n");
  await expect(app.console).toContainText("5.0");
  expect(asked.filter((url) => url.includes("numpy"))).toHaveLength(1);
});

test("the standard library is there for who needs it; of another package the message says what there is", async ({
  app,
}) => {
  await app.openLab("world=empty");
  await app.runToEnd("import math\nimport pandas\n");
  await expect(app.problem).toContainText("pandas");
  await expect(app.problem).toContainText(/numpy/i);
  await expect(app.problem).toContainText("line 2");
  await app.runToEnd("import colorsys, wave, tomllib\nprint(tomllib.loads('a = 1'))\n");
  await expect(app.console).toContainText("{'a': 1}");
});

test("an error is told well before the standard library has come", async ({ app, page }) => {
  await page.route("**/python/stdlib-*", () => {}); // never answered
  await app.openLab("world=empty");
  await app.runToEnd('import json\ndata = json.loads("{")\n');
  await expect(app.problem).toContainText("line 2");
  await expect(app.problem).toContainText(/json|Expecting/i);
  await app.runToEnd("print(1 / 0)\n");
  await expect(app.problem).toContainText("line 1");
});

test("a snapshot that is damaged, or of another release: Python starts plainly", async ({
  app,
  page,
}) => {
  const { gzipSync } = await import("node:zlib");
  const bodies = [Buffer.from("this is no snapshot"), gzipSync(Buffer.alloc(100_000, 7))];
  await page.route("**/python/snapshot-*", (route) =>
    route.fulfill({ status: 200, body: bodies.shift() ?? "" }),
  );
  for (const what of ["damaged", "of another release"]) {
    await app.openLab("world=empty");
    await app.runToEnd(`print("started all the same: ${what}")\n`);
    await expect(app.console).toContainText(`started all the same: ${what}`);
  }
  expect(bodies).toEqual([]);
});

test("a reader who saves data fetches Python only when reaching for the lab", async ({
  app,
  page,
}) => {
  await page.addInitScript(() => {
    Object.defineProperty(Navigator.prototype, "connection", { value: { saveData: true } });
  });
  const asked = askedOf(page);
  await app.openLab("world=empty");
  await page.evaluate(() => new Promise((resolve) => requestIdleCallback(resolve)));
  expect(asked).toEqual([]);
  await app.runToEnd("print('wanted')\n");
  await expect(app.console).toContainText("wanted");
  expect(asked.length).toBeGreaterThan(0);
});
