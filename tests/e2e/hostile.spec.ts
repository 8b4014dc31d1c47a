/** After every hostile or broken program: a clear end, and the next program runs correctly. */
import { expect, test } from "./fixtures.ts";
import { ENDLESS, HOSTILE } from "./hostile.ts";

interface Outcome {
  status: string;
  message: string;
  console: string;
  fault: { type: string; line: number | null; message: string } | null;
}

interface Lab {
  program: string;
  run(): Promise<Outcome>;
  stop(): void;
}

/** A program that runs correctly prints this, … */
const NEXT = "from bugbot import *\nwait(0.5)\nprint(len(scan()), clock())\n";
const PRINTS = "8 0.5\n";
/** … and each hostile one begins with it, so that it is the next one of the one before. */
const LINES = NEXT.split("\n").length - 1;

test("hostile programs end clearly, and the next one runs", async ({ app, page }) => {
  test.setTimeout(400_000);
  await app.openLab("world=empty");
  const lab = page.locator("bugbot-lab");
  const run = (program: string) =>
    lab.evaluate(async (element: HTMLElement & Lab, source) => {
      element.program = source;
      return await element.run();
    }, program);
  expect(HOSTILE.length).toBeGreaterThanOrEqual(25);
  for (const [index, one] of HOSTILE.entries()) {
    const { name, program, mute, status, type, line, says, names } = one;
    await test.step(name, async () => {
      const outcome = await run(mute ? program : NEXT + program);
      expect.soft(outcome.status, `${name}: ${outcome.message}`).toBe(status);
      if (type) expect.soft(outcome.fault?.type, name).toMatch(type);
      if (line) expect.soft(outcome.fault?.line, name).toBe(mute ? line : line + LINES);
      if (line === null) expect.soft(outcome.fault?.line, name).toBeNull();
      if (names) expect.soft(outcome.message, name).toContain(`line ${names + LINES}`);
      if (says) expect.soft(outcome.message, name).toMatch(says);
      expect.soft(outcome.message, name).not.toBe("");
      if (!type) expect.soft(outcome.fault?.type, name).not.toBe("InternalError");
      if (!mute) expect.soft(outcome.console.slice(0, PRINTS.length), name).toBe(PRINTS);
      const next = HOSTILE[index + 1];
      if (next && !next.mute) return;
      const after = await run(NEXT);
      expect.soft(after, `the run after: ${name}`).toMatchObject({
        status: "finished",
        console: PRINTS,
        fault: null,
      });
    });
  }
});

test("Stop ends what never ends, and the next program runs", async ({ app, page }) => {
  test.setTimeout(200_000);
  await app.openLab("world=empty");
  await app.showEndsAtOnce();
  const lab = page.locator("bugbot-lab");
  for (const { name, program } of ENDLESS) {
    await test.step(name, async () => {
      await lab.evaluate((element: HTMLElement & Lab, source) => {
        element.program = source;
      }, program);
      await app.run.click();
      await expect(app.status).toHaveText(/Running/);
      await app.stop.click();
      await expect(app.status).toHaveText(/stopped/);
      const after = await lab.evaluate(async (element: HTMLElement & Lab, source) => {
        element.program = source;
        return await element.run();
      }, NEXT);
      expect(after.console, `the run after: ${name}`).toBe(PRINTS);
    });
  }
});
