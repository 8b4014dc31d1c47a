/**
 * Reads a world's JSON by the rules of `py/bugbot/worlds`, in the same order and the same words:
 * tests/golden/worlds.json holds worlds, good and bad, that both are asked about.
 *
 * What comes in may be anything, from a link or a file of somebody else's. May import `trace`.
 */
import type { Obstacle, OdometryErrors, World } from "../../trace/events.ts";
import { MAT_CM, ROBOT_RADIUS_CM, wrapHeading } from "../../trace/frames.ts";

/** The most obstacles of a world. */
export const MOST_OBSTACLES = 200;
/** The most characters of a name, a title or a description. */
export const MOST_CHARACTERS = 300;
/** The least side of an obstacle that a file may have [cm]. */
const LEAST_CM = 0.1;

/** What is wrong with a world, as `field wants …; it got …`. */
export class WorldError extends Error {
  override readonly name = "WorldError";
}

type Fields = Record<string, unknown>;

/** The world in the data of a JSON file. Throws WorldError. */
export function readWorld(data: unknown): World {
  const world = readDraft(data);
  const { x, y } = world.start;
  world.obstacles.forEach((obstacle, index) => {
    const short = ROBOT_RADIUS_CM - gap(obstacle, x, y);
    if (short > 0) {
      throw new WorldError(
        `start (${shortest(x)}, ${shortest(y)}) is too near obstacles[${index}], the ${obstacle.name}: move it ${short.toFixed(1)} cm away (the robot's radius is ${ROBOT_RADIUS_CM} cm)`,
      );
    }
  });
  return world;
}

/** The same for a world that is being made: the robot may still stand in something. */
export function readDraft(data: unknown): World {
  const wanted = ["name", "title", "description", "obstacles", "start"];
  const fields = fieldsOf(data, "", wanted, ["camera", "odometry"]);
  const [name, title, description] = ["name", "title", "description"].map((key) =>
    text(fields[key], key),
  ) as [string, string, string];
  if (!Array.isArray(fields.obstacles)) {
    return refuse("obstacles", "wants a list of rectangles", fields.obstacles);
  }
  if (fields.obstacles.length > MOST_OBSTACLES) {
    refuse("obstacles", `wants at most ${MOST_OBSTACLES} rectangles`, fields.obstacles.length);
  }
  const obstacles = fields.obstacles.map((each, i) => obstacle(each, `obstacles[${i}]`));
  const start = startOf(fields.start);
  const { camera = true } = fields;
  if (typeof camera !== "boolean") refuse("camera", "wants true or false", camera);
  const odometry = errorsOf(fields.odometry === undefined ? {} : fields.odometry);
  return {
    name,
    title,
    description,
    obstacles,
    start,
    ...(camera ? {} : { camera: false }),
    ...(Object.keys(odometry).length ? { odometry } : {}),
  };
}

/** Distance [cm] from a point to a rectangle; 0 inside it. */
export function gap({ x, y, width, height }: Obstacle, atX: number, atY: number): number {
  const beside = Math.max(x - atX, 0, atX - (x + width));
  const above = Math.max(y - atY, 0, atY - (y + height));
  return Math.hypot(beside, above);
}

/** One line of text that can be written down anywhere: no control signs, no halves of letters. */
export function isPlainLine(line: string): boolean {
  return !/[\p{Cc}\p{Cs}]/u.test(line) && [...line].length <= MOST_CHARACTERS;
}

function obstacle(data: unknown, at: string): Obstacle {
  const fields = fieldsOf(data, at, ["x", "y", "width", "height", "name"]);
  const x = number(fields.x, `${at}.x`, 0, MAT_CM);
  const y = number(fields.y, `${at}.y`, 0, MAT_CM);
  const width = number(fields.width, `${at}.width`, LEAST_CM, MAT_CM - x);
  const height = number(fields.height, `${at}.height`, LEAST_CM, MAT_CM - y);
  return { x, y, width, height, name: text(fields.name, `${at}.name`) };
}

function startOf(data: unknown): World["start"] {
  const fields = fieldsOf(data, "start", ["x", "y", "heading"]);
  const far = MAT_CM - ROBOT_RADIUS_CM;
  const x = number(fields.x, "start.x", ROBOT_RADIUS_CM, far);
  const y = number(fields.y, "start.y", ROBOT_RADIUS_CM, far);
  return { x, y, heading: wrapHeading(number(fields.heading, "start.heading", -360, 360)) };
}

/** The robot's errors, without those that an ideal robot has as well. */
function errorsOf(data: unknown): OdometryErrors {
  const fields = fieldsOf(data, "odometry", [], ["drift_deg_s", "turn_scale", "slip"]);
  const { drift_deg_s: drift, turn_scale: scale = 1, slip = 0 } = fields;
  const errors: OdometryErrors = {};
  if (drift !== undefined) errors.drift_deg_s = number(drift, "odometry.drift_deg_s", -1, 1);
  if (number(scale, "odometry.turn_scale", 0.5, 1.5) !== 1) errors.turn_scale = Number(scale);
  if (number(slip, "odometry.slip", 0, 0.5) !== 0) errors.slip = Number(slip);
  return errors;
}

function fieldsOf(data: unknown, at: string, wanted: string[], allowed: string[] = []): Fields {
  if (typeof data !== "object" || data === null || Array.isArray(data)) {
    const names = wanted.length ? wanted : allowed;
    return refuse(at, `wants an object with ${names.join(", ")}`, data);
  }
  const place = at && `${at}.`;
  const missing = wanted.find((key) => !Object.hasOwn(data, key));
  if (missing !== undefined) throw new WorldError(`${place}${missing} is missing; add it`);
  const known = [...wanted, ...allowed];
  const strange = Object.keys(data).find((key) => !known.includes(key));
  if (strange !== undefined) {
    throw new WorldError(
      `${place}${shown(strange)} is not a field here; the fields are ${known.join(", ")}`,
    );
  }
  return data as Fields;
}

function text(value: unknown, at: string): string {
  if (typeof value !== "string" || value.trim() === "") {
    return refuse(at, "wants a text that is not empty", value);
  }
  if (!isPlainLine(value)) {
    refuse(at, `wants one line of at most ${MOST_CHARACTERS} characters`, value);
  }
  return value;
}

function number(value: unknown, at: string, low: number, high: number): number {
  // NaN and the infinite are in no range.
  if (typeof value !== "number" || !(value >= low && value <= high)) {
    return refuse(at, `wants a number from ${shortest(low)} to ${shortest(high)}`, value);
  }
  return value;
}

function refuse(field: string, wants: string, value: unknown): never {
  throw new WorldError(`${field || "the world"} ${wants}; it got ${shown(JSON.stringify(value))}`);
}

/** With six digits at most, as Python's :g. */
const shortest = (value: number): string => String(Number(value.toPrecision(6)));

const shown = (value: string | undefined): string => {
  const whole = value ?? "nothing";
  return whole.length > 48 ? `${whole.slice(0, 45)}…` : whole;
};
