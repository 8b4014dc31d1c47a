/**
 * The page's workers: spares that are ready, most often one, and those that are running a program.
 *
 * A worker runs one program and is thrown away, so nothing leaks from one run to the next, and
 * stopping is ending the worker: no shared memory, no special headers, works against any loop.
 */
import workerUrl from "../worker/worker.ts?worker&url";
import { type Boot, type FromWorker, isFromWorker, type ToWorker } from "./messages.ts";
import { isOfLoading, NotLoaded, refresh } from "./scripts.ts";

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

  constructor(boot: Boot) {
    const channel = new MessageChannel();
    this.#port = channel.port1;
    this.#worker = startWorker();
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
  const interpreter = new Interpreter(boot);
  try {
    await interpreter.ready;
  } catch (error) {
    interpreter.end();
    throw error;
  }
  return interpreter;
}

/**
 * A worker whose script is a `blob:` inherits the page's Content-Security-Policy in every engine;
 * one that is started from a URL would have none on a host that can't send headers.
 *
 * The script is had by import(): without a network Firefox asks the service worker for those, not for
 * what a blob's `import` names. A message that comes before the script is held for it.
 */
function startWorker(): Worker {
  const url = JSON.stringify(WORKER);
  const script = `
    let early = null;
    self.onmessage = (event) => { early = event; };
    import(${url}).then(
      () => { const held = early; early = null; if (held) self.onmessage(held); },
      (error) => setTimeout(() => { throw error; }),
    );`;
  const blobUrl = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  const worker = new Worker(blobUrl, { type: "module", name: "Python" });
  // The worker has taken its script by the time it says anything, and no later.
  setTimeout(() => URL.revokeObjectURL(blobUrl), 60_000);
  return worker;
}
