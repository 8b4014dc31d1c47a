/**
 * What there is to see at a moment, before anything is painted: which layers, which cells, what
 * speaks for the one pointed at. Remembers what stays the same from one frame to the next.
 * May import `trace` and, in this folder, `cells` and `cursor`.
 */
import type { Layer } from "../../trace/events.ts";
import { type CellEvidence, Evidence } from "../../trace/evidence.ts";
import type { Cell } from "../../trace/frames.ts";
import type { Trace } from "../../trace/trace.ts";
import { DrawnCells } from "./cells.ts";
import type { CellCursor } from "./cursor.ts";

export interface Sight {
  /** What is drawn at the moment, and of that what is not switched off. */
  layers: readonly Layer[];
  visible: readonly Layer[];
  cells: DrawnCells;
  cell: Cell | null;
  /** What the beams say about the cell, null without one. */
  evidence: CellEvidence | null;
  /** Cells of another layer in the run before; null if it has none of the same size. */
  different: readonly Cell[] | null;
}

export class Inspector {
  /** Names of the layers that are switched off. */
  readonly hidden = new Set<string>();
  #evidence = new Kept((trace: Trace) => new Evidence(trace));
  #cells = new Kept((trace: Trace, ...layers: Layer[]) => new DrawnCells(trace, layers));
  #cellsBefore = new Kept((trace: Trace, ...layers: Layer[]) => new DrawnCells(trace, layers));
  #different = new Kept((a: DrawnCells, b: DrawnCells) => a.differencesFrom(b));

  look(trace: Trace, t: number, cursor: CellCursor, before: Trace | null): Sight {
    const layers = trace.layersAt(t);
    const visible = this.#visible(layers);
    const cells = this.#cells.of(trace, ...visible);
    const cell = cursor.cell(cells.size);
    return {
      layers,
      visible,
      cells,
      cell,
      evidence: cell && this.#evidence.of(trace).of(cell, t),
      different:
        before &&
        this.#different.of(
          cells,
          this.#cellsBefore.of(before, ...this.#visible(before.layersAt(t))),
        ),
    };
  }

  toggle(name: string): void {
    if (!this.hidden.delete(name)) this.hidden.add(name);
  }

  #visible(layers: readonly Layer[]): Layer[] {
    return layers.filter((layer) => !this.hidden.has(layer.name));
  }
}

/** What was made from some things, kept until it is asked for other things. */
class Kept<Things extends readonly unknown[], Made> {
  readonly #make: (...things: Things) => Made;
  #things: Things | null = null;
  #made: Made | null = null;

  constructor(make: (...things: Things) => Made) {
    this.#make = make;
  }

  of(...things: Things): Made {
    const same =
      this.#things?.length === things.length &&
      things.every((thing, i) => thing === this.#things?.[i]);
    if (!same) {
      this.#made = this.#make(...things);
      this.#things = things;
    }
    return this.#made as Made;
  }
}
