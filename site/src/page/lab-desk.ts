/**
 * What files, links and what is printed ask of a lab. May import types of `runtime`, `trace` and `views`.
 */
import type { Runtime } from "../runtime/client.ts";
import type { World } from "../trace/events.ts";
import type { Trace } from "../trace/trace.ts";
import type { Backdrop } from "../views/overhead/backdrop.ts";
import type { Place } from "./address.ts";
import type { LabProgram } from "./lab-program.ts";
import type { Note } from "./status.ts";

export interface LabDesk {
  /** The element, with its world, seed and title as they are now. */
  readonly lab: HTMLElement & Place & { label: string; backdrop: Backdrop | null };
  readonly program: LabProgram;
  readonly worlds: readonly World[];
  /** Address of the lab's own page. */
  readonly labAddress: string;
  /** The run on show; null before the first. */
  run(): Trace | null;
  /** The run and the moment on the mat, a guest's too. */
  readonly shown: { trace: Trace; time: number };
  readonly runtime: Pick<Runtime, "convert">;
  /** Shows a run made before, on its world. */
  show(run: Trace): Promise<void>;
  say(note: Note | null): void;
}

/** The place of the run on show, or before the first what it would be. */
export function placeOfRun({ lab, run }: LabDesk): Place {
  const header = run()?.header;
  return header
    ? { world: header.world.name, seed: header.seed }
    : { world: lab.world, seed: lab.seed };
}

/** A world of a saved run may be none of this site's: it goes by its name. */
export function titleOf({ worlds }: LabDesk, name: string): string {
  return worlds.find((world) => world.name === name)?.title ?? name;
}
