/**
 * What can be done to a world's rectangles and its robot: every change gives a new world, and
 * nothing leaves the mat. May import `trace`.
 */
import type { Obstacle, World } from "../../trace/events.ts";
import { MAT_CM, ROBOT_RADIUS_CM, wrapHeading } from "../../trace/frames.ts";

/** The grid that things snap to while they are dragged [cm]. */
export const SNAP_CM = 5;
/** Headings snap to these [degrees]. */
export const SNAP_DEG = 15;
/** The least side that can be drawn or typed [cm]. */
export const LEAST_SIDE_CM = 1;
/** Sides of a box that is added without being drawn [cm]. */
const BOX_CM = 20;
/** A rectangle this much longer than it is wide is called a wall until it has a better name. */
const WALL_RATIO = 3;

export type Rectangle = Omit<Obstacle, "name">;
export interface Point {
  x: number;
  y: number;
}

/** What is chosen: an obstacle by its place in the list, or the robot. */
export type Part = number | "robot";

/** Which sides of a rectangle a handle moves: "n", "se", … */
export type Side = "n" | "s" | "e" | "w" | "ne" | "nw" | "se" | "sw";

/** To a tenth of a millimetre: what a drag leaves behind in digits is nobody's wish. */
const tidy = (cm: number): number => Math.round(cm * 100) / 100;

const within = (value: number, low: number, high: number): number =>
  Math.min(Math.max(value, low), high);

/** To the next line of the grid; `grid` 0 leaves it to a whole cm. */
export function snapped(cm: number, grid: number): number {
  const step = grid || 1;
  return Math.round(cm / step) * step;
}

/** The rectangle between two corners, on the grid and on the mat; null where there is none yet. */
export function drawn(from: Point, to: Point, grid: number): Rectangle | null {
  const [left, right] = along(from.x, to.x, grid);
  const [bottom, top] = along(from.y, to.y, grid);
  const width = right - left;
  const height = top - bottom;
  if (width < LEAST_SIDE_CM || height < LEAST_SIDE_CM) return null;
  return { x: left, y: bottom, width, height };
}

function along(from: number, to: number, grid: number): [low: number, high: number] {
  const a = snapped(within(from, 0, MAT_CM), grid);
  const b = snapped(within(to, 0, MAT_CM), grid);
  return a < b ? [a, b] : [b, a];
}

/** A rectangle whose lower left corner is there, as far as the mat lets it. */
export function movedTo<Some extends Rectangle>(box: Some, x: number, y: number): Some {
  return {
    ...box,
    x: tidy(within(x, 0, MAT_CM - box.width)),
    y: tidy(within(y, 0, MAT_CM - box.height)),
  };
}

/** A rectangle with one or two of its sides brought to a point. */
export function resized<Some extends Rectangle>(box: Some, side: Side, to: Point): Some {
  let { x, y, width, height } = box;
  const right = x + width;
  const top = y + height;
  if (side.includes("w")) {
    x = within(to.x, 0, right - LEAST_SIDE_CM);
    width = right - x;
  }
  if (side.includes("e")) width = within(to.x, x + LEAST_SIDE_CM, MAT_CM) - x;
  if (side.includes("s")) {
    y = within(to.y, 0, top - LEAST_SIDE_CM);
    height = top - y;
  }
  if (side.includes("n")) height = within(to.y, y + LEAST_SIDE_CM, MAT_CM) - y;
  return { ...box, x: tidy(x), y: tidy(y), width: tidy(width), height: tidy(height) };
}

/** The heading from one point to another, in whole degrees or in steps. */
export function headingTo(from: Point, to: Point, step: number): number {
  const degrees = (Math.atan2(to.x - from.x, to.y - from.y) * 180) / Math.PI;
  return wrapHeading(snapped(degrees, step));
}

// -- of a whole world ----------------------------------------------------------------------------

export function withObstacle(world: World, index: number, box: Obstacle): World {
  return { ...world, obstacles: world.obstacles.map((each, i) => (i === index ? box : each)) };
}

export function withStart(world: World, change: Partial<World["start"]>): World {
  const { x, y, heading } = { ...world.start, ...change };
  const far = MAT_CM - ROBOT_RADIUS_CM;
  const start = {
    x: tidy(within(x, ROBOT_RADIUS_CM, far)),
    y: tidy(within(y, ROBOT_RADIUS_CM, far)),
    heading: tidy(wrapHeading(heading)),
  };
  return { ...world, start };
}

/** With one more rectangle at the end of the list. */
export function added(world: World, box: Obstacle): World {
  return { ...world, obstacles: [...world.obstacles, box] };
}

export function without(world: World, index: number): World {
  return { ...world, obstacles: world.obstacles.filter((_, i) => i !== index) };
}

/** A copy beside the thing itself, to the right of it or wherever there is room. */
export function copyOf(box: Obstacle): Obstacle {
  const beside = box.x + 2 * SNAP_CM + box.width <= MAT_CM ? 2 * SNAP_CM : -2 * SNAP_CM;
  const below = box.y >= 2 * SNAP_CM ? -2 * SNAP_CM : 2 * SNAP_CM;
  return movedTo(box, box.x + beside, box.y + below);
}

/** Moves what is chosen by so much. */
export function nudged(world: World, part: Part, dx: number, dy: number): World {
  if (part === "robot") {
    const { x, y } = world.start;
    return withStart(world, { x: x + dx, y: y + dy });
  }
  const box = world.obstacles[part];
  return box ? withObstacle(world, part, movedTo(box, box.x + dx, box.y + dy)) : world;
}

/** Makes what is chosen larger to the right and upwards; turns the robot. */
export function grown(world: World, part: Part, dx: number, dy: number): World {
  if (part === "robot") {
    return withStart(world, { heading: world.start.heading + (dx + dy) * SNAP_DEG });
  }
  const box = world.obstacles[part];
  if (!box) return world;
  const to = { x: box.x + box.width + dx, y: box.y + box.height + dy };
  return withObstacle(world, part, resized(box, "ne", to));
}

/** What something of that shape is called before it has a name of its own. */
export function kindOf({ width, height }: Rectangle): "wall" | "box" {
  return Math.max(width, height) >= WALL_RATIO * Math.min(width, height) ? "wall" : "box";
}

/** Where a new box stands clear of everything, as near the middle as can be; else in the middle. */
export function freePlace({ obstacles, start }: World): Rectangle {
  const middle = (MAT_CM - BOX_CM) / 2;
  const places: Rectangle[] = [];
  for (let x = BOX_CM / 2; x <= MAT_CM - BOX_CM; x += BOX_CM) {
    for (let y = BOX_CM / 2; y <= MAT_CM - BOX_CM; y += BOX_CM) {
      places.push({ x, y, width: BOX_CM, height: BOX_CM });
    }
  }
  const far = ({ x, y }: Rectangle): number => Math.hypot(x - middle, y - middle);
  const robot = { x: start.x - BOX_CM / 2, y: start.y - BOX_CM / 2, width: BOX_CM, height: BOX_CM };
  const clear = (box: Rectangle): boolean => ![robot, ...obstacles].some((one) => meet(one, box));
  places.sort((a, b) => far(a) - far(b));
  return places.find(clear) ?? { x: middle, y: middle, width: BOX_CM, height: BOX_CM };
}

function meet(one: Rectangle, other: Rectangle): boolean {
  return (
    one.x < other.x + other.width &&
    other.x < one.x + one.width &&
    one.y < other.y + other.height &&
    other.y < one.y + one.height
  );
}
