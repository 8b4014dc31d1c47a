/**
 * The whole picture of a moment, for the screen or for a file. What changes rarely (ground, map)
 * is kept on canvases of its own and only copied.
 * May import `trace` and the painters of this folder.
 */

import type { Layer } from "../../trace/events.ts";
import type { Beam } from "../../trace/evidence.ts";
import { type Cell, MAT_CM } from "../../trace/frames.ts";
import type { Trace } from "../../trace/trace.ts";
import type { Backdrop } from "./backdrop.ts";
import { type Camera, WALL_CM } from "./camera.ts";
import { paintGround, paintScale, paintTruth, paintTruthEdges } from "./ground.ts";
import { paintLayer } from "./layers.ts";
import { paintCells, paintCursor, paintTouch } from "./marks.ts";
import type { Palette } from "./palette.ts";
import { paintBeams, paintBumps, paintNote, paintRobot, paintTrail } from "./robot.ts";

/** Only the last so many touches are marked: a robot that leans on a wall leaves thousands. */
const MOST_BUMPS = 200;

/** Points of the trail nearer to each other than this would be drawn for nothing. */
const TRAIL_CM = 0.5;

/** So many squares can be drawn between two frames. */
const MOST_WORK = 40_000;

/** Everything the picture shows. */
export interface Moment {
  trace: Trace;
  t: number;
  /** The visible layers, in order of drawing. */
  layers: readonly Layer[];
  /** Whether what is really there is shown. */
  truth: boolean;
  /** What lies under the layers; null for nothing. */
  backdrop: Backdrop | null;
  /** Cells to be outlined: a failed check's. */
  outlined: readonly Cell[];
  /** Cells that differ from the run before. */
  different: readonly Cell[];
  /** The cell pointed at, and the last beam that touched it. */
  cell: Cell | null;
  touch: Beam | null;
}

export class MatPicture {
  readonly #camera: Camera;
  readonly #palette: Palette;
  readonly #map = document.createElement("canvas");
  /** What the map canvas holds. */
  #mapOf: Pick<Moment, "trace" | "layers" | "truth" | "backdrop"> | null = null;

  constructor(camera: Camera, palette: Palette) {
    this.#camera = camera;
    this.#palette = palette;
    this.#map.width = camera.width;
    this.#map.height = camera.height;
  }

  get camera(): Camera {
    return this.#camera;
  }

  paint(ctx: CanvasRenderingContext2D, moment: Moment): void {
    const camera = this.#camera;
    const palette = this.#palette;
    const { trace, t } = moment;
    if (!this.#holds(moment)) this.#paintMap(moment);
    ctx.clearRect(0, 0, camera.width, camera.height);
    ctx.drawImage(this.#map, 0, 0);
    paintTrail(ctx, camera, palette, trace.trail(0, t, TRAIL_CM));
    const scan = trace.scanAt(t);
    if (scan) paintBeams(ctx, camera, palette, scan);
    const pose = trace.poseAt(t);
    paintRobot(ctx, camera, palette, pose, trace.ledAt(t));
    paintBumps(ctx, camera, palette, trace.bumpsUpTo(t, MOST_BUMPS));
    if (trace.beepAt(t)) paintNote(ctx, camera, palette, pose);
    this.#dim(ctx);
    paintCells(ctx, camera, palette, moment.different, palette.differs);
    paintCells(ctx, camera, palette, moment.outlined, palette.cursor);
    if (moment.touch) paintTouch(ctx, camera, palette, moment.touch);
    if (moment.cell) paintCursor(ctx, camera, palette, moment.cell);
  }

  #holds({ trace, layers, truth, backdrop }: Moment): boolean {
    const held = this.#mapOf;
    return (
      held !== null &&
      held.trace === trace &&
      held.truth === truth &&
      held.backdrop === backdrop &&
      held.layers.length === layers.length &&
      held.layers.every((layer, i) => layer === layers[i])
    );
  }

  #paintMap({ trace, layers, truth, backdrop }: Moment): void {
    const ctx = this.#map.getContext("2d");
    if (!ctx) return;
    const camera = this.#camera;
    const palette = this.#palette;
    const { world } = trace.header;
    ctx.clearRect(0, 0, camera.width, camera.height);
    paintGround(ctx, camera, palette);
    paintScale(ctx, camera, palette);
    if (truth) paintTruth(ctx, camera, palette, world);
    backdrop?.paint(ctx, camera);
    let work = MOST_WORK;
    for (const layer of layers) {
      work = paintLayer(ctx, camera, layer, trace.pointsOf(layer), palette.font, work);
    }
    if (truth) paintTruthEdges(ctx, camera, palette, world);
    this.#mapOf = { trace, layers, truth, backdrop };
  }

  /** In the dark theme the mat is the same, only dimmer; in the light one this changes nothing. */
  #dim(ctx: CanvasRenderingContext2D): void {
    const camera = this.#camera;
    const side = (MAT_CM + 2 * WALL_CM) * camera.scale;
    ctx.globalCompositeOperation = "multiply";
    ctx.fillStyle = this.#palette.dim;
    ctx.beginPath();
    ctx.roundRect(camera.x(-WALL_CM), camera.y(MAT_CM + WALL_CM), side, side, camera.px(5));
    ctx.fill();
    ctx.globalCompositeOperation = "source-over";
  }
}
