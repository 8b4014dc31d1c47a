/** After the lock-down a worker holds only what is allowed by name, whatever the engine adds. */
import { ALLOWED } from "../../site/src/worker/allowed.ts";
import { faultsOf, type LeftOver, lookingAtLeftOver } from "../engines/left-over.mjs";
import { expect, test } from "./fixtures.ts";

test("a locked-down worker holds only what is allowed, and all of it is frozen", async ({
  page,
}) => {
  await page.goto("");
  const left = (await page.evaluate(await lookingAtLeftOver())) as LeftOver;
  expect(faultsOf(left, ALLOWED)).toEqual([]);
  expect(left.names).toContain("WebAssembly");
  expect(left.names.length).toBeLessThanOrEqual(ALLOWED.size);
});
