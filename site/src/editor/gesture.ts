/**
 * One movement of a number, from taking hold of it to letting go: however many values it passes
 * through, it is one step that undo takes back. May import `numbers`.
 */
import { isolateHistory } from "@codemirror/commands";
import { Transaction } from "@codemirror/state";
import { type EditorView, ViewPlugin } from "@codemirror/view";
import { type WrittenNumber, writtenLike } from "./numbers.ts";

/** What happens to a number: it may soon move, its value has changed, it has been let go. */
export type NumberEvent = "held" | "moved" | "released";

export type OnNumber = (event: NumberEvent) => void;

/**
 * The history makes one step of neighbouring changes of about one time. Every change of a movement
 * is said to be of this time [ms]: the same as the one before it, and far from any typing.
 */
const ONE_TIME = 1000;

export class Gesture {
  readonly #view: EditorView;
  readonly #tell: OnNumber;
  #moved = false;

  constructor(view: EditorView, tell: OnNumber) {
    this.#view = view;
    this.#tell = tell;
  }

  hold(): void {
    this.#tell("held");
  }

  move(number: WrittenNumber, value: number): void {
    const insert = writtenLike(number.text, value);
    if (insert === number.text) return;
    const time = Transaction.time.of(ONE_TIME);
    this.#view.dispatch({
      changes: { from: number.from, to: number.to, insert },
      annotations: this.#moved ? time : [time, isolateHistory.of("before")],
    });
    this.#moved = true;
    this.#tell("moved");
  }

  release(): void {
    if (!this.#moved) return;
    this.#moved = false;
    this.#tell("released");
  }
}

/** The editor's gesture: `view.plugin(gesture)`. */
export const gesture = ViewPlugin.define((view, tell: OnNumber) => new Gesture(view, tell));
