/**
 * Printed text as lines, the last of them only: a program may print two million characters, and
 * the reader may drag through all of them. May import `trace`.
 */
import { Column } from "../trace/columns.ts";
import type { Print } from "../trace/events.ts";

/** No more lines than this are shown at a time, … */
export const MOST_LINES = 1000;
/** … nor more characters: one line may be very long. */
export const MOST_CHARACTERS = 100_000;

export interface Piece {
  stream: Print["stream"];
  text: string;
}

export interface PrintedLine {
  /** Counted from 0 at the start of the run. */
  number: number;
  pieces: Piece[];
}

export class ConsoleLines {
  readonly #prints: readonly Print[];
  /** How many lines had ended before each print, and after the last. */
  readonly #ended = new Column();

  constructor(prints: readonly Print[]) {
    this.#prints = prints;
    this.#ended.push(0);
  }

  /** The last lines after the first `count` prints; their numbers say how many came before. */
  after(count: number): PrintedLine[] {
    this.#readNew();
    const firstWanted = Math.max(0, this.#ended.at(count) - MOST_LINES);
    let from = count;
    let characters = 0;
    while (from > 0 && this.#ended.at(from) >= firstWanted && characters < MOST_CHARACTERS) {
      from -= 1;
      characters += this.#text(from).length;
    }
    const excess = Math.max(0, characters - MOST_CHARACTERS);
    const lines: PrintedLine[] = [];
    let number = this.#ended.at(from) + newlines(this.#text(from).slice(0, excess));
    for (let i = from; i < count; i++) {
      const { stream, text } = this.#prints[i] as Print;
      const parts = (i === from ? text.slice(excess) : text).split("\n");
      parts.forEach((part, k) => {
        if (k > 0) number += 1;
        const nothingYet = part === "" && k === parts.length - 1;
        if (number < firstWanted || nothingYet) return;
        const line = lineOf(lines, number);
        if (part !== "") line.pieces.push({ stream, text: part });
      });
    }
    return lines;
  }

  #text(index: number): string {
    return this.#prints[index]?.text ?? "";
  }

  #readNew(): void {
    for (let i = this.#ended.length - 1; i < this.#prints.length; i++) {
      this.#ended.push(this.#ended.at(i) + newlines(this.#text(i)));
    }
  }
}

/** The line of that number, the last or a new one. */
function lineOf(lines: PrintedLine[], number: number): PrintedLine {
  const last = lines.at(-1);
  if (last?.number === number) return last;
  const line: PrintedLine = { number, pieces: [] };
  lines.push(line);
  return line;
}

function newlines(text: string): number {
  let count = 0;
  for (let at = text.indexOf("\n"); at >= 0; at = text.indexOf("\n", at + 1)) count += 1;
  return count;
}
