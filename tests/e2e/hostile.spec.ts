/** After every hostile or broken program: a clear end, and the next program runs correctly. */
import type { Locator } from "@playwright/test";
import { expect, test } from "./fixtures.ts";
import { ENDLESS, HOSTILE, type Hostile } from "./hostile.ts";

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

for (const { which, tag, hostile, endless } of [
  {
    which: "of every kind",
    tag: [],
    hostile: HOSTILE.filter(({ sample }) => sample),
    endless: ENDLESS.filter(({ sample }) => sample),
  },
  { which: "one and all", tag: ["@long"], hostile: HOSTILE, endless: ENDLESS },
]) {
  test(`hostile programs end clearly, and the next one runs: ${which}`, { tag }, async ({
    app,
    page,
  }) => {
    test.setTimeout(400_000);
    expect(hostile.length).toBeGreaterThanOrEqual(13);
    await app.openLab("world=empty");
    await allEnd(page.locator("bugbot-lab"), hostile);
  });

  test(`Stop ends what never ends, and the next program runs: ${which}`, { tag }, async ({
    app,
    page,
  }) => {
    test.setTimeout(200_000);
    expect(endless.length).toBeGreaterThanOrEqual(3);
    await app.openLab("world=empty");
    await app.showEndsAtOnce();
    const lab = page.locator("bugbot-lab");
    for (const { name, program } of endless) {
      await test.step(name, async () => {
        await lab.evaluate((element: HTMLElement & Lab, source) => {
          element.program = source;
        }, program);
        await app.run.click();
        await expect(app.status).toHaveText(/Running/);
        await app.stop.click();
        await expect(app.status).toHaveText(/stopped/);
        const after = await run(lab, NEXT);
        expect(after.console, `the run after: ${name}`).toBe(PRINTS);
      });
    }
  });
}

function run(lab: Locator, program: string): Promise<Outcome> {
  return lab.evaluate(async (element: HTMLElement & Lab, source) => {
    element.program = source;
    return await element.run();
  }, program);
}

/** Runs one after the other; after each, the next program must run as if nothing had been. */
async function allEnd(lab: Locator, hostile: readonly Hostile[]): Promise<void> {
  for (const [index, one] of hostile.entries()) {
    const { name, program, mute, status, type, line, says, names } = one;
    await test.step(name, async () => {
      const outcome = await run(lab, mute ? program : NEXT + program);
      expect.soft(outcome.status, `${name}: ${outcome.message}`).toBe(status);
      if (type) expect.soft(outcome.fault?.type, name).toMatch(type);
      if (line) expect.soft(outcome.fault?.line, name).toBe(mute ? line : line + LINES);
      if (line === null) expect.soft(outcome.fault?.line, name).toBeNull();
      if (names) expect.soft(outcome.message, name).toContain(`line ${names + LINES}`);
      if (says) expect.soft(outcome.message, name).toMatch(says);
      expect.soft(outcome.message, name).not.toBe("");
      if (!type) expect.soft(outcome.fault?.type, name).not.toBe("InternalError");
      if (!mute) expect.soft(outcome.console.slice(0, PRINTS.length), name).toBe(PRINTS);
      const next = hostile[index + 1];
      if (next && !next.mute) return;
      const after = await run(lab, NEXT);
      expect.soft(after, `the run after: ${name}`).toMatchObject({
        status: "finished",
        console: PRINTS,
        fault: null,
      });
    });
  }
}
