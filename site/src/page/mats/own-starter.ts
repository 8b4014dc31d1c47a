/**
 * The program that a mat of one's own begins with: the ready program that maps from one spot, with
 * this mat's start and obstacles in the place of its own. May import `trace`.
 */
import type { World } from "../../trace/events.ts";

/** The lines `START = …` and `REAL = …`, as a ready program has them. */
const START = /^START = .*?(?= {2}#|$)/m;
const REAL = /^REAL = .*$/m;

export function ownStarter(source: string, { start, obstacles }: World): string {
  const boxes = obstacles.map(({ x, y, width, height }) => `(${x}, ${y}, ${width}, ${height})`);
  const list =
    boxes.length > 2 ? `\n${boxes.map((box) => `    ${box},\n`).join("")}` : boxes.join(", ");
  return source
    .replace(START, `START = (${start.x}, ${start.y})`)
    .replace(REAL, `REAL = [${list}]`);
}
