/**
 * While the arguments of a robot's call are written: its parameters above the line, the one at the
 * caret marked, with what it means. May import `calls`.
 *
 * It comes with typing or with its key and goes with Esc or when the caret leaves the arguments. A
 * screen reader is told the parameter as it changes.
 */
import { ensureSyntaxTree } from "@codemirror/language";
import { type EditorState, type Extension, Prec, StateEffect, StateField } from "@codemirror/state";
import {
  EditorView,
  keymap,
  showTooltip,
  type Tooltip,
  type TooltipView,
  type ViewUpdate,
} from "@codemirror/view";
import "./argument-help.css";
import { type Call, callAround, parametersOf, type WrittenCall } from "./calls.ts";

/** The arguments at the caret are nearly always read by then [ms]. */
const PARSE_MS = 20;

const setAsked = StateEffect.define<boolean>();

interface Help {
  /** The robot's call whose arguments the caret is in, whether its help is on show or not. */
  at: WrittenCall | null;
  shown: boolean;
  /** Esc has put it away, for as long as the caret stays in these arguments. */
  dismissed: boolean;
}

const NONE: Help = { at: null, shown: false, dismissed: false };

export function argumentHelp(calls: readonly Call[]): Extension {
  const byName = new Map(
    calls.filter((call) => parametersOf(call).length > 0).map((call) => [call.name, call]),
  );
  const field = StateField.define<Help>({
    create: () => NONE,
    update(help, transaction) {
      const { docChanged, selection } = transaction;
      const asked = transaction.effects.find((effect) => effect.is(setAsked))?.value;
      if (!docChanged && !selection && asked === undefined) return help;
      const at = callAt(transaction.state, byName);
      if (!at) return NONE;
      const same = help.at !== null && transaction.changes.mapPos(help.at.from) === at.from;
      const dismissed = asked === undefined ? same && help.dismissed : !asked;
      const typed = docChanged && transaction.isUserEvent("input.type");
      return { at, dismissed, shown: asked ?? (!dismissed && (typed || (same && help.shown))) };
    },
    provide: (self) => showTooltip.from(self, (help) => tooltipOf(help, create)),
  });
  const create = (view: EditorView): TooltipView => tooltipView(view, field);
  const ask = (view: EditorView): boolean => {
    const isThere = callAt(view.state, byName) !== null;
    if (isThere) view.dispatch({ effects: setAsked.of(true) });
    return isThere;
  };
  const dismiss = (view: EditorView): boolean => {
    if (view.state.field(field).shown) view.dispatch({ effects: setAsked.of(false) });
    // Esc goes on to do what it does besides: Tab then leaves the editor.
    return false;
  };
  return [
    field,
    // Before the completion, which takes an Esc for itself while it is only looking for something.
    Prec.highest(keymap.of([{ key: "Escape", run: dismiss }])),
    keymap.of([{ key: "Mod-Shift-Space", run: ask }]),
    EditorView.domEventHandlers({ blur: (_event, view) => dismiss(view) }),
    EditorView.updateListener.of((update) => readOut(update, field)),
  ];
}

function callAt(state: EditorState, calls: ReadonlyMap<string, Call>): WrittenCall | null {
  const { main } = state.selection;
  const tree = main.empty && ensureSyntaxTree(state, main.head, PARSE_MS);
  return tree ? callAround(tree, state.doc.toString(), main.head, calls) : null;
}

/** `create` is always the same, so that the tooltip stays and only what is in it changes. */
function tooltipOf({ at, shown }: Help, create: Tooltip["create"]): Tooltip | null {
  return at && shown ? { pos: at.from, above: true, create } : null;
}

function tooltipView(view: EditorView, field: StateField<Help>): TooltipView {
  const dom = document.createElement("div");
  dom.className = "cm-argument-help";
  dom.setAttribute("role", "tooltip");
  const show = ({ at }: Help): void => {
    if (at) dom.replaceChildren(...partsOf(at));
  };
  show(view.state.field(field));
  return { dom, update: ({ state }) => show(state.field(field)) };
}

/** The signature with the parameter marked, and what that means. */
function partsOf({ call, parameter }: WrittenCall): HTMLElement[] {
  const parameters = parametersOf(call);
  const signature = document.createElement("code");
  signature.append(`${call.name}(`);
  parameters.forEach(({ text }, i) => {
    const mark = document.createElement(i === parameter ? "strong" : "span");
    mark.textContent = text;
    signature.append(i > 0 ? ", " : "", mark);
  });
  signature.append(")");
  const meaning = parameter === null ? "" : (parameters[parameter]?.meaning ?? "");
  if (meaning === "") return [signature];
  const sentence = document.createElement("p");
  sentence.textContent = meaning;
  return [signature, sentence];
}

/** Says what has come: the call with its parameter, or another parameter of the same call. */
function readOut({ view, state, startState }: ViewUpdate, field: StateField<Help>): void {
  const [before, now] = [startState.field(field), state.field(field)];
  if (!now.shown || !now.at) return;
  const sameCall = before.shown && before.at?.call === now.at.call;
  if (sameCall && before.at?.parameter === now.at.parameter) return;
  const { call, parameter } = now.at;
  const { text, meaning } = parametersOf(call)[parameter ?? -1] ?? { text: "", meaning: "" };
  const words = [sameCall ? "" : call.signature, `${text}: ${meaning}`];
  const said = words.filter((part) => part !== "" && part !== ": ").join("; ");
  view.dispatch({ effects: EditorView.announce.of(said) });
}
