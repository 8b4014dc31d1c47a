/**
 * Finding and replacing in the program: fetched when somebody turns to the editor. Imports `ui`.
 */
import { Compartment, type Extension } from "@codemirror/state";
import { EditorView, keymap } from "@codemirror/view";
import { part } from "../ui/part.ts";

/** The keys that begin a search; whoever presses one at once does not get the browser's. */
const KEYS = ["Mod-f", "F3", "Mod-g"];

/** What is fetched, once for all editors of the page. */
const found = (): Promise<typeof import("@codemirror/search")> =>
  part(() => import("@codemirror/search"));

export function finding(): Extension {
  const place = new Compartment();
  let fetching: Promise<void> | null = null;
  const fetchFor = (view: EditorView): Promise<void> => {
    fetching ??= put(view).catch((error: unknown) => {
      // The reader has been told; the next time may be a better one.
      fetching = null;
      throw error;
    });
    return fetching;
  };
  const put = async (view: EditorView): Promise<void> => {
    const { highlightSelectionMatches, search, searchKeymap } = await found();
    const all = [highlightSelectionMatches(), search({ top: true }), keymap.of(searchKeymap)];
    view.dispatch({ effects: place.reconfigure(all) });
  };
  const open = (view: EditorView): boolean => {
    void fetchFor(view)
      .then(found)
      .then(
        ({ openSearchPanel }) => openSearchPanel(view),
        () => {},
      );
    return true;
  };
  return [
    EditorView.domEventHandlers({ focus: (_event, view) => void fetchFor(view).catch(() => {}) }),
    place.of(keymap.of(KEYS.map((key) => ({ key, run: open })))),
  ];
}
