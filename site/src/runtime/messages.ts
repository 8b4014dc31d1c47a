/**
 * Every message between the page and a worker, both ways, once.
 * May import types of `trace` only; the worker imports this file and nothing else of ours.
 *
 * The first message to a new worker is `Boot`, with a MessagePort in its transfer list. All that
 * follows goes over that port, which the worker keeps where a program cannot reach it.
 */
import type { World } from "../trace/events.ts";

/** What a new worker is handed. Nothing in it is fetched by the worker itself. */
export interface Boot {
  kind: "boot";
  /** Where pyodide.mjs lies; absolute, ends in a slash. */
  pyodideUrl: string;
  /** The compiled interpreter, shared by every worker of the page. */
  module: WebAssembly.Module;
  /** Memory of the started interpreter (`snapshot-pages`), or null for a plain start. */
  snapshot: Blob | null;
  /** The standard library archive; may be null with a snapshot, while it is on its way. */
  stdlib: ArrayBuffer | null;
  /** Our Python sources: path below site-packages -> text in UTF-8. */
  sources: Record<string, Uint8Array>;
}

/** Each ends the run with a plain message; the names are those of `bugbot.run.Limits`. */
export interface Limits {
  simulated_s: number;
  /** Seconds of computing with no simulated time passing. */
  silent_s: number;
  print_bytes: number;
  trace_bytes: number;
}

export const DEFAULT_LIMITS: Limits = {
  simulated_s: 600,
  silent_s: 60,
  print_bytes: 2_000_000,
  trace_bytes: 64_000_000,
};

export interface RunRequest {
  program: string;
  world: World;
  seed: number;
  limits?: Partial<Limits>;
}

export type ToWorker =
  /** Which modules does this program import that are not loaded? Answered by `imports`. */
  | { kind: "inspect"; id: number; program: string }
  | {
      kind: "run";
      id: number;
      program: string;
      world: World;
      seed: number;
      limits: Limits;
    }
  /** Judge a program by a check; answered by `step`. `request` is a JudgeRequest as JSON. */
  | { kind: "judge"; id: number; request: string }
  /** What became of the jobs of the last step, each as JSON; answered by the next `step`. */
  | { kind: "results"; id: number; results: readonly string[] }
  /** Do a job of a marking, given as JSON; answered by `performed`. */
  | { kind: "perform"; id: number; program: string; job: string }
  /** Make or read a file, by `bridge.ros`; JSON and the files' bytes, answered by `converted`. */
  | { kind: "convert"; id: number; request: string; files: readonly ArrayBuffer[] }
  | { kind: "stdlib"; bytes: ArrayBuffer }
  | { kind: "package"; name: string; bytes: ArrayBuffer };

/** What the judge is told to begin with. The judge never runs any of the program. */
export interface JudgeRequest {
  lesson: string;
  task: string;
  /** The text of check.py. */
  check: string;
  program: string;
  /** What the learner began with: causes speak only of what has been written since. */
  starter: string;
  /** The lesson's own worlds, which a check may name. */
  worlds: readonly World[];
}

/** The longest texts that a judge and a performer may send [characters]. */
export const MOST_STEP = 16_000_000;
export const MOST_RESULT = 200_000_000;

export type DeathReason = "recursion" | "fatal" | "internal";

export type FromWorker =
  /** The interpreter is up and answers the messages above. */
  | { kind: "ready" }
  | { kind: "imports"; id: number; missing: string[]; hasStdlib: boolean }
  /** Events since the last chunk; `points` is an Int16Array's buffer, transferred. */
  | { kind: "chunk"; id: number; events: string; points: ArrayBuffer }
  /** The program computes and no simulated time passes; on which of its lines, if that is known. */
  | { kind: "still"; id: number; line: number | null }
  /** The program has ended by itself; its trace holds an end event. */
  | { kind: "finished"; id: number }
  /** The judge wants jobs done, or gives the mark: `readStep` reads it. */
  | { kind: "step"; id: number; step: string }
  /** The run of a job has come to this simulated time [s]. */
  | { kind: "beat"; id: number; t: number }
  /** A job is done: its result as JSON, with the trace of the run. */
  | { kind: "performed"; id: number; result: string }
  /** What was asked for by `convert`, as JSON and, if there are some, bytes; transferred. */
  | { kind: "converted"; id: number; answer: string; bytes: ArrayBuffer | null }
  /**
   * The interpreter can't be used any more: `recursion`, calls went deeper than the engine allows;
   * `fatal`, it broke down; `internal`, a fault of ours. `line` is the program's, if it is known;
   * `message` has all that is known.
   */
  | {
      kind: "died";
      id: number | null;
      reason: DeathReason;
      line: number | null;
      message: string;
    };

/** Is this a message that a worker may send? Its shape and bounds, not its truth. */
export function isFromWorker(value: unknown): value is FromWorker {
  if (typeof value !== "object" || value === null || !("kind" in value)) return false;
  const message = value as Record<string, unknown>;
  const hasId = typeof message.id === "number";
  switch (message.kind) {
    case "ready":
      return true;
    case "imports":
      return (
        hasId &&
        typeof message.hasStdlib === "boolean" &&
        Array.isArray(message.missing) &&
        message.missing.every((name) => typeof name === "string")
      );
    case "chunk":
      return hasId && typeof message.events === "string" && message.points instanceof ArrayBuffer;
    case "still":
      return hasId && (message.line === null || Number.isSafeInteger(message.line));
    case "finished":
      return hasId;
    case "beat":
      return hasId && Number.isFinite(message.t);
    case "step":
      return hasId && isText(message.step, MOST_STEP);
    case "performed":
      return hasId && isText(message.result, MOST_RESULT);
    case "converted":
      return (
        hasId &&
        isText(message.answer, MOST_RESULT) &&
        (message.bytes === null || message.bytes instanceof ArrayBuffer)
      );
    case "died":
      return (
        (hasId || message.id === null) &&
        typeof message.message === "string" &&
        (typeof message.line === "number" || message.line === null) &&
        ["recursion", "fatal", "internal"].includes(message.reason as string)
      );
    default:
      return false;
  }
}

function isText(value: unknown, most: number): boolean {
  return typeof value === "string" && value.length <= most;
}
