/**
 * Steps back and forth through the states of something that is being made. A movement that is made
 * of many small changes is one step: they share a key. Imports nothing of ours.
 */

/** Further back than this nobody goes. */
const MOST_STEPS = 300;

export class History<State> {
  #now: State;
  #before: State[] = [];
  #after: State[] = [];
  /** What the last step belongs to; null: the next change is a step of its own. */
  #key: string | null = null;

  constructor(now: State) {
    this.#now = now;
  }

  get now(): State {
    return this.#now;
  }

  get canUndo(): boolean {
    return this.#before.length > 0;
  }

  get canRedo(): boolean {
    return this.#after.length > 0;
  }

  /** A change. With the key of the change before, both are one step. */
  change(next: State, key: string | null = null): void {
    if (key === null || key !== this.#key) {
      this.#before.push(this.#now);
      if (this.#before.length > MOST_STEPS) this.#before.shift();
    }
    this.#key = key;
    this.#now = next;
    this.#after = [];
  }

  /** Another look at the same state: no step. */
  show(now: State): void {
    this.#now = now;
  }

  /** What comes next is a step of its own, whatever its key. */
  settle(): void {
    this.#key = null;
  }

  /** Takes back the step of this key, if it is the last one, as if it had not been begun. */
  abandon(key: string): void {
    if (this.#key === key) this.#now = this.#before.pop() ?? this.#now;
    this.#key = null;
  }

  undo(): boolean {
    return this.#go(this.#before, this.#after);
  }

  redo(): boolean {
    return this.#go(this.#after, this.#before);
  }

  #go(from: State[], to: State[]): boolean {
    const next = from.pop();
    this.#key = null;
    if (next === undefined) return false;
    to.push(this.#now);
    this.#now = next;
    return true;
  }
}
