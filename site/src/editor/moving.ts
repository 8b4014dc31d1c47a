/**
 * Any number of the program can be moved: drag it with Alt held, or press Alt with the up and down
 * arrows while the caret is in it. May import `numbers` and `gesture`.
 */
import { syntaxTree } from "@codemirror/language";
import { type Extension, Prec } from "@codemirror/state";
import { EditorView, keymap } from "@codemirror/view";
import { gesture } from "./gesture.ts";
import { numberAt, onStep, stepped, type WrittenNumber } from "./numbers.ts";

/** A step of the number for so much of a drag [px]. */
const STEP_PX = 4;

function numberIn(view: EditorView, at: number): WrittenNumber | null {
  return numberAt(syntaxTree(view.state), view.state.doc.toString(), at);
}

/** The number that is drawn at a place in the window. */
function numberUnder(view: EditorView, x: number, y: number): WrittenNumber | null {
  const at = view.posAtCoords({ x, y });
  const number = at === null ? null : numberIn(view, at);
  const left = number && view.coordsAtPos(number.from)?.left;
  const right = number && view.coordsAtPos(number.to)?.right;
  // Beyond the end of a line is not on its last number.
  return left && right && x >= left - STEP_PX && x <= right + STEP_PX ? number : null;
}

/** Follows the pointer until it lets go. */
function drag(view: EditorView, event: PointerEvent): boolean {
  if (!event.altKey || event.button !== 0 || event.pointerType === "touch") return false;
  const moves = view.plugin(gesture);
  const start = numberUnder(view, event.clientX, event.clientY);
  if (!moves || !start) return false;
  const { contentDOM } = view;
  const follow = ({ clientX }: PointerEvent): void => {
    const steps = Math.round((clientX - event.clientX) / STEP_PX);
    const here = numberIn(view, start.from);
    // A value between steps stays what it is until the pointer has gone a step.
    const value = steps === 0 ? start.value : onStep(start, start.value + steps * start.step);
    if (here) moves.move(here, value);
  };
  const letGo = (): void => {
    contentDOM.removeEventListener("pointermove", follow);
    moves.release();
  };
  moves.hold();
  contentDOM.setPointerCapture(event.pointerId);
  contentDOM.addEventListener("pointermove", follow);
  contentDOM.addEventListener("lostpointercapture", letGo, { once: true });
  // Neither the caret nor the selection follows the pointer.
  event.preventDefault();
  return true;
}

function step(view: EditorView, by: 1 | -1): boolean {
  const number = numberIn(view, view.state.selection.main.head);
  const moves = view.plugin(gesture);
  if (!number || !moves) return false;
  moves.hold();
  moves.move(number, stepped(number, by));
  return true;
}

export const movingNumbers: Extension = [
  // Before the keys that move whole lines, which still do where the caret is in no number.
  Prec.high(
    keymap.of([
      { key: "Alt-ArrowUp", run: (view) => step(view, 1) },
      { key: "Alt-ArrowDown", run: (view) => step(view, -1) },
    ]),
  ),
  EditorView.domEventHandlers({
    pointerdown: (event, view) => drag(view, event),
    mousemove: ({ altKey }, view) => {
      view.scrollDOM.classList.toggle("cm-moves-numbers", altKey);
    },
    keyup: (_event, view) => view.plugin(gesture)?.release(),
    blur: (_event, view) => view.plugin(gesture)?.release(),
  }),
];
