/** The last events of a run that did not end by itself, in words for the learner. */
import type { Chunk, Status } from "../trace/events.ts";
import type { Trace } from "../trace/trace.ts";
import type { DeathReason, Limits } from "./messages.ts";

export type Ending =
  | { kind: "finished" }
  | { kind: "stopped" }
  /** There was no interpreter to run it; why, in words. */
  | { kind: "unloaded"; message: string }
  /** Computed for too long with no simulated time passing; on which line, if that is known. */
  | { kind: "silent"; line: number | null }
  | { kind: "died"; reason: DeathReason; line: number | null; message: string };

/** The events that complete a trace whose program could not end it itself. */
export function explain(ending: Ending, trace: Trace, limits: Limits): Chunk {
  const t = trace.duration;
  const at = `${t.toFixed(1)} s`;
  switch (ending.kind) {
    case "stopped":
      return end(t, "stopped", `Stopped at ${at}.`);
    case "unloaded":
      return end(
        t,
        "limit",
        `The program could not run, because Python could not start: ${ending.message}. ` +
          "Reload the page; your program is kept.",
      );
    case "silent":
      return end(
        t,
        "limit",
        `Stopped${onLine(ending.line)} after ${limits.silent_s} s of computing in which no simulated ` +
          "time passed. If a loop waits for the robot there, put wait(0.1) into it.",
      );
    case "finished":
      return fault(
        t,
        "InternalError",
        "The run ended without saying how. This is a fault of the site, not of your program.",
        null,
        "",
      );
    case "died": {
      // The line that last let time pass is the best guess when the interpreter said nothing.
      const line = ending.line ?? trace.lineAt(t);
      if (ending.reason === "recursion") {
        return fault(
          t,
          "RecursionError",
          "Calls went deeper than the browser allows: a function keeps calling itself.",
          line,
          ending.message,
          "A function that calls itself needs an if that ends it, and must come nearer to that.",
        );
      }
      if (ending.reason === "fatal") {
        return fault(
          t,
          "SystemError",
          "The program broke the Python interpreter, so the run ended here. The next run starts afresh.",
          line,
          ending.message,
        );
      }
      return fault(
        t,
        "InternalError",
        "Something went wrong outside your program's own lines. If the program changes parts of Python or " +
          "of bugbot itself, that is why; if not, it is a fault of the site. The next run starts afresh.",
        null,
        ending.message,
      );
    }
  }
}

/** What a page says while a program computes and simulated time stands still. */
export function stillWords(line: number | null): string {
  return (
    `Still computing${onLine(line)}: no simulated time is passing. ` +
    "If a loop waits for the robot there, put wait(0.1) into it."
  );
}

function onLine(line: number | null): string {
  return line === null ? "" : ` on line ${line}`;
}

function end(t: number, status: Status, message: string): Chunk {
  return chunk([["end", t, status, message]]);
}

function fault(
  t: number,
  type: string,
  message: string,
  line: number | null,
  detail: string,
  hint: string | null = null,
): Chunk {
  return chunk([
    ["fault", t, type, message, line, hint, detail],
    ["end", t, "fault", message],
  ]);
}

function chunk(rows: unknown[][]): Chunk {
  return { events: JSON.stringify(rows), points: new Int16Array(0) };
}
