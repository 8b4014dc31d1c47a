/** Runs that follow a moving number: one at a time, and at the end the last value. */
import { expect, test } from "@playwright/test";
import { Redoing } from "../../site/src/page/redoing.ts";

/**
 * A page of which the value is set by hand and each run ended by hand; `spares` says how many
 * interpreters there are.
 */
function bench(spares = 3) {
  const log: string[] = [];
  const ends: (() => void)[] = [];
  const page = { value: 0 };
  const redoing = new Redoing({
    begin: () => log.push("begin"),
    ready: (runs) => (runs <= spares ? Promise.resolve() : new Promise(() => {})),
    run: () => {
      log.push(`run ${page.value}`);
      return new Promise<void>((resolve) => ends.push(resolve));
    },
    expect: () => {},
  });
  const move = async (value: number): Promise<void> => {
    page.value = value;
    redoing.on("moved");
    await settled();
  };
  const release = async (): Promise<void> => {
    redoing.on("released");
    await settled();
  };
  const end = async (): Promise<void> => {
    ends.shift()?.();
    await settled();
  };
  return { log, move, release, end };
}

/** All that follows from resolved promises has been done. */
const settled = (): Promise<void> => new Promise((resolve) => setImmediate(resolve));

test("a run under way is not disturbed; the newest value is next, those between are left out", async () => {
  const { log, move, release, end } = bench();
  await move(1);
  await move(2);
  await move(3);
  expect(log).toEqual(["begin", "run 1"]);
  await end();
  expect(log).toEqual(["begin", "run 1", "run 3"]);
  await end();
  await release();
  expect(log).toEqual(["begin", "run 1", "run 3"]);
});

test("let go, the last value is run at once and the overtaken run is not waited for", async () => {
  const { log, move, release, end } = bench();
  await move(1);
  await move(2);
  await release();
  expect(log).toEqual(["begin", "run 1", "run 2"]);
  await end();
  await end();
  expect(log).toEqual(["begin", "run 1", "run 2"]);
});

test("each movement begins anew", async () => {
  const { log, move, release, end } = bench();
  await move(1);
  await release();
  await end();
  await move(2);
  expect(log).toEqual(["begin", "run 1", "begin", "run 2"]);
});

test("while the number moves one interpreter is kept for the last value", async () => {
  const { log, move, release, end } = bench(1);
  await move(1);
  await end();
  await move(2);
  await move(3);
  expect(log).toEqual(["begin", "run 1"]);
  await release();
  expect(log).toEqual(["begin", "run 1", "run 3"]);
});
