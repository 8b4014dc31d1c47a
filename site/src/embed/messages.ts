/**
 * What a page of another site and the lab in its frame say to each other. Imports the outcome's type.
 *
 * The lab's page says HELLO to the page around it; that answers with a greeting and a port, and from
 * then on everything goes through the port. Before that, the page's first script (site/src/early) tells
 * that it is on its way, or what did not arrive.
 */
import type { Outcome } from "../trace/events.ts";

export const HELLO = "bugbot-lab: hello";
export const COMING = "bugbot-lab: coming";
/** Followed by what is wrong, in words. */
export const MISSING = "bugbot-lab: missing ";

/** How a lab is to begin; what is missing is the lab's own choice. */
export interface Start {
  program: string | null;
  world: string | null;
  seed: string | null;
  label: string | null;
  /** Whether the reader may choose the world. */
  pickers: boolean;
  /** Tells labs of one site apart: each has its own kept program. */
  name: string;
}

export interface Greeting {
  kind: typeof HELLO;
  start: Start;
}

/** What the lab is now. */
export interface LabState {
  program: string;
  world: string;
  seed: number;
}

export type ToLab =
  | { kind: "run"; id: number }
  | { kind: "stop" }
  | { kind: "seek"; seconds: number }
  | { kind: "set"; state: Partial<LabState> }
  /** The host has set a property to something that it can't be: `got` says what. */
  | { kind: "wrong"; what: keyof LabState | "seek"; got: string };

export type FromLab =
  | { kind: "state"; state: LabState }
  | { kind: "outcome"; id: number; outcome: Outcome }
  | { kind: "failed"; id: number; message: string }
  /** How high the lab is [px]. */
  | { kind: "height"; pixels: number }
  /** The page is being left: what runs in it comes to nothing. */
  | { kind: "gone" };
