/**
 * The map as cells: which layer each square of the mat belongs to, as drawn.
 * May import `trace`.
 */
import { type Layer, POINTS_PER_CM } from "../../trace/events.ts";
import { type Cell, cellsAcross } from "../../trace/frames.ts";
import type { Trace } from "../../trace/trace.ts";

/** The cell size when no squares are drawn [cm]. */
const USUAL_CELL_CM = 5;
/** Squares smaller than this are no cells to be pointed at [cm]. */
const SMALLEST_CELL_CM = 1;

const isGrid = (layer: Layer) =>
  layer.shape === "squares" && layer.size >= SMALLEST_CELL_CM && layer.count > 0;

/** The side of the cells [cm]: that of the first squares drawn. */
export function cellSizeOf(layers: readonly Layer[]): number {
  return layers.find(isGrid)?.size ?? USUAL_CELL_CM;
}

/** The cells of one size on the mat, each with the topmost layer that has a square there. */
export class DrawnCells {
  readonly size: number;
  /** Cells that no square covers. */
  readonly bare: number;
  /** True if any layer drew cells of this size. */
  readonly any: boolean;
  readonly #across: number;
  readonly #layers: readonly Layer[];
  /** For each cell, row by row from the lower left: 1 + the index of its layer, or 0. */
  readonly #owner: Uint16Array;

  constructor(trace: Trace, layers: readonly Layer[], size = cellSizeOf(layers)) {
    this.size = size;
    this.#layers = layers.filter((layer) => isGrid(layer) && layer.size === size);
    this.any = this.#layers.length > 0;
    this.#across = cellsAcross(size);
    this.#owner = new Uint16Array(this.#across ** 2);
    this.#layers.forEach((layer, index) => {
      const points = trace.pointsOf(layer);
      for (let i = 0; i < points.length; i += 2) {
        const cell = this.#index(
          (points[i] as number) / POINTS_PER_CM,
          (points[i + 1] as number) / POINTS_PER_CM,
        );
        if (cell !== null) this.#owner[cell] = index + 1;
      }
    });
    this.bare = this.#owner.reduce((bare, owner) => (owner === 0 ? bare + 1 : bare), 0);
  }

  /** Name of the topmost layer with a square in the cell at a point, or null for bare mat. */
  nameAt(x: number, y: number): string | null {
    const cell = this.#index(x, y);
    const owner = cell === null ? 0 : (this.#owner[cell] ?? 0);
    return this.#layers[owner - 1]?.name ?? null;
  }

  /** The cells that belong to another layer in `other`; null if its cells have another size. */
  differencesFrom(other: DrawnCells): Cell[] | null {
    if (other.size !== this.size) return null;
    const { size } = this;
    const different: Cell[] = [];
    for (let row = 0; row < this.#across; row++) {
      for (let column = 0; column < this.#across; column++) {
        const x = (column + 0.5) * size;
        const y = (row + 0.5) * size;
        if (this.nameAt(x, y) !== other.nameAt(x, y)) {
          different.push({ x: column * size, y: row * size, size });
        }
      }
    }
    return different;
  }

  #index(x: number, y: number): number | null {
    const column = Math.floor(x / this.size);
    const row = Math.floor(y / this.size);
    const inside = column >= 0 && column < this.#across && row >= 0 && row < this.#across;
    return inside ? row * this.#across + column : null;
  }
}
