/**
 * What lies under the map: the walls, the mat with its scale, and what is really there.
 * May import `trace` and, in this folder, `camera` and `palette`.
 */
import type { Obstacle, World } from "../../trace/events.ts";
import { MAT_CM } from "../../trace/frames.ts";
import { type Camera, WALL_CM } from "./camera.ts";
import type { Palette } from "./palette.ts";

const SCALE_EVERY_CM = 50;
/** Between the lines that mark what is really there, across them [CSS pixels]. */
const HATCH_PX = 5;

export function paintGround(ctx: CanvasRenderingContext2D, camera: Camera, palette: Palette) {
  const walled = MAT_CM + 2 * WALL_CM;
  ctx.fillStyle = palette.wall;
  ctx.beginPath();
  ctx.roundRect(
    camera.x(-WALL_CM),
    camera.y(MAT_CM + WALL_CM),
    walled * camera.scale,
    walled * camera.scale,
    camera.px(5),
  );
  ctx.fill();
  ctx.fillStyle = palette.mat;
  ctx.fillRect(camera.x(0), camera.y(MAT_CM), MAT_CM * camera.scale, MAT_CM * camera.scale);
  ctx.strokeStyle = palette.grid;
  ctx.lineWidth = camera.px(1);
  ctx.beginPath();
  for (let cm = SCALE_EVERY_CM; cm < MAT_CM; cm += SCALE_EVERY_CM) {
    ctx.moveTo(camera.x(cm), camera.y(0));
    ctx.lineTo(camera.x(cm), camera.y(MAT_CM));
    ctx.moveTo(camera.x(0), camera.y(cm));
    ctx.lineTo(camera.x(MAT_CM), camera.y(cm));
  }
  ctx.stroke();
}

/** Numbers in cm along the left and lower edges. */
export function paintScale(ctx: CanvasRenderingContext2D, camera: Camera, palette: Palette) {
  ctx.fillStyle = palette.ink;
  ctx.font = `${camera.px(11)}px ${palette.font}`;
  const left = camera.x(-WALL_CM) - camera.px(5);
  const below = camera.y(-WALL_CM) + camera.px(6);
  for (let cm = 0; cm <= MAT_CM; cm += SCALE_EVERY_CM) {
    ctx.textAlign = "right";
    ctx.textBaseline = cm === MAT_CM ? "top" : cm === 0 ? "alphabetic" : "middle";
    ctx.fillText(String(cm), left, camera.y(cm));
    ctx.textAlign = cm === MAT_CM ? "right" : cm === 0 ? "left" : "center";
    ctx.textBaseline = "top";
    ctx.fillText(cm === MAT_CM ? `${cm} cm` : String(cm), camera.x(cm), below);
  }
}

/** What is really there, hatched: told from a map's cells without its colour as well. */
export function paintTruth(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  world: World,
) {
  ctx.save();
  ctx.beginPath();
  for (const obstacle of world.obstacles) outline(ctx, camera, obstacle);
  ctx.fillStyle = palette.truth;
  ctx.fill();
  ctx.clip();
  ctx.beginPath();
  const step = camera.px(HATCH_PX) * Math.SQRT2;
  for (let x = -camera.height; x < camera.width; x += step) {
    ctx.moveTo(x, camera.height);
    ctx.lineTo(x + camera.height, 0);
  }
  ctx.strokeStyle = palette.truthEdge;
  ctx.globalAlpha = 0.45;
  ctx.lineWidth = camera.px(1);
  ctx.stroke();
  ctx.restore();
}

/** Their outlines again, over the map, so that cells cannot hide them. */
export function paintTruthEdges(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  world: World,
) {
  ctx.beginPath();
  for (const obstacle of world.obstacles) outline(ctx, camera, obstacle);
  ctx.strokeStyle = palette.truthEdge;
  ctx.lineWidth = camera.px(1.25);
  ctx.stroke();
}

function outline(ctx: CanvasRenderingContext2D, camera: Camera, obstacle: Obstacle) {
  const { x, y, width, height } = obstacle;
  ctx.rect(camera.x(x), camera.y(y + height), width * camera.scale, height * camera.scale);
}
