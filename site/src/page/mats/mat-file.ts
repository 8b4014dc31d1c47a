/**
 * A mat as text: the same JSON as `py/bugbot/worlds/*.json`, as a file and in a link.
 * May import `trace`, `ui` and, above, `share` and `text-file`.
 */
import type { Obstacle, World } from "../../trace/events.ts";
import { matFileWords } from "../../ui/mat-words.ts";
import { writeAddress } from "../address.ts";
import { pack, ShareError, unpack } from "../share.ts";
import { decodeText, FileError } from "../text-file.ts";
import { readWorld, WorldError } from "./check-world.ts";

/** The longest text of a mat that is looked at: 200 obstacles with long names take less [bytes]. */
const MOST_BYTES = 100_000;

/** A file for a lesson's worlds folder: its name is the world's name, made from the title. */
export function matFile(mat: World, taken: readonly string[]): { name: string; text: string } {
  const name = fileName(mat.title, taken);
  return { name: `${name}.json`, text: worldText({ ...mat, name }) };
}

/** The mat in a chosen file. Throws FileError with a message for the reader. */
export async function readMatFile(file: File): Promise<World> {
  if (file.size > MOST_BYTES) throw new FileError(matFileWords.tooLarge(file.name));
  const text = await file
    .arrayBuffer()
    .then((bytes) => decodeText(new Uint8Array(bytes)))
    .catch(() => null);
  if (text === null) throw new FileError(matFileWords.noText(file.name));
  try {
    return worldIn(text);
  } catch (error) {
    if (!(error instanceof WorldError)) throw error;
    throw new FileError(matFileWords.notMat(file.name, error.message));
  }
}

/** A link to the lab that carries a mat and, with a seed, a program to run on it. */
export async function linkToMat(
  lab: string,
  mat: World,
  run: { seed: number; program: string } | null = null,
): Promise<string> {
  const { name: _own, ...rest } = mat;
  const carried = `mat=${await pack(JSON.stringify({ name: fileName(mat.title, []), ...rest }))}`;
  if (!run) return `${lab}#${carried}`;
  return `${lab}${writeAddress({ seed: run.seed })}#${carried}&code=${await pack(run.program)}`;
}

/** The mat that a link carries. Throws ShareError with a message for the reader. */
export async function matIn(packed: string): Promise<World> {
  const words = { broken: matFileWords.brokenLink, tooLarge: matFileWords.longLink };
  const text = await unpack(packed, MOST_BYTES, words);
  try {
    return worldIn(text);
  } catch (error) {
    if (!(error instanceof WorldError)) throw error;
    throw new ShareError(matFileWords.notMatLink(error.message));
  }
}

/** Whether two mats are the same but for the name they go by. */
export function sameMat(one: World, other: World): boolean {
  return worldText({ ...one, name: "" }) === worldText({ ...other, name: "" });
}

/** Throws WorldError. */
function worldIn(text: string): World {
  let data: unknown;
  try {
    data = JSON.parse(text);
  } catch {
    // What engines say of it differs, and of lists a thousand deep some say nothing of use.
    throw new WorldError(matFileWords.notJson);
  }
  return readWorld(data);
}

/** "Büro 2" -> "buro-2", and something else where a world of the site is called so. */
function fileName(title: string, taken: readonly string[]): string {
  const letters = title.normalize("NFKD").replaceAll(/\p{M}/gu, "").toLowerCase();
  const words =
    letters
      .match(/[a-z0-9]+/g)
      ?.join("-")
      .slice(0, 40)
      .replace(/-$/, "") ?? "mat";
  return taken.includes(words) ? `${words}-of-mine` : words;
}

/** In the shape of the files that come with bugbot: a line for each obstacle. */
function worldText(mat: World): string {
  const { name, title, description, obstacles, start, camera, odometry } = mat;
  const text = JSON.stringify;
  const box = ({ x, y, width, height, name: word }: Obstacle) => ({
    x,
    y,
    width,
    height,
    name: word,
  });
  const line = (value: object): string => text(value, null, 1).replaceAll(/\s*\n\s*/g, " ");
  const list = obstacles.map((each) => `    ${line(box(each))}`).join(",\n");
  return `{
  "name": ${text(name)},
  "title": ${text(title)},
  "description": ${text(description)},
  "obstacles": [${list && `\n${list}\n  `}],
  "start": ${line({ x: start.x, y: start.y, heading: start.heading })}${camera === false ? ',\n  "camera": false' : ""}${odometry ? `,\n  "odometry": ${line(odometry)}` : ""}
}
`;
}
