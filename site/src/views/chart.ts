/**
 * <chart-view>: every plotted line against time, with its value at the shown moment.
 *
 * Set `player`; `earlier`, the run before, drawn thin behind this one; `runs`, many runs of one
 * program, drawn as a band with its median. A click or drag on the chart seeks. `toCsv()` gives
 * the values as a file. May import `trace`, `player`, `ui`; the drawing is uPlot's.
 */
import { html, LitElement, nothing, svg, type TemplateResult } from "lit";
import type uPlot from "uplot";
import type { Player } from "../player/player.ts";
import type { Trace } from "../trace/trace.ts";
import { part } from "../ui/part.ts";
import { chartWords as words } from "../ui/view-words.ts";
import {
  csvOf,
  dashOf,
  joined,
  type Line,
  linesOf,
  short,
  shownNames,
  tableOf,
  valueAt,
} from "./chart-data.ts";
import "./chart.css";
import { onThemeChange } from "./theme-change.ts";

/** Rows of the table: enough to follow a line, few enough to be read out. */
const TABLE_ROWS = 60;

let views = 0;

/** The part that draws: a tenth of all script, so it comes when there is something to draw. */
let drawing: typeof import("./chart-plot.ts") | null = null;

export class ChartView extends LitElement {
  static override properties = {
    player: { attribute: false },
    earlier: { attribute: false },
    runs: { attribute: false },
  };
  declare player: Player;
  declare earlier: Trace | null;
  declare runs: readonly Trace[];

