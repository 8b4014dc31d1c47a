/**
 * One run, from the request to the last event of its trace, however it ends.
 *
 * The trace always gets an `end` event: from Python when the program ended by itself or met one of
 * Python's limits, from here when it was stopped, computed for too long, or broke the interpreter.
 */
import { FORMAT, type Header, KINDS, VERSION } from "../trace/events.ts";
import { Trace } from "../trace/trace.ts";
import { type Ending, explain, stillWords } from "./endings.ts";
import { DEFAULT_LIMITS, type FromWorker, type Limits, type RunRequest } from "./messages.ts";
import { type ModuleFiles, provideModules } from "./modules.ts";
import type { Partner, Workers } from "./pool.ts";

export interface RunListeners {
  /** The trace has grown. */
  onChunk?(trace: Trace): void;
  /** Something to show while waiting, such as "Loading NumPy: 40 % of 3.1 MB"; null: no more. */
  onNote?(text: string | null): void;
}

export class Run {
  readonly done: Promise<Trace>;
  readonly #request: RunRequest;
  readonly #limits: Limits;
  readonly #listeners: RunListeners;
  readonly #workers: Workers;
  readonly #modules: ModuleFiles;
  readonly #trace: Trace;
  #interpreter: Partner | null = null;
  #end: (ending: Ending) => void = () => {};
  #ended = false;
  /** Whether the page has been told that time stands still, and the line if it is known. */
  #isStill = false;
  #stillOn: number | null = null;

  constructor(
    request: RunRequest,
    listeners: RunListeners,
    workers: Workers,
    modules: ModuleFiles,
  ) {
    this.#request = request;
    this.#limits = { ...DEFAULT_LIMITS, ...request.limits };
    this.#listeners = listeners;
    this.#workers = workers;
    this.#modules = modules;
    this.#trace = new Trace(headerOf(request));
    this.done = this.#carryOut();
  }

  /** What the run has left so far. */
  get trace(): Trace {
    return this.#trace;
  }

  /** End the run now; what it has left so far is kept. Nothing happens if it has ended. */
  stop(): void {
    this.#end({ kind: "stopped" });
  }

  async #carryOut(): Promise<Trace> {
    const ended = new Promise<Ending>((resolve) => {
      this.#end = resolve;
    });
    const watch = new Watch(this.#limits.silent_s, {
      onStill: () => this.#tellOfStandstill(null),
      onSilent: () => this.#end({ kind: "silent", line: this.#stillOn }),
    });
    this.#begin(watch).catch((error: unknown) => this.#end(ourFault(error)));
    const ending = await ended;
    watch.end();
    this.#ended = true;
    this.#interpreter?.end();
    // A failure to have the next one ready shows when it is needed.
    this.#workers.prepare().catch(() => {});
    if (!this.#trace.complete) this.#trace.append(explain(ending, this.#trace, this.#limits));
    this.#listeners.onChunk?.(this.#trace);
    return this.#trace;
  }

  async #begin(watch: Watch): Promise<void> {
    let interpreter: Partner;
    try {
      interpreter = await this.#workers.take();
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      this.#end({ kind: "unloaded", message });
      return;
    }
    if (this.#ended) {
      interpreter.end();
      return;
    }
    this.#interpreter = interpreter;
    const { program, world, seed } = this.#request;
    const note = (text: string) => this.#listeners.onNote?.(text);
    const died = await provideModules(interpreter, program, this.#modules, note);
    if (died) this.#end(died);
    // Ended meanwhile, and the interpreter with it: it must not be spoken to.
    if (died || this.#ended) return;
    interpreter.listen((message) => this.#receive(message, watch));
    interpreter.send({ kind: "run", id: 0, program, world, seed, limits: this.#limits });
    watch.begin(() => {
      if (!this.#workers.oneAtATime) this.#workers.prepare().catch(() => {});
    });
  }

  #receive(message: FromWorker, watch: Watch): void {
    if (message.kind === "chunk") {
      const before = this.#trace.duration;
      try {
        this.#trace.append({ events: message.events, points: new Int16Array(message.points) });
      } catch (error) {
        this.#end(ourFault(error));
        return;
      }
      if (this.#trace.duration > before) {
        watch.restart();
        this.#timePasses();
      }
      this.#listeners.onChunk?.(this.#trace);
    } else if (message.kind === "still") {
      this.#tellOfStandstill(message.line);
    } else if (message.kind === "finished") {
      this.#end({ kind: "finished" });
    } else if (message.kind === "died") {
      this.#end(message);
    }
  }

  #tellOfStandstill(line: number | null): void {
    if (this.#isStill && line === null) return;
    this.#isStill = true;
    this.#stillOn = line;
    this.#listeners.onNote?.(stillWords(line));
  }

  #timePasses(): void {
    if (!this.#isStill) return;
    this.#isStill = false;
    this.#stillOn = null;
    this.#listeners.onNote?.(null);
  }
}

/** Python tells of a standstill with its line; when it can't, because of a long calculation in C: */
const STILL_MS = 5000;

/** A spare is started once a run has lasted this long, so that a short run has the machine. */
const LONG_RUN_MS = 300;

/** Watches over a run in real time: says when it is a long one, and when it has gone silent. */
class Watch {
  readonly #silentMs: number;
  readonly #tell: { onStill(): void; onSilent(): void };
  #still: ReturnType<typeof setTimeout> | undefined;
  #silence: ReturnType<typeof setTimeout> | undefined;
  #long: ReturnType<typeof setTimeout> | undefined;
  #begun = false;

  constructor(silentSeconds: number, tell: { onStill(): void; onSilent(): void }) {
    this.#silentMs = silentSeconds * 1000;
    this.#tell = tell;
  }

  begin(onLong: () => void): void {
    this.#begun = true;
    this.#long = setTimeout(onLong, LONG_RUN_MS);
    this.restart();
  }

  restart(): void {
    clearTimeout(this.#silence);
    clearTimeout(this.#still);
    if (!this.#begun) return;
    this.#silence = setTimeout(() => this.#tell.onSilent(), this.#silentMs);
    this.#still = setTimeout(() => this.#tell.onStill(), STILL_MS);
  }

  end(): void {
    this.#begun = false;
    clearTimeout(this.#silence);
    clearTimeout(this.#still);
    clearTimeout(this.#long);
  }
}

function ourFault(error: unknown): Ending {
  return { kind: "died", reason: "internal", line: null, message: String(error) };
}

function headerOf(request: RunRequest): Header {
  const { program, world, seed } = request;
  return { format: FORMAT, version: VERSION, program, world, seed, kinds: KINDS };
}
