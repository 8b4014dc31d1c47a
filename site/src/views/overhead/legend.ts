/**
 * What is on the mat, what it counts, and the switches for it.
 * May import `trace`, `ui` and, in this folder, `backdrop`.
 */
import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from "lit";
import type { Layer, Shape } from "../../trace/events.ts";
import { overheadWords as words } from "../../ui/view-words.ts";
import type { Backdrop } from "./backdrop.ts";

/** A legend of more layers than this would be longer than the picture. */
const MOST_KEYS = 8;

export interface Legend {
  /** Every layer of the run, as it was drawn last. */
  layers: readonly Layer[];
  /** How many points each has at the shown moment. */
  counts: ReadonlyMap<string, number>;
  hidden: ReadonlySet<string>;
  /** Cells that no square covers, or null where no squares are drawn. */
  bare: number | null;
  truth: boolean;
  /** How many cells are pointed out. */
  outlined: number;
  /** How many cells differ from the run before; null if there is none to compare with. */
  differs: { shown: boolean; count: number | null } | null;
  /** What lies under the layers, and whether it is shown. */
  backdrop: Backdrop | null;
  backdropShown: boolean;
  onLayer(name: string): void;
  onTruth(): void;
  onDiffers(): void;
  onBackdrop(): void;
}

export function legend(of: Legend): TemplateResult {
  const more = of.layers.length - MOST_KEYS;
  return html`<div class="overhead-legend" role="group" aria-label=${words.legend}>
    ${of.layers.slice(0, MOST_KEYS).map(({ name, colour, shape }) =>
      key({
        swatch: swatch(shape, colour),
        name,
        count: of.counts.get(name) ?? 0,
        shown: !of.hidden.has(name),
        toggle: () => of.onLayer(name),
      }),
    )}
    ${more > 0 ? html`<span>${words.more(more)}</span>` : nothing}
    ${
      of.bare === null
        ? nothing
        : html`<span class="overhead-key">${bareSwatch} ${words.bare} <b>${of.bare}</b></span>`
    }
    ${key({
      swatch: truthSwatch,
      name: words.truth,
      count: null,
      shown: of.truth,
      toggle: of.onTruth,
    })}
    ${
      of.outlined === 0
        ? nothing
        : html`<span class="overhead-key">
            ${outlinedSwatch} ${words.outlined} <b>${of.outlined}</b>
          </span>`
    }
    ${
      of.differs === null
        ? nothing
        : key({
            swatch: differsSwatch,
            name: words.differs,
            count: of.differs.count ?? words.otherSize,
            shown: of.differs.shown,
            toggle: of.onDiffers,
          })
    }
    ${of.backdrop ? under(of.backdrop, of) : nothing}
  </div>`;
}

/** What lies under the layers, what there is to know of it, and the way to be rid of it. */
function under({ name, note, more, onRemove }: Backdrop, of: Legend): TemplateResult {
  return html`<div class="overhead-under">
    ${key({
      swatch: backdropSwatch,
      name,
      count: null,
      shown: of.backdropShown,
      toggle: of.onBackdrop,
    })}
    <details>
      <summary>${note}</summary>
      <p>${more}</p>
    </details>
    <button type="button" class="link" aria-label=${words.removeOf(name)} @click=${onRemove}>
      ${words.remove}
    </button>
  </div>`;
}

interface Key {
  swatch: TemplateResult;
  name: string;
  count: number | string | null;
  shown: boolean;
  toggle(): void;
}

function key({ swatch, name, count, shown, toggle }: Key): TemplateResult {
  return html`<label class="overhead-key">
    <input type="checkbox" .checked=${shown} @change=${toggle} />
    ${swatch} <span>${name}</span> ${count === null ? nothing : html`<b>${count}</b>`}
  </label>`;
}

/** On a piece of the mat, so that it looks as it does there in both themes. */
function tile(of: SVGTemplateResult): TemplateResult {
  return html`<svg class="swatch" viewBox="0 0 16 16" aria-hidden="true">
    <rect class="tile" x="0.5" y="0.5" width="15" height="15" rx="3" />
    ${of}
  </svg>`;
}

function swatch(shape: Shape, colour: string): TemplateResult {
  const shapes = {
    squares: svg`<rect x="3" y="3" width="10" height="10" fill=${colour} />`,
    dots: svg`<circle cx="8" cy="8" r="4" fill=${colour} />`,
    line: svg`<path d="M3 11 6 6 10 10 13 5" fill="none" stroke=${colour} stroke-width="2" />`,
    text: svg`<path d="M4 3.5h8v2.2H9.2v7H6.8v-7H4z" fill=${colour} />`,
  };
  return tile(shapes[shape]);
}

const backdropSwatch = tile(svg`
  <rect x="3" y="3" width="5" height="5" /><rect x="8" y="8" width="5" height="5" />`);
const bareSwatch = tile(svg``);
const truthSwatch = tile(svg`
  <rect class="truth" x="3" y="3" width="10" height="10" />
  <path class="truth-hatch" d="M3 8 8 3M3 13 13 3M8 13l5-5" />`);
const outlinedSwatch = tile(svg`<path class="outlined" d="M4 4h8v8H4zM4 12l8-8" />`);
const differsSwatch = tile(svg`<path class="differs" d="M4 4h8v8H4zM4 12l8-8" />`);
