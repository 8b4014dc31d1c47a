/** People make mats of their own: by mouse, finger or keys, for the lab, for others, as files. */
import { readFile } from "node:fs/promises";
import type { Page } from "@playwright/test";
import { expectAccess } from "./access.ts";
import { App } from "./app.ts";
import { expect, test } from "./fixtures.ts";

test.use({ device: "small" });

type Point = readonly [x: number, y: number];

const mat = (page: Page) => page.getByRole("application", { name: "Mat" });
const story = (page: Page) => page.getByRole("img", { name: "Mat" });
const check = (page: Page) => page.getByRole("status", { name: "Check of the mat" });
const list = (page: Page) => page.getByRole("list", { name: "On the mat" });
const button = (page: Page, name: string) => page.getByRole("button", { name, exact: true });

/** Drags with the mouse, or with a finger where the screen has one; places are in cm of the mat. */
async function drag(page: Page, from: Point, to: Point): Promise<void> {
  await mat(page).scrollIntoViewIfNeeded();
  const ground = await mat(page).locator(".mat").boundingBox();
  if (!ground) throw new Error("the mat is not on the screen");
  const scale = ground.width / 200;
  const onScreen = ([x, y]: Point) => ({
    x: ground.x + x * scale,
    y: ground.y + ground.height - y * scale,
  });
  const [a, b] = [onScreen(from), onScreen(to)];
  const middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  if (await page.evaluate(() => matchMedia("(pointer: coarse)").matches)) {
    const finger = await page.context().newCDPSession(page);
    const send = (
      type: "touchStart" | "touchMove" | "touchEnd",
      points: { x: number; y: number }[],
    ) => finger.send("Input.dispatchTouchEvent", { type, touchPoints: points });
    await send("touchStart", [a]);
    await send("touchMove", [middle]);
    await send("touchMove", [b]);
    await send("touchEnd", []);
    await finger.detach();
  } else {
    await page.mouse.move(a.x, a.y);
    await page.mouse.down();
    await page.mouse.move(middle.x, middle.y);
    await page.mouse.move(b.x, b.y);
    await page.mouse.up();
  }
}

test("a wall drawn on a mat stops the robot's beams in the lab", async ({ app, page }) => {
  await page.goto("worlds/");
  await page.getByRole("textbox", { name: "Name" }).fill("One wall");
  await expect(check(page)).toContainText("The mat is bare");
  await drag(page, [21, 119], [178, 131]);
  await expect(list(page)).toContainText("wall 160 × 10 cm at (20, 120)");
  await expect(check(page)).toContainText("every place where it fits");
  // Its handle on the right, then the wall itself, then the robot into it and back.
  const away = (await page.evaluate(() => matchMedia("(pointer: coarse)").matches)) ? 10 : 4;
  await drag(page, [180 + away, 125], [200 + away, 125]);
  await expect(list(page)).toContainText("wall 180 × 10 cm at (20, 120)");
  await drag(page, [100, 125], [80, 125]);
  await expect(list(page)).toContainText("wall 180 × 10 cm at (0, 120)");
  await drag(page, [100, 25], [100, 122]);
  await expect(check(page)).toHaveText(/The robot stands in the wall\. Move one of them 5\.0 cm/);
  await expect(button(page, "Try it in the lab")).toBeDisabled();
  await button(page, "Undo").click();
  await expect(list(page)).toContainText("Robot at (100, 25), heading 0°");

  await button(page, "Try it in the lab").click();
  await expect(app.world.getByRole("option", { name: "One wall", exact: true })).toBeAttached();
  await expect(app.world.locator("option:checked")).toHaveText("One wall");
  expect(await app.text()).toContain("START = (100, 25)");
  expect(await app.text()).toContain("REAL = [(0, 120, 180, 10)]");
  await app.showEndsAtOnce();
  await app.runToEnd(
    'from bugbot import *\n\nprint("beam", round(distance() / 10))\nforward(100, 70)\n',
  );
  await expect(app.console).toContainText(/beam (9|10)\b/);
  await expect(app.view).toHaveAccessibleDescription(
    /robot at \(100, 95\) cm.*; wall 2[0-9] cm ahead/,
  );
});

test("a mat goes to somebody else in a link, with a program; both are shown first", {
  tag: "@once",
}, async ({ app, page, browser }) => {
  const program = 'print("for this mat")\n';
  await page.goto("worlds/");
  await mat(page).focus();
  await page.keyboard.press("n");
  await page.getByRole("textbox", { name: "Name" }).fill("One box");
  await button(page, "Try it in the lab").click();
  await app.write(program);
  await app.more("Share as a link…");
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  const context = await browser.newContext();
  const elsewhere = new App(await context.newPage());
  await elsewhere.page.goto(link);
  const offered = elsewhere.page.getByRole("dialog", { name: "Somebody shared a mat" });
  await expect(offered).toContainText("One box: 1 obstacle.");
  await button(elsewhere.page, "Take this mat").click();
  await expect(
    elsewhere.page.getByRole("dialog", { name: "Somebody shared a program" }),
  ).toContainText("for One box, seed 1");
  await button(elsewhere.page, "Open this program").click();
  expect(await elsewhere.text()).toBe(program);
  await expect(elsewhere.world.locator("option:checked")).toHaveText("One box");
  expect(new URL(elsewhere.page.url()).hash).toBe("");
  // It is theirs now: to change, and no second time when the link is opened again.
  await elsewhere.page.goto("about:blank");
  await elsewhere.page.goto(link);
  await expect(elsewhere.status).toContainText("The link holds the program that is here already.");
  await elsewhere.page.getByRole("link", { name: "Edit this mat" }).click();
  await expect(elsewhere.page.getByRole("textbox", { name: "Name" })).toHaveValue("One box");
  await expect(list(elsewhere.page)).toContainText("box 20 × 20 cm at (90, 90)");
  await context.close();
});

