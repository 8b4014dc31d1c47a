/**
 * What the program has drawn: dots, squares, lines and text, straight from the point store.
 * May import `trace` and, in this folder, `camera` and `palette`.
 */
import { type Layer, POINTS_PER_CM, type Shape } from "../../trace/events.ts";
import type { Camera } from "./camera.ts";

/** What drawing one point takes, next to filling a square. */
const WORK: Record<Shape, number> = { squares: 1, line: 1, dots: 2, text: 20 };
/** Of one text only so much is drawn. */
const MOST_LETTERS = 100;
/** Points in one path: with many more, filling a path takes longer than in proportion. */
const PATH_POINTS = 400;
/** Squares at least so wide are drawn with a gap between them, so that they can be counted. */
const GAP_FROM_PX = 5;

/**
 * Paints as many of the points as `work` allows (a square takes 1) and returns how much is left of
 * it: a program may draw millions of points, and nobody could tell them apart.
 */
export function paintLayer(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  layer: Layer,
  stored: Int16Array,
  font: string,
  work: number,
): number {
  const points = stored.subarray(0, 2 * Math.floor(work / WORK[layer.shape]));
  ctx.fillStyle = ctx.strokeStyle = layer.colour;
  const paint = { dots, squares, line, text };
  paint[layer.shape](ctx, camera, layer, points, font);
  return work - (points.length / 2) * WORK[layer.shape];
}

const x = (camera: Camera, points: Int16Array, i: number) =>
  camera.x((points[i] as number) / POINTS_PER_CM);
const y = (camera: Camera, points: Int16Array, i: number) =>
  camera.y((points[i + 1] as number) / POINTS_PER_CM);

/** On whole pixels: edges stay sharp, and neighbours leave neither seam nor overlap. */
function squares(ctx: CanvasRenderingContext2D, camera: Camera, layer: Layer, points: Int16Array) {
  const half = (layer.size * camera.scale) / 2;
  const gap = 2 * half >= camera.px(GAP_FROM_PX) ? Math.max(1, Math.floor(camera.ratio)) : 0;
  for (let i = 0; i < points.length; i += 2) {
    const left = Math.round(x(camera, points, i) - half);
    const top = Math.round(y(camera, points, i) - half);
    const right = Math.round(x(camera, points, i) + half);
    const bottom = Math.round(y(camera, points, i) + half);
    ctx.fillRect(left, top, Math.max(1, right - left - gap), Math.max(1, bottom - top - gap));
  }
}

function dots(ctx: CanvasRenderingContext2D, camera: Camera, layer: Layer, points: Int16Array) {
  const radius = Math.max((layer.size * camera.scale) / 2, camera.px(0.75));
  for (let from = 0; from < points.length; from += 2 * PATH_POINTS) {
    ctx.beginPath();
    for (let i = from; i < Math.min(from + 2 * PATH_POINTS, points.length); i += 2) {
      ctx.moveTo(x(camera, points, i) + radius, y(camera, points, i));
      ctx.arc(x(camera, points, i), y(camera, points, i), radius, 0, 2 * Math.PI);
    }
    ctx.fill();
  }
}

function line(ctx: CanvasRenderingContext2D, camera: Camera, layer: Layer, points: Int16Array) {
  ctx.lineWidth = Math.max(layer.size * camera.scale, camera.px(1));
  ctx.lineCap = ctx.lineJoin = "round";
  ctx.beginPath();
  for (let i = 0; i < points.length; i += 2) {
    ctx.lineTo(x(camera, points, i), y(camera, points, i));
  }
  ctx.stroke();
}

function text(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  layer: Layer,
  points: Int16Array,
  font: string,
) {
  ctx.font = `${Math.max(layer.size * camera.scale, camera.px(7))}px ${font}`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  for (let i = 0; i < points.length; i += 2) {
    ctx.fillText(
      layer.texts?.[i / 2]?.slice(0, MOST_LETTERS) ?? "",
      x(camera, points, i),
      y(camera, points, i),
    );
  }
}
