/**
 * The words of ROS maps. `strings.ts` has the voice. Imports nothing of ours.
 */

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

const sentence = (text: string): string => `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;

const percent = (share: number): string => String(Number((100 * share).toFixed(1)));

export const rosWords = {
  /** `moment` is the shown one [s], or null at the end of the run. */
  saved: (
    file: string,
    { free, occupied, unknown }: { free: number; occupied: number; unknown: number },
    moment: number | null,
  ) =>
    `${file} has the map as it is at ${moment === null ? "the end of the run" : `${moment.toFixed(1)} s`}, and its YAML file: ${free} cells free, ${occupied} occupied, ${unknown} unknown.`,
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
  note: (map: {
    width: number;
    height: number;
    resolution: number;
    mode: string;
    doubts: readonly string[];
    negate: boolean;
    occupied_thresh: number;
    free_thresh: number;
  }) =>
    `${map.width} × ${map.height} cells of ${Number((100 * map.resolution).toFixed(2))} cm; ${map.mode}${
      map.mode === "raw"
        ? ""
        : `, occupied from ${percent(map.occupied_thresh)}\u00a0%, free to ${percent(map.free_thresh)}\u00a0%${map.negate ? ", negated" : ""}`
    }${map.doubts.map((doubt) => `. ${sentence(doubt).slice(0, -1)}`).join("")}`,
};