  readonly #id = `chart-${++views}`;
  #plot: uPlot | null = null;
  /** What the plot holds: the runs, how long this one was then, and the lines' names and roles. */
  #held: { of: readonly unknown[]; lines: string } | null = null;
  #tableOpen = false;
  #stopTheme: (() => void) | null = null;
  readonly #redraw = (): void => this.requestUpdate();
  readonly #remake = (): void => {
    this.#drop();
    this.requestUpdate();
  };
  readonly #resize = new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = this.#frame;
    if (width > 0 && height > 0) this.#plot?.setSize({ width, height });
    this.requestUpdate();
  });

  constructor() {
    super();
    this.earlier = null;
    this.runs = [];
  }

  /** In the page itself, not in a shadow: one style sheet, and ids that can be referred to. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.player.addEventListener("change", this.#redraw);
    this.#stopTheme = onThemeChange(this.#remake);
    if (this.hasUpdated) this.firstUpdated();
  }

  override firstUpdated(): void {
    this.#resize.observe(this.#frame);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.player.removeEventListener("change", this.#redraw);
    this.#stopTheme?.();
    this.#resize.disconnect();
    this.#drop();
  }

  /** All that this run has plotted: a row per time, a column per line. */
  toCsv(): string {
    return csvOf(this.player.trace);
  }

  override render(): TemplateResult {
    const { trace, time } = this.player;
    const names = shownNames(trace, this.runs);
    return html`
      <div class="chart-legend">
        ${names.map((name, i) => {
          const series = trace.series.get(name);
          const value = series ? valueAt(series, time) : null;
          return html`<span class="chart-key">
            ${swatch(i)} <span>${name}</span>
            <b>${value === null ? words.none : short(value)}</b>
          </span>`;
        })}
        ${trace.series.size > names.length ? words.more(trace.series.size - names.length) : nothing}
        ${this.earlier?.series.size ? html`<small>${words.earlier}</small>` : nothing}
        ${this.runs.length > 0 ? html`<small>${words.runs(this.runs.length)}</small>` : nothing}
      </div>
      <div
        class="chart-frame"
        role="img"
        aria-label=${words.name}
        aria-describedby="${this.#id}-moment"
      ></div>
      ${names.length === 0 ? html`<p class="chart-empty"><span>${words.empty}</span></p>` : nothing}
      <p class="out-of-sight" id="${this.#id}-moment">${words.moment(names.length, time)}</p>
      <details class="chart-table" @toggle=${this.#onTable}>
        <summary>${words.table}</summary>
        ${this.#tableOpen ? this.#table() : nothing}
      </details>
    `;
  }

  override updated(): void {
    this.#sync();
    this.#placeCursor();
  }

  get #frame(): HTMLElement {
    const frame = this.querySelector<HTMLElement>(".chart-frame");
    if (!frame) throw new Error("the chart was asked for its frame before it had one");
    return frame;
  }

  /** Brings the plot up to the runs as they are now. */
  #sync(): void {
    const { trace } = this.player;
    const of = [trace, trace.length, this.earlier, ...this.runs];
    if (this.#plot && same(of, this.#held?.of)) return;
    const lines = linesOf(trace, this.earlier, this.runs);
    const kinds = JSON.stringify(lines.map(({ name, role }) => [name, role]));
    if (this.#plot && this.#held?.lines === kinds) this.#plot.setData(joined(lines));
    else this.#make(lines);
    this.#held = { of, lines: kinds };
  }

  #make(lines: readonly Line[]): void {
    this.#drop();
    const frame = this.#frame;
    if (frame.clientWidth === 0 || lines.length === 0) return;
    if (!drawing) {
      void this.#fetchDrawing();
      return;
    }
    this.#plot = drawing.makePlot(frame, lines, shownNames(this.player.trace, this.runs), {
      lastTime: () =>
        [this.player.trace, this.earlier, ...this.runs].reduce(
          (last, run) => Math.max(last, run?.duration ?? 0),
          0,
        ),
      onSeek: (t) => this.player.seek(t),
    });
    // A new plot has no scales yet: it sets them in a microtask of its own, before this one.
    queueMicrotask(() => this.#placeCursor());
  }

  async #fetchDrawing(): Promise<void> {
    drawing = await part(() => import("./chart-plot.ts"));
    this.requestUpdate();
  }

  #drop(): void {
    this.#plot?.destroy();
    this.#plot = null;
  }

  /** The line at the shown time, and the veil over what is yet to come. */
  #placeCursor(): void {
    const plot = this.#plot;
    if (!plot) return;
    const x = Math.round(plot.valToPos(this.player.time, "x"));
    for (const mark of plot.over.querySelectorAll<HTMLElement>(".chart-now, .chart-yet")) {
      mark.style.translate = `${x}px 0`;
    }
  }

  #onTable(event: Event): void {
    this.#tableOpen = event.target instanceof HTMLDetailsElement && event.target.open;
    this.requestUpdate();
  }

  #table(): TemplateResult {
    const { names, rows, all } = tableOf(this.player.trace, TABLE_ROWS);
    return html`<div class="chart-rows" tabindex="0" role="region" aria-label=${words.table}>
      <table>
        <thead>
          <tr>
            <th scope="col">${words.time}</th>
            ${names.map((name) => html`<th scope="col">${name}</th>`)}
          </tr>
        </thead>
        <tbody>
          ${rows.map(
            ({ t, values }) => html`<tr>
              <th scope="row">${short(t)} s</th>
              ${values.map((value) => html`<td>${value === null ? words.none : short(value)}</td>`)}
            </tr>`,
          )}
        </tbody>
      </table>
      ${all > rows.length ? html`<p>${words.skipped(rows.length, all)}</p>` : nothing}
    </div>`;
  }
}

function same(a: readonly unknown[], b: readonly unknown[] | undefined): boolean {
  return a.length === b?.length && a.every((item, i) => item === b[i]);
}

/** A short piece of the line, in its colour and pattern. */
function swatch(index: number): TemplateResult {
  return html`<svg class="chart-swatch" viewBox="0 0 22 8" aria-hidden="true">
    ${svg`<path class="chart-line-${1 + (index % 6)}" d="M0 4H22" stroke-dasharray=${dashOf(index).join(" ")} />`}
  </svg>`;
}

customElements.define("chart-view", ChartView);
