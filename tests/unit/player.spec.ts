import { expect, test } from "@playwright/test";
import { Player, type Speed } from "../../site/src/player/player.ts";
import { Trace } from "../../site/src/trace/trace.ts";
import { grow, header, twoSeconds } from "./traces.ts";

/** A clock that stands until it is told to go on. */
class Frames {
  now = 1000;
  #waiting: ((now: number) => void)[] = [];

  readonly request = (callback: (now: number) => void) => {
    this.#waiting.push(callback);
  };

  get requested(): number {
    return this.#waiting.length;
  }

  /** Lets one frame happen, `ms` after the last. */
  next(ms = 100): void {
    this.now += ms;
    const waiting = this.#waiting;
    this.#waiting = [];
    for (const callback of waiting) callback(this.now);
  }
}

function playerOf(trace: Trace) {
  const frames = new Frames();
  const player = new Player(trace, frames.request);
  const shown: number[] = [];
  player.addEventListener("change", () => shown.push(player.time));
  return { player, frames, shown };
}

test("plays at the robot's own speed and stops at the end", () => {
  const { player, frames, shown } = playerOf(twoSeconds());
  player.play();
  for (let i = 0; i < 30; i++) frames.next();
  expect(shown[0]).toBe(0);
  expect(shown[10]).toBeCloseTo(1, 9);
  expect([player.time, player.playing]).toEqual([2, false]);
  expect(frames.requested).toBe(0);
});

test("speed multiplies; the fastest frame does not leap over a held-up one", () => {
  const { player, frames } = playerOf(twoSeconds());
  player.speed = 4;
  player.play();
  frames.next();
  frames.next();
  expect(player.time).toBeCloseTo(0.4, 9);
  frames.next(60_000);
  expect(player.time).toBeCloseTo(0.4 + 4 * 0.25, 9);
});

test("refuses a speed it does not have and a time that is none", () => {
  const { player } = playerOf(twoSeconds());
  expect(() => {
    player.speed = 3 as Speed;
  }).toThrow("speed should be one of 0.5, 1, 2, 4, 8, 16, not 3");
  expect(() => player.seek(Number.NaN)).toThrow(RangeError);
});

test("pause holds the moment, play goes on from it", () => {
  const { player, frames } = playerOf(twoSeconds());
  player.toggle();
  frames.next();
  frames.next(200);
  player.toggle();
  frames.next(200);
  expect(player.time).toBeCloseTo(0.2, 9);
  player.toggle();
  frames.next(200);
  frames.next(200);
  expect(player.time).toBeCloseTo(0.4, 9);
});

test("play at the end of a whole run begins again", () => {
  const { player } = playerOf(twoSeconds());
  player.toEnd();
  player.play();
  expect([player.time, player.playing]).toEqual([0, true]);
});

test("seek shows the time at once, keeps within the run, and fires once a frame", () => {
  const { player, frames, shown } = playerOf(twoSeconds());
  player.seek(-5);
  player.seek(99);
  player.seek(1.25);
  expect(player.time).toBe(1.25);
  frames.next();
  expect(shown).toEqual([1.25]);
});

test("step goes to the next and the last time the program did something", () => {
  const { player } = playerOf(twoSeconds());
  const stops: number[] = [];
  for (const by of [1, 1, -1, -1, -1] as const) {
    player.step(by);
    stops.push(player.time);
  }
  expect(stops).toEqual([0.5, 1, 0.5, 0, 0]);
  player.seek(0.7);
  player.step(-1);
  expect(player.time).toBe(0.5);
  player.seek(0.7);
  player.step(1);
  expect(player.time).toBe(1);
});

test("a step is half a second at most, so that a long wait is not leapt over", () => {
  const { player } = playerOf(twoSeconds());
  player.seek(1);
  const stops: number[] = [];
  for (const by of [1, 1, 1, -1, -1] as const) {
    player.step(by);
    stops.push(player.time);
  }
  expect(stops).toEqual([1.5, 2, 2, 1.5, 1]);
});

test("step pauses", () => {
  const { player, frames } = playerOf(twoSeconds());
  player.play();
  frames.next();
  player.step(1);
  expect(player.playing).toBe(false);
});

test.describe("a run that is still growing", () => {
  const growing = () => {
    const trace = new Trace(header());
    grow(trace, [
      ["pose", 0, 100, 100, 0],
      ["line", 1, 1],
    ]);
    return trace;
  };

  test("at its end the player moves along with it", () => {
    const trace = growing();
    const { player } = playerOf(trace);
    player.toEnd();
    expect([player.time, player.live]).toEqual([1, true]);
    grow(trace, [["line", 3, 1]]);
    player.grown();
    expect(player.time).toBe(3);
    grow(trace, [["end", 4, "finished", ""]]);
    player.grown();
    expect([player.time, player.live]).toEqual([4, false]);
  });

  test("anywhere else the moment stays, and the views hear of what is new", () => {
    const trace = growing();
    const { player, frames, shown } = playerOf(trace);
    player.seek(0.5);
    frames.next();
    grow(trace, [["line", 3, 1]]);
    player.grown();
    frames.next();
    expect(shown).toEqual([0.5, 0.5]);
  });

  test("playing waits at the end for more", () => {
    const trace = growing();
    const { player, frames } = playerOf(trace);
    player.play();
    for (let i = 0; i < 15; i++) frames.next();
    expect([player.time, player.playing]).toEqual([1, true]);
    // Nothing is drawn meanwhile: the program has the machine to itself.
    expect(frames.requested).toBe(0);
    grow(trace, [["end", 1.15, "finished", ""]]);
    player.grown();
    // However long that took, it goes on from where it was.
    frames.next(5000);
    expect(player.time).toBe(1);
    frames.next();
    expect(player.time).toBeCloseTo(1.1, 9);
    frames.next();
    expect([player.time, player.playing]).toEqual([1.15, false]);
  });

  test("another run is shown from its start, paused", () => {
    const { player } = playerOf(growing());
    player.toEnd();
    player.show(twoSeconds());
    expect([player.time, player.playing, player.live]).toEqual([0, false, false]);
    player.grown();
    expect(player.time).toBe(0);
  });
});
