/**
 * What is on the mat, what it counts, and the switches for it.
 * May import `trace` and `ui`.
 */
import { html, nothing, svg, type TemplateResult } from "lit";
import type { Layer, Shape } from "../../trace/events.ts";
import { overheadWords as words } from "../../ui/view-words.ts";

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
  /** How many cells differ from the run before; null if there is none to compare with. */
  differs: { shown: boolean; count: number | null } | null;
  onLayer(name: string): void;
  onTruth(): void;
  onDiffers(): void;
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

function swatch(shape: Shape, colour: string): TemplateResult {
  const shapes = {
    squares: svg`<rect x="1" y="1" width="10" height="10" rx="1.5" fill=${colour} />`,
    dots: svg`<circle cx="6" cy="6" r="4" fill=${colour} />`,
    line: svg`<path d="M1 9 4.5 4 7.5 8 11 3" fill="none" stroke=${colour} stroke-width="2" />`,
    text: svg`<path d="M2 2h8v2H7v7H5V4H2z" fill=${colour} />`,
  };
  return html`<svg class="swatch" viewBox="0 0 12 12" aria-hidden="true">${shapes[shape]}</svg>`;
}

const bareSwatch = html`<svg class="swatch" viewBox="0 0 12 12" aria-hidden="true">
  <rect class="bare" x="1" y="1" width="10" height="10" rx="1.5" />
</svg>`;

const truthSwatch = html`<svg class="swatch" viewBox="0 0 12 12" aria-hidden="true">
  <rect class="truth" x="1" y="1" width="10" height="10" rx="1.5" />
  <path class="truth-hatch" d="M1 6 6 1M1 11 11 1M6 11l5-5" />
</svg>`;

const differsSwatch = html`<svg class="swatch" viewBox="0 0 12 12" aria-hidden="true">
  <path class="differs" d="M1.5 1.5h9v9h-9zM1.5 10.5l9-9" />
</svg>`;
