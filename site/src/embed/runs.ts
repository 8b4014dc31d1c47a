/**
 * The runs that a host's page waits for. Each settles, whatever becomes of the frame. Imports the
 * outcome's type.
 */
import type { Outcome } from "../trace/events.ts";

interface Waiting {
  resolve(outcome: Outcome): void;
  reject(error: Error): void;
}

export class HostRuns {
  readonly #waiting = new Map<number, Waiting>();
  #count = 0;

  get any(): boolean {
    return this.#waiting.size > 0;
  }

  /** A run of its own number, which `ask` carries to the lab. */
  begin(ask: (id: number) => void): Promise<Outcome> {
    this.#count += 1;
    const id = this.#count;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      ask(id);
    });
  }

  end(id: number, outcome: Outcome): void {
    this.#waiting.get(id)?.resolve(outcome);
    this.#waiting.delete(id);
  }

  fail(id: number, why: string): void {
    this.#waiting.get(id)?.reject(new Error(`<bugbot-lab>: ${why}`));
    this.#waiting.delete(id);
  }

  failAll(why: string): void {
    for (const id of [...this.#waiting.keys()]) this.fail(id, why);
  }
}
