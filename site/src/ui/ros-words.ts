/**
 * The words of ROS maps. `strings.ts` has the voice. Imports `counted`.
 */
import { counted } from "./counted.ts";

interface Reach {
  x: readonly [number, number];
  y: readonly [number, number];
  onMat: "all" | "part" | "none";
}

function placed(name: string, { x, y, onMat }: Reach): string {
  const span = ([from, to]: readonly [number, number]) => `${from.toFixed(0)} to ${to.toFixed(0)}`;
  const extent = `the map covers x = ${span(x)} and y = ${span(y)} cm, the mat 0 to 200`;
  if (onMat === "none") return `${name} was read, but none of it is on the mat: ${extent}.`;
  const here = `${name} lies on the mat now, under what the program draws.`;
  if (onMat === "all") return here;
  return `${here} Only a part of it is shown: ${extent}.`;
}

interface Size {
  width: number;
  height: number;
  /** Side of a cell [m]. */
  resolution: number;
}

interface Rules {
  mode: string;
  negate: boolean;
  occupied_thresh: number;
  free_thresh: number;
  doubts: readonly string[];
}

const sentence = (text: string): string => `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;

const percent = (share: number): string => String(Number((100 * share).toFixed(1)));

export const rosWords = {
  /** `moment` is the shown one [s], or null at the end of the run. */
  saved: (
    file: string,
    { free, occupied, unknown }: { free: number; occupied: number; unknown: number },
    moment: number | null,
  ) =>
    `${file} has the map as it is at ${moment === null ? "the end of the run" : `${moment.toFixed(1)} s`}, and its YAML file: ${counted(free, "cell is", "cells are")} free, ${occupied} occupied, ${unknown} unknown.`,
  noMap:
    "There is no map to take away at this moment: draw its cells as squares, in a layer named “free” and one named “occupied”.",
  mixed: (free: number, occupied: number) =>
    `The squares of “free” are ${free} cm wide and those of “occupied” ${occupied} cm. A map has cells of one size.`,
  tooLarge: (name: string, most: number) =>
    `${name} is too large to be a map for this page: ${most} MB at most.`,
  notOpened: (why: string) => `That map can’t be opened: ${why}.`,
  failed: (why: string) =>
    `The map could not be made or read. That is a fault of this site, not of your file: ${why}.`,
  unreadable: (name: string) => `${name} can’t be read: is it a folder, or gone?`,
  opened: (name: string, reach: Reach, doubts: readonly string[]) =>
    [placed(name, reach), ...doubts.map(sentence)].join(" "),
  legend: (name: string) => `map ${name}`,
  note: ({ width, height, resolution }: Size) =>
    `${width.toLocaleString("en-GB")} × ${counted(height, "cell")} of ${Number((100 * resolution).toFixed(2))} cm`,
  more: ({ mode, negate, occupied_thresh: occupied, free_thresh: free, doubts }: Rules) => {
    const rules =
      mode === "raw"
        ? "its values are the cells themselves"
        : `occupied from ${percent(occupied)}\u00a0%, free to ${percent(free)}\u00a0%${negate ? ", with black for free" : ""}`;
    return [sentence(`read as ${mode}: ${rules}`), ...doubts.map(sentence)].join(" ");
  },
};
