/**
 * A ROS map on the mat. Its coordinates are the mat's, in metres: the map's origin is where its lower
 * left corner lies. May import `views`, `trace` and `ui`.
 */
import { MAT_CM } from "../trace/frames.ts";
import { rosWords } from "../ui/ros-words.ts";
import type { Backdrop } from "../views/overhead/backdrop.ts";
import type { Camera } from "../views/overhead/camera.ts";

/** A map as `py/bridge/ros.py` reads it. */
export interface OpenedMap {
  name: string;
  width: number;
  height: number;
  /** Side of a cell [m]. */
  resolution: number;
  /** Lower left corner [m], and turn, counter-clockwise [rad]. */
  origin: readonly [x: number, y: number, yaw: number];
  mode: string;
  negate: boolean;
  occupied_thresh: number;
  free_thresh: number;
  /** What a reader of the map should know, in sentences without a stop. */
  doubts: readonly string[];
  /** 0 free to 100 occupied, 255 unknown; row after row from the bottom. */
  cells: Uint8Array;
}

/** Free as programs here draw it, as red, green, blue. */
const FREE = [158, 202, 225] as const;
const MOST = 100;
/** A picture with longer sides is made smaller: no screen shows more of the mat [pixels]. */
const MOST_SIDE = 2000;

export function backdropOf(map: OpenedMap, onRemove: () => void): Backdrop {
  const picture = pictureOf(map);
  return {
    name: rosWords.legend(map.name),
    note: rosWords.note(map),
    more: rosWords.more(map),
    onRemove,
    paint: (ctx, camera) => {
      if (picture) paint(ctx, camera, map, picture);
    },
  };
}

/** How far the map reaches, as from and to [cm], and how much of it is on the mat. */
export interface Reach {
  x: readonly [number, number];
  y: readonly [number, number];
  onMat: "all" | "part" | "none";
}

export function reachOf(map: OpenedMap): Reach {
  const { origin, width, height, resolution } = map;
  const corners = cornersOf(100 * width * resolution, 100 * height * resolution);
  const turned = turn(corners, origin[2]).map(
    ([a, b]): Point => [a + 100 * origin[0], b + 100 * origin[1]],
  );
  const [x, y] = [spanOf(turned, 0), spanOf(turned, 1)];
  const inside = [x, y].every(([from, to]) => from > -SLACK_CM && to < MAT_CM + SLACK_CM);
  const onMat = inside ? "all" : partOnMat(map) ? "part" : "none";
  return { x, y, onMat };
}

/** Less than this beyond the edge is a rounding error [cm]. */
const SLACK_CM = 0.01;

type Point = readonly [number, number];

function cornersOf(across: number, up: number): Point[] {
  return [
    [0, 0],
    [across, 0],
    [0, up],
    [across, up],
  ];
}

function turn(points: readonly Point[], by: number): Point[] {
  const [sin, cos] = [Math.sin(by), Math.cos(by)];
  return points.map(([a, b]) => [a * cos - b * sin, a * sin + b * cos]);
}

function spanOf(points: readonly Point[], axis: 0 | 1): [number, number] {
  const values = points.map((point) => point[axis]);
  return [Math.min(...values), Math.max(...values)];
}

/** Columns and rows of the map that may be on the mat: from, and up to but not including. */
interface Part {
  columns: [number, number];
  rows: [number, number];
}

