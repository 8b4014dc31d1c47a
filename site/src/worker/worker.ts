/**
 * The worker: one interpreter, for one piece of work (a run, or a judge or a job of a marking).
 * Loads Pyodide, then passes messages between the page and `py/bridge`. May import
 * `runtime/messages` only; has no DOM.
 *
 * The port to the page lives in this module's closure, where Python can't reach it: a message on
 * the worker's own channel is nothing to anybody.
 */
import type { PyodideAPI } from "pyodide";
import type { Boot, FromWorker, ToWorker } from "../runtime/messages.ts";
import { type Sealed, seal, startInterpreter, writePythonStack } from "./interpreter.ts";
import { LastWords } from "./last-words.ts";
import { undoFilters } from "./png-rows.ts";

/** `bridge.session`, as far as it is called from here. */
interface Session {
  missing_modules(program: string): { toJs(): string[]; destroy(): void };
  run(
    program: string,
    worldJson: string,
    seed: number,
    limitsJson: string,
    send: (events: string, points: PythonBytes) => void,
    begin: (t: number, stream: string) => void,
    keep: (text: string) => void,
    still: (line: number) => void,
  ): void;
}

/** `bridge.marking`, as far as it is called from here. */
interface Marking {
  perform(job: string, program: string, beat: (t: number) => void, look: () => void): string;
}

/** `bridge.ros`, as far as it is called from here. */
interface Ros {
  convert(
    request: string,
    files: readonly Uint8Array[],
    send: (answer: string, bytes: PythonBytes | undefined) => void,
    undo: (rows: PythonBytes, rowBytes: number, pixelBytes: number) => void,
  ): void;
}

/** Bytes in Python's memory, lent for the time of a call. */
interface PythonBytes {
  getBuffer(type: "u8"): { data: Uint8Array; release(): void };
}

/** `bridge.judging`, which is there only if the page has sent it. */
interface Judging {
  Judge(request: string): Judge;
}

interface Judge {
  hear(result: string): void;
  step(): string;
}

type MarkingMessage = Extract<ToWorker, { kind: "judge" | "results" | "perform" }>;

self.onmessage = (event: MessageEvent<Boot>) => {
  self.onmessage = null;
  const port = event.ports[0];
  if (port) new Interpreter(port, event.data);
};

class Interpreter {
  #port: MessagePort;
  /** Bound at the start, so that nothing a program does can change what is sent. */
  #post: (message: FromWorker, transfer: Transferable[]) => void;
  #pyodide: PyodideAPI | null = null;
  #sealed: Sealed | null = null;
  #session: Session | null = null;
  #judge: Judge | null = null;
  #hasStdlib: boolean;
  #runId: number | null = null;
  #unsent = new Unsent();
  #lastWords = new LastWords();

  constructor(port: MessagePort, boot: Boot) {
    this.#port = port;
    this.#post = port.postMessage.bind(port);
    this.#hasStdlib = boot.stdlib !== null;
    this.#start(boot).catch((error: unknown) => this.#fail(error));
  }

  async #start(boot: Boot): Promise<void> {
    const pyodide = await startInterpreter(boot, this.#lastWords);
    this.#pyodide = pyodide;
    this.#session = pyodide.pyimport("bridge.session") as Session;
    const sealed = seal(pyodide, this.#lastWords);
    this.#sealed = sealed;
    this.#port.onmessage = (event: MessageEvent<ToWorker>) => this.#receive(event.data);
    this.#send({ kind: "ready" });
  }

  #receive(message: ToWorker): void {
    const pyodide = this.#pyodide;
    const sealed = this.#sealed;
    const session = this.#session;
    if (!pyodide || !sealed || !session) return;
    try {
      if (message.kind === "stdlib") {
        if (!this.#hasStdlib) sealed.installStdlib(message.bytes);
        this.#hasStdlib = true;
      } else if (message.kind === "package") {
        sealed.installWheel(message.bytes);
      } else if (message.kind === "inspect") {
        const names = session.missing_modules(message.program);
        const missing = names.toJs();
        names.destroy();
        this.#send({ kind: "imports", id: message.id, missing, hasStdlib: this.#hasStdlib });
      } else if (message.kind === "run") {
        this.#run(sealed, session, message);
      } else if (message.kind === "convert") {
        this.#convert(sealed.module("bridge.ros") as Ros, message);
      } else {
        this.#mark(sealed, message);
      }
    } catch (error) {
      this.#fail(error);
    }
  }

  #convert(ros: Ros, { id, request, files }: Extract<ToWorker, { kind: "convert" }>): void {
    ros.convert(
      request,
      files.map((file) => new Uint8Array(file)),
      (answer, lent) => {
        const bytes = lent ? withData(lent, (data) => data.slice().buffer as ArrayBuffer) : null;
        this.#send({ kind: "converted", id, answer, bytes }, bytes ? [bytes] : []);
      },
      (rows, rowBytes, pixelBytes) =>
        withData(rows, (data) => undoFilters(data, rowBytes, pixelBytes)),
    );
  }

