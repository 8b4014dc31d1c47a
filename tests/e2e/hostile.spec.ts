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

const NEXT = "from bugbot import *\nwait(0.5)\nprint(len(scan()), clock())\n";

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
  const next = await run(NEXT);
  expect(next.console).toBe("8 0.5\n");
  for (const { name, program, status, type, line, says } of HOSTILE) {
    await test.step(name, async () => {
      const outcome = await run(program);
      expect.soft(outcome.status, `${name}: ${outcome.message}`).toBe(status);
      if (type) expect.soft(outcome.fault?.type, name).toMatch(type);
      if (line !== undefined) expect.soft(outcome.fault?.line, name).toBe(line);
      if (says) expect.soft(outcome.message, name).toMatch(says);
      expect.soft(outcome.message, name).not.toBe("");
      if (!type) expect.soft(outcome.fault?.type, name).not.toBe("InternalError");
      expect.soft(await run(NEXT), `the run after: ${name}`).toEqual(next);
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
      expect(after.console, `the run after: ${name}`).toBe("8 0.5\n");
    });
  }
});
