/**
 * Between the mat (cm, y up) and the canvas (pixels, y down): the only place that turns y over.
 * May import `trace/frames`.
 *
 * The mat is as large as fits beside the numbers of its scale. Positions on the canvas are in
 * device pixels; a pointer's are in CSS pixels.
 */
import { MAT_CM } from "../../trace/frames.ts";

/** Thickness of the wall drawn around the mat [cm]. */
export const WALL_CM = 3;

/** Room around the walls, for the scale's numbers to the left and below [CSS pixels]. */
const ROOM = { left: 30, right: 2, top: 2, bottom: 22 } as const;

export class Camera {
  /** Size of the canvas [device pixels]. */
  readonly width: number;
  readonly height: number;
  /** Device pixels in a CSS pixel. */
  readonly ratio: number;
  /** Device pixels in a cm. */
  readonly scale: number;
  /** Where the mat's lower left corner is [device pixels]. */
  readonly #left: number;
  readonly #bottom: number;

  /** For a canvas of this many CSS pixels. */
  constructor(cssWidth: number, cssHeight: number, ratio: number) {
    this.ratio = ratio;
    this.width = Math.max(1, Math.round(cssWidth * ratio));
    this.height = Math.max(1, Math.round(cssHeight * ratio));
    const across = this.width - (ROOM.left + ROOM.right) * ratio;
    const up = this.height - (ROOM.top + ROOM.bottom) * ratio;
    const walled = MAT_CM + 2 * WALL_CM;
    this.scale = Math.max(Math.min(across, up) / walled, 0.01);
    const spareX = across - this.scale * walled;
    const spareY = up - this.scale * walled;
    this.#left = ROOM.left * ratio + spareX / 2 + WALL_CM * this.scale;
    this.#bottom = this.height - ROOM.bottom * ratio - spareY / 2 - WALL_CM * this.scale;
  }

  /** Pixels from the left of a point that far to the right on the mat. */
  x(cm: number): number {
    return this.#left + cm * this.scale;
  }

  /** Pixels from the top of a point that far up the mat. */
  y(cm: number): number {
    return this.#bottom - cm * this.scale;
  }

  /** CSS pixels as device pixels: for lines and letters, whose size does not depend on the mat's. */
  px(cssPixels: number): number {
    return cssPixels * this.ratio;
  }

  /** The point of the mat [cm] under a pointer [CSS pixels from the canvas's upper left corner]. */
  toMat(cssX: number, cssY: number): { x: number; y: number } {
    return {
      x: (cssX * this.ratio - this.#left) / this.scale,
      y: (this.#bottom - cssY * this.ratio) / this.scale,
    };
  }
}
