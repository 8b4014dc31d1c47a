/**
 * Mouse and finger on the mat: draw, choose, move, change the size, turn. One movement is one step
 * to undo; Escape, or the browser taking the finger for itself, gives it up.
 * May import `trace`.
 */
import type { World } from "../../trace/events.ts";
import type { MatDesk } from "./mat-desk.ts";
import { toMat } from "./mat-picture.ts";
import {
  added,
  drawn,
  headingTo,
  kindOf,
  movedTo,
  type Part,
  type Point,
  resized,
  type Side,
  SNAP_DEG,
  snapped,
  withObstacle,
  withStart,
} from "./shapes.ts";

/** A shorter way than this is a click [pixels]. */
const CLICK_PX = 4;

let drags = 0;

/** The world as a movement to this point makes it, and what is chosen then; null: nothing yet. */
type Move = (to: Point) => { world: World; chosen: Part } | null;

interface Drag {
  pointer: number;
  key: string;
  from: { clientX: number; clientY: number };
  begun: boolean;
  move: Move;
}

export class MatDrag {
  readonly #desk: MatDesk;
  readonly #grid: () => number;
  #drag: Drag | null = null;

  /** `grid` gives what things snap to [cm], 0 for nothing. */
  constructor(desk: MatDesk, grid: () => number) {
    this.#desk = desk;
    this.#grid = grid;
  }

  get active(): boolean {
    return this.#drag !== null;
  }

  down(event: PointerEvent, picture: SVGSVGElement): void {
    if (this.#drag || event.button !== 0 || !event.isPrimary) return;
    const target = event.target instanceof Element ? event.target.closest("[data-part]") : null;
    const from = toMat(picture.getBoundingClientRect(), event.clientX, event.clientY);
    const { part, side } = target instanceof SVGElement ? target.dataset : {};
    const move = this.#moveOf(part ?? null, side ?? null, from);
    if (!move) return;
    const { clientX, clientY, pointerId } = event;
    picture.setPointerCapture(pointerId);
    const key = `drag ${++drags}`;
    this.#drag = { pointer: pointerId, key, from: { clientX, clientY }, begun: false, move };
  }

  move(event: PointerEvent, picture: SVGSVGElement): void {
    const drag = this.#drag;
    if (!drag || event.pointerId !== drag.pointer) return;
    const { clientX, clientY } = event;
    const way = Math.hypot(clientX - drag.from.clientX, clientY - drag.from.clientY);
    if (!drag.begun && way < CLICK_PX) return;
    const next = drag.move(toMat(picture.getBoundingClientRect(), clientX, clientY));
    if (next) {
      this.#desk.change(next.world, drag.key, next.chosen);
      drag.begun = true;
    } else if (drag.begun) {
      this.#desk.abandon(drag.key);
      drag.begun = false;
    }
  }

  up(event: PointerEvent): void {
    if (event.pointerId !== this.#drag?.pointer) return;
    this.#drag = null;
    this.#desk.settle();
  }

  /** Gives the movement up, as if it had not been begun. */
  cancel(): void {
    const drag = this.#drag;
    this.#drag = null;
    if (drag?.begun) this.#desk.abandon(drag.key);
  }

  #moveOf(part: string | null, side: string | null, from: Point): Move | null {
    const { world, chosen } = this.#desk;
    if (part === "handle") return side === "turn" ? this.#turn() : this.#resize(side as Side, from);
    if (part === null) {
      if (chosen !== null) this.#desk.choose(null);
      return this.#desk.hasRoom() ? this.#draw(from) : null;
    }
    const taken: Part = part === "robot" ? "robot" : Number(part);
    if (taken !== chosen) this.#desk.choose(taken);
    if (taken === "robot") {
      const { start } = world;
      return (to) => ({
        world: withStart(world, {
          x: snapped(start.x + to.x - from.x, this.#grid()),
          y: snapped(start.y + to.y - from.y, this.#grid()),
        }),
        chosen: taken,
      });
    }
    const box = world.obstacles[taken];
    if (!box) return null;
    return (to) => {
      const x = snapped(box.x + to.x - from.x, this.#grid());
      const y = snapped(box.y + to.y - from.y, this.#grid());
      return { world: withObstacle(world, taken, movedTo(box, x, y)), chosen: taken };
    };
  }

  #draw(from: Point): Move {
    const { world } = this.#desk;
    return (to) => {
      const box = drawn(from, to, this.#grid());
      if (!box) return null;
      return { world: added(world, { ...box, name: kindOf(box) }), chosen: world.obstacles.length };
    };
  }

  /** The side goes as far as the pointer does: a handle lies beside its side. */
  #resize(side: Side, from: Point): Move | null {
    const { world, chosen } = this.#desk;
    const box = typeof chosen === "number" ? world.obstacles[chosen] : undefined;
    if (typeof chosen !== "number" || !box) return null;
    const x = side.includes("e") ? box.x + box.width : box.x;
    const y = side.includes("n") ? box.y + box.height : box.y;
    return (to) => {
      const at = {
        x: snapped(x + to.x - from.x, this.#grid()),
        y: snapped(y + to.y - from.y, this.#grid()),
      };
      return { world: withObstacle(world, chosen, resized(box, side, at)), chosen };
    };
  }

  #turn(): Move {
    const { world } = this.#desk;
    const step = this.#grid() ? SNAP_DEG : 1;
    return (to) => ({
      world: withStart(world, { heading: headingTo(world.start, to, step) }),
      chosen: "robot",
    });
  }
}
