/**
 * A slider at the end of each line `NAME = number  # … (low to high)`. May import `numbers` and
 * `gesture`.
 * `sliders.css` finds the room for it.
 */
import { ensureSyntaxTree, syntaxTree } from "@codemirror/language";
import { type EditorState, type Extension, RangeSet, StateField } from "@codemirror/state";
import {
  Decoration,
  type DecorationSet,
  EditorView,
  GutterMarker,
  gutterLineClass,
  runScopeHandlers,
  WidgetType,
} from "@codemirror/view";
import { type Gesture, gesture } from "./gesture.ts";
import { type Constant, constantsOf, onStep, stepped } from "./numbers.ts";
import "./sliders.css";

/** Steps that Page Up and Page Down go by. */
const PAGE_STEPS = 10;
/**
 * A slider must not go while it is dragged because the machine is busy and the program only half
 * read; so the reading is given this long, of which it takes a few hundredths [ms].
 */
const PARSE_MS = 500;

class Slider extends WidgetType {
  readonly #constant: Constant;

  constructor(constant: Constant) {
    super();
    this.#constant = constant;
  }

  override eq(other: Slider): boolean {
    const [a, b] = [this.#constant, other.#constant];
    return a.name === b.name && a.text === b.text && a.low === b.low && a.high === b.high;
  }

  override toDOM(view: EditorView): HTMLElement {
    const frame = document.createElement("span");
    frame.className = "cm-slider";
    const input = frame.appendChild(document.createElement("input"));
    input.type = "range";
    // The steps are those of the number, counted from 0 and not from the lowest value.
    input.step = "any";
    this.#show(input);
    listen(view, frame, input);
    return frame;
  }

  /** The slider being dragged stays the one it is while its number changes. */
  override updateDOM(frame: HTMLElement, _view: EditorView, from: Slider): boolean {
    const input = frame.querySelector("input");
    if (!input || from.#constant.name !== this.#constant.name) return false;
    this.#show(input);
    return true;
  }

  #show(input: HTMLInputElement): void {
    const { name, text, value, low, high } = this.#constant;
    input.min = String(low);
    input.max = String(high);
    input.value = String(value);
    input.ariaLabel = name;
    input.ariaValueText = text;
    input.title = `${name}: ${low} to ${high}`;
  }
}

function listen(view: EditorView, frame: HTMLElement, input: HTMLInputElement): void {
  const moves = (): Gesture | null => view.plugin(gesture);
  const constant = (): Constant | undefined => constantBehind(view.state, view.posAtDOM(frame));
  let held = false;
  const hold = (): void => {
    held = true;
    moves()?.hold();
  };
  const release = (): void => {
    held = false;
    moves()?.release();
  };
  input.addEventListener("pointerdown", () => {
    hold();
    for (const end of ["pointerup", "pointercancel"]) {
      addEventListener(end, release, { once: true });
    }
  });
  input.addEventListener("input", () => {
    const number = constant();
    if (number) moves()?.move(number, onStep(number, input.valueAsNumber));
  });
  // Neither pointer nor key: assistive technology sets the value by itself.
  input.addEventListener("change", () => {
    if (!held) moves()?.release();
  });
  input.addEventListener("keydown", (event) => {
    const number = constant();
    const value = number && keyed(number, event);
    if (value !== undefined) {
      if (!held) hold();
      moves()?.move(number as Constant, value);
    } else if (event.key === "Escape") {
      view.focus();
    } else if (!isShortcut(event) || !runScopeHandlers(view, event, "editor")) {
      return;
    }
    event.preventDefault();
  });
  input.addEventListener("keyup", release);
  input.addEventListener("blur", release);
}

/** Run, undo and redo work from a slider as they do from the text. */
function isShortcut(event: KeyboardEvent): boolean {
  return event.ctrlKey || event.metaKey;
}

/** The value a key leads to, or undefined if it is no key of a slider. */
function keyed(number: Constant, event: KeyboardEvent): number | undefined {
  if (event.ctrlKey || event.metaKey || event.altKey) return undefined;
  switch (event.key) {
    case "ArrowRight":
    case "ArrowUp":
      return stepped(number, 1);
    case "ArrowLeft":
    case "ArrowDown":
      return stepped(number, -1);
    case "PageUp":
      return stepped(number, PAGE_STEPS);
    case "PageDown":
      return stepped(number, -PAGE_STEPS);
    case "Home":
      return number.low;
    case "End":
      return number.high;
    default:
      return undefined;
  }
}

interface Sliders {
  /** The constant of each slider by where its line ends. */
  constants: ReadonlyMap<number, Constant>;
  shown: DecorationSet;
  gutter: RangeSet<GutterMarker>;
}

const tallLine = Decoration.line({ class: "cm-slider-line" });
const tallNumber = new (class extends GutterMarker {
  override elementClass = "cm-slider-line";
})();

const sliderField = StateField.define<Sliders>({
  create: slidersOf,
  update(sliders, { state, startState, docChanged }) {
    const parsed = syntaxTree(state) !== syntaxTree(startState);
    return docChanged || parsed ? slidersOf(state) : sliders;
  },
  provide: (field) => [
    EditorView.decorations.from(field, ({ shown }) => shown),
    gutterLineClass.from(field, ({ gutter }) => gutter),
  ],
});

function slidersOf(state: EditorState): Sliders {
  const tree = ensureSyntaxTree(state, state.doc.length, PARSE_MS) ?? syntaxTree(state);
  const all = constantsOf(tree, state.doc.toString());
  const constants = new Map(
    all.filter(({ ranged }) => ranged).map((one) => [state.doc.lineAt(one.to).to, one]),
  );
  const ends = [...constants];
  return {
    constants,
    shown: Decoration.set(
      ends.flatMap(([end, constant]) => [
        tallLine.range(state.doc.lineAt(end).from),
        Decoration.widget({ widget: new Slider(constant), side: 1 }).range(end),
      ]),
    ),
    gutter: RangeSet.of(ends.map(([end]) => tallNumber.range(state.doc.lineAt(end).from))),
  };
}

/** The constant whose slider stands at the end of a line. */
function constantBehind(state: EditorState, end: number): Constant | undefined {
  return state.field(sliderField).constants.get(end);
}

export const sliders: Extension = sliderField;