test("a mat is made by keyboard alone, kept, deleted and brought back", { tag: "@once" }, async ({
  page,
}) => {
  const { keyboard } = page;
  await page.goto("worlds/");
  await mat(page).focus();
  await keyboard.press("n");
  await expect(list(page)).toContainText("box 20 × 20 cm at (90, 90)");
  for (const key of ["ArrowRight", "ArrowUp", "Control+ArrowUp", "Shift+ArrowRight"]) {
    await keyboard.press(key);
  }
  await expect(list(page)).toContainText("box 21 × 20 cm at (91, 96)");
  await expect(page.getByRole("status").filter({ hasText: "box: 21 cm wide" })).toBeAttached();
  await keyboard.press("d");
  await expect(list(page)).toContainText("box 21 × 20 cm at (101, 86)");
  await keyboard.press("Delete");
  await expect(list(page).getByRole("listitem")).toHaveCount(2);
  await keyboard.press("Control+z");
  await expect(list(page).getByRole("listitem")).toHaveCount(3);
  await keyboard.press("PageDown");
  await keyboard.press("Shift+ArrowRight");
  await keyboard.press("ArrowLeft");
  await expect(list(page)).toContainText("Robot at (99, 25), heading 15°");
  await expect(story(page)).toHaveAccessibleDescription(
    /2 obstacles\. robot: at \(99, 25\) cm, heading 15°\. box: 21 cm wide, 20 cm high/,
  );

  await list(page).getByRole("button").nth(1).press("Enter");
  const width = page.getByRole("spinbutton", { name: "Width" });
  await width.fill("0.2");
  await width.press("Tab");
  await expect(page.getByText("Width: at least 1 cm.")).toBeVisible();
  await expect(width).toHaveValue("21");
  await width.fill("33.5");
  await page.getByRole("textbox", { name: "Word for it" }).fill("sofa");
  await expect(list(page)).toContainText("sofa 33.5 × 20 cm at (91, 96)");

  await page.getByRole("textbox", { name: "Name" }).fill("By keys");
  await page.reload();
  await expect(page.getByRole("textbox", { name: "Name" })).toHaveValue("By keys");
  await expect(list(page)).toContainText("sofa 33.5 × 20 cm");
  await list(page).getByRole("button", { name: "sofa" }).click();
  await expectAccess(page);
  await button(page, "Delete By keys").click();
  await expect(page.getByText("By keys is deleted.")).toBeVisible();
  await expect(button(page, "Open By keys")).toBeHidden();
  await page.locator(".own-mats").getByRole("button", { name: "Undo" }).click();
  await expect(button(page, "Open By keys")).toBeVisible();
  await expect(list(page)).toContainText("sofa 33.5 × 20 cm");
});

test("a mat goes into a file and comes back; what is no mat is refused, in files and in links", {
  tag: "@once",
}, async ({ app, page }) => {
  await page.goto("worlds/");
  await page.getByRole("combobox", { name: "Start a new one from" }).selectOption("A doorway");
  await button(page, "New mat").click();
  await page.getByRole("textbox", { name: "Name" }).fill("Doorway");
  const saving = page.waitForEvent("download");
  await button(page, "Save as a file").click();
  const file = await saving;
  expect(file.suggestedFilename()).toBe("doorway-of-mine.json");
  const text = await readFile(await file.path(), "utf8");
  expect(JSON.parse(text)).toMatchObject({ name: "doorway-of-mine", title: "Doorway" });

  const open = async (name: string, content: string): Promise<void> => {
    const choosing = page.waitForEvent("filechooser");
    await button(page, "Open a file…").click();
    await (await choosing).setFiles({
      name,
      mimeType: "application/json",
      buffer: Buffer.from(content),
    });
  };
  await open("broken.json", text.replace('"width": 90', '"width": 900'));
  await expect(page.getByText("obstacles[0].width wants a number from 0.1 to 200")).toBeVisible();
  await open("room.json", text.replace("Doorway", "Another room"));
  await expect(page.getByText("This is the mat of room.json")).toBeVisible();
  await expect(button(page, "Open Another room")).toBeVisible();

  await app.openLab("world=own_zzzzzz#mat=abc");
  const alert = page.getByRole("alert");
  await expect(alert).toContainText("The mat in this link cannot be read");
  await expect(alert).toContainText("a mat of somebody’s own");
  await app.world.selectOption("Another room");
  expect(await app.text()).toContain("REAL = [(0, 120, 90, 8), (110, 120, 90, 8)]");
  await expect(page.getByRole("link", { name: "Edit this mat" })).toBeVisible();
});
