/**
 * The words of ROS maps. `strings.ts` has the voice. Imports nothing of ours.
 */

const percent = (share: number): string => String(Number((100 * share).toFixed(1)));

export const rosWords = {
  /** The title of the menu's part. */
  map: "Map",
  save: "Download as ROS map",
  open: "Open a ROS map…",
  remove: "Remove the ROS map",
  saved: (file: string, free: number, occupied: number, unknown: number) =>
    `${file} holds the map and its YAML file: ${free} cells free, ${occupied} occupied, ${unknown} unknown.`,
  working: "Python is making the map…",
  reading: "Python is reading the map…",
  noMap:
    "There is no map to take away at this moment: draw its cells as squares, in a layer named “free” and one named “occupied”.",
  mixed: (free: number, occupied: number) =>
    `The squares of “free” are ${free} cm wide and those of “occupied” ${occupied} cm. A map has cells of one size.`,
  tooLarge: (name: string, most: number) =>
    `${name} is too large to be a map for this page: ${most} MB at most.`,
  notOpened: (why: string) => `That map can’t be opened: ${why}.`,
  failed: (why: string) =>
    `The map could not be made or read. That is a fault of this site, not of your file: ${why}.`,
  opened: (name: string) => `${name} lies on the mat now, under what the program draws.`,
  beyond: (name: string, x: number, y: number) =>
    `${name} was read, but none of it is on the mat: its lower left corner is at (${x.toFixed(0)}, ${y.toFixed(0)}) cm, and the mat goes from 0 to 200.`,
  legend: (name: string) => `map ${name}`,
  note: (map: {
    width: number;
    height: number;
    resolution: number;
    mode: string;
    negate: boolean;
    occupied_thresh: number;
    free_thresh: number;
  }) =>
    `${map.width} × ${map.height} cells of ${Number((100 * map.resolution).toFixed(2))} cm; ${map.mode}${
      map.mode === "raw"
        ? ""
        : `, occupied from ${percent(map.occupied_thresh)}\u00a0%, free to ${percent(map.free_thresh)}\u00a0%${map.negate ? ", negated" : ""}`
    }`,
};
