/**
 * One movement of a number, from taking hold of it to letting go: however many values it passes
 * through, it is one step that undo takes back, and none if it ends where it began. May import
 * `numbers`.
 */
import { isolateHistory, undo } from "@codemirror/commands";
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
  /** The number as it was when it was taken hold of, and how it is written now. */
  #moved: { start: string; now: string } | null = null;

  constructor(view: EditorView, tell: OnNumber) {
    this.#view = view;
    this.#tell = tell;
  }

  hold(): void {
    this.#tell("held");
  }

  move(number: WrittenNumber, value: number): void {
    const { from, to, text } = number;
    const insert = writtenLike(text, value);
    if (insert === text) return;
    const time = Transaction.time.of(ONE_TIME);
    this.#view.dispatch({
      changes: { from, to, insert },
      annotations: this.#moved ? time : [time, isolateHistory.of("before")],
    });
    this.#moved = { start: this.#moved?.start ?? text, now: insert };
    this.#tell("moved");
  }

  release(): void {
    if (!this.#moved) return;
    const { start, now } = this.#moved;
    this.#moved = null;
    if (start === now) this.#dropStep();
    this.#tell("released");
  }

  /** There and back again has left a step that changes nothing. */
  #dropStep(): void {
    // Undoing goes to the caret, and this is not to go anywhere.
    const scrolled = this.#view.scrollSnapshot();
    undo(this.#view);
    this.#view.dispatch({ effects: scrolled });
  }
}

/** The editor's gesture: `view.plugin(gesture)`. */
export const gesture = ViewPlugin.define((view, tell: OnNumber) => new Gesture(view, tell));
