/** The run that a job of a marking left, as a trace to be shown. Imports the trace. */
import { FORMAT, KINDS, VERSION } from "../trace/events.ts";
import { readPoints } from "../trace/file.ts";
import { Trace } from "../trace/trace.ts";
import type { Performance } from "./marker.ts";

/** Null if the job was no run, left no whole one, or one that breaks the format. */
export function runOf(program: string, { job, result }: Performance): Trace | null {
  if (!job.place) return null;
  const format = { format: FORMAT, version: VERSION, kinds: KINDS } as const;
  const { world, seed } = job.place;
  const trace = new Trace({ ...format, program, world, seed });
  try {
    const left = JSON.parse(result).trace as unknown;
    if (!isLeft(left)) return null;
    trace.append({ events: left.events, points: readPoints(left.points, "the run") });
  } catch (error) {
    // It was made beside a stranger's program: what is no trace is not shown.
    console.info("A run of the marking can't be shown:", error);
    return null;
  }
  return trace.complete ? trace : null;
}

function isLeft(value: unknown): value is { events: string; points: string } {
  return (
    typeof value === "object" &&
    value !== null &&
    "events" in value &&
    "points" in value &&
    typeof value.events === "string" &&
    typeof value.points === "string"
  );
}
