/**
 * What a page of another site and the lab in its frame say to each other. Imports the outcome's type.
 *
 * The lab's page says HELLO to the page around it; that answers with a greeting and a port, and from
 * then on everything goes through the port.
 */
import type { Outcome } from "../trace/events.ts";

export const HELLO = "bugbot-lab: hello";

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
  | { kind: "set"; state: Partial<LabState> };

export type FromLab =
  | { kind: "state"; state: LabState }
  | { kind: "outcome"; id: number; outcome: Outcome }
  | { kind: "failed"; id: number; message: string }
  /** How high the lab is [px]. */
  | { kind: "height"; pixels: number };
