/** Of a worker's JavaScript nothing is left but what is allowed by name, whatever the engine brings. */
import { ALLOWED } from "../../site/src/worker/allowed.ts";
import { faultsOf, type LeftOver, lookingAtLeftOver } from "../engines/left-over.mjs";
import { expect, test } from "./fixtures.ts";

test("a locked-down worker holds what is allowed, all of it frozen", async ({ page }) => {
  await page.goto("");
  const left = (await page.evaluate(await lookingAtLeftOver())) as LeftOver;
  expect(faultsOf(left, ALLOWED)).toEqual([]);
  // Of 700 names and more in a worker of Chromium; something has been looked at.
  expect(left.names).toContain("WebAssembly");
  expect(left.names.length).toBeLessThanOrEqual(ALLOWED.size);
});
