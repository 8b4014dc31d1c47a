/**
 * A trace as a file, the same that `py/bugbot/trace.py` saves and loads: JSON lines, the header
 * first, a row per event, and last `["points", text]`, the store in base64, little-endian.
 * Imports the trace.
 */
import { decodeHeader, TraceError } from "./decode.ts";
import { KINDS, type TraceEvent } from "./events.ts";
import { Trace } from "./trace.ts";

/** Throws TraceError, naming the line and what is wrong with it. */
export function readTraceFile(text: string): Trace {
  const rows: unknown[] = [];
  const numbers: number[] = [];
  let trace: Trace | null = null;
  let points: Int16Array | null = null;
  let number = 0;
  for (const line of linesOf(text)) {
    number += 1;
    if (trace && line.trim() === "") continue;
    const where = `line ${number}`;
    if (!trace) {
      trace = new Trace(decodeHeader(parse(line, where), where));
      continue;
    }
    if (points) throw new TraceError(`${where}: there is more after the points, the last row`);
    const row = parse(line, where);
    if (Array.isArray(row) && row[0] === "points") {
      points = decodePoints(row, where);
    } else {
      rows.push(row);
      numbers.push(number);
    }
  }
  if (!trace || !points) {
    throw new TraceError("the points, the last row, are missing: the file is cut short");
  }
  trace.appendRows(rows, points, (i) => `line ${numbers[i] ?? number}`);
  return trace;
}

export function writeTraceFile(trace: Trace): string {
  const rows: string[] = [JSON.stringify(trace.header)];
  for (const event of trace.events()) rows.push(JSON.stringify(rowOf(event)));
  rows.push(JSON.stringify(["points", encodePoints(trace.pointBlocks())]));
  return `${rows.join("\n")}\n`;
}

/** `[kind, value, …]` with the values in the order of KINDS. */
function rowOf(event: TraceEvent): unknown[] {
  const values: Record<string, unknown> = { ...event };
  return [event.kind, ...KINDS[event.kind].map((field) => values[field])];
}

/** A run has 64 MB at most, and no row takes less than a few dozen bytes. */
const MOST_LINES = 3_000_000;

/** One after the other: a file may consist of millions. */
function* linesOf(text: string): Generator<string> {
  let start = 0;
  let count = 0;
  for (let end = text.indexOf("\n"); end >= 0; end = text.indexOf("\n", start)) {
    count += 1;
    if (count > MOST_LINES) throw new TraceError(`line ${count}: no run has so many lines`);
    yield text.slice(start, end);
    start = end + 1;
  }
  yield text.slice(start);
}

/** A row is a flat list, and the header lists a world's obstacles: more of these is no trace. */
const MOST_BRACKETS = 20_000;
const DEEPEST = 8;

/**
 * Before a line is parsed: brackets by the million would take more memory than the tab has.
 * Throws TraceError.
 */
function checkNesting(line: string, where: string): void {
  let depth = 0;
  let count = 0;
  let inText = false;
  for (let i = 0; i < line.length; i++) {
    const sign = line.charCodeAt(i);
    if (sign === QUOTE) inText = !inText;
    else if (inText) {
      if (sign === BACKSLASH) i += 1;
    } else if (sign === LIST || sign === RECORD) {
      depth += 1;
      count += 1;
      if (depth > DEEPEST || count > MOST_BRACKETS) {
        throw new TraceError(`${where}: more brackets than a line of a run has`);
      }
    } else if (sign === LIST_END || sign === RECORD_END) depth -= 1;
  }
}

const [QUOTE, BACKSLASH, LIST, LIST_END, RECORD, RECORD_END] = [...'"\\[]{}'].map((sign) =>
  sign.charCodeAt(0),
);

function parse(line: string, where: string): unknown {
  checkNesting(line, where);
  try {
    return JSON.parse(line);
  } catch (error) {
    throw new TraceError(`${where}: not JSON: ${error instanceof Error ? error.message : error}`);
  }
}

function decodePoints(row: unknown[], where: string): Int16Array {
  const text = row[1];
  if (row.length !== 2 || typeof text !== "string") {
    throw new TraceError(`${where}: points has 1 value (text), not ${row.length - 1}`);
  }
  return readPoints(text, where);
}

/** The point store of a run from its base64 text. Throws TraceError. */
export function readPoints(text: string, where: string): Int16Array {
  let binary: string;
  try {
    binary = atob(text);
  } catch {
    throw new TraceError(`${where}: the points are not base64`);
  }
  if (binary.length % 4 !== 0) throw new TraceError(`${where}: the points do not come in pairs`);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = binary.charCodeAt(i);
  return new Int16Array(bytes.buffer); // every engine that runs this is little-endian
}

function encodePoints(blocks: readonly Int16Array[]): string {
  const pieces: string[] = [];
  for (const block of blocks) {
    const bytes = new Uint8Array(block.buffer, block.byteOffset, block.byteLength);
    // As arguments of one call a large block would overflow the stack.
    for (let i = 0; i < bytes.length; i += 0x8000) {
      pieces.push(String.fromCharCode(...bytes.subarray(i, i + 0x8000)));
    }
  }
  return btoa(pieces.join(""));
}
