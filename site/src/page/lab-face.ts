/**
 * What a lab looks like, drawn from its state; what a person does to it goes to the handlers.
 * May import every room of the site but `worker`.
 */
import { html, nothing, type TemplateResult } from "lit";
import type { Player } from "../player/player.ts";
import type { Cell } from "../trace/frames.ts";
import type { Trace } from "../trace/trace.ts";
import { icons } from "../ui/icons.ts";
import { editorHint, keyWords } from "../ui/key-words.ts";
import { part } from "../ui/part.ts";
import { editorWords, labWords } from "../ui/strings.ts";
import "../views/chart.ts";
import "../views/console.ts";
import type { Backdrop } from "../views/overhead/backdrop.ts";
import "../views/overhead/overhead.ts";
import "./lab.css";
import "./lab-menu.ts";
import type { MenuGroup } from "./lab-menu.ts";
import "./lab-print.css";
import { type PickersInput, pickers } from "./pickers.ts";
import { playbackKey } from "./playback-keys.ts";
import { problem } from "./problem.ts";
import { type StatusInput, status } from "./status.ts";
import "./transport.ts";

export interface LabFace {
  label: string;
  /** Id for the sentence that says how to leave the editor. */
  hintId: string;
  player: Player;
  /** The run to compare the one on show with. */
  earlier: Trace | null;
  /** Cells to point out on the overhead view. */
  outlined: readonly Cell[];
  /** What lies under the program's layers. */
  backdrop: Backdrop | null;
  pickers: PickersInput;
  status: StatusInput;
  /** Runs of one program with many seeds, and what to say of them. */
  runs: readonly Trace[];
  report: string;
  menu: readonly MenuGroup[];
  /** Has the menu's items at hand. */
  onMenu(): Promise<void>;
  onReset(): void;
  onStop(): void;
  onRun(): void;
  /** Larger (+1) or smaller (-1) text in the editor. */
  onCodeSize(by: 1 | -1): void;
}

export function labFace(face: LabFace): TemplateResult {
  const { label, player, earlier, outlined, backdrop, runs } = face;
  return html`<section class="lab" aria-label=${label || labWords.untitled}>
    <div class="lab-bar">
      ${label ? html`<h2 class="title">${label}</h2>` : nothing}
      ${pickers(face.pickers)}
      ${actions(face)}
    </div>
    ${status(face.status)}
    <div class="lab-columns">
      <div class="lab-program">
        <div class="lab-editor"></div>
        ${tools(face)} ${problem(face.status.fault)}
      </div>
      <console-view .player=${player} .note=${face.report}></console-view>
      <overhead-view
        .player=${player}
        .earlier=${earlier}
        .outlined=${outlined}
        .backdrop=${backdrop}
        @keydown=${(event: KeyboardEvent) => playbackKey(event, player)}
      ></overhead-view>
      <chart-view .player=${player} .earlier=${earlier} .runs=${runs}></chart-view>
    </div>
    <lab-transport .player=${player}></lab-transport>
  </section>`;
}

function actions(face: LabFace): TemplateResult {
  const { menu, status, onMenu, onReset, onStop, onRun } = face;
  const { phase } = status;
  const busy = phase === "running" || phase === "waiting";
  return html`<div class="lab-actions">
    <lab-menu .groups=${menu} .prepare=${onMenu}></lab-menu>
    <button type="button" aria-label=${labWords.reset} @click=${onReset}>
      <span class="in-full">${labWords.reset}</span>
      <span class="in-short">${labWords.resetShort}</span>
    </button>
    <button type="button" ?disabled=${!busy} @click=${onStop}>${icons.stop}${labWords.stop}</button>
    <button type="button" class="go" @click=${onRun}>${icons.play}${labWords.run}</button>
  </div>`;
}

function tools({ hintId, onCodeSize }: LabFace): TemplateResult {
  return html`<div class="lab-tools">
    <p id=${hintId}>
      ${editorHint.run} <span class="with-alt">${editorHint.numbers}</span> ${editorHint.leave}
    </p>
    <button type="button" class="keys" @click=${openKeys}>${keyWords.open}</button>
    <button type="button" aria-label=${editorWords.smaller} @click=${() => onCodeSize(-1)}>A−</button>
    <button type="button" aria-label=${editorWords.larger} @click=${() => onCodeSize(1)}>A+</button>
  </div>`;
}

async function openKeys(): Promise<void> {
  (await part(() => import("./keys-dialog.ts"))).showKeys();
}
