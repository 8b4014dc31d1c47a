/**
 * The keys of the lab, as the keyboard in front of the reader has them. Imports nothing of ours.
 */

const isMac = /Mac|iPhone|iPad/.test(globalThis.navigator?.userAgent ?? "");
const mod = isMac ? "⌘" : "Ctrl+";
const alt = isMac ? "⌥" : "Alt+";
const shift = isMac ? "⇧" : "Shift+";

export const editorHint = {
  run: `${mod}Enter runs.`,
  /** Of no use where there is no Alt key. */
  numbers: `${alt}↑↓ changes the number at the caret.`,
  leave: "Esc, then Tab, leaves.",
};

interface Keys {
  title: string;
  keys: readonly (readonly [key: string, does: string])[];
}

export const keyWords = {
  open: "Keys",
  title: "Keys of the lab",
  groups: [
    {
      title: "In the program",
      keys: [
        [`${mod}Enter`, "runs it"],
        ["Esc, then Tab", "leaves the editor (Tab alone indents)"],
        [
          `${alt}↑ ${alt}↓`,
          "changes the number at the caret while the run follows; elsewhere moves the line",
        ],
        [`${alt}drag`, "the same with a mouse, on any number"],
        [isMac ? "⌃Space" : "Ctrl+Space", "completes a word"],
        [`${mod}${shift}Space`, "tells what a call's arguments mean"],
        [`${mod}F`, "searches and replaces"],
        [`${mod}/`, "makes lines a comment, or no comment"],
        [`${mod}Z`, "undoes"],
        [isMac ? "⌘⇧Z" : "Ctrl+Y", "does again what was undone"],
      ],
    },
    {
      title: "On a number's slider",
      keys: [
        ["← →", "a step"],
        ["Page Up, Page Down", "ten steps"],
        ["Home, End", "the lowest and the highest value"],
      ],
    },
    {
      title: "On the mat",
      keys: [
        ["← → ↑ ↓", `picks a cell and tells what speaks for it; with ${shift}arrow five cells on`],
        ["Esc", "puts the cursor away"],
        ["Space", "plays and pauses"],
      ],
    },
    {
      title: "On the playback bar",
      keys: [
        ["Space", "plays and pauses"],
        ["← →", "a step back or on"],
        ["Page Up, Page Down", "a tenth of the run"],
        ["Home, End", "the start and the end"],
      ],
    },
  ] satisfies readonly Keys[],
};
