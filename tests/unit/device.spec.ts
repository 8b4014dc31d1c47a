/** Which devices are small, and what is said where Python can't run. */
import { expect, test } from "@playwright/test";
import { inWords, isSmall, obstacle } from "../../site/src/runtime/device.ts";

const LAPTOP = "Mozilla/5.0 (X11; Linux x86_64) AppleWebKit/537.36 Chrome/140 Safari/537.36";
const IPHONE = "Mozilla/5.0 (iPhone; CPU iPhone OS 18_0 like Mac OS X) AppleWebKit/605.1.15";
const MAC = "Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7) AppleWebKit/605.1.15 Safari/605.1.15";

test("a device is small by its memory, or as one of Apple's that one touches", () => {
  const small = (userAgent: string, maxTouchPoints: number, deviceMemory?: number) =>
    isSmall({ userAgent, maxTouchPoints, ...(deviceMemory === undefined ? {} : { deviceMemory }) });
  expect([0.5, 1, 2, 4, 8].map((memory) => small(LAPTOP, 0, memory))).toEqual([
    ...[true, true, true, true, false],
  ]);
  expect(small(LAPTOP, 10)).toBe(false);
  expect(small(IPHONE, 5)).toBe(true);
  // An iPad calls itself a Mac.
  expect([small(MAC, 5), small(MAC, 0)]).toEqual([true, false]);
});

test("what keeps Python from running is told in words", () => {
  expect(obstacle({ WebAssembly: {}, Worker: class {} })).toBeNull();
  expect(obstacle({ Worker: class {} })).toContain("WebAssembly, which is switched off");
  expect(obstacle({ WebAssembly: {} })).toContain("does not let pages start any");
  expect(inWords(new DOMException("denied", "SecurityError"))).toContain("does not let pages");
  for (const text of [
    "WebAssembly.Memory(): could not allocate memory",
    "Out of memory: Cannot allocate Wasm memory",
    "Array buffer allocation failed",
  ]) {
    expect(inWords(new RangeError(text))).toContain("too little memory");
  }
  expect(inWords(new Error("core.bin could not be fetched"))).toBe("core.bin could not be fetched");
});
