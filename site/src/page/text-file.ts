/**
 * Files of text, in and out: what a person chose or dropped is checked before it is used.
 * May import `ui` and `trace`.
 */
import { TraceError } from "../trace/decode.ts";
import { FORMAT } from "../trace/events.ts";
import { readTraceFile } from "../trace/file.ts";
import type { Trace } from "../trace/trace.ts";
import { fileWords } from "../ui/file-words.ts";

/** The largest program that is opened, from a file or a link. */
export const MOST_PROGRAM_BYTES = 1024 * 1024;
/** A run of 64 MB, the most there is, takes about this as a file. */
const MOST_RUN_BYTES = 160_000_000;

/** A file that can't be opened; the message is for the reader. */
export class FileError extends Error {
  override readonly name = "FileError";
}

export type Opened = { program: string } | { run: Trace };

/** A program, or a run saved before: what is in the file decides. Throws FileError. */
export async function readFile(file: File): Promise<Opened> {
  return (await isRun(file)) ? { run: await readRun(file) } : { program: await readProgram(file) };
}

/** The first line of a saved run names its format. */
async function isRun(file: File): Promise<boolean> {
  const start = await file.slice(0, 200).text();
  return start.startsWith("{") && start.includes(`"${FORMAT}"`);
}

/** Throws FileError unless the file holds text, and no more than a program may have. */
async function readProgram(file: File): Promise<string> {
  if (file.size > MOST_PROGRAM_BYTES) throw new FileError(fileWords.tooLarge(file.name, file.size));
  const text = decodeText(await bytesOf(file));
  if (text === null) throw new FileError(fileWords.notText(file.name));
  return text;
}

/** Throws FileError with the line that is wrong and how. */
export async function readRun(file: File): Promise<Trace> {
  if (file.size > MOST_RUN_BYTES) throw new FileError(fileWords.runTooLarge(file.name, file.size));
  const text = decodeText(await bytesOf(file));
  if (text === null) throw new FileError(fileWords.notRun(file.name, fileWords.noText));
  try {
    const trace = readTraceFile(text);
    if (!trace.complete) throw new TraceError(fileWords.noEnd);
    return trace;
  } catch (error) {
    if (!(error instanceof TraceError)) throw error;
    throw new FileError(fileWords.notRun(file.name, error.message));
  }
}

async function bytesOf(file: File): Promise<Uint8Array> {
  try {
    return new Uint8Array(await file.arrayBuffer());
  } catch {
    // A folder dropped on the page, or a file that has gone since.
    throw new FileError(fileWords.unreadable(file.name));
  }
}

/** UTF-8 as text with plain line ends, or null if it is no text. */
export function decodeText(bytes: Uint8Array): string | null {
  try {
    const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    return text.includes("\0") ? null : text.replaceAll(/\r\n?/g, "\n");
  } catch {
    return null;
  }
}

/** Hands a file to the browser to save. */
export function saveFile(name: string, content: string | Blob, type = "text/plain"): void {
  const blob = typeof content === "string" ? new Blob([content], { type }) : content;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // Once the browser has begun to save, it needs the address no longer; a minute is ample.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** Lets a person choose a file; null if they do not. */
export async function chooseFile(accept: string): Promise<File | null> {
  return (await choose(accept, false))[0] ?? null;
}

/** Lets a person choose files together; none if they do not. */
export function chooseFiles(accept: string): Promise<File[]> {
  return choose(accept, true);
}

function choose(accept: string, multiple: boolean): Promise<File[]> {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = accept;
  input.multiple = multiple;
  return new Promise((resolve) => {
    input.addEventListener("change", () => resolve([...(input.files ?? [])]));
    input.addEventListener("cancel", () => resolve([]));
    input.click();
  });
}
