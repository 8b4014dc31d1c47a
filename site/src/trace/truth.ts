/**
 * What is really on the mat: the world of a trace, asked in words and distances.
 * Imports `events` and `frames`.
 */
import type { Obstacle, Pose, World } from "./events.ts";
import { type Cell, direction, MAT_CM } from "./frames.ts";

/** The obstacle that holds a point, edges included, or null for floor. */
export function obstacleAt(world: World, x: number, y: number): Obstacle | null {
  return (
    world.obstacles.find(
      (o) => x >= o.x && x <= o.x + o.width && y >= o.y && y <= o.y + o.height,
    ) ?? null
  );
}

/** The obstacle that covers some of a cell, or null. */
export function obstacleIn(world: World, cell: Cell): Obstacle | null {
  return (
    world.obstacles.find(
      (o) =>
        o.x < cell.x + cell.size &&
        o.x + o.width > cell.x &&
        o.y < cell.y + cell.size &&
        o.y + o.height > cell.y,
    ) ?? null
  );
}

/** Something solid and how far it is; the mat's edge is called that. */
export interface Near {
  name: string;
  cm: number;
}

/** The solid thing nearest to a point, from the point to its edge [cm]. */
export function nearestTo(world: World, x: number, y: number): Near {
  let nearest: Near = { name: "edge of the mat", cm: Math.min(x, y, MAT_CM - x, MAT_CM - y) };
  for (const o of world.obstacles) {
    const dx = Math.max(o.x - x, 0, x - o.x - o.width);
    const dy = Math.max(o.y - y, 0, y - o.y - o.height);
    const cm = Math.hypot(dx, dy);
    if (cm < nearest.cm) nearest = { name: o.name, cm };
  }
  return nearest;
}

/** What a pose looks straight at, and how far from the robot's centre [cm]. */
export function aheadOf(world: World, pose: Pose): Near {
  const [right, up] = direction(pose.heading);
  const toEdge = Math.min(
    right > 0 ? (MAT_CM - pose.x) / right : right < 0 ? -pose.x / right : Number.POSITIVE_INFINITY,
    up > 0 ? (MAT_CM - pose.y) / up : up < 0 ? -pose.y / up : Number.POSITIVE_INFINITY,
  );
  let ahead: Near = { name: "edge of the mat", cm: toEdge };
  for (const o of world.obstacles) {
    const [inX, outX] = span(o.x - pose.x, o.x + o.width - pose.x, right);
    const [inY, outY] = span(o.y - pose.y, o.y + o.height - pose.y, up);
    const enter = Math.max(inX, inY, 0);
    if (enter <= Math.min(outX, outY) && enter < ahead.cm) ahead = { name: o.name, cm: enter };
  }
  return ahead;
}

/** From where to where a ray of that rate lies between two edges, both relative to its start. */
function span(low: number, high: number, rate: number): [enter: number, leave: number] {
  if (rate === 0) {
    const inside = low <= 0 && high >= 0;
    return inside
      ? [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY]
      : [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  }
  const [a, b] = [low / rate, high / rate];
  return a < b ? [a, b] : [b, a];
}
