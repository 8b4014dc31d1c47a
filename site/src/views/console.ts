/**
 * <console-view>: what the program has printed up to the shown moment, and the notes on its calls.
 *
 * Set `player`, and `note` for lines of the page's own at the end. May import `trace`, `player`
 * and `ui`.
 */
import { html, LitElement, type TemplateResult } from "lit";
import type { Player } from "../player/player.ts";
import type { Trace } from "../trace/trace.ts";
import { consoleWords as words } from "../ui/view-words.ts";
import "./console.css";
import { ConsoleLines, type PrintedLine } from "./console-lines.ts";

/**
 * Lines of a block. A block that is scrolled out of sight costs nothing to lay out (`console.css`
 * knows its height), so that a flood of lines is as cheap as the few in sight.
 */
const BLOCK_LINES = 50;

/** More new lines than this at once are not read out: nobody could follow. */
const READ_OUT_LINES = 10;

export class ConsoleView extends LitElement {
  static override properties = { player: { attribute: false }, note: { attribute: false } };
  declare player: Player;
  declare note: string;

  #lines: { trace: Trace; of: ConsoleLines } | null = null;
  /** What is in the page, row for row. */
  #rows: Row[] = [];
  #blocks = new Map<number, HTMLElement>();
  #shownEntries = -1;
  readonly #redraw = (): void => this.requestUpdate();

  constructor() {
    super();
    this.note = "";
  }

  /** In the page itself, not in a shadow: one style sheet for all of it. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.player.addEventListener("change", this.#redraw);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.player.removeEventListener("change", this.#redraw);
  }

  override render(): TemplateResult {
    const { trace, time } = this.player;
    const quiet = trace.consoleUpTo(time) === 0 && this.note === "";
    return html`<div class="console-log" role="log" aria-label=${words.name} tabindex="0">
      <div class="console-text">
        <p class="console-left" hidden></p>
        <div class="console-lines"></div>
        ${(quiet ? words.empty : this.note).split("\n").map((line) => html`<p>${line}</p>`)}
      </div>
    </div>`;
  }

  override updated(): void {
    const { trace, time } = this.player;
    const entries = trace.consoleUpTo(time);
    if (this.#lines?.trace !== trace) {
      this.#lines = { trace, of: new ConsoleLines(trace.console) };
      this.#shownEntries = -1;
    }
    if (entries !== this.#shownEntries) {
      this.#shownEntries = entries;
      this.#show(this.#lines.of.after(entries));
    }
  }

  #part(selector: string): HTMLElement {
    const part = this.querySelector<HTMLElement>(selector);
    if (!part) throw new Error(`the console was asked for its ${selector} before it had one`);
    return part;
  }

  /** Changes only the rows that have to change: most often one is added at the end. */
  #show(lines: readonly PrintedLine[]): void {
    const kept = new Map(this.#rows.map((row) => [row.number, row]));
    let added = 0;
    let inError = false;
    const rows = lines.map((line) => {
      const begins = !inError && hasError(line);
      inError = hasError(line);
      const key = keyOf(line, begins);
      const row = kept.get(line.number);
      if (row?.key === key) return row;
      added += 1;
      return { number: line.number, key, element: rowOf(line, begins) };
    });
    this.#part(".console-log").ariaLive = added > READ_OUT_LINES ? "off" : "polite";
    this.#rows = rows;
    this.#place(rows);
    const left = this.#part(".console-left");
    const before = lines[0]?.number ?? 0;
    left.hidden = before === 0;
    left.textContent = words.left(before);
  }

  /** Puts the rows into the page, block by block; what is in its place already is left alone. */
  #place(rows: readonly Row[]): void {
    const inBlocks = new Map<number, HTMLElement[]>();
    for (const { number, element } of rows) {
      const block = Math.floor(number / BLOCK_LINES);
      const elements = inBlocks.get(block);
      if (elements) elements.push(element);
      else inBlocks.set(block, [element]);
    }
    const blocks = Array.from(inBlocks, ([block, elements]) => {
      const element = this.#blocks.get(block) ?? document.createElement("div");
      place(element, elements);
      return [block, element] as const;
    });
    this.#blocks = new Map(blocks);
    place(this.#part(".console-lines"), [...this.#blocks.values()]);
  }
}

/** A line as it is in the page. Two of one key look the same. */
interface Row {
  number: number;
  key: string;
  element: HTMLElement;
}

function hasError(line: PrintedLine): boolean {
  return line.pieces.some((piece) => piece.stream === "stderr");
}

function keyOf(line: PrintedLine, begins: boolean): string {
  return `${begins}${line.pieces.map(({ stream, text }) => `\n${stream}${text}`).join("")}`;
}

function rowOf(line: PrintedLine, begins: boolean): HTMLElement {
  const row = document.createElement("div");
  if (begins) row.append(span("console-tag", words.error));
  if (line.pieces[0]?.stream === "note") row.append(span("console-tag", words.noteTag));
  for (const { stream, text } of line.pieces) {
    if (stream === "stdout") row.append(text);
    else row.append(span(stream === "stderr" ? "console-error" : "console-note", text));
  }
  if (line.pieces.length === 0) row.append(document.createElement("br"));
  return row;
}

function span(className: string, text: string): HTMLElement {
  const element = document.createElement("span");
  element.className = className;
  element.textContent = text;
  return element;
}

/** Makes these the children of `parent`, leaving alone those that are in their place already. */
function place(parent: HTMLElement, wanted: readonly HTMLElement[]): void {
  const stays = new Set<Element>(wanted);
  for (const child of [...parent.children]) if (!stays.has(child)) child.remove();
  let at = parent.firstElementChild;
  for (const element of wanted) {
    if (element === at) at = at.nextElementSibling;
    else parent.insertBefore(element, at);
  }
}

customElements.define("console-view", ConsoleView);
