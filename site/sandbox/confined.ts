/**
 * The site's own Python worker as a process of Node, shut in: the same start, the same
 * lock-down and, around them, Node's fences. May import `src/worker` and Node's own modules.
 *
 * Everything is read from the disk here, before any program is known; `site/build/sandbox.mjs`
 * bundles the script that imports this and puts what is read beside it.
 */
import { readFileSync } from "node:fs";
import { type Sealed, seal, startInterpreter } from "../src/worker/interpreter.ts";
import { LastWords } from "../src/worker/last-words.ts";
import { closeGlobals, closeNetwork } from "./node-fences.mjs";
import { timeHad } from "./time-had.mjs";

export interface Confined {
  sealed: Sealed;
  /** NumPy's archive, for programs that import it. */
  numpy: ArrayBuffer;
  lastWords: LastWords;
}

const folder = new URL(".", import.meta.url);

/** @param imports modules of ours that are to be at hand; none can be imported from JavaScript later */
export async function startConfined(imports: readonly string[]): Promise<Confined> {
  const lastWords = new LastWords();
  const numpy = read("numpy.whl");
  const stdlib = read("stdlib.zip");
  const snapshot = new Blob([read("snapshot.bin")]);
  const module = await WebAssembly.compile(read("interpreter.wasm"));
  poseAsWorker();
  countTimeHad();
  closeNetwork();
  closeGlobals((text) => lastWords.hear(text));
  const pyodide = await startInterpreter(
    // Our sources are in the snapshot; nothing shows their lines to a learner.
    { kind: "boot", pyodideUrl: `${folder}loader/`, module, snapshot, stdlib, sources: {} },
    lastWords,
  );
  for (const name of imports) pyodide.pyimport(name);
  return { sealed: seal(pyodide, lastWords), numpy, lastWords };
}

/** A file beside this script, as a buffer of its own. */
function read(name: string): ArrayBuffer {
  return new Uint8Array(readFileSync(new URL(name, folder))).buffer;
}

/** Limits inside are of computing: what others keep the process waiting does not count. */
function countTimeHad(): void {
  const wall = performance.now.bind(performance);
  const usage = process.cpuUsage.bind(process);
  const processor = (): number => {
    const { user, system } = usage();
    return (user + system) / 1000;
  };
  Object.defineProperty(performance, "now", { value: timeHad(wall, processor) });
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
