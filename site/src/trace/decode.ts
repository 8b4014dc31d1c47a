/**
 * From JSON to events: every value is checked here, so nothing behind this file meets a surprise.
 * Imports `events` only.
 */
import {
  FORMAT,
  type Header,
  KINDS,
  type Kind,
  type Layer,
  type TraceEvent,
  VERSION,
} from "./events.ts";

/** A trace that is broken, too large, or not a trace; says which row and what is wrong. */
export class TraceError extends Error {
  override readonly name = "TraceError";
}

/** What a value should be: the test, and its words for the message. */
type Check = readonly [wanted: string, holds: (value: unknown) => boolean];

const isText = (value: unknown): value is string => typeof value === "string";
const isWhole = (value: unknown): value is number => Number.isSafeInteger(value);
const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);
const oneOf = (...names: readonly string[]): Check => [
  `one of ${names.join(", ")}`,
  (value) => isText(value) && names.includes(value),
];

const number: Check = ["a number", Number.isFinite];
const size: Check = ["a number from 0", (value) => Number.isFinite(value) && Number(value) >= 0];
const text: Check = ["text", isText];
const textOrNull: Check = ["text or null", (value) => value === null || isText(value)];
const count: Check = ["a whole number from 0", (value) => isWhole(value) && value >= 0];
const line: Check = ["a line number from 1", (value) => isWhole(value) && value >= 1];
const lineOrNull: Check = [
  "a line number from 1, or null",
  (value) => value === null || (isWhole(value) && value >= 1),
];
const colourByte: Check = [
  "a number from 0 to 255",
  (value) => Number.isFinite(value) && Number(value) >= 0 && Number(value) <= 255,
];
const beams: Check = [
  "a flat list of angle, distance pairs",
  (value) => Array.isArray(value) && value.length % 2 === 0 && value.every(Number.isFinite),
];
const textsOrNull: Check = [
  "a list of texts or null",
  (value) => value === null || (Array.isArray(value) && value.every(isText)),
];

const CHECKS: { [K in Kind]: { [F in (typeof KINDS)[K][number]]: Check } } = {
  pose: { t: size, x: number, y: number, heading: number },
  scan: { t: size, x: number, y: number, heading: number, beams },
  layer: {
    t: size,
    name: text,
    colour: text,
    shape: oneOf("dots", "squares", "line", "text"),
    size,
    first: count,
    count,
    texts: textsOrNull,
  },
  plot: { t: size, name: text, value: number },
  print: { t: size, stream: oneOf("stdout", "stderr"), text },
  note: { t: size, line, text },
  line: { t: size, line },
  led: { t: size, red: colourByte, green: colourByte, blue: colourByte },
  beep: { t: size, freq: number, ms: size },
  bump: { t: size, x: number, y: number },
  fault: {
    t: size,
    type: text,
    message: text,
    line: lineOrNull,
    hint: textOrNull,
    traceback: text,
  },
  end: { t: size, status: oneOf("finished", "fault", "stopped", "limit"), message: text },
};

/** Each kind's fields with their checks, in the order of a row: looked up 40,000 times a run. */
const FIELDS = new Map<string, [field: string, check: Check][]>(
  Object.entries(KINDS).map(([kind, fields]) => {
    const checks: Record<string, Check> = CHECKS[kind as Kind];
    return [kind, fields.map((field) => [field, checks[field] as Check])];
  }),
);

