/**
 * What a lab shows before anything has run. May import `trace`.
 */
import { FORMAT, KINDS, VERSION, type World } from "../trace/events.ts";
import { Trace } from "../trace/trace.ts";

/** A run that has not begun: the world, and the robot where it starts. */
export function emptyTrace(world: World): Trace {
  const format = { format: FORMAT, version: VERSION, kinds: KINDS } as const;
  return new Trace({ ...format, program: "", world, seed: 0 });
}

/** A run that was stopped before its first step. */
export function stoppedTrace(world: World): Trace {
  const trace = emptyTrace(world);
  const end = ["end", 0, "stopped", "Stopped before it began."];
  trace.append({ events: JSON.stringify([end]), points: new Int16Array(0) });
  return trace;
}
