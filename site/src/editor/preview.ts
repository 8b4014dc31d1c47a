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
  readonly #label: string;

  /** `label` says what is previewed, where there is more than one. */
  constructor(parent: HTMLElement, label: string = dialogWords.preview) {
    this.#view = new EditorView({ parent });
    this.#label = label;
  }

  /** Shows a text, at the first of its changed lines (1 first); `lines` says which to mark. */
  show(
    text: string,
    changed: { first: number; last: number } | null,
    lines: readonly number[] = linesOf(changed),
  ): void {
    const marked = extensions(lines, this.#label);
    this.#view.setState(EditorState.create({ doc: text, extensions: marked }));
    const { doc } = this.#view.state;
    const line = doc.line(Math.min(changed?.first ?? 1, doc.lines));
    this.#view.dispatch({ effects: EditorView.scrollIntoView(line.from, { y: "center" }) });
  }
}

function linesOf(changed: { first: number; last: number } | null): readonly number[] {
  if (!changed) return [];
  const { first, last } = changed;
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => first + i);
}

function extensions(lines: readonly number[], label: string): Extension {
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
      "aria-label": label,
      "aria-readonly": "true",
      // Not to be written in, and still to be scrolled by keyboard.
      tabindex: "0",
    }),
    EditorView.decorations.of(({ state: { doc } }) => {
      const marks = new RangeSetBuilder<Decoration>();
      for (const n of lines) {
        if (n > doc.lines) break;
        const { from } = doc.line(n);
        marks.add(from, from, changedLine);
      }
      return marks.finish();
    }),
  ];
}
