/**
 * A process that does one job of a marking with one learner's program, and ends. It is the
 * site's own worker under Node: the same start, the same lock-down, the same Python; around it
 * stand Node's permission model and the limits that `grader.classes.sandbox` puts on the process.
 *
 *   in    one line of JSON {"job", "program"}, then the end of the input
 *   out   lines: "ready"; "beat T" as simulated time passes; then "result JSON", or "died WORDS"
 *         if the interpreter broke, or "failed WORDS" for a fault of ours
 *
 * Everything is read from the disk before the program is known. `site/build/sandbox.mjs` bundles
 * this file and puts what it reads beside it. May import `src/worker` and Node's own modules.
 */
import { readFileSync, writeSync } from "node:fs";
import { installWheel, startInterpreter } from "../src/worker/interpreter.ts";
import { LastWords } from "../src/worker/last-words.ts";
import { CLOSE_IMPORTS, lockDown } from "../src/worker/lockdown.ts";
import { closeGlobals, closeNetwork } from "./node-fences.mjs";

interface Session {
  missing_modules(program: string): { toJs(): string[] };
}

interface Marking {
  perform(job: string, program: string, beat: (t: number) => void): string;
}

const exit = process.exit.bind(process);
const lastWords = new LastWords();
const folder = new URL(".", import.meta.url);

/** One line to whoever started this process; a pipe may take it in parts. */
function say(text: string): void {
  let rest = new TextEncoder().encode(`${text}\n`);
  while (rest.length > 0) {
    try {
      rest = rest.subarray(writeSync(1, rest));
    } catch (error) {
      // The pipe is full: whoever reads it has not got on yet.
      if ((error as NodeJS.ErrnoException).code !== "EAGAIN") throw error;
    }
  }
}

/** A file beside this script, as a buffer of its own. */
function read(name: string): ArrayBuffer {
  return new Uint8Array(readFileSync(new URL(name, folder))).buffer;
}

/** Look like a worker in a page, which is what the interpreter's start expects. */
function poseAsWorker(): void {
  /** An answer with bytes in it; Node's own would bring its network code into the process. */
  class PlainResponse {
    readonly ok = true;
    readonly status = 200;
    #body: ArrayBuffer | Uint8Array<ArrayBuffer>;
    constructor(body: ArrayBuffer | Uint8Array<ArrayBuffer>) {
      this.#body = body;
    }
    async arrayBuffer(): Promise<ArrayBuffer> {
      return this.#body instanceof Uint8Array ? this.#body.slice().buffer : this.#body;
    }
  }
  class PlainRequest {}
  const worker = {
    self: globalThis,
    WorkerGlobalScope: Object,
    location: folder,
    Response: PlainResponse,
    Request: PlainRequest,
  };
  for (const [name, value] of Object.entries(worker)) {
    Object.defineProperty(globalThis, name, { value, writable: true, configurable: true });
  }
}

async function main(): Promise<void> {
  const numpy = read("numpy.whl");
  const stdlib = read("stdlib.zip");
  const snapshot = new Blob([read("snapshot.bin")]);
  const module = await WebAssembly.compile(read("interpreter.wasm"));
  poseAsWorker();
  closeNetwork();
  closeGlobals((text) => lastWords.hear(text));
  const pyodide = await startInterpreter(
    // Our sources are in the snapshot; nothing shows their lines to a learner.
    { kind: "boot", pyodideUrl: `${folder}loader/`, module, snapshot, stdlib, sources: {} },
    lastWords,
  );
  const session = pyodide.pyimport("bridge.session") as Session;
  const marking = pyodide.pyimport("bridge.marking") as Marking;
  pyodide.runPython(CLOSE_IMPORTS);
  lockDown();
  say("ready");

  const request: unknown = JSON.parse(readFileSync(0, "utf8"));
  const { job, program } = request as { job: object; program: string };
  if (session.missing_modules(program).toJs().includes("numpy")) installWheel(pyodide, numpy);
  say("begun");
  const beat = (t: number): void => say(`beat ${Number(t)}`);
  say(`result ${marking.perform(JSON.stringify(job), program, beat)}`);
}

try {
  await main();
} catch (error) {
  const { name, message } = error instanceof Error ? error : new Error(String(error));
  // As in the page's worker: Python's own exceptions are faults of ours, anything else broke it.
  const what = name === "PythonError" ? "failed" : "died";
  say(`${what} ${JSON.stringify(`${name}: ${message}\n${lastWords}`.slice(0, 4000))}`);
}
// Timers of the interpreter would keep the process waiting.
exit(0);
