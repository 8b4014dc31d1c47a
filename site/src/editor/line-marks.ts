/**
 * Two marks on whole lines: where the run is at the shown time, and where the program failed.
 */
import {
  type EditorState,
  type Extension,
  type Range,
  StateEffect,
  StateField,
} from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView, WidgetType } from "@codemirror/view";

/** The line being carried out at the shown time (1 first), or null for none. */
export const setPlayingLine = StateEffect.define<number | null>();
/** The line the program failed on and what to say there, or null for none. */
export const setFaultLine = StateEffect.define<{ line: number; message: string } | null>();

class FaultNote extends WidgetType {
  readonly #message: string;

  constructor(message: string) {
    super();
    this.#message = message;
  }

  override eq(other: FaultNote): boolean {
    return other.#message === this.#message;
  }

  override toDOM(): HTMLElement {
    const note = document.createElement("div");
    note.className = "cm-fault-note";
    note.textContent = this.#message;
    return note;
  }
}

const playingLine = Decoration.line({ class: "cm-playing" });
const faultLine = Decoration.line({ class: "cm-fault" });

/** Where line `number` starts, or null if the program has no such line. */
export function lineStart(state: EditorState, number: number): number | null {
  return number >= 1 && number <= state.doc.lines ? state.doc.line(number).from : null;
}

const playing = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, transaction) {
    for (const effect of transaction.effects) {
      if (!effect.is(setPlayingLine)) continue;
      const from = effect.value === null ? null : lineStart(transaction.state, effect.value);
      return from === null ? Decoration.none : Decoration.set(playingLine.range(from));
    }
    // After an edit the run's line numbers no longer belong to this text.
    return transaction.docChanged ? Decoration.none : marks;
  },
  provide: (field) => EditorView.decorations.from(field),
});

const fault = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, transaction) {
    for (const effect of transaction.effects) {
      if (effect.is(setFaultLine)) return faultMarks(transaction.state, effect.value);
    }
    if (!transaction.docChanged || marks.size === 0) return marks;
    let touched = false;
    const { doc } = transaction.startState;
    marks.between(0, doc.length, (from) => {
      touched ||= transaction.changes.touchesRange(from, doc.lineAt(from).to) !== false;
    });
    return touched ? Decoration.none : marks.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

function faultMarks(
  state: EditorState,
  value: { line: number; message: string } | null,
): DecorationSet {
  const from = value && lineStart(state, value.line);
  if (!value || from === null) return Decoration.none;
  const note = Decoration.widget({ widget: new FaultNote(value.message), block: true, side: 1 });
  const marks: Range<Decoration>[] = [faultLine.range(from), note.range(state.doc.lineAt(from).to)];
  return Decoration.set(marks);
}

export const lineMarks: Extension = [playing, fault];
