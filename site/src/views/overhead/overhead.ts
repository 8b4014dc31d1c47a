/**
 * <overhead-view>: the mat from above at the shown moment, its legend, and what speaks for a cell.
 *
 * Set `player`; `earlier`, a run to compare the map with; `outlined`, cells to point out; `backdrop`,
 * what lies under the layers. `toPng()` gives the picture as a file. May import `trace`, `player`, `ui` and the files of this folder.
 */
import { html, LitElement, type TemplateResult } from "lit";
import type { Player } from "../../player/player.ts";
import type { Cell } from "../../trace/frames.ts";
import type { Trace } from "../../trace/trace.ts";
import { overheadWords as words } from "../../ui/view-words.ts";
import { onThemeChange } from "../theme-change.ts";
import type { Backdrop } from "./backdrop.ts";
import { Camera } from "./camera.ts";
import { CellCursor } from "./cursor.ts";
import { type CellStory, describeMoment, explainCell } from "./describe.ts";
import { Inspector, type Sight } from "./inspector.ts";
import { legend } from "./legend.ts";
import "./overhead.css";
import { readPalette } from "./palette.ts";
import { MatPicture, type Moment } from "./picture.ts";

/** A picked cell is read out when the cursor has rested on it so long [ms]. */
const REST_MS = 400;
/** Side of the picture as a file [pixels]. */
const PNG_PX = 1600;

let views = 0;

export class OverheadView extends LitElement {
  static override properties = {
    player: { attribute: false },
    earlier: { attribute: false },
    outlined: { attribute: false },
    backdrop: { attribute: false },
  };
  declare player: Player;
  declare earlier: Trace | null;
  declare outlined: readonly Cell[];
  declare backdrop: Backdrop | null;

