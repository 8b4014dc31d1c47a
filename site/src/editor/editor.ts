/**
 * The program's editor: CodeMirror put together from its parts, behind the few things a lab asks.
 * May import `ui` only; what it needs to know of the robot is handed in.
 */
import { defaultKeymap, history, historyKeymap, isolateHistory } from "@codemirror/commands";
import { python } from "@codemirror/lang-python";
import { bracketMatching, ensureSyntaxTree, indentOnInput, indentUnit } from "@codemirror/language";
import { lintKeymap } from "@codemirror/lint";
import { EditorState, type Extension, Prec } from "@codemirror/state";
import {
  drawSelection,
  dropCursor,
  EditorView,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import { editorWords } from "../ui/strings.ts";
import { argumentHelp } from "./argument-help.ts";
import type { Call } from "./calls.ts";
import { finding } from "./finding.ts";
import { gesture, type OnNumber } from "./gesture.ts";
import { leaveWithEscape } from "./leaving.ts";
import { lineMarks, lineStart, setFaultLine, setPlayingLine } from "./line-marks.ts";
import { movingNumbers } from "./moving.ts";
import { constantsOf, withValues } from "./numbers.ts";
import { robotCalls } from "./robot-calls.ts";
import { sliders } from "./sliders.ts";
import { syntaxProblems } from "./syntax.ts";
import { theme } from "./theme.ts";
import { typing } from "./typing.ts";
import "./unmeasured.css";

export interface EditorOptions {
  text: string;
  calls: readonly Call[];
  /** Id of an element that says how to leave the editor. */
  describedBy: string;
  /** The text has changed, by typing or by `replace`. */
  onChange(text: string): void;
  /** Ctrl or Cmd with Enter. */
  onRun(): void;
  /** A number is being moved by its slider, by dragging or by keys. */
  onNumber: OnNumber;
}

/** Reading a whole program takes a few ms; this much is given to a very long one [ms]. */
const PARSE_MS = 200;

/** Longer insertions need care [characters]. */
const LONG = 100_000;

export class ProgramEditor {
  readonly #view: EditorView;
  readonly #extensions: Extension;
  readonly #onChange: (text: string) => void;

  constructor(parent: HTMLElement, options: EditorOptions) {
    this.#extensions = extensions(options);
    this.#onChange = options.onChange;
    this.#view = new EditorView({ parent, state: this.#stateOf(options.text) });
  }

  #stateOf(text: string): EditorState {
    return EditorState.create({ doc: text, extensions: this.#extensions });
  }

  get text(): string {
    return this.#view.state.doc.toString();
  }

  /** Opens another program: nothing of the one before is left, not even in the history. */
  open(text: string): void {
    delete this.#view.dom.dataset.measured;
    this.#view.setState(this.#stateOf(text));
  }

  /**
   * Puts another text in place of this one, as one step that undo takes back.
   * Only what differs is changed, so the cursor stays where it was.
   */
  replace(text: string): void {
    const old = this.text;
    if (text === old) return;
    let start = 0;
    while (start < old.length && start < text.length && old[start] === text[start]) start++;
    let oldEnd = old.length;
    let newEnd = text.length;
    while (oldEnd > start && newEnd > start && old[oldEnd - 1] === text[newEnd - 1]) {
      oldEnd--;
      newEnd--;
    }
    const step = this.#view.state.update({
      changes: { from: start, to: oldEnd, insert: text.slice(start, newEnd) },
      annotations: isolateHistory.of("full"),
      userEvent: "input.replace",
    });
    if (newEnd - start < LONG) {
      this.#view.dispatch(step);
    } else {
      // Out of the window's sight, what is inserted would all be drawn, to the last line.
      this.#view.setState(step.state);
      this.#onChange(this.text);
    }
  }

  /**
   * Gives each `NAME = number` at the program's top level another value, all as one step that undo
   * takes back. Throws a RangeError where there is no such line, and then has changed nothing.
   */
  setConstants(values: Readonly<Record<string, number>>): void {
    const { text } = this;
    const tree = ensureSyntaxTree(this.#view.state, text.length, PARSE_MS);
    this.replace(withValues(text, tree ? constantsOf(tree, text) : [], values));
  }

  /** Marks the line being carried out at the shown time (1 first); null takes the mark away. */
  showPlaying(line: number | null): void {
    this.#view.dispatch({ effects: setPlayingLine.of(line) });
  }

  /** Marks the line that failed, with the message under it; null takes the mark away. */
  showFault(fault: { line: number; message: string } | null): void {
    const from = fault && lineStart(this.#view.state, fault.line);
    this.#view.dispatch({
      effects: [
        setFaultLine.of(fault),
        ...(from === null ? [] : [EditorView.scrollIntoView(from, { y: "center" })]),
      ],
    });
  }

  /** Puts the cursor at the start of what is written on a line (1 first) and goes there. */
  goToLine(line: number): void {
    const { doc } = this.#view.state;
    const { from, text } = doc.line(Math.max(1, Math.min(line, doc.lines)));
    const anchor = from + (text.length - text.trimStart().length);
    this.#view.dispatch({
      selection: { anchor },
      effects: EditorView.scrollIntoView(anchor, { y: "center" }),
    });
    this.#view.focus();
  }

  destroy(): void {
    this.#view.destroy();
  }
}

function extensions(options: EditorOptions): Extension {
  const run = (): boolean => {
    options.onRun();
    return true;
  };
  return [
    Prec.highest(keymap.of([{ key: "Mod-Enter", run }])),
    lineNumbers(),
    highlightActiveLineGutter(),
    history(),
    drawSelection(),
    dropCursor(),
    indentUnit.of("    "),
    EditorState.tabSize.of(4),
    indentOnInput(),
    bracketMatching(),
    finding(),
    python(),
    argumentHelp(options.calls),
    typing,
    robotCalls(options.calls),
    syntaxProblems,
    lineMarks,
    gesture.of(options.onNumber),
    sliders,
    movingNumbers,
    theme,
    keymap.of([...defaultKeymap, ...historyKeymap, ...lintKeymap]),
    leaveWithEscape,
    EditorView.contentAttributes.of({
      "aria-label": editorWords.name,
      "aria-describedby": options.describedBy,
      // A contenteditable element can be reached anyway; this says so to those who check.
      tabindex: "0",
      autocapitalize: "off",
      autocorrect: "off",
      spellcheck: "false",
    }),
    EditorView.updateListener.of((update) => {
      if (update.geometryChanged && update.view.inView) update.view.dom.dataset.measured = "";
      if (update.docChanged) options.onChange(update.state.doc.toString());
    }),
  ];
}
