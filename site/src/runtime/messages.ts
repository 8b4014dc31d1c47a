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
  /** Where pyodide.mjs lies; absolute. */
  pyodideUrl: string;
  /** The compiled interpreter, shared by every worker of the page. */
  module: WebAssembly.Module;
  /** Memory of the started interpreter, or null for a plain start. */
  snapshot: ArrayBuffer | null;
  /** The standard library archive; null while it is still on its way (with a snapshot only). */
  stdlib: ArrayBuffer | null;
  /** Our Python sources: path below site-packages -> text. */
  sources: Record<string, string>;
}

export interface Limits {
  /** Simulated seconds. */
  simulated_s: number;
  /** Seconds of computing with no simulated time passing. */
  silent_s: number;
  print_bytes: number;
  trace_bytes: number;
}

export interface RunRequest {
  program: string;
  world: World;
  seed: number;
  limits?: Partial<Limits>;
}

export type ToWorker =
  | ({ kind: "run"; id: number } & RunRequest)
  | { kind: "stdlib"; bytes: ArrayBuffer }
  | { kind: "package"; name: string; bytes: ArrayBuffer };

export type FromWorker =
  /** The interpreter is up and answers `run`. */
  | { kind: "ready" }
  /** Events since the last chunk; `points` is an Int16Array's buffer, transferred. */
  | { kind: "chunk"; id: number; events: string; points: ArrayBuffer }
  /** The program has ended by itself; its trace holds an end event. */
  | { kind: "finished"; id: number }
  /** The program is about to import a package that is not loaded yet. */
  | { kind: "need"; id: number; name: "numpy" | "stdlib" }
  /** The interpreter died; `message` is the runtime's own. */
  | { kind: "died"; id: number | null; message: string }
  /** A fault of ours, with everything we know. */
  | { kind: "internal_error"; id: number | null; message: string };