  readonly #id = `overhead-${++views}`;
  readonly #cursor = new CellCursor();
  readonly #inspector = new Inspector();
  #showsTruth = true;
  #showsDifferent = false;
  #showsBackdrop = true;
  #sight: Sight | null = null;
  #picture: MatPicture | null = null;
  #readOut = "";
  #resting: ReturnType<typeof setTimeout> | undefined;
  #stopTheme: (() => void) | null = null;
  readonly #redraw = (): void => this.requestUpdate();
  readonly #repaint = (): void => {
    this.#picture = null;
    this.requestUpdate();
  };
  readonly #resize = new ResizeObserver(this.#repaint);

  constructor() {
    super();
    this.earlier = null;
    this.outlined = [];
    this.backdrop = null;
  }

  /** In the page itself, not in a shadow: one style sheet, and ids that can be referred to. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.player.addEventListener("change", this.#redraw);
    this.#stopTheme = onThemeChange(this.#repaint);
    if (this.hasUpdated) this.firstUpdated();
  }

  override firstUpdated(): void {
    this.#resize.observe(this.#canvas);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.player.removeEventListener("change", this.#redraw);
    this.#stopTheme?.();
    this.#resize.disconnect();
    clearTimeout(this.#resting);
  }

  /** The picture of the shown moment, as bright as in the light theme. */
  async toPng(): Promise<Blob> {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = PNG_PX;
    const camera = new Camera(PNG_PX / 2, PNG_PX / 2, 2);
    const palette = { ...readPalette(this), ink: "#566067", dim: "#fff" };
    const ctx = context(canvas);
    new MatPicture(camera, palette).paint(ctx, this.#moment(this.#look()));
    ctx.globalCompositeOperation = "destination-over";
    ctx.fillStyle = "#fff";
    ctx.fillRect(0, 0, PNG_PX, PNG_PX);
    return new Promise((resolve, reject) => {
      canvas.toBlob((blob) => {
        if (blob) resolve(blob);
        else reject(new Error("this browser could not make a picture of the mat"));
      }, "image/png");
    });
  }

  override render(): TemplateResult {
    const { trace, time } = this.player;
    const sight = this.#look();
    const story = this.#story(sight);
    return html`
      <div
        class="overhead-mat"
        tabindex="0"
        role="application"
        aria-label=${words.cursor}
        aria-describedby="${this.#id}-help"
        @keydown=${this.#onKey}
      >
        <canvas
          role="img"
          aria-label=${words.name}
          aria-describedby="${this.#id}-moment"
          @pointermove=${this.#onHover}
          @pointerleave=${this.#onLeave}
          @click=${this.#onClick}
        ></canvas>
      </div>
      <p class="out-of-sight" id="${this.#id}-moment">${describeMoment(trace, time, sight.layers, this.outlined)}</p>
      <p class="out-of-sight" id="${this.#id}-help">${words.cursorHelp}</p>
      <div class="overhead-below">
        ${this.#legend(sight)}
        <p class="overhead-why" ?data-asked=${story !== null}>
          ${story ? html`<b>${story.title}</b> ${story.text}` : words.ask}
        </p>
      </div>
      <p class="out-of-sight" role="status">${this.#readOut}</p>
    `;
  }

  #legend({ layers, cells, different }: Sight): TemplateResult {
    const { trace } = this.player;
    const changed = (change: () => void) => () => {
      change();
      this.requestUpdate();
    };
    return legend({
      layers: trace.layersAt(trace.duration),
      counts: new Map(layers.map(({ name, count }) => [name, count])),
      hidden: this.#inspector.hidden,
      bare: cells.any ? cells.bare : null,
      truth: this.#showsTruth,
      outlined: this.outlined.length,
      differs: this.earlier && { shown: this.#showsDifferent, count: different?.length ?? null },
      backdrop: this.backdrop,
      backdropShown: this.#showsBackdrop,
      onLayer: (name) => changed(() => this.#inspector.toggle(name))(),
      onTruth: changed(() => {
        this.#showsTruth = !this.#showsTruth;
      }),
      onDiffers: changed(() => {
        this.#showsDifferent = !this.#showsDifferent;
      }),
      onBackdrop: changed(() => {
        this.#showsBackdrop = !this.#showsBackdrop;
      }),
    });
  }

  override updated(): void {
    const canvas = this.#canvas;
    this.#picture ??= this.#pictureFor(canvas);
    if (this.#picture && this.#sight) {
      this.#picture.paint(context(canvas), this.#moment(this.#sight));
    }
  }

  get #canvas(): HTMLCanvasElement {
    const canvas = this.querySelector("canvas");
    if (!canvas) throw new Error("the overhead view was asked for its canvas before it had one");
    return canvas;
  }

  /** Null while the view takes no room in the page. */
  #pictureFor(canvas: HTMLCanvasElement): MatPicture | null {
    const { width, height } = canvas.getBoundingClientRect();
    if (width === 0 || height === 0) return null;
    const camera = new Camera(width, height, devicePixelRatio);
    canvas.width = camera.width;
    canvas.height = camera.height;
    return new MatPicture(camera, readPalette(this));
  }

  #look(): Sight {
    const { trace, time } = this.player;
    this.#sight = this.#inspector.look(trace, time, this.#cursor, this.earlier);
    return this.#sight;
  }

  #moment({ visible, cell, evidence, different }: Sight): Moment {
    return {
      trace: this.player.trace,
      t: this.player.time,
      layers: visible,
      truth: this.#showsTruth,
      backdrop: this.#showsBackdrop ? this.backdrop : null,
      outlined: this.outlined,
      different: (this.#showsDifferent && different) || [],
      cell,
      touch: evidence?.last ?? null,
    };
  }

  #story({ cell, cells, evidence }: Sight): CellStory | null {
    if (!cell || !evidence) return null;
    const half = cell.size / 2;
    const drawnAs = cells.nameAt(cell.x + half, cell.y + half);
    return explainCell(this.player.trace, cell, drawnAs, evidence);
  }

  #onHover(event: PointerEvent): void {
    if (event.pointerType === "touch") return;
    this.#cursor.hover(this.#picture?.camera.toMat(event.offsetX, event.offsetY) ?? null);
    this.requestUpdate();
  }

  #onLeave(): void {
    this.#cursor.hover(null);
    this.requestUpdate();
  }

  #onClick(event: MouseEvent): void {
    if (!this.#picture || !this.#sight) return;
    const point = this.#picture.camera.toMat(event.offsetX, event.offsetY);
    this.#cursor.pick(point, this.#sight.cells.size);
    this.#moved();
  }

  #onKey(event: KeyboardEvent): void {
    if (!this.#sight || event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === "Escape") {
      this.#cursor.drop();
    } else {
      const start = this.player.trace.poseAt(this.player.time);
      if (!this.#cursor.key(event.key, event.shiftKey, this.#sight.cells.size, start)) return;
    }
    event.preventDefault();
    this.#moved();
  }

  /** Shows the cell at once, and reads it out when the cursor has come to rest. */
  #moved(): void {
    this.requestUpdate();
    clearTimeout(this.#resting);
    this.#resting = setTimeout(() => {
      const story = this.#story(this.#look());
      this.#readOut = story ? `${story.title} ${story.text}` : "";
      this.requestUpdate();
    }, REST_MS);
  }
}

function context(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const ctx = canvas.getContext("2d");
  if (!ctx) throw new Error("this browser gives no canvas to draw on");
  return ctx;
}

customElements.define("overhead-view", OverheadView);
