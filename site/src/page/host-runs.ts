/**
 * Runs that the page around a lab asks for, as fast as it likes: the newest counts, and each comes to
 * an outcome. Knows no element. May import types of `trace`.
 */
import type { Outcome } from "../trace/events.ts";

export interface HostRunsLab {
  /** Resolves when a run would start at once; rejects if none can. */
  ready(): Promise<void>;
  run(): Promise<Outcome>;
  stop(): void;
  /** What a run that was stopped before its first step has come to. */
  unbegun(): Outcome;
}

export interface HostRunsListeners {
  onOutcome(id: number, outcome: Outcome): void;
  onFailed(id: number, message: string): void;
}

export class HostRuns {
  readonly #lab: HostRunsLab;
  readonly #listeners: HostRunsListeners;
  /** The run to begin next. */
  #next: number | null = null;
  #isBusy = false;

  constructor(lab: HostRunsLab, listeners: HostRunsListeners) {
    this.#lab = lab;
    this.#listeners = listeners;
  }

  /** Begins this run as soon as there is an interpreter for it; those before it have ended then. */
  ask(id: number): void {
    this.stop();
    this.#next = id;
    if (!this.#isBusy) void this.#carryOut();
  }

  /** Ends the run under way, and the one that has not begun. */
  stop(): void {
    if (this.#next !== null) this.#listeners.onOutcome(this.#next, this.#lab.unbegun());
    this.#next = null;
    this.#lab.stop();
  }

  async #carryOut(): Promise<void> {
    this.#isBusy = true;
    while (this.#next !== null) {
      // Each run uses an interpreter up: none is taken for one that is stopped by then. Where none can be
      // had, the run itself tells why.
      await this.#lab.ready().catch(() => {});
      if (this.#next === null) continue;
      const id = this.#next;
      this.#next = null;
      try {
        this.#listeners.onOutcome(id, await this.#lab.run());
      } catch (error) {
        this.#listeners.onFailed(id, error instanceof Error ? error.message : String(error));
      }
    }
    this.#isBusy = false;
  }
}
