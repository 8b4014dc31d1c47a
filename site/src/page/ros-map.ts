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
const MOST_BYTES = 20_000_000;

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

/** Hands the map's files to the browser to save, as one archive; resolves to what to say of it. */
export async function saveRosMap(runtime: Asked, name: string, map: DrawnMap): Promise<string> {
  const answer = await ask(runtime, { act: "save", name, ...map });
  const { file, bytes, free, occupied, unknown } = answer as Saved;
  saveFile(file, new Blob([decode(bytes)], { type: "application/zip" }));
  return rosWords.saved(file, free, occupied, unknown);
}

interface Saved {
  file: string;
  bytes: string;
  free: number;
  occupied: number;
  unknown: number;
}

/** The map in files that were chosen together; throws FileError that names the file and the fault. */
export async function readRosMap(runtime: Asked, files: readonly File[]): Promise<OpenedMap> {
  const sent = await Promise.all(
    files.map(async (file) => {
      if (file.size > MOST_BYTES) {
        throw new FileError(rosWords.tooLarge(file.name, MOST_BYTES / 1e6));
      }
      return { name: file.name, bytes: encode(new Uint8Array(await file.arrayBuffer())) };
    }),
  );
  const map = (await ask(runtime, { act: "open", files: sent })) as OpenedMap & { cells: unknown };
  return { ...map, cells: decode(String(map.cells)) };
}

/** Throws FileError for what is wrong with a file, and for what is wrong with us. */
async function ask(runtime: Asked, request: object): Promise<unknown> {
  let answer: { error?: string };
  try {
    answer = JSON.parse(await runtime.convert(JSON.stringify(request)));
  } catch (error) {
    throw new FileError(rosWords.failed(error instanceof Error ? error.message : String(error)));
  }
  if (answer.error !== undefined) throw new FileError(rosWords.notOpened(answer.error));
  return answer;
}

/** So many bytes at a time become letters: arguments of a call are not without end. */
const CHUNK = 0x8000;

function encode(bytes: Uint8Array): string {
  const parts: string[] = [];
  for (let i = 0; i < bytes.length; i += CHUNK) {
    parts.push(String.fromCharCode(...bytes.subarray(i, i + CHUNK)));
  }
  return btoa(parts.join(""));
}

function decode(text: string): Uint8Array<ArrayBuffer> {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}
