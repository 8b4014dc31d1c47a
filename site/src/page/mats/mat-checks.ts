/**
 * What is wrong with a mat, or worth knowing before it is used. May import `trace` and `ui`.
 */
import type { World } from "../../trace/events.ts";
import { matWords as words } from "../../ui/mat-words.ts";
import { inTheWay, reach } from "./room.ts";

export interface Finding {
  /** "fault": no robot can be put on it; "note": it can; "fine": nothing to say against it. */
  kind: "fault" | "note" | "fine";
  text: string;
}

/** The robot's places in a wall, in one line; with a fault nothing else is looked at. */
export function checkMat(world: World): Finding {
  const touched = inTheWay(world);
  if (touched) return { kind: "fault", text: words.inTheWay(touched.thing.name, touched.short) };
  if (world.obstacles.length === 0) return { kind: "note", text: words.bare };
  const share = reach(world);
  // A few places of the lattice at a wall's end, where there is no more than a hair.
  if (share > 0.995) return { kind: "fine", text: words.fine };
  if (share < 0.01) return { kind: "note", text: words.shutIn };
  return { kind: "note", text: words.partly(Math.floor(share * 100)) };
}
