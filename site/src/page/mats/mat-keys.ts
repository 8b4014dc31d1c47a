/**
 * The keyboard on the mat and in its list. Imports nothing of ours but the desk's type.
 */
import type { MatDesk } from "./mat-desk.ts";

/** With Control an arrow moves so much [cm]. */
const LEAP_CM = 5;

const ARROWS: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

const ACTS: Readonly<Record<string, (desk: MatDesk) => void>> = {
  Delete: (desk) => desk.remove(),
  Backspace: (desk) => desk.remove(),
  Escape: (desk) => desk.choose(null),
  PageDown: (desk) => desk.chooseNext(1),
  PageUp: (desk) => desk.chooseNext(-1),
  n: (desk) => desk.addBox(),
  d: (desk) => desk.duplicate(),
};

/** Does what the key means; false if it means nothing here. */
export function matKey(event: KeyboardEvent, desk: MatDesk): boolean {
  const { key, shiftKey, altKey } = event;
  const mod = event.ctrlKey || event.metaKey;
  if (altKey) return false;
  const arrow = ARROWS[key];
  if (arrow && desk.chosen !== null) {
    const [right, up] = arrow;
    const leap = mod ? LEAP_CM : 1;
    if (shiftKey) desk.grow(right * leap, up * leap);
    else desk.nudge(right * leap, up * leap);
    return true;
  }
  if (mod) return history(key.toLowerCase(), shiftKey, desk);
  const act = ACTS[key.length === 1 ? key.toLowerCase() : key];
  if (!act || shiftKey) return false;
  act(desk);
  return true;
}

function history(key: string, shift: boolean, desk: MatDesk): boolean {
  if (key === "y" || (key === "z" && shift)) desk.redo();
  else if (key === "z") desk.undo();
  else return false;
  return true;
}
