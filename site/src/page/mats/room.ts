/**
 * Whether the robot has room on a mat: what it stands in, and how much of the floor it can reach.
 * May import `trace`.
 */
import type { Obstacle, World } from "../../trace/events.ts";
import { MAT_CM, ROBOT_RADIUS_CM } from "../../trace/frames.ts";
import { gap } from "./check-world.ts";

/** Between the places that are tried [cm]. */
const STEP_CM = 2;
const ACROSS = Math.floor((MAT_CM - 2 * ROBOT_RADIUS_CM) / STEP_CM) + 1;

/** The obstacle that the robot touches at its start, and by how much it stands too near [cm]. */
export function inTheWay(world: World): { thing: Obstacle; short: number } | null {
  const { x, y } = world.start;
  let worst: { thing: Obstacle; short: number } | null = null;
  for (const thing of world.obstacles) {
    const short = ROBOT_RADIUS_CM - gap(thing, x, y);
    if (short > (worst?.short ?? 0)) worst = { thing, short };
  }
  return worst;
}

/**
 * Of the places where the robot fits, the share that it can drive to from its start, 0 to 1. Found
 * on a lattice of 2 cm; a passage is as wide as the robot needs or it is none.
 */
export function reach(world: World): number {
  const free = new Uint8Array(ACROSS * ACROSS).fill(1);
  for (const thing of world.obstacles) close(free, thing);
  let fits = 0;
  for (const place of free) fits += place;
  return fits === 0 ? 0 : flood(free, around(world.start)) / fits;
}

/** The places next to a point: where the robot touches something, not all of them are free. */
function around({ x, y }: { x: number; y: number }): number[] {
  const beside = (cm: number): number[] => [nearest(cm - STEP_CM / 2), nearest(cm + STEP_CM / 2)];
  return beside(y).flatMap((row) => beside(x).map((column) => index(column, row)));
}

const at = (step: number): number => ROBOT_RADIUS_CM + step * STEP_CM;
const index = (column: number, row: number): number => row * ACROSS + column;
const nearest = (cm: number): number =>
  Math.min(Math.max(Math.round((cm - ROBOT_RADIUS_CM) / STEP_CM), 0), ACROSS - 1);

/** Marks the places where the robot would touch the thing. */
function close(free: Uint8Array, thing: Obstacle): void {
  const { x, y, width, height } = thing;
  const last = (cm: number): number => nearest(cm + ROBOT_RADIUS_CM);
  for (let row = nearest(y - ROBOT_RADIUS_CM); row <= last(y + height); row++) {
    for (let column = nearest(x - ROBOT_RADIUS_CM); column <= last(x + width); column++) {
      if (gap(thing, at(column), at(row)) < ROBOT_RADIUS_CM) free[index(column, row)] = 0;
    }
  }
}

/** How many places can be reached from the first ones; takes them out of `free`. */
function flood(free: Uint8Array, first: readonly number[]): number {
  const edge: number[] = [];
  const visit = (place: number): void => {
    if (!free[place]) return;
    free[place] = 0;
    edge.push(place);
  };
  for (const place of first) visit(place);
  let reached = 0;
  for (let place = edge.pop(); place !== undefined; place = edge.pop()) {
    reached += 1;
    const column = place % ACROSS;
    if (column > 0) visit(place - 1);
    if (column < ACROSS - 1) visit(place + 1);
    if (place >= ACROSS) visit(place - ACROSS);
    if (place < ACROSS * (ACROSS - 1)) visit(place + ACROSS);
  }
  return reached;
}
