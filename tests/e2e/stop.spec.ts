/** A program that never ends is stopped, and the next one runs. */
import { expect, test } from "./fixtures.ts";
import { NEVER_ENDS } from "./programs.ts";

test("stop an endless loop, keep what it showed, run another; Run while one is running starts afresh", async ({
  app,
}) => {
  await app.openLab("world=empty");
  await app.write(NEVER_ENDS);
  await app.run.click();
  await expect(app.status).toHaveText("Running…");
  await app.stop.click();
  await expect(app.status).toHaveText(/You stopped the program/);
  await expect(app.console).toContainText("off we go");
  await expect(app.run).toBeFocused();
  await app.runToEnd('print("still here")');
  await expect(app.console).toContainText("still here");

  await app.write(NEVER_ENDS);
  await app.run.click();
  await expect(app.status).toHaveText("Running…");
  await app.runToEnd('print("another")');
  await expect(app.console).toContainText("another");
});
