/**
 * The mat of the world editor as a picture to take hold of: what stands on it, the robot, and the
 * handles of what is chosen. Parts name themselves in `data-part`; `mat-drag.ts` acts on them.
 * May import `trace`.
 */
import { nothing, type SVGTemplateResult, svg } from "lit";
import type { Obstacle, World } from "../../trace/events.ts";
import { direction, MAT_CM, ROBOT_RADIUS_CM } from "../../trace/frames.ts";
import type { Part, Point, Side } from "./shapes.ts";

/** Room around the mat [cm]: its wall, and the numbers of its scale to the left and below. */
const ROOM = { left: 20, right: 4, top: 4, bottom: 13 } as const;
const WALL_CM = 3;
const SCALE_EVERY_CM = 50;
const LINES_EVERY_CM = 10;

/** Pixels: the half of a handle that is seen, of what can be hit, and how far off a side it is. */
const HANDLE_PX = 6;
const HIT_PX = { mouse: 12, finger: 20 } as const;
const AWAY_PX = { mouse: 10, finger: 18 } as const;
/** A side shorter than this has no handles at its ends [pixels]. */
const CORNERS_FROM_PX = 70;
/** Things smaller than this are hit beside themselves as well [pixels]. */
const EASY_PX = { mouse: 14, finger: 32 } as const;

export const WIDTH = ROOM.left + MAT_CM + ROOM.right;
const HEIGHT = ROOM.top + MAT_CM + ROOM.bottom;
export const VIEW_BOX = `${-ROOM.left} ${-ROOM.top} ${WIDTH} ${HEIGHT}`;

export interface MatLook {
  world: World;
  chosen: Part | null;
  /** Pixels in a cm. */
  scale: number;
  finger: boolean;
}

/** In the picture y runs down, on the mat it runs up. */
const down = (y: number): number => MAT_CM - y;

/** The point of the mat under a pointer, from where the picture is on the screen. */
export function toMat(box: DOMRect, clientX: number, clientY: number): Point {
  const scale = WIDTH / box.width;
  return {
    x: (clientX - box.left) * scale - ROOM.left,
    y: down((clientY - box.top) * scale - ROOM.top),
  };
}

export function matPicture(look: MatLook): SVGTemplateResult {
  const { world, chosen } = look;
  const box = typeof chosen === "number" ? world.obstacles[chosen] : undefined;
  return svg`
    <defs>
      <pattern id="mat-hatch" width="3" height="3" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
        <rect class="truth" width="3" height="3" />
        <line class="hatch" x1="0" x2="0" y1="0" y2="3" />
      </pattern>
    </defs>
    <g class="mat-ground">
      <rect class="wall" x=${-WALL_CM} y=${-WALL_CM} width=${MAT_CM + 2 * WALL_CM} height=${MAT_CM + 2 * WALL_CM} rx="1.5" />
      <rect class="mat" width=${MAT_CM} height=${MAT_CM} />
      <path class="lines" d=${lines(LINES_EVERY_CM)} />
      <path class="lines strong" d=${lines(SCALE_EVERY_CM)} />
      ${world.obstacles.map((each, i) => thing(look, each, i))}
      ${robot(look)}
      <rect class="dim" x=${-WALL_CM} y=${-WALL_CM} width=${MAT_CM + 2 * WALL_CM} height=${MAT_CM + 2 * WALL_CM} rx="1.5" />
    </g>
    ${scaleNumbers(look.scale)}
    ${box ? outline(box) : nothing}
    ${box ? handles(look, box) : chosen === "robot" ? robotHandles(look) : nothing}
  `;
}

function lines(every: number): string {
  let path = "";
  for (let cm = every; cm < MAT_CM; cm += every) path += `M${cm} 0V${MAT_CM}M0 ${cm}H${MAT_CM}`;
  return path;
}

function scaleNumbers(scale: number): SVGTemplateResult[] {
  const size = 11 / scale;
  const marks: SVGTemplateResult[] = [];
  for (let cm = 0; cm <= MAT_CM; cm += SCALE_EVERY_CM) {
    const last = cm === MAT_CM;
    marks.push(
      svg`<text class="scale" font-size=${size} text-anchor="end" x=${-WALL_CM - 4 / scale}
        y=${down(cm) + (last ? size * 0.8 : cm === 0 ? 0 : size * 0.35)}>${cm}</text>`,
      svg`<text class="scale" font-size=${size} y=${MAT_CM + WALL_CM + size + 1}
        text-anchor=${last ? "end" : cm === 0 ? "start" : "middle"} x=${cm}>${cm}${last ? " cm" : ""}</text>`,
    );
  }
  return marks;
}

