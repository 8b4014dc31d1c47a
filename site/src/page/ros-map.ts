/**
 * ROS maps: what is drawn at a moment as the two files that map servers read, and such files as a
 * picture under the program's layers.
 *
 * The format is Python's business (`py/mapping/ros_map.py`): the page asks the site's own Python, in
 * an interpreter that is to spare, so there is one reader and one writer of it. Fetched on use.
 * May import `runtime`, `trace` and `ui`.
 */
import type { Runtime } from "../runtime/client.ts";
import { POINTS_PER_CM } from "../trace/events.ts";
import type { Trace } from "../trace/trace.ts";
import { rosWords } from "../ui/ros-words.ts";
import type { OpenedMap } from "./ros-backdrop.ts";
import { FileError, saveFile } from "./text-file.ts";

/** What there is to be saved: middles of cells [cm]. */
export interface DrawnMap {
  cell_cm: number;
  free: readonly (readonly number[])[];
  occupied: readonly (readonly number[])[];
}

type Asked = Pick<Runtime, "convert">;

/** Files larger than this are no maps of a mat [bytes]. */
const MOST_BYTES = 80_000_000;

/** What the run has drawn as a map at a moment; throws FileError if that is none. */
export function drawnAt(trace: Trace, seconds: number): DrawnMap {
  const layers = trace.layersAt(seconds);
  const squares = (name: string) =>
    layers.find((layer) => layer.name === name && layer.shape === "squares");
  const [free, occupied] = [squares("free"), squares("occupied")];
  const size = (free ?? occupied)?.size;
  if (size === undefined) throw new FileError(rosWords.noMap);
  if (free && occupied && free.size !== occupied.size) {
    throw new FileError(rosWords.mixed(free.size, occupied.size));
  }
  const points = (layer: typeof free): number[][] => {
    const stored = layer ? trace.pointsOf(layer) : new Int16Array();
    return Array.from({ length: stored.length / 2 }, (_, i) => [
      (stored[2 * i] as number) / POINTS_PER_CM,
      (stored[2 * i + 1] as number) / POINTS_PER_CM,
    ]);
  };
  return { cell_cm: size, free: points(free), occupied: points(occupied) };
}

/**
 * Hands the map's files to the browser to save, as one archive; resolves to what to say of it.
 * `moment` is when it was drawn like this [s], null for the end of a run.
 */
export async function saveRosMap(
  runtime: Asked,
  name: string,
  map: DrawnMap,
  moment: number | null = null,
): Promise<string> {
  const title = moment === null ? name : `${name}-at-${moment.toFixed(1)}-s`;
  const { answer, bytes } = await ask(runtime, { act: "save", name: title, ...map });
  const { file, ...counts } = answer as Saved;
  saveFile(file, new Blob(bytes ? [bytes] : [], { type: "application/zip" }));
  return rosWords.saved(file, counts, moment);
}

interface Saved {
  file: string;
  free: number;
  occupied: number;
  unknown: number;
}

/** The map in files that were chosen together; throws FileError that names the file and the fault. */
export async function readRosMap(runtime: Asked, files: readonly File[]): Promise<OpenedMap> {
  const contents = await Promise.all(files.map(contentOf));
  const names = files.map((file) => file.name);
  const { answer, bytes } = await ask(runtime, { act: "open", names }, contents);
  return {
    ...(answer as Omit<OpenedMap, "cells">),
    cells: new Uint8Array(bytes ?? new ArrayBuffer(0)),
  };
}

async function contentOf(file: File): Promise<ArrayBuffer> {
  if (file.size > MOST_BYTES) throw new FileError(rosWords.tooLarge(file.name, MOST_BYTES / 1e6));
  try {
    return await file.arrayBuffer();
  } catch {
    // A folder dropped on the page, or a file that has gone since.
    throw new FileError(rosWords.unreadable(file.name));
  }
}

/** Throws FileError for what is wrong with a file, and for what is wrong with us. */
async function ask(
  runtime: Asked,
  request: object,
  files: readonly ArrayBuffer[] = [],
): Promise<{ answer: object; bytes: ArrayBuffer | null }> {
  let answer: { error?: string };
  let bytes: ArrayBuffer | null;
  try {
    const converted = await runtime.convert(JSON.stringify(request), files);
    answer = JSON.parse(converted.answer);
    bytes = converted.bytes;
  } catch (error) {
    throw new FileError(rosWords.failed(error instanceof Error ? error.message : String(error)));
  }
  if (answer.error !== undefined) throw new FileError(rosWords.notOpened(answer.error));
  return { answer, bytes };
}
