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
  ctx.setLineDash(beam.did === "ended" ? [] : [camera.px(6), camera.px(4)]);
  ctx.beginPath();
  ctx.moveTo(camera.x(beam.x), camera.y(beam.y));
  ctx.lineTo(camera.x(beam.endX), camera.y(beam.endY));
  stroke(ctx, camera, palette, palette.cursor, 2);
  ctx.setLineDash([]);
  if (beam.did !== "ended") return;
  ctx.beginPath();
  ctx.arc(camera.x(beam.endX), camera.y(beam.endY), camera.px(2), 0, 2 * Math.PI);
  stroke(ctx, camera, palette, palette.cursor, 2);
}

/** More cells than this are marked as regions: a frame around every one would hide the map. */
const MANY_CELLS = 60;
/** Of a region, every so many diagonals is drawn. */
const HATCH = 3;

/**
 * Cells marked by an outline and strokes across, so that they show on any colour. Cells that touch
 * are outlined together.
 */
export function paintCells(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  cells: readonly Cell[],
  colour: string,
) {
  const place = ({ x, y, size }: Cell): [column: number, row: number] => [
    Math.round(x / size),
    Math.round(y / size),
  ];
  const marked = new Set(cells.map((cell) => place(cell).join()));
  const line = (x1: number, y1: number, x2: number, y2: number): void => {
    ctx.moveTo(camera.x(x1), camera.y(y1));
    ctx.lineTo(camera.x(x2), camera.y(y2));
  };
  ctx.beginPath();
  for (const cell of cells) {
    const [column, row] = place(cell);
    const [left, low, right, top] = [cell.x, cell.y, cell.x + cell.size, cell.y + cell.size];
    if (!marked.has(`${column - 1},${row}`)) line(left, low, left, top);
    if (!marked.has(`${column + 1},${row}`)) line(right, low, right, top);
    if (!marked.has(`${column},${row - 1}`)) line(left, low, right, low);
    if (!marked.has(`${column},${row + 1}`)) line(left, top, right, top);
    const hatched = cells.length <= MANY_CELLS || (column - row) % HATCH === 0;
    if (hatched) line(left, low, right, top);
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
