/** A program goes to somebody else in a link, and nothing of theirs is touched unasked. */
import type { Page } from "@playwright/test";
import { App } from "./app.ts";
import { expect, test } from "./fixtures.ts";

test.use({ device: "small" });

const SHARED = '# ø, 世界, 🤖\nprint("shared")\n';
const THEIRS = 'print("theirs")\n';

async function linkTo(app: App): Promise<string> {
  await app.more("Share as a link…");
  const link = await app.page.getByRole("textbox", { name: "Link" }).inputValue();
  await app.page.getByRole("button", { name: "Close" }).click();
  return link;
}

const panel = (page: Page) => page.getByRole("dialog", { name: "Somebody shared a program" });

test("a link opened elsewhere asks first, opens if told to, and runs nothing", {
  tag: "@once",
}, async ({ app, browser }) => {
  await app.openLab("world=doorway&seed=7");
  await app.write(SHARED);
  const link = await linkTo(app);
  expect(new URL(link).search).toBe("?world=doorway&seed=7");

  const context = await browser.newContext();
  const elsewhere = new App(await context.newPage());
  await elsewhere.page.goto(link.replace(/#.*/, ""));
  await elsewhere.write(THEIRS);
  await elsewhere.page.goto("about:blank");
  await elsewhere.page.goto(link);

  await expect(panel(elsewhere.page)).toContainText("2 lines (35 B) for A doorway, seed 7");
  await expect(elsewhere.page.getByRole("textbox", { name: "Preview" })).toContainText("世界, 🤖");
  expect(await elsewhere.text()).toBe(THEIRS);
  await elsewhere.page.getByRole("button", { name: "Open this program" }).click();
  await expect(panel(elsewhere.page)).toBeHidden();
  expect(await elsewhere.text()).toBe(SHARED);
  await expect(elsewhere.status).toContainText(/Ready|Python is starting|Press Run to start/);
  await expect(elsewhere.console).not.toContainText("shared");
  expect(new URL(elsewhere.page.url()).hash).toBe("");

  await elsewhere.more("Earlier versions…");
  await expect(elsewhere.page.getByRole("textbox", { name: "Preview" })).toContainText("theirs");
  await context.close();
});

test("keeping one's own changes nothing, and a reload does not ask again", {
  tag: "@once",
}, async ({ app, page }) => {
  await app.openLab("world=empty");
  await app.write(SHARED);
  const link = await linkTo(app);
  await app.write(THEIRS);
  await page.goto(link);
  await page.getByRole("button", { name: "Keep mine" }).click();
  expect(await app.text()).toBe(THEIRS);
  await page.reload();
  await expect(app.status).toContainText("Your program is back.");
  await expect(panel(page)).toBeHidden();
});

test("a link is copied; where that is refused it is there to be copied by hand", {
  tag: "@once",
}, async ({ app, page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await app.openLab("world=empty");
  await app.more("Share as a link…");
  const field = page.getByRole("textbox", { name: "Link" });
  const dialog = page.getByRole("dialog", { name: "Share this program" });
  await page.getByRole("button", { name: "Copy link" }).click();
  await expect(dialog).toContainText("The link is copied.");
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(await field.inputValue());
  await page.evaluate(() => {
    Clipboard.prototype.writeText = () => Promise.reject(new DOMException("no", "NotAllowedError"));
  });
  await page.getByRole("button", { name: "Copy link" }).click();
  await expect(dialog).toContainText("The link is selected");
  await expect(field).toBeFocused();
  expect(await page.evaluate(() => getSelection()?.toString())).toBe(await field.inputValue());
});

test("a long link is warned of", { tag: "@once" }, async ({ app, page }) => {
  await app.openLab("world=empty");
  // Numbers without a pattern do not pack.
  const numbers = Array.from({ length: 2500 }, (_, i) => (i * 2654435761) % 4294967296);
  await app.setProgram(`table = [${numbers.join(", ")}]\n`);
  await app.more("Share as a link…");
  await expect(page.getByRole("dialog")).toContainText(/The link has \d\d,\d{3} characters/);
  await expect(page.getByRole("button", { name: "Save as a .py file" })).toBeVisible();
});

test("a damaged link says so and leaves the lab as it is", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=empty#code=abc");
  await expect(page.getByRole("alert")).toContainText("damaged or cut short");
  await app.write(THEIRS);
  expect(await app.text()).toBe(THEIRS);
});
