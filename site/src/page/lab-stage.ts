/**
 * The side of a lab that shows a run: overhead view, chart and console, all following one player.
 * May import `trace`, `player` and `views`.
 */
import type { Player } from "../player/player.ts";
import { FORMAT, KINDS, VERSION, type World } from "../trace/events.ts";
import { Trace } from "../trace/trace.ts";

/** A run that has not begun: the world, and the robot where it starts. */
export function emptyTrace(world: World): Trace {
  return new Trace({
    format: FORMAT,
    version: VERSION,
    program: "",
    world,
    seed: 0,
    kinds: KINDS,
  });
}

export class LabStage {
  constructor(stage: HTMLElement, console: HTMLElement, player: Player) {
    stage.textContent = "picture";
    console.textContent = player.trace.header.world.title;
  }

  begin(_before: Trace | null): void {}
}
