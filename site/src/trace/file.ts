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
  const lines = text.split("\n");
  const trace = new Trace(decodeHeader(parse(lines[0] ?? "", "line 1"), "line 1"));
  const rows: unknown[] = [];
  const numbers: number[] = [];
  let points: Int16Array | null = null;
  for (let i = 1; i < lines.length; i++) {
    const line = lines[i] as string;
    if (line.trim() === "") continue;
    const where = `line ${i + 1}`;
    if (points) throw new TraceError(`${where}: there is more after the points, the last row`);
    const row = parse(line, where);
    if (Array.isArray(row) && row[0] === "points") {
      points = decodePoints(row, where);
    } else {
      rows.push(row);
      numbers.push(i + 1);
    }
  }
  if (!points) {
    throw new TraceError("the points, the last row, are missing: the file is cut short");
  }
  trace.appendRows(rows, points, (i) => `line ${numbers[i] ?? lines.length}`);
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

function parse(line: string, where: string): unknown {
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
