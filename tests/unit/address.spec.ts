/** The lab's address is read with care: whatever it gets wrong is replaced, and said. */
import { expect, test } from "@playwright/test";
import { MOST_SEED, readAddress, readSeed, writeAddress } from "../../site/src/page/address.ts";
import type { World } from "../../site/src/trace/events.ts";

const world = (name: string): World => ({
  name,
  title: `The ${name}`,
  description: "",
  obstacles: [],
  start: { x: 100, y: 100, heading: 0 },
});
const WORLDS = [world("first"), world("second")];

test("an empty address is the first world and seed 1", () => {
  expect(readAddress("", WORLDS)).toEqual({
    world: "first",
    seed: 1,
    unknownWorld: null,
    seedProblem: null,
  });
});

test("what is written is what is read", () => {
  const place = { world: "second", seed: 41 };
  expect(readAddress(writeAddress(place), WORLDS)).toMatchObject(place);
});

test("an unknown world is named and the first one used", () => {
  expect(readAddress("?world=narnia&seed=3", WORLDS)).toMatchObject({
    world: "first",
    seed: 3,
    unknownWorld: "narnia",
  });
});

for (const text of [
  "",
  "abc",
  "-1",
  "1.5",
  "1e3",
  "0x10",
  "NaN",
  String(MOST_SEED + 1),
  "9".repeat(400),
]) {
  test(`"${text.slice(0, 12)}" is no seed`, () => {
    expect(readSeed(text)).toBeNull();
    const { seed, seedProblem } = readAddress(`?seed=${text}`, WORLDS);
    expect(seed).toBe(1);
    expect(seedProblem).toContain(`“${text}” is not a whole number from 0 to ${MOST_SEED}`);
  });
}

test("the least and the most seed", () => {
  expect([readSeed("0"), readSeed(" 7 "), readSeed(String(MOST_SEED))]).toEqual([0, 7, MOST_SEED]);
});