/** One row `[kind, value, …]` as an event. `where` begins the message of what is wrong with it. */
export function decodeRow(row: unknown, where: string): TraceEvent {
  if (!Array.isArray(row) || !isText(row[0])) {
    throw new TraceError(`${where}: an event is a list that begins with its kind`);
  }
  const [kind, ...values]: [string, ...unknown[]] = [row[0], ...row.slice(1)];
  const fields = FIELDS.get(kind);
  if (!fields) {
    throw new TraceError(
      `${where}: unknown kind ${shown(kind)}; known: ${[...FIELDS.keys()].join(", ")}`,
    );
  }
  if (values.length !== fields.length) {
    const names = fields.map(([field]) => field).join(", ");
    throw new TraceError(
      `${where}: ${kind} has ${fields.length} values (${names}), not ${values.length}`,
    );
  }
  const event: Record<string, unknown> = { kind };
  fields.forEach(([field, [wanted, holds]], i) => {
    if (!holds(values[i])) {
      throw new TraceError(
        `${where}: ${field} of ${kind} should be ${wanted}, not ${shown(values[i])}`,
      );
    }
    event[field] = values[i];
  });
  // CHECKS has a check for each field of the kind, and each held.
  return event as unknown as TraceEvent;
}

/** Rough memory an event takes [bytes]. */
export function weight(event: TraceEvent): number {
  switch (event.kind) {
    case "scan":
      return 64 + 8 * event.beams.length;
    case "print":
    case "note":
      return 64 + event.text.length;
    case "layer":
      return (event.texts ?? []).reduce((sum, text) => sum + text.length, 64);
    default:
      return 64;
  }
}

/** A layer's points must be in the store, and a text layer have a text for each. */
export function checkLayer(layer: Layer, available: number, where: string): void {
  if (layer.first + layer.count > available) {
    throw new TraceError(
      `${where}: the layer "${layer.name}" wants ${layer.count} points from number ` +
        `${layer.first}, but the store has ${available}`,
    );
  }
  if (layer.shape === "text" && layer.texts?.length !== layer.count) {
    throw new TraceError(
      `${where}: the layer "${layer.name}" has ${layer.texts?.length ?? "no"} texts ` +
        `for ${layer.count} points`,
    );
  }
}

/** The rows of a chunk's JSON text. */
export function decodeRows(events: string, where: string): unknown[] {
  let rows: unknown;
  try {
    rows = JSON.parse(events);
  } catch (error) {
    throw new TraceError(`${where}: not JSON: ${error instanceof Error ? error.message : error}`);
  }
  if (!Array.isArray(rows)) throw new TraceError(`${where}: should be a list of events`);
  return rows;
}

/** The header of a stored run, checked. */
export function decodeHeader(value: unknown, where: string): Header {
  const fail = (fault: string): never => {
    throw new TraceError(`${where}: ${fault}`);
  };
  const need = (record: Record<string, unknown>, checks: Record<string, Check>, of: string) => {
    for (const [name, [wanted, holds]] of Object.entries(checks)) {
      if (!holds(record[name]))
        fail(`${name} of ${of} should be ${wanted}, not ${shown(record[name])}`);
    }
  };
  if (!isRecord(value) || value.format !== FORMAT) {
    return fail(`not a trace: "format" should be "${FORMAT}"`);
  }
  if (value.version !== VERSION) {
    fail(`version ${shown(value.version)}; this reads version ${VERSION}`);
  }
  const world = ["a world", isRecord] as const;
  need(value, { program: text, world, seed: ["a whole number", isWhole] }, "the header");
  const { name, title, description, obstacles, start } = value.world as Record<string, unknown>;
  need({ name, title, description }, { name: text, title: text, description: text }, "the world");
  if (!Array.isArray(obstacles) || !obstacles.every(isRecord)) {
    return fail("obstacles of the world should be a list of rectangles");
  }
  const rectangle = { x: number, y: number, width: size, height: size, name: text };
  for (const obstacle of obstacles) need(obstacle, rectangle, "an obstacle");
  if (!isRecord(start)) return fail("start of the world should be x, y and heading");
  need(start, { x: number, y: number, heading: number }, "the start");
  return value as unknown as Header;
}

/** A value for a message: as JSON, but never long. */
function shown(value: unknown): string {
  const json = JSON.stringify(value) ?? "nothing";
  return json.length > 60 ? `${json.slice(0, 57)}…` : json;
}
