/**
 * How a run is shown: at a speed, or its end at once. Remembered on this device.
 * May import `player` and `ui`.
 */
import { SPEEDS, type Speed } from "../player/player.ts";
import { recall, remember } from "../ui/dom.ts";

export type Pace = Speed | "end";

export const USUAL_SPEED: Speed = 4;

export const PACES: readonly Pace[] = [...SPEEDS, "end"];

export function rememberedPace(): Pace {
  const kept = PACES.find((pace) => String(pace) === recall("speed"));
  if (kept !== undefined) return kept;
  return matchMedia("(prefers-reduced-motion: reduce)").matches ? "end" : USUAL_SPEED;
}

export function rememberPace(pace: Pace): void {
  remember("speed", String(pace));
}