function thing({ scale, finger }: MatLook, box: Obstacle, index: number): SVGTemplateResult {
  const { x, y, width, height } = box;
  const least = EASY_PX[finger ? "finger" : "mouse"] / scale;
  const beside = Math.max(0, (least - width) / 2);
  const above = Math.max(0, (least - height) / 2);
  return svg`<g data-part=${index}>
    <rect class="hit" x=${x - beside} y=${down(y + height) - above}
      width=${width + 2 * beside} height=${height + 2 * above} />
    <rect class="thing" x=${x} y=${down(y + height)} width=${width} height=${height} fill="url(#mat-hatch)" />
  </g>`;
}

function outline({ x, y, width, height }: Obstacle): SVGTemplateResult {
  return svg`<rect class="chosen" x=${x} y=${down(y + height)} width=${width} height=${height} />`;
}

function robot({ world, scale, finger }: MatLook): SVGTemplateResult {
  const { x, y, heading } = world.start;
  const [right, up] = direction(heading);
  const r = ROBOT_RADIUS_CM;
  const at = (ahead: number, aside: number): string =>
    `${x + r * (ahead * right + aside * up)} ${down(y) - r * (ahead * up - aside * right)}`;
  const hit = Math.max(r, HIT_PX[finger ? "finger" : "mouse"] / scale);
  return svg`<g data-part="robot">
    <circle class="hit" cx=${x} cy=${down(y)} r=${hit} />
    <circle class="rim" cx=${x} cy=${down(y)} r=${r + 0.6} />
    <circle class="robot" cx=${x} cy=${down(y)} r=${r} />
    <path class="nose" d="M${at(0.78, 0)}L${at(-0.46, 0.56)}L${at(-0.2, 0)}L${at(-0.46, -0.56)}Z" />
  </g>`;
}

/** A ring, and a knob ahead that turns it. */
function robotHandles({ world, scale, finger }: MatLook): SVGTemplateResult {
  const { x, y, heading } = world.start;
  const [right, up] = direction(heading);
  const far = ROBOT_RADIUS_CM + (finger ? 34 : 24) / scale;
  const knob = { x: x + far * right, y: y + far * up };
  return svg`<line class="stalk" x1=${x + right * ROBOT_RADIUS_CM} y1=${down(y + up * ROBOT_RADIUS_CM)} x2=${knob.x} y2=${down(knob.y)} />
    <circle class="chosen" cx=${x} cy=${down(y)} r=${ROBOT_RADIUS_CM + 1.5} />
    ${handle("turn", knob, scale, finger)}`;
}

function handles({ scale, finger }: MatLook, box: Obstacle): SVGTemplateResult[] {
  return handlePlaces(box, scale, finger).map(({ side, at }) => handle(side, at, scale, finger));
}

/** Where the handles of a rectangle are: off its sides, so that it can be dragged between them. */
export function handlePlaces(
  { x, y, width, height }: Obstacle,
  scale: number,
  finger: boolean,
): { side: Side; at: Point }[] {
  const away = AWAY_PX[finger ? "finger" : "mouse"] / scale;
  const across = { w: x - away, "": x + width / 2, e: x + width + away };
  const along = { s: y - away, "": y + height / 2, n: y + height + away };
  const corners = Math.min(width, height) * scale >= CORNERS_FROM_PX;
  const sides: Side[] = [
    "n",
    "s",
    "e",
    "w",
    ...(corners ? (["ne", "nw", "se", "sw"] as const) : []),
  ];
  // At the mat's edge a handle stays where it can be reached.
  const low = -ROOM.right;
  const high = MAT_CM + ROOM.right;
  return sides.map((side) => ({
    side,
    at: {
      x: Math.min(Math.max(across[(/[ew]/.exec(side)?.[0] ?? "") as "e" | "w" | ""], low), high),
      y: Math.min(Math.max(along[(/[ns]/.exec(side)?.[0] ?? "") as "n" | "s" | ""], low), high),
    },
  }));
}

function handle(part: string, at: Point, scale: number, finger: boolean): SVGTemplateResult {
  const hit = HIT_PX[finger ? "finger" : "mouse"] / scale;
  const seen = (finger ? HANDLE_PX + 2 : HANDLE_PX) / scale;
  return svg`<g data-part="handle" data-side=${part}>
    <circle class="hit" cx=${at.x} cy=${down(at.y)} r=${hit} />
    <circle class="handle" cx=${at.x} cy=${down(at.y)} r=${seen} />
  </g>`;
}
