/**
 * The marks of one task: marks the learner's program, one marking at a time, and knows how the last
 * one stands. Dispatches "change". May import `runtime` and `trace`.
 */
import type { JudgeRequest, Marking, MarkProgress, Runtime } from "../runtime/client.ts";
import type { Performance } from "../runtime/marker.ts";
import type { Mark, Where } from "../runtime/marks.ts";
import { runOf } from "../runtime/performed-run.ts";
import type { Trace } from "../trace/trace.ts";
import { emptyTrace } from "./empty-trace.ts";

/** Interpreters to have ready while marking: each job uses one up. */
const SPARES = 3;

export type MarkingPhase = "none" | "marking" | "marked" | "cancelled" | "failed";

/** A mark, and what it was given for. */
export interface Marks {
  mark: Mark;
  program: string;
}

/** Where a check failed, ready to be drawn. */
export interface Shown {
  trace: Trace;
  isRun: boolean;
}

export class TaskMarking extends EventTarget {
  readonly #runtime: Pick<Runtime, "mark" | "expect">;
  #phase: MarkingPhase = "none";
  #marking: Marking | null = null;
  #progress: MarkProgress | null = null;
  #note: string | null = null;
  #marks: Marks | null = null;
  #performances: readonly Performance[] = [];
  readonly #shown = new WeakMap<Where, Shown>();
  #error: string | null = null;

  constructor(runtime: Pick<Runtime, "mark" | "expect">) {
    super();
    this.#runtime = runtime;
  }

  get phase(): MarkingPhase {
    return this.#phase;
  }

  /** How far the marking under way is; null before its first jobs are known. */
  get progress(): MarkProgress | null {
    return this.#progress;
  }

  /** What it waits for, in words, or null. */
  get note(): string | null {
    return this.#note;
  }

  /** The last mark there is; a cancelled marking leaves the one before. */
  get marks(): Marks | null {
    return this.#marks;
  }

  /** What went wrong on our side, or null. */
  get error(): string | null {
    return this.#error ?? this.#marks?.mark.ours ?? null;
  }

  /** The run that shows where a check failed, or, where there is none to show, the bare world. */
  shown(where: Where): Shown {
    const known = this.#shown.get(where);
    if (known) return known;
    const performance = this.#performances.find(({ job }) => job.id === where.job);
    const run = performance && this.#marks ? runOf(this.#marks.program, performance) : null;
    const shown = { trace: run ?? emptyTrace(where.world), isRun: run !== null };
    this.#shown.set(where, shown);
    return shown;
  }

  /** Marks a program; resolves to the mark, or null if it came to none. */
  async mark(request: JudgeRequest): Promise<Mark | null> {
    this.cancel();
    this.#runtime.expect(SPARES);
    const mine = this.#runtime.mark(request, {
      onProgress: (progress) => this.#hear(mine, { progress }),
      onNote: (note) => this.#hear(mine, { note }),
    });
    this.#marking = mine;
    this.#phase = "marking";
    this.#progress = null;
    this.#note = null;
    this.#error = null;
    this.#changed();
    const marked = await mine.done;
    if (this.#marking !== mine) return null;
    this.#marking = null;
    this.#runtime.expect(1);
    this.#phase = marked.kind;
    if (marked.kind === "marked") {
      this.#marks = { mark: marked.mark, program: request.program };
      this.#performances = marked.performances;
    }
    if (marked.kind === "failed") this.#error = marked.message;
    this.#changed();
    return marked.kind === "marked" ? marked.mark : null;
  }

  /** Ends the marking under way. */
  cancel(): void {
    this.#marking?.cancel();
  }

  #hear(from: Marking, { progress, note }: { progress?: MarkProgress; note?: string }): void {
    if (this.#marking !== from) return;
    if (progress) this.#progress = progress;
    this.#note = note ?? null;
    this.#changed();
  }

  #changed(): void {
    this.dispatchEvent(new Event("change"));
  }
}
