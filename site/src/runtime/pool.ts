/**
 * The page's workers: spares that are ready, most often one, and those that are running a program.
 *
 * A worker runs one program and is thrown away, so nothing leaks from one run to the next, and
 * stopping is ending the worker: no shared memory, no special headers, works against any loop.
 */
import workerUrl from "../worker/worker.ts?worker&url";
import { type Boot, type FromWorker, isFromWorker, type ToWorker } from "./messages.ts";
import { isOfLoading, NotLoaded, refresh } from "./scripts.ts";
import { startWorker } from "./worker-frame.ts";

/** What one needs of an interpreter to work with it. */
export interface Partner {
  /** From now on messages go to this listener; only one listens at a time. */
  listen(listener: (message: FromWorker) => void): void;
  send(message: ToWorker): void;
  /** End it at once, whatever it is doing. */
  end(): void;
}

/** Where work gets its interpreters. */
export interface Workers {
  /** A spare, as soon as it is ready; nobody else gets it. */
  take(): Promise<Partner>;
  /** Have the next one on its way. */
  prepare(): Promise<void>;
  /** On a small device no interpreter is started while another works, unless one waits for the other. */
  readonly oneAtATime: boolean;
}

/** One interpreter in its worker. */
export class Interpreter implements Partner {
  readonly ready: Promise<void>;
  #worker: Worker;
  #port: MessagePort;
  #listener: (message: FromWorker) => void = () => {};

  constructor(boot: Boot, worker: Worker) {
    const channel = new MessageChannel();
    this.#port = channel.port1;
    this.#worker = worker;
    this.ready = new Promise((resolve, reject) => {
      this.#listener = (message) => {
        if (message.kind === "ready") resolve();
        if (message.kind === "died") reject(new Error(message.message));
      };
      this.#worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error(event.message || "The worker's script could not be loaded"));
      };
    });
    this.ready.catch(() => {});
    this.#port.onmessage = (event: MessageEvent<unknown>) => {
      if (isFromWorker(event.data)) this.#listener(event.data);
    };
    this.#worker.postMessage(boot, [channel.port2]);
  }

  listen(listener: (message: FromWorker) => void): void {
    this.#listener = listener;
  }

  send(message: ToWorker): void {
    this.#port.postMessage(message);
  }

  end(): void {
    this.#listener = () => {};
    this.#port.close();
    this.#worker.terminate();
  }
}

export class Pool {
  #boot: () => Promise<Boot>;
  /** Ready or on their way, the first to be ready first. */
  #spares: Promise<Interpreter>[] = [];
  #wanted = 1;

  /** @param boot gives what a new worker is handed */
  constructor(boot: () => Promise<Boot>) {
    this.#boot = boot;
  }

  /** So many spares are to be held from now on; there is one unless more are asked for. */
  hold(count: number): void {
    this.#wanted = count;
    for (const surplus of this.#spares.splice(count)) {
      surplus.then(
        (interpreter) => interpreter.end(),
        () => {},
      );
    }
  }

  /**
   * Have the spares on their way. Resolves when `count` of those held are ready; rejects if they
   * can't be started.
   */
  async prepare(count = 1): Promise<void> {
    this.#spares[0] ??= this.start();
    const spare = this.#spares[0];
    try {
      await spare;
    } catch (error) {
      this.#spares = this.#spares.filter((one) => one !== spare);
      throw error;
    }
    // One after the other: side by side each would take longer, the first as well.
    this.#addNext();
    await Promise.all(this.#spares.slice(0, count));
  }

  #addNext(): void {
    if (this.#spares.length >= this.#wanted) return;
    const next = this.start();
    this.#spares.push(next);
    next.then(
      () => this.#addNext(),
      () => {
        this.#spares = this.#spares.filter((one) => one !== next);
      },
    );
  }

  /** A spare, as soon as it is ready. Nobody else gets it; call `prepare` for the next one. */
  async take(): Promise<Interpreter> {
    return this.#spares.shift() ?? this.start();
  }

  /** A new interpreter that is nobody's spare. */
  async start(): Promise<Interpreter> {
    const boot = await this.#boot();
    try {
      return await begun(boot);
    } catch (error) {
      if (!isOfLoading(error)) throw error;
      const scripts = LOADED.map((name) => `${boot.pyodideUrl}${name}`);
      const wrong = await refresh([WORKER, ...scripts]);
      try {
        return await begun(boot);
      } catch (again) {
        throw new NotLoaded(wrong ?? (again instanceof Error ? again.message : String(again)));
      }
    }
  }
}

/** The worker's own script, and what it loads of Pyodide. */
const WORKER = new URL(workerUrl, import.meta.url).href;
const LOADED = ["pyodide.mjs", "pyodide.asm.mjs"];

/** A new interpreter, once it is ready. */
async function begun(boot: Boot): Promise<Interpreter> {
  const interpreter = new Interpreter(boot, await startWorker(WORKER));
  try {
    await interpreter.ready;
  } catch (error) {
    interpreter.end();
    throw error;
  }
  return interpreter;
}
