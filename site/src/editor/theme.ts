/**
 * How the editor looks: every colour is a CSS variable, so one theme serves light and dark.
 */
import { HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import type { Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { wordKinds } from "./word-kinds.mjs";

const layout = EditorView.theme({
  "&": { height: "100%", backgroundColor: "var(--panel)", color: "var(--ink)" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": {
    fontFamily: "var(--code)",
    fontSize: "var(--code-size)",
    lineHeight: "1.62",
    overflow: "auto",
    // Firefox would paint them white on a dark page.
    scrollbarColor: "var(--line-strong) var(--panel)",
  },
  ".cm-content": { padding: "10px 0 24px", caretColor: "var(--ink)" },
  ".cm-line": { padding: "0 14px 0 8px" },
  ".cm-gutters": {
    backgroundColor: "var(--panel)",
    color: "var(--ink-soft)",
    border: "none",
  },
  ".cm-lineNumbers .cm-gutterElement": { minWidth: "3em", padding: "0 8px 0 6px" },
  ".cm-activeLineGutter": { backgroundColor: "transparent", color: "var(--ink)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)", borderLeftWidth: "2px" },
  "&.cm-focused .cm-selectionBackground, .cm-selectionBackground": {
    backgroundColor: "var(--accent-wash) !important",
  },
  ".cm-matchingBracket, &.cm-focused .cm-matchingBracket": {
    backgroundColor: "transparent",
    outline: "1px solid var(--accent)",
    borderRadius: "2px",
  },
  ".cm-nonmatchingBracket, &.cm-focused .cm-nonmatchingBracket": {
    backgroundColor: "transparent",
    outline: "1px solid var(--error)",
  },
  ".cm-searchMatch": { backgroundColor: "transparent", outline: "1px solid var(--warn)" },
  ".cm-searchMatch-selected": { backgroundColor: "var(--accent-wash)" },
  ".cm-selectionMatch": { backgroundColor: "var(--accent-wash)" },
});

const marks = EditorView.theme({
  ".cm-playing": {
    backgroundColor: "var(--accent-wash)",
    boxShadow: "inset 3px 0 0 var(--accent)",
  },
  ".cm-fault": { backgroundColor: "var(--error-wash)", boxShadow: "inset 3px 0 0 var(--error)" },
  ".cm-fault-note": {
    font: "13px/1.45 var(--ui)",
    color: "var(--ink)",
    backgroundColor: "var(--error-wash)",
    boxShadow: "inset 3px 0 0 var(--error)",
    padding: "2px 14px 6px 12px",
    whiteSpace: "pre-wrap",
    overflowWrap: "anywhere",
  },
  ".cm-lintRange-error": {
    backgroundImage: "none",
    textDecoration: "underline wavy var(--error) 1px",
    textUnderlineOffset: "3px",
  },
  ".cm-lintPoint-error:after": { borderBottomColor: "var(--error)" },
});

const popups = EditorView.theme({
  ".cm-tooltip": {
    backgroundColor: "var(--panel)",
    color: "var(--ink)",
    border: "1px solid var(--line)",
    borderRadius: "8px",
    boxShadow: "0 8px 24px -12px #0006",
    zIndex: "30",
  },
  ".cm-tooltip.cm-tooltip-autocomplete > ul": {
    fontFamily: "var(--code)",
    fontSize: "13px",
    maxHeight: "15em",
    borderRadius: "7px",
  },
  ".cm-tooltip.cm-completionInfo": { padding: "0", margin: "0 4px" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li": { padding: "5px 10px" },
  ".cm-tooltip-autocomplete ul li[aria-selected], .cm-tooltip-autocomplete-disabled ul li[aria-selected]":
    { backgroundColor: "var(--accent)", color: "var(--accent-ink)" },
  ".cm-completionDetail": { fontStyle: "normal", opacity: "0.8" },
  ".cm-completionMatchedText": { textDecoration: "none", fontWeight: "700" },
  ".cm-call-help": {
    font: "13px/1.5 var(--ui)",
    padding: "8px 12px",
    maxWidth: "min(40ch, 80vw)",
    whiteSpace: "pre-wrap",
  },
  ".cm-call-help code": {
    display: "block",
    fontFamily: "var(--code)",
    fontWeight: "600",
    marginBottom: "6px",
    padding: "0",
    background: "none",
  },
  ".cm-diagnostic": {
    font: "13px/1.5 var(--ui)",
    padding: "6px 12px",
    borderLeft: "3px solid var(--error)",
  },
  ".cm-panels": {
    backgroundColor: "var(--panel)",
    color: "var(--ink)",
    borderColor: "var(--line)",
  },
  ".cm-panels.cm-panels-top": { borderBottom: "1px solid var(--line)" },
  ".cm-panel.cm-search": { padding: "8px 28px 8px 10px", font: "13px/1.4 var(--ui)" },
  ".cm-panel.cm-search label": { fontSize: "13px", whiteSpace: "nowrap" },
  ".cm-panel .cm-textfield, .cm-panel .cm-button": {
    font: "13px/1.4 var(--ui)",
    color: "var(--ink)",
    backgroundColor: "var(--panel)",
    backgroundImage: "none",
    border: "1px solid var(--line-strong)",
    borderRadius: "6px",
    padding: "4px 8px",
  },
  ".cm-panel.cm-search [name=close]": { color: "var(--ink)", fontSize: "18px", padding: "0 8px" },
});

const colours = HighlightStyle.define(
  wordKinds.map(({ kind, tags }) => ({ tag: tags, color: `var(--code-${kind})` })),
);

export const theme: Extension = [layout, marks, popups, syntaxHighlighting(colours)];