  #run(sealed: Sealed, session: Session, request: Extract<ToWorker, { kind: "run" }>): void {
    const { id } = request;
    this.#runId = id;
    sealed.lookAtTheClock();
    session.run(
      request.program,
      JSON.stringify(request.world),
      request.seed,
      JSON.stringify(request.limits),
      (events, points) => {
        const buffer = withData(points, (data) => data.slice().buffer as ArrayBuffer);
        this.#unsent.clear();
        this.#send({ kind: "chunk", id, events, points: buffer }, [buffer]);
      },
      (t, stream) => this.#unsent.begin(t, stream),
      (text) => this.#unsent.keep(text),
      (line) => this.#send({ kind: "still", id, line }),
    );
    this.#send({ kind: "finished", id });
    this.#runId = null;
  }

  #mark(sealed: Sealed, message: MarkingMessage): void {
    const { id } = message;
    if (message.kind === "perform") {
      const marking = sealed.module("bridge.marking") as Marking;
      const beat = (t: number): void => this.#send({ kind: "beat", id, t });
      const result = marking.perform(message.job, message.program, beat, () =>
        sealed.lookAtTheClock(),
      );
      this.#send({ kind: "performed", id, result });
      return;
    }
    if (message.kind === "judge") {
      const judging = sealed.module("bridge.judging") as Judging;
      this.#judge = judging.Judge(message.request);
    } else for (const result of message.results) this.#judge?.hear(result);
    if (!this.#judge) throw new Error("results came before there was a judge to hear them");
    this.#send({ kind: "step", id, step: this.#judge.step() });
  }

  /** Tell the page what broke. The interpreter is not used again after this. */
  #fail(error: unknown): void {
    const message = error instanceof Error ? `${error.name}: ${error.message}` : String(error);
    // Python's own exceptions are faults of ours (a learner's come out in the trace); anything
    // else, such as a stack that overflowed or a failed assertion, has killed the interpreter.
    const ours = error instanceof Error && error.name === "PythonError";
    if (!ours && this.#pyodide) writePythonStack(this.#pyodide);
    if (this.#runId !== null) {
      const events = JSON.stringify(this.#unsent.rows());
      this.#send({ kind: "chunk", id: this.#runId, events, points: new ArrayBuffer(0) });
    }
    const detail = error instanceof Error && error.stack ? error.stack : message;
    this.#send({
      kind: "died",
      id: this.#runId,
      reason: ours ? "internal" : stackOverflowed(message) ? "recursion" : "fatal",
      line: this.#lastWords.line,
      message: ours ? message : `${detail}\n${this.#lastWords}`,
    });
  }

  #send(message: FromWorker, transfer: Transferable[] = []): void {
    this.#post(message, transfer);
  }
}

/** What a program has printed and the page has not been sent: `bridge.kept` tells of it. */
class Unsent {
  #prints: { t: number; stream: string; texts: string[] }[] = [];

  begin(t: number, stream: string): void {
    this.#prints.push({ t, stream, texts: [] });
  }

  keep(text: string): void {
    this.#prints.at(-1)?.texts.push(text);
  }

  /** All has been sent; what comes next may still be at the same time. */
  clear(): void {
    this.#prints = this.#prints.slice(-1);
    for (const print of this.#prints) print.texts = [];
  }

  /** As rows of the trace. */
  rows(): unknown[][] {
    return this.#prints
      .filter(({ texts }) => texts.length > 0)
      .map(({ t, stream, texts }) => ["print", t, stream, texts.join("")]);
  }
}

/** The three engines' words for a JavaScript stack that is full. */
function stackOverflowed(message: string): boolean {
  return /call stack|recursion/i.test(message);
}

function withData<Result>(lent: PythonBytes, use: (data: Uint8Array) => Result): Result {
  const buffer = lent.getBuffer("u8");
  try {
    return use(buffer.data);
  } finally {
    buffer.release();
  }
}
