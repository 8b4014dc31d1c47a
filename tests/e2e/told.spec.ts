/** What the lab says of a program that stands still, breaks the interpreter or asks too much. */
import { nativeOutcome } from "../native-trace.mjs";
import { expect, test } from "./fixtures.ts";

const STANDS_STILL = `from bugbot import *

forward(50)
while distance() > 20:
    pass
`;

const COMPUTES_FOR_EVER = `print("first")
print("second")
while True:
    pass
`;

const BREAKS_AFTER_21_PRINTS = `class F:
    def __call__(self, n):
        return 0 if n == 0 else 1 + self(n - 1)

for i in range(20):
    print("scan", i)
print("now the deep one")
F()(800)
`;

const ONE_CLOCK = `import asyncio
import datetime
import time
from bugbot import *

async def go_on():
    forward(50)
    await asyncio.gather(asyncio.sleep(1), asyncio.sleep(0.5))
    stop()

asyncio.run(go_on())
print(position(), clock(), time.process_time(), time.localtime()[:6])
print(time.time() == datetime.datetime.now().timestamp(), datetime.date.today())
`;

const CHANCE = `import os
import random
import numpy as np
print(np.random.rand(), np.random.default_rng().random(), random.SystemRandom().random())
print(os.urandom(4))
`;

test("a loop that never waits is ended with its line and the remedy; what is too much is noted beside the prints", async ({
  app,
}) => {
  await app.openLab("world=post-and-shelf");
  await app.runToEnd(STANDS_STILL);
  await expect(app.status).toContainText("Stopped on line 4 at 0 s: the depth sensor was used");
  await expect(app.status).toContainText("Put wait(0.1) into the loop on line 4.");

  await app.showEndsAtOnce();
  await app.runToEnd('from bugbot import *\nprint("off")\nforward(500, distance=300)\n');
  await expect(app.status).toContainText("Finished at");
  await expect(app.console).toContainText(
    "Line 3: forward(speed, distance) got speed 500, and the robot can't go faster than 100 per cent",
  );
  await expect(app.console).toContainText(/Line 3: the robot drove .* it touched the shelf at/);
  const outcome = await app.page
    .locator("bugbot-lab")
    .evaluate((lab: HTMLElement & Lab) => lab.run());
  expect(outcome).toMatchObject({ console: "off\n", notes: [{ line: 3 }, { line: 3 }] });
});

test("a program that only computes is told the line and goes on, and nothing printed is lost", async ({
  app,
}) => {
  await app.openLab("world=empty");
  await app.write(COMPUTES_FOR_EVER);
  await app.run.click();
  await expect(app.status).toHaveText(
    "Still computing on line 4: no simulated time is passing. " +
      "If a loop waits for the robot there, put wait(0.1) into it.",
  );
  await expect(app.console).toContainText("first");
  await expect(app.console).toContainText("second");
  await app.stop.click();
  await expect(app.status).toHaveText(/You stopped the program/);

  // Nor where the interpreter breaks.
  await app.runToEnd(BREAKS_AFTER_21_PRINTS);
  await expect(app.status).toHaveText("An error on line 3 ended the program.");
  for (let i = 0; i < 20; i++) await expect(app.console).toContainText(`scan ${i}`);
  await expect(app.console).toContainText("now the deep one");
});

test("every clock, asyncio and chance are those of plain Python's run", async ({ app, page }) => {
  await app.openLab("world=empty");
  for (const program of [ONE_CLOCK, CHANCE]) {
    const outcome = await page
      .locator("bugbot-lab")
      .evaluate(async (lab: HTMLElement & Lab, text) => {
        Object.assign(lab, { seed: 3, program: text });
        return lab.run();
      }, program);
    expect(outcome).toMatchObject({ status: "finished", fault: null });
    expect(outcome).toEqual(nativeOutcome({ program, world: "empty", seed: 3 }));
  }
});

interface Lab {
  seed: number;
  program: string;
  run(): Promise<unknown>;
}
