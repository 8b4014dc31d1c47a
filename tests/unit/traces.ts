/** Small traces made by hand, for tests that know what should come out. */
import { FORMAT, type Header, KINDS, VERSION, type World } from "../../site/src/trace/events.ts";
import { Trace } from "../../site/src/trace/trace.ts";

export const WORLD: World = {
  name: "one-post",
  title: "One post",
  description: "A post to the right of the middle.",
  obstacles: [{ x: 130, y: 70, width: 8, height: 70, name: "post" }],
  start: { x: 100, y: 100, heading: 0 },
};

export function header(world: World = WORLD): Header {
  return { format: FORMAT, version: VERSION, program: "stop()", world, seed: 1, kinds: KINDS };
}

/** A trace of these rows and points [cm], as one chunk. */
export function traceOf(rows: readonly unknown[][], points: readonly number[] = []): Trace {
  const trace = new Trace(header());
  grow(trace, rows, points);
  return trace;
}

export function grow(trace: Trace, rows: readonly unknown[][], points: readonly number[] = []) {
  trace.append({
    events: JSON.stringify(rows),
    points: Int16Array.from(points, (cm) => cm * 100),
  });
}

/**
 * Two seconds: the robot drives right from the middle for a second, turning through up the mat
 * (350 to 10 degrees), looks, draws, prints; then it stands until it ends.
 */
export const TWO_SECONDS: readonly unknown[][] = [
  ["pose", 0, 100, 100, 350],
  ["line", 0, 3],
  ["scan", 0, 100, 100, 350, [-5, 50, 5, 200]],
  ["layer", 0, "free", "#9ecae1", "squares", 5, 0, 2, null],
  ["print", 0, "stdout", "go\n"],
  ["pose", 0.5, 105, 100, 0],
  ["scan", 0.5, 105, 100, 0, [0, 80]],
  ["layer", 0.5, "walls", "black", "squares", 5, 2, 1, null],
  ["plot", 0.5, "known %", 10],
  ["pose", 1, 110, 100, 10],
  ["line", 1, 4],
  ["layer", 1, "free", "#9ecae1", "squares", 5, 3, 3, null],
  ["layer", 1, "names", "red", "text", 6, 0, 2, ["a", "b"]],
  ["plot", 1, "known %", 30],
  ["plot", 1, "walls", 1],
  ["print", 1, "stderr", "oh\n"],
  ["led", 1, 255, 0, 0],
  ["beep", 1, 440, 250],
  ["bump", 1.2, 115, 100],
  ["print", 2, "stdout", "done\n"],
  ["end", 2, "finished", "The program ended."],
];

/** Points of TWO_SECONDS: 0 and 1 free, 2 a wall, 3 to 5 free again. */
export const TWO_SECONDS_POINTS = [
  102.5, 102.5, 107.5, 102.5, 127.5, 102.5, 102.5, 102.5, 107.5, 102.5, 112.5, 102.5,
];

export const twoSeconds = () => traceOf(TWO_SECONDS, TWO_SECONDS_POINTS);
