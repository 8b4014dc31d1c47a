/**
 * The whole evidence figure as text: what the build puts into the page, and what the element writes
 * again with its controls enabled, so that nothing moves when the script arrives. Words and numbers
 * of our own only. May import `picture`, `says`, `cell` and `ui`.
 */
import { evidenceWords } from "../../ui/figure-words.ts";
import { type Press, SYSTEMS, type System } from "./cell.ts";
import { evidencePicture, HIGH_PX } from "./picture.ts";
import { evidenceSentence, READOUT, readout, systemSentence } from "./says.ts";

export interface EvidenceFigure {
  system: System;
  presses: readonly Press[];
  /** Begins the ids in it. */
  id: string;
  live: boolean;
}

/** What the buttons give, in their order. */
export const BUTTONS = {
  hit: { press: { what: "hit", times: 1 }, label: evidenceWords.hit },
  pass: { press: { what: "pass", times: 1 }, label: evidenceWords.pass },
  hits: { press: { what: "hit", times: 10 }, label: evidenceWords.hits(10) },
  passes: { press: { what: "pass", times: 10 }, label: evidenceWords.passes(10) },
} as const satisfies Record<string, { press: Press; label: string }>;

/** Three hits and two passes: a wall that is not yet quite sure of itself. */
export const FIRST_PRESSES: readonly Press[] = [
  { what: "hit", times: 3 },
  { what: "pass", times: 2 },
];

export function evidenceHtml({ system, presses, id, live }: EvidenceFigure): string {
  const disabled = live ? "" : " disabled";
  const numbers = SYSTEMS[system];
  const now = readout(numbers, presses);
  const button = (name: string, label: string): string =>
    `<button type="button" data-do="${name}"${disabled}>${label}</button>`;
  return `
    <div class="figure-readout">
      <i class="cell" data-call="${now.call}"></i>
      <dl>${READOUT.map((name) => `<div><dt>${evidenceWords.readout[name]}</dt><dd data-now="${name}">${now[name]}</dd></div>`).join("")}</dl>
    </div>
    <svg class="picture lines" role="img" aria-label="${evidenceWords.picture}" aria-describedby="${id}-says" height="${HIGH_PX}">${evidencePicture(numbers, presses)}</svg>
    <p class="figure-says" id="${id}-says"${live ? ' role="status"' : ""}>${evidenceSentence(numbers, presses)}</p>
    <div class="figure-controls" role="group" aria-label="${evidenceWords.controls}">
      ${Object.entries(BUTTONS)
        .map(([name, { label }]) => button(name, label))
        .join("")}
      ${button("undo", evidenceWords.undo)}${button("again", evidenceWords.again)}
    </div>
    <div class="figure-systems">
      <label for="${id}-system">${evidenceWords.numbers}</label>
      <select id="${id}-system"${disabled}>${Object.keys(SYSTEMS)
        .map((name) => option(name as System, name === system))
        .join("")}</select>
      <p id="${id}-system-says">${systemSentence(system)}</p>
    </div>`;
}

function option(name: System, selected: boolean): string {
  return `<option value="${name}"${selected ? " selected" : ""}>${evidenceWords[name]}</option>`;
}
