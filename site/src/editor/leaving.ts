/**
 * Tab indents, so there must be another way out for the keyboard: Esc, then Tab.
 *
 * The editor's own version of this lapses after two seconds. Here it waits for as long as the
 * person needs: until Tab is pressed, another key is, or the editor is left.
 */
import { completionStatus } from "@codemirror/autocomplete";
import { indentWithTab } from "@codemirror/commands";
import { Prec } from "@codemirror/state";
import { EditorView, keymap } from "@codemirror/view";

const MODIFIERS = new Set(["Shift", "Control", "Alt", "Meta"]);

export const leaveWithEscape = [
  keymap.of([indentWithTab]),
  // Before the completion, which takes an Esc for itself while it is only looking for something.
  Prec.highest(
    EditorView.domEventHandlers({
      keydown(event, view) {
        const closesList = completionStatus(view.state) === "active";
        if (event.key === "Escape") view.setTabFocusMode(!closesList);
        else if (event.key !== "Tab" && !MODIFIERS.has(event.key)) view.setTabFocusMode(false);
      },
      blur(_event, view) {
        view.setTabFocusMode(false);
      },
    }),
  ),
];
