/**
 * The overhead view in words: a moment of the run, and what speaks for one cell.
 * May import `trace`, `ui` and, in this folder, `cells`.
 */
import type { Layer } from "../../trace/events.ts";
import type { CellEvidence } from "../../trace/evidence.ts";
import type { Cell } from "../../trace/frames.ts";
import type { Trace } from "../../trace/trace.ts";
import { aheadOf, nearestTo, obstacleAt, obstacleIn } from "../../trace/truth.ts";
import { overheadWords as words } from "../../ui/view-words.ts";

/** What lies further ahead than this is not worth a word [cm]. */
const AHEAD_CM = 40;

/** A sentence that lists more layers than this is of no help. */
const MOST_LAYERS = 8;
/** Nor one that lists more cells than this. */
const MOST_CELLS = 4;

/** "robot at (100, 112) cm, heading 90°; 901 free, 115 occupied; nothing within 40 cm ahead" */
export function describeMoment(
  trace: Trace,
  t: number,
  layers: readonly Layer[],
  outlined: readonly Cell[] = [],
): string {
  const pose = trace.poseAt(t);
  const ahead = aheadOf(trace.header.world, pose);
  return [
    words.robot(pose.x, pose.y, pose.heading),
    words.layers(
      layers.slice(0, MOST_LAYERS).map((layer) => `${layer.count} ${layer.name}`),
      layers.length - MOST_LAYERS,
    ),
    ahead.cm <= AHEAD_CM ? words.ahead(ahead.name, ahead.cm) : words.clear(AHEAD_CM),
    ...(outlined.length > 0
      ? [words.pointedOut(outlined.slice(0, MOST_CELLS).map(middleOf), outlined.length)]
      : []),
  ].join("; ");
}

function middleOf({ x, y, size }: Cell): [x: number, y: number] {
  return [x + size / 2, y + size / 2];
}

/** Which cell, and the sentences about it. */
export interface CellStory {
  title: string;
  text: string;
}

/** `drawnAs` is the layer the cell belongs to, null for bare mat. */
export function explainCell(
  trace: Trace,
  cell: Cell,
  drawnAs: string | null,
  { passed, ended, close, last }: CellEvidence,
): CellStory {
  const x = cell.x + cell.size / 2;
  const y = cell.y + cell.size / 2;
  const evidence = last
    ? `${words.evidence(passed, ended, close)}; ${words.last(last.t, last.reading, last.did)}.`
    : words.untouched;
  return {
    title: words.cell(x, y),
    text: `${words.drawnAs(drawnAs)}; ${truthOf(trace, cell, x, y)}. ${evidence}`,
  };
}

function truthOf(trace: Trace, cell: Cell, x: number, y: number): string {
  const { world } = trace.header;
  const thing = obstacleAt(world, x, y);
  if (thing) return words.isThing(thing.name);
  const part = obstacleIn(world, cell);
  if (part) return words.isPartly(part.name);
  const near = nearestTo(world, x, y);
  return words.isFloor(near.name, near.cm);
}
