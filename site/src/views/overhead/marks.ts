/**
 * What points at cells: the cursor, the last beam that touched its cell, and outlined cells.
 * May import `trace` and, in this folder, `camera` and `palette`.
 */
import type { Beam } from "../../trace/evidence.ts";
import type { Cell } from "../../trace/frames.ts";
import type { Camera } from "./camera.ts";
import type { Palette } from "./palette.ts";

/** The outline of the cell pointed at. */
export function paintCursor(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  cell: Cell,
) {
  ctx.beginPath();
  frame(ctx, camera, cell, 1);
  stroke(ctx, camera, palette, palette.cursor, 2.5);
}

/** The beam: a whole line with a dot at its end if it ended in the cell, dashed if it passed on. */
export function paintTouch(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  beam: Beam,
) {
  ctx.setLineDash(beam.ended ? [] : [camera.px(6), camera.px(4)]);
  ctx.beginPath();
  ctx.moveTo(camera.x(beam.x), camera.y(beam.y));
  ctx.lineTo(camera.x(beam.endX), camera.y(beam.endY));
  stroke(ctx, camera, palette, palette.cursor, 2);
  ctx.setLineDash([]);
  if (!beam.ended) return;
  ctx.beginPath();
  ctx.arc(camera.x(beam.endX), camera.y(beam.endY), camera.px(2), 0, 2 * Math.PI);
  stroke(ctx, camera, palette, palette.cursor, 2);
}

/** Cells marked by an outline and a stroke across, so that they show on any colour. */
export function paintCells(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  cells: readonly Cell[],
  colour: string,
) {
  ctx.beginPath();
  for (const cell of cells) {
    frame(ctx, camera, cell, 0);
    ctx.moveTo(camera.x(cell.x), camera.y(cell.y));
    ctx.lineTo(camera.x(cell.x + cell.size), camera.y(cell.y + cell.size));
  }
  stroke(ctx, camera, palette, colour, 1.5);
}

function frame(ctx: CanvasRenderingContext2D, camera: Camera, cell: Cell, outside: number) {
  const away = camera.px(outside);
  const side = cell.size * camera.scale + 2 * away;
  ctx.rect(camera.x(cell.x) - away, camera.y(cell.y + cell.size) - away, side, side);
}

/** Strokes the path, set off by a light line on both sides from whatever colours it lies on. */
function stroke(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  colour: string,
  width: number,
) {
  ctx.lineCap = ctx.lineJoin = "round";
  ctx.strokeStyle = palette.nose;
  ctx.lineWidth = camera.px(width + 2);
  ctx.stroke();
  ctx.strokeStyle = colour;
  ctx.lineWidth = camera.px(width);
  ctx.stroke();
}
