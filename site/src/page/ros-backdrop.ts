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
  /** 0 free to 100 occupied, 255 unknown; row after row from the bottom. */
  cells: Uint8Array;
}

/** Free as programs here draw it, as red, green, blue. */
const FREE = [158, 202, 225] as const;
const MOST = 100;

export function backdropOf(map: OpenedMap, onRemove: () => void): Backdrop {
  const picture = pictureOf(map);
  return {
    name: rosWords.legend(map.name),
    note: rosWords.note(map),
    onRemove,
    paint: (ctx, camera) => paint(ctx, camera, map, picture),
  };
}

/** Whether any of it is on the mat. */
export function isOnMat({ origin: [x, y, yaw], width, height, resolution }: OpenedMap): boolean {
  const [across, up] = [width * resolution, height * resolution];
  const corners = [
    [0, 0],
    [across, 0],
    [0, up],
    [across, up],
  ].map(([a = 0, b = 0]) => ({
    x: 100 * (x + a * Math.cos(yaw) - b * Math.sin(yaw)),
    y: 100 * (y + a * Math.sin(yaw) + b * Math.cos(yaw)),
  }));
  const spans = (values: number[]) => Math.max(...values) > 0 && Math.min(...values) < MAT_CM;
  return spans(corners.map((corner) => corner.x)) && spans(corners.map((corner) => corner.y));
}

/** A pixel a cell, the top row first; what is unknown can be seen through. */
function pictureOf({ width, height, cells }: OpenedMap): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const ctx = canvas.getContext("2d");
  if (!ctx) throw new Error("this browser gives no canvas to draw on");
  const image = ctx.createImageData(width, height);
  for (let i = 0; i < cells.length; i++) {
    const value = cells[i] as number;
    if (value > MOST) continue;
    const at = 4 * ((height - 1 - Math.floor(i / width)) * width + (i % width));
    // From the colour of free floor to black.
    FREE.forEach((full, channel) => {
      image.data[at + channel] = Math.round(full * (1 - value / MOST));
    });
    image.data[at + 3] = 255;
  }
  ctx.putImageData(image, 0, 0);
  return canvas;
}

function paint(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  { origin: [x, y, yaw], width, height, resolution }: OpenedMap,
  picture: HTMLCanvasElement,
): void {
  const scale = 100 * resolution * camera.scale;
  const side = MAT_CM * camera.scale;
  ctx.save();
  ctx.beginPath();
  ctx.rect(camera.x(0), camera.y(MAT_CM), side, side);
  ctx.clip();
  ctx.translate(camera.x(100 * x), camera.y(100 * y));
  ctx.rotate(-yaw); // on the canvas y runs down
  ctx.imageSmoothingEnabled = false;
  ctx.drawImage(picture, 0, -height * scale, width * scale, height * scale);
  ctx.restore();
}
