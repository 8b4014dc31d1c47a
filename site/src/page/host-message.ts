/**
 * What the page around a lab has sent: anything at all, until it has been looked at here. May import
 * the messages of `embed`.
 */
import type { LabState, ToLab } from "../embed/messages.ts";
import { MOST_SEED } from "./address.ts";

/** A message of which nothing can be made. */
export type Unknown = { kind: "unknown" };

/** The message, if it is one; what is wrong with it, if that can be said. */
export function readHostMessage(data: unknown): ToLab | Unknown {
  if (!isRecord(data)) return { kind: "unknown" };
  switch (data.kind) {
    case "run":
      return isNumber(data.id) ? { kind: "run", id: data.id } : { kind: "unknown" };
    case "stop":
      return { kind: "stop" };
    case "seek":
      if (isNumber(data.seconds)) return { kind: "seek", seconds: data.seconds };
      return { kind: "wrong", what: "seek", got: nameOf(data.seconds) };
    case "set":
      return isRecord(data.state) ? readState(data.state) : { kind: "unknown" };
    case "wrong":
      return isWhat(data.what)
        ? { kind: "wrong", what: data.what, got: String(data.got).slice(0, 40) }
        : { kind: "unknown" };
    default:
      return { kind: "unknown" };
  }
}

function readState({ program, world, seed }: Record<string, unknown>): ToLab {
  const wrong = (what: keyof LabState, value: unknown): ToLab => {
    return { kind: "wrong", what, got: nameOf(value) };
  };
  if (program !== undefined && typeof program !== "string") return wrong("program", program);
  if (world !== undefined && typeof world !== "string") return wrong("world", world);
  if (seed !== undefined && !isSeed(seed)) return wrong("seed", seed);
  return {
    kind: "set",
    state: {
      ...(program === undefined ? {} : { program }),
      ...(world === undefined ? {} : { world }),
      ...(seed === undefined ? {} : { seed }),
    },
  };
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null;
}

function isNumber(value: unknown): value is number {
  return Number.isFinite(value);
}

function isSeed(value: unknown): value is number {
  return Number.isSafeInteger(value) && Number(value) >= 0 && Number(value) <= MOST_SEED;
}

function isWhat(value: unknown): value is keyof LabState | "seek" {
  return value === "program" || value === "world" || value === "seed" || value === "seek";
}

/** What a value is, for a message. */
function nameOf(value: unknown): string {
  if (value === null || value === undefined || typeof value === "number") return String(value);
  return typeof value === "object" ? "an object" : `a ${typeof value}`;
}
