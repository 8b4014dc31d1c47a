/**
 * Printed text as lines, the last of them only: a program may print two million characters, and
 * the reader may drag through all of them. May import `trace` and `ui`.
 */
import { Column } from "../trace/columns.ts";
import type { ConsoleEntry, Print } from "../trace/events.ts";
import { consoleWords as words } from "../ui/view-words.ts";

/** No more lines than this are shown at a time, … */
export const MOST_LINES = 1000;
/** … nor more characters: one line may be very long. */
export const MOST_CHARACTERS = 100_000;

export interface Piece {
  stream: Print["stream"] | "note";
  text: string;
}

export interface PrintedLine {
  /** Counted from 0 at the start of the run. */
  number: number;
  pieces: Piece[];
}

export class ConsoleLines {
  readonly #entries: readonly ConsoleEntry[];
  /** How many lines had ended before each entry, and after the last. */
  readonly #ended = new Column();

  constructor(entries: readonly ConsoleEntry[]) {
    this.#entries = entries;
    this.#ended.push(0);
  }

  /** The last lines after the first `count` entries; their numbers say how many came before. */
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
      const stream = streamOf(this.#entries[i] as ConsoleEntry);
      const text = this.#text(i);
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

  /** An entry as it stands in the console: a note has a line to itself. */
  #text(index: number): string {
    const entry = this.#entries[index];
    if (!entry) return "";
    if ("stream" in entry) return entry.text;
    const before = this.#entries[index - 1];
    const midLine = before && "stream" in before && !before.text.endsWith("\n");
    return `${midLine ? "\n" : ""}${words.note(entry.line, entry.text)}\n`;
  }

  #readNew(): void {
    for (let i = this.#ended.length - 1; i < this.#entries.length; i++) {
      this.#ended.push(this.#ended.at(i) + newlines(this.#text(i)));
    }
  }
}

function streamOf(entry: ConsoleEntry): Piece["stream"] {
  return "stream" in entry ? entry.stream : "note";
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
