/**
 * What stands in the editor is what was typed: the completion list takes a key only from somebody who
 * has asked for it, and closing quotes and brackets are typed over.
 */
import {
  acceptCompletion,
  autocompletion,
  closeBrackets,
  closeBracketsKeymap,
  closeCompletion,
  completionStatus,
  currentCompletions,
  moveCompletionSelection,
  selectedCompletionIndex,
  startCompletion,
} from "@codemirror/autocomplete";
import { matchBrackets, syntaxTree } from "@codemirror/language";
import { EditorState, type Extension, Prec } from "@codemirror/state";
import { type Command, EditorView, keymap, ViewPlugin, type ViewUpdate } from "@codemirror/view";

/** Tab takes what is chosen in the list, or its first word if nothing is. */
const acceptWithTab: Command = (view) => {
  if (completionStatus(view.state) !== "active") return false;
  if (selectedCompletionIndex(view.state) === null) moveCompletionSelection(true)(view);
  return acceptCompletion(view);
};

/** Enter takes a word only if one has been chosen with the arrow keys; otherwise it is a new line. */
const acceptWithEnter: Command = (view) =>
  selectedCompletionIndex(view.state) !== null && acceptCompletion(view);

const listKeys = keymap.of([
  { key: "Ctrl-Space", run: startCompletion },
  { mac: "Alt-`", run: startCompletion },
  { key: "Escape", run: closeCompletion },
  { key: "ArrowDown", run: moveCompletionSelection(true) },
  { key: "ArrowUp", run: moveCompletionSelection(false) },
  { key: "PageDown", run: moveCompletionSelection(true, "page") },
  { key: "PageUp", run: moveCompletionSelection(false, "page") },
  { key: "Tab", run: acceptWithTab },
  { key: "Enter", run: acceptWithEnter },
]);

/** Closes the list when the word is complete: somebody who has typed `CELL` may have meant `CELL`. */
const closeOnCompleteWord = ViewPlugin.fromClass(
  class {
    #typed = false;

    update(update: ViewUpdate): void {
      if (update.docChanged) {
        this.#typed = update.transactions.some((each) => each.isUserEvent("input.type"));
      }
      if (!this.#typed || completionStatus(update.state) !== "active") return;
      const before = wordBefore(update.state);
      if (!currentCompletions(update.state).some(({ label }) => label === before)) return;
      // The view takes no further change in the middle of this one.
      queueMicrotask(() => {
        if (update.view.state === update.state) closeCompletion(update.view);
      });
    }
  },
);

function wordBefore({ doc, selection }: EditorState): string {
  const line = doc.lineAt(selection.main.head);
  return /\w*$/.exec(line.text.slice(0, selection.main.head - line.from))?.[0] ?? "";
}

/** As Python's, but without the triple quotes, which would be typed over three at a time. */
const pairs = Prec.highest(
  EditorState.languageData.of(() => [
    {
      closeBrackets: {
        brackets: ["(", "[", "{", "'", '"'],
        stringPrefixes: ["f", "r", "b", "u", "rf", "fr", "F", "R"],
      },
    },
  ]),
);

/** A third quote begins or ends a docstring, and inside one a quote is a quote: no partner is added. */
const quotes = Prec.high(
  EditorView.inputHandler.of((view, from, to, text) => {
    if ((text !== '"' && text !== "'") || from !== to || view.composing) return false;
    const { doc } = view.state;
    const isThird = doc.sliceString(Math.max(0, from - 2), from) === text + text;
    if (!isThird && !inTripleQuotes(view.state, from)) return false;
    view.dispatch({
      changes: { from, insert: text },
      selection: { anchor: from + 1 },
      scrollIntoView: true,
      userEvent: "input.type",
    });
    return true;
  }),
);

function inTripleQuotes(state: EditorState, at: number): boolean {
  let node = syntaxTree(state).resolveInner(at, -1);
  while (node.parent && !/String/.test(node.name)) node = node.parent;
  const start = state.doc.sliceString(node.from, Math.min(at, node.from + 5));
  return /String/.test(node.name) && /^[a-z]{0,2}("""|''')/i.test(start);
}

/** A closing bracket that already stands on one of the next lines is typed over as well. */
const closers = Prec.high(
  EditorView.inputHandler.of((view, from, to, text) => {
    if (!/^[)\]}]$/.test(text) || from !== to) return false;
    const { state } = view;
    const gap = /^\s*\n\s*(?=[)\]}])/.exec(state.doc.sliceString(from, from + LONGEST_GAP));
    const closer = from + (gap?.[0].length ?? 0);
    if (!gap || state.doc.sliceString(closer, closer + 1) !== text) return false;
    const match = matchBrackets(state, closer + 1, -1);
    if (!match?.matched || !match.end || match.end.from >= from) return false;
    view.dispatch({
      changes: { from, to: closer },
      selection: { anchor: from + 1 },
      scrollIntoView: true,
      userEvent: "input.type",
    });
    return true;
  }),
);

/** Blanks and line ends between the cursor and a closing bracket [characters]. */
const LONGEST_GAP = 200;

export const typing: Extension = [
  autocompletion({ selectOnOpen: false, defaultKeymap: false, interactionDelay: 0 }),
  Prec.highest(listKeys),
  closeOnCompleteWord,
  pairs,
  quotes,
  closers,
  closeBrackets(),
  keymap.of(closeBracketsKeymap),
];
