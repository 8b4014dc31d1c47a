/** The clock of the locked-down Python under Node. */
import { expect, test } from "@playwright/test";
import { timeHad } from "../../site/sandbox/time-had.mjs";

test("it stands still while the process waits, and is never faster than the clock on the wall", () => {
  const time = { wall: 1000, processor: 400 };
  const had = timeHad(
    () => time.wall,
    () => time.processor,
  );
  const pass = (wall: number, processor: number): number => {
    time.wall += wall;
    time.processor += processor;
    return had();
  };
  expect(pass(10, 10)).toBe(1010);
  expect(pass(20, 19.5)).toBe(1029.5);
  // Others have the processor.
  expect(pass(60_000, 1.5)).toBe(1031);
  expect(pass(100, 100)).toBe(1131);
  // Four threads at once, and what they have done is not held against it later.
  expect(pass(100, 400)).toBe(1231);
  expect(pass(200, 0)).toBe(1231);
});
