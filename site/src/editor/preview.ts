/**
 * A program to read, not to change: with line numbers and colours, and the lines that differ from
 * another one marked. May import `ui` only.
 */
import { python } from "@codemirror/lang-python";
import { EditorState, type Extension, RangeSetBuilder } from "@codemirror/state";
import { Decoration, EditorView, highlightSpecialChars, lineNumbers } from "@codemirror/view";
import { dialogWords } from "../ui/file-words.ts";
import { theme } from "./theme.ts";

const changedLine = Decoration.line({ class: "cm-playing" });

export class ProgramPreview {
  readonly #view: EditorView;

  constructor(parent: HTMLElement) {
    this.#view = new EditorView({ parent });
  }

  /** Shows a text, at the first of its changed lines (1 first). */
  show(text: string, changed: { first: number; last: number } | null): void {
    this.#view.setState(EditorState.create({ doc: text, extensions: extensions(changed) }));
    const { doc } = this.#view.state;
    const line = doc.line(Math.min(changed?.first ?? 1, doc.lines));
    this.#view.dispatch({ effects: EditorView.scrollIntoView(line.from, { y: "center" }) });
  }
}

function extensions(changed: { first: number; last: number } | null): Extension {
  return [
    lineNumbers(),
    // Signs that cannot be seen, or turn text round, can hide what a program does.
    highlightSpecialChars(),
    python(),
    theme,
    EditorView.lineWrapping,
    EditorState.readOnly.of(true),
    EditorView.editable.of(false),
    EditorView.contentAttributes.of({
      "aria-label": dialogWords.preview,
      "aria-readonly": "true",
      // Not to be written in, and still to be scrolled by keyboard.
      tabindex: "0",
    }),
    EditorView.decorations.of(({ state: { doc } }) => {
      const marks = new RangeSetBuilder<Decoration>();
      for (let n = changed?.first ?? 1; n <= (changed?.last ?? 0) && n <= doc.lines; n++) {
        const { from } = doc.line(n);
        marks.add(from, from, changedLine);
      }
      return marks.finish();
    }),
  ];
}
