/**
 * <task-where>: a small picture of the mat at a moment of a run, such as the one a check failed at,
 * with cells outlined.
 *
 * Set `run`, the moment `time` [s] and `cells`. May import `trace`, `views` and `ui`.
 */
import { html, LitElement, type TemplateResult } from "lit";
import type { Cell } from "../trace/frames.ts";
import type { Trace } from "../trace/trace.ts";
import { Camera } from "../views/overhead/camera.ts";
import { readPalette } from "../views/overhead/palette.ts";
import { MatPicture } from "../views/overhead/picture.ts";
import { onThemeChange } from "../views/theme-change.ts";

class TaskWhere extends LitElement {
  static override properties = {
    run: { attribute: false },
    time: { attribute: false },
    cells: { attribute: false },
    label: { attribute: false },
  };
  declare run: Trace;
  declare time: number;
  declare cells: readonly Cell[];
  /** What the picture shows, in words. */
  declare label: string;
  readonly #resize = new ResizeObserver(() => this.#paint());
  #stopTheme: (() => void) | null = null;

  /** In the page itself, not in a shadow: one style sheet. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#resize.observe(this);
    this.#stopTheme = onThemeChange(() => this.#paint());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#resize.disconnect();
    this.#stopTheme?.();
  }

  override render(): TemplateResult {
    return html`<canvas role="img" aria-label=${this.label}></canvas>`;
  }

  override updated(): void {
    this.#paint();
  }

  #paint(): void {
    const canvas = this.querySelector("canvas");
    const ctx = canvas?.getContext("2d");
    if (!canvas || !ctx) return;
    const { width, height } = canvas.getBoundingClientRect();
    if (width === 0 || height === 0) return;
    const camera = new Camera(width, height, devicePixelRatio);
    canvas.width = camera.width;
    canvas.height = camera.height;
    const { run: trace, time: t, cells: outlined } = this;
    const layers = trace.layersAt(t);
    const nothing = { backdrop: null, different: [], cell: null, touch: null };
    new MatPicture(camera, readPalette(this)).paint(ctx, {
      ...{ trace, t, layers, truth: true, outlined },
      ...nothing,
    });
  }
}

customElements.define("task-where", TaskWhere);