/** Null if there are none. */
function partOnMat({ origin: [x, y, yaw], width, height, resolution }: OpenedMap): Part | null {
  const cell = 100 * resolution;
  const moved = cornersOf(MAT_CM, MAT_CM).map(([a, b]): Point => [a - 100 * x, b - 100 * y]);
  const mat = turn(moved, -yaw);
  const range = (axis: 0 | 1, count: number): [number, number] => {
    const [from, to] = spanOf(mat, axis);
    return [Math.max(0, Math.floor(from / cell)), Math.min(count, Math.ceil(to / cell))];
  };
  const [columns, rows] = [range(0, width), range(1, height)];
  if (columns[0] >= columns[1] || rows[0] >= rows[1]) return null;
  // The other way round as well: a turned map's frame may meet the mat where the map does not.
  const around = turn(cornersOf(width * cell, height * cell), yaw);
  const meets = ([from, to]: Point, at: number): boolean => to + at > 0 && from + at < MAT_CM;
  return meets(spanOf(around, 0), 100 * x) && meets(spanOf(around, 1), 100 * y)
    ? { columns, rows }
    : null;
}

/** A picture of cells, and where in the map it lies: its lower left cell, and cells to a pixel. */
interface Picture {
  canvas: HTMLCanvasElement;
  left: number;
  bottom: number;
  cells: number;
}

/** What may be on the mat, the top row first; what is unknown can be seen through. */
function pictureOf(map: OpenedMap): Picture | null {
  const part = partOnMat(map);
  if (!part) return null;
  const { columns, rows } = part;
  const [across, up] = [columns[1] - columns[0], rows[1] - rows[0]];
  const cells = Math.ceil(Math.max(across, up) / MOST_SIDE);
  const canvas = document.createElement("canvas");
  canvas.width = Math.ceil(across / cells);
  canvas.height = Math.ceil(up / cells);
  const ctx = canvas.getContext("2d");
  if (!ctx) throw new Error("this browser gives no canvas to draw on");
  const image = ctx.createImageData(canvas.width, canvas.height);
  const pixels = new Uint32Array(image.data.buffer);
  for (let y = 0; y < canvas.height; y++) {
    const top = canvas.height - 1 - y;
    for (let x = 0; x < canvas.width; x++) {
      const column = columns[0] + x * cells;
      const row = rows[0] + y * cells;
      pixels[top * canvas.width + x] = COLOURS[strongest(map, column, row, cells, part)] as number;
    }
  }
  ctx.putImageData(image, 0, 0);
  return { canvas, left: columns[0], bottom: rows[0], cells };
}

/** Of so many cells across and up: a wall before floor, and floor before nothing. */
function strongest(
  { width, cells: values }: OpenedMap,
  column: number,
  row: number,
  cells: number,
  { columns, rows }: Part,
): number {
  if (cells === 1) return values[row * width + column] as number;
  let found = UNKNOWN;
  for (let y = row; y < Math.min(row + cells, rows[1]); y++) {
    for (let x = column; x < Math.min(column + cells, columns[1]); x++) {
      const value = values[y * width + x] as number;
      if (value <= MOST && (found === UNKNOWN || value > found)) found = value;
    }
  }
  return found;
}

const UNKNOWN = 255;

/** Each value's colour as a pixel has it in memory: free floor's to black, and nothing. */
const COLOURS = new Uint32Array(
  Uint8Array.from({ length: 4 * 256 }, (_, i) => {
    const value = i >> 2;
    if (value > MOST) return 0;
    return (i & 3) === 3 ? 255 : Math.round((FREE[i & 3] ?? 0) * (1 - value / MOST));
  }).buffer,
);

function paint(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  { origin: [x, y, yaw], resolution }: OpenedMap,
  { canvas, left, bottom, cells }: Picture,
): void {
  const scale = 100 * resolution * camera.scale;
  const side = MAT_CM * camera.scale;
  const [across, up] = [canvas.width * cells * scale, canvas.height * cells * scale];
  ctx.save();
  ctx.beginPath();
  ctx.rect(camera.x(0), camera.y(MAT_CM), side, side);
  ctx.clip();
  ctx.translate(camera.x(100 * x), camera.y(100 * y));
  ctx.rotate(-yaw); // on the canvas y runs down
  ctx.imageSmoothingEnabled = cells * scale < 1;
  ctx.drawImage(canvas, left * scale, -bottom * scale - up, across, up);
  ctx.restore();
}
