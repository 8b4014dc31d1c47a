/**
 * A small picture of the mat for a result: as it really is, or as a run has mapped it, with what is
 * wrong in the map and the robot's way. May import `runtime`, `trace` and `ui`.
 */
import { nothing, type SVGTemplateResult, svg } from "lit";
import { CELL, type Result, type ResultMap } from "../runtime/results.ts";
import type { World } from "../trace/events.ts";
import { MAT_CM, ROBOT_RADIUS_CM } from "../trace/frames.ts";
import { resultsWords, type Shares } from "../ui/results-words.ts";

/** Centimetres of wall round the mat. */
const RIM = 4;
const VIEW = `${-RIM} ${-RIM} ${MAT_CM + 2 * RIM} ${MAT_CM + 2 * RIM}`;

/** In the picture y runs down, on the mat it runs up. */
const down = (y: number): number => MAT_CM - y;

/** The mat with what really stands on it, and the robot at its start. */
export function truthPicture(world: World): SVGTemplateResult {
  const { x, y } = world.start;
  return frame(
    resultsWords.truthOf(world.title),
    svg`${world.obstacles.map(
      (box) => svg`<rect class="thing" x=${box.x} y=${down(box.y + box.height)}
        width=${box.width} height=${box.height} />`,
    )}
    <circle class="robot" cx=${x} cy=${down(y)} r=${ROBOT_RADIUS_CM} />`,
  );
}

/** The map of a run, over nothing but the mat. */
export function mapPicture({ map, path, seed }: Result): SVGTemplateResult {
  const end = path.at(-1);
  const label = map ? resultsWords.mapOf(seed, sharesOf(map)) : resultsWords.noMap;
  return frame(
    label,
    svg`${
      map
        ? svg`<path class="free" d=${runsOf(map, CELL.free + CELL.wrongFloor)} />
          <path class="occupied" d=${runsOf(map, CELL.occupied)} />
          <path class="wrong" d=${runsOf(map, CELL.wrongWall + CELL.wrongFloor)} />`
        : nothing
    }
    <polyline class="way" points=${path.map(([x, y]) => `${x},${down(y)}`).join(" ")} />
    ${
      end
        ? svg`<circle class="robot" cx=${end[0]} cy=${down(end[1])} r=${ROBOT_RADIUS_CM} />`
        : nothing
    }`,
  );
}

function frame(label: string, content: SVGTemplateResult): SVGTemplateResult {
  return svg`<svg class="result-picture" viewBox=${VIEW} role="img" aria-label=${label}>
    <rect class="wall" x=${-RIM} y=${-RIM} width=${MAT_CM + 2 * RIM} height=${MAT_CM + 2 * RIM} />
    <rect class="mat" width=${MAT_CM} height=${MAT_CM} />
    ${content}
    <rect class="dim" x=${-RIM} y=${-RIM} width=${MAT_CM + 2 * RIM} height=${MAT_CM + 2 * RIM} />
  </svg>`;
}

/** The cells of these letters as one path: cells side by side in a row are one rectangle. */
export function runsOf({ across, cell_cm: side, cells }: ResultMap, letters: string): string {
  const parts: string[] = [];
  for (let row = 0; row < across; row++) {
    for (let column = 0; column < across; column++) {
      const from = column;
      while (column < across && letters.includes(cells.charAt(row * across + column))) column++;
      if (column === from) continue;
      const [x, y, width] = [from * side, down((row + 1) * side), (column - from) * side];
      parts.push(`M${x} ${y}h${width}v${side}h${-width}z`);
    }
  }
  return parts.join("");
}

/** How much of the mat is what [%], and how many cells are wrong. */
function sharesOf({ cells }: ResultMap): Shares {
  const count = (letters: string) => [...cells].filter((cell) => letters.includes(cell)).length;
  const share = (letters: string) => (100 * count(letters)) / cells.length;
  return {
    free: share(CELL.free + CELL.wrongFloor),
    occupied: share(CELL.occupied + CELL.wrongWall),
    unknown: share(CELL.unknown),
    wrong: count(CELL.wrongWall + CELL.wrongFloor),
  };
}

/** The wrong cells: column and row of each. */
export function wrongCells(map: ResultMap | null): [column: number, row: number][] {
  if (!map) return [];
  const wrong: string = CELL.wrongWall + CELL.wrongFloor;
  return [...map.cells].flatMap((cell, i): [number, number][] =>
    wrong.includes(cell) ? [[i % map.across, Math.floor(i / map.across)]] : [],
  );
}
