/**
 * The events of a trace, as `py/bugbot/trace.py` defines them (a test holds the two equal).
 * Imports nothing of ours.
 *
 * Times in seconds of simulated time, lengths in cm on the mat, headings in degrees clockwise
 * from straight up the mat.
 */

export const FORMAT = "bugbot-trace";
export const VERSION = 1;
/** The point store counts in hundredths of a centimetre. */
export const POINTS_PER_CM = 100;

/** Field names of each kind, in the order of a row: `[kind, ...values]`. */
export const KINDS = {
  pose: ["t", "x", "y", "heading"],
  scan: ["t", "x", "y", "heading", "beams"],
  layer: ["t", "name", "colour", "shape", "size", "first", "count", "texts"],
  plot: ["t", "name", "value"],
  print: ["t", "stream", "text"],
  note: ["t", "line", "text"],
  line: ["t", "line"],
  led: ["t", "red", "green", "blue"],
  beep: ["t", "freq", "ms"],
  bump: ["t", "x", "y"],
  fault: ["t", "type", "message", "line", "hint", "traceback"],
  end: ["t", "status", "message"],
} as const;

export type Kind = keyof typeof KINDS;

export interface Pose {
  t: number;
  x: number;
  y: number;
  heading: number;
}

/** One look of the depth sensor, from the true pose. */
export interface Scan extends Pose {
  /** angle, distance, angle, distance, … (degrees from straight ahead, clockwise; cm). */
  beams: readonly number[];
}

export type Shape = "dots" | "squares" | "line" | "text";

export interface Layer {
  t: number;
  name: string;
  colour: string;
  shape: Shape;
  /** cm: side of a square, diameter of a dot, width of a line, height of text. */
  size: number;
  /** Number of the first point in the point store, and how many. */
  first: number;
  count: number;
  texts: readonly string[] | null;
}

export interface Plot {
  t: number;
  name: string;
  value: number;
}

export interface Print {
  t: number;
  stream: "stdout" | "stderr";
  text: string;
}

/** What the program should know of a call on this line that did not do all it was told. */
export interface Note {
  t: number;
  line: number;
  text: string;
}

/** What the console shows. */
export type ConsoleEntry = Print | Note;

/** The learner's line that is being carried out from this time on. */
export interface Line {
  t: number;
  line: number;
}

/** The colour of the light, 0 to 255 each. */
export interface Led {
  t: number;
  red: number;
  green: number;
  blue: number;
}

export interface Beep {
  t: number;
  /** Hz */
  freq: number;
  /** How long it sounds [ms]. */
  ms: number;
}

/** The robot touched something; (x, y) is the point of contact. */
export interface Bump {
  t: number;
  x: number;
  y: number;
}

export interface Fault {
  t: number;
  type: string;
  message: string;
  line: number | null;
  hint: string | null;
  traceback: string;
}

export type Status = "finished" | "fault" | "stopped" | "limit";

export interface End {
  t: number;
  status: Status;
  message: string;
}

/** One event of any kind, with the names of KINDS. */
export type TraceEvent =
  | ({ kind: "pose" } & Pose)
  | ({ kind: "scan" } & Scan)
  | ({ kind: "layer" } & Layer)
  | ({ kind: "plot" } & Plot)
  | ({ kind: "print" } & Print)
  | ({ kind: "note" } & Note)
  | ({ kind: "line" } & Line)
  | ({ kind: "led" } & Led)
  | ({ kind: "beep" } & Beep)
  | ({ kind: "bump" } & Bump)
  | ({ kind: "fault" } & Fault)
  | ({ kind: "end" } & End);

export interface Obstacle {
  x: number;
  y: number;
  width: number;
  height: number;
  /** What it is called in sentences: "post", "shelf". */
  name: string;
}

/** A world as in `py/bugbot/worlds/*.json`. */
export interface World {
  name: string;
  title: string;
  description: string;
  obstacles: readonly Obstacle[];
  start: { x: number; y: number; heading: number };
  /** false: no camera tells the program the robot's pose; left out where there is one. */
  camera?: boolean;
  /** How the robot differs from an ideal one; left out where it does not. */
  odometry?: OdometryErrors;
}

/** As `Errors` of `py/bugbot/worlds`: what is left out is as an ideal robot has it. */
export interface OdometryErrors {
  drift_deg_s?: number;
  turn_scale?: number;
  slip?: number;
}

export interface Header {
  format: typeof FORMAT;
  version: typeof VERSION;
  program: string;
  world: World;
  seed: number;
  kinds: Record<string, readonly string[]>;
}

/** What comes out of a running program at a time: rows as JSON text, and the new points. */
export interface Chunk {
  /** A JSON list of rows. */
  events: string;
  /** x, y, x, y, … in hundredths of a cm, to be appended to the store. */
  points: Int16Array;
}

/** The summary of a run: design.md section 3, the same JSON as `python -m bugbot run --json`. */
export interface Outcome {
  status: Status;
  /** What the end event says in words. */
  message: string;
  seconds: number;
  console: string;
  notes: { line: number; text: string }[];
  pose: { x: number; y: number; heading: number };
  series: Record<string, [t: number, value: number][]>;
  layers: Record<
    string,
    { shape: Shape; size: number; colour: string; points: [number, number][]; texts?: string[] }
  >;
  fault: null | { type: string; message: string; line: number | null; hint: string | null };
}
