/**
 * What a dying interpreter says. When Python breaks beyond repair, it writes the Python stack
 * to its error output, and only there: it is kept here, for the learner's line and for us.
 * Imports nothing of ours.
 */

const MOST_LINES = 100;

export class LastWords {
  #lines: string[] = [];

  hear(line: string): void {
    if (this.#lines.length < MOST_LINES) this.#lines.push(line);
  }

  /** The innermost line of the program on the stack that was written, if there was one. */
  get line(): number | null {
    for (const text of this.#lines) {
      const found = /File "program\.py", line (\d+)/.exec(text);
      if (found) return Number(found[1]);
    }
    return null;
  }

  toString(): string {
    return this.#lines.join("\n");
  }
}
