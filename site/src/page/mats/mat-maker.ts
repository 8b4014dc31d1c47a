/**
 * <mat-maker>: the world editor. A mat to draw on, what is chosen to the centimetre, a list of
 * everything on it, a check, and the mats of this device. `showMatMaker` puts it on its page.
 *
 * `mat-desk` holds what is made; `mat-picture` draws it, `mat-drag` and `mat-keys` act on it.
 * May import every room of the site but `worker`.
 */
import { html, LitElement, nothing, type TemplateResult } from "lit";
import type { World } from "../../trace/events.ts";
import { recall, remember } from "../../ui/dom.ts";
import { icons } from "../../ui/icons.ts";
import { matKeyWords, matWords as words } from "../../ui/mat-words.ts";
import { showKeyList } from "../keys-dialog.ts";
import { checkMat, type Finding } from "./mat-checks.ts";
import { MatDesk } from "./mat-desk.ts";
import { MatDrag } from "./mat-drag.ts";
import { chosenFields, partList, textField } from "./mat-fields.ts";
import { matKey } from "./mat-keys.ts";
import "./mat-maker.css";
import { matPicture, VIEW_BOX, WIDTH } from "./mat-picture.ts";
import { MatWays, type Place } from "./mat-ways.ts";
import { OwnMats } from "./own-mats.ts";
import { ownMatsList, saidOf } from "./own-mats-list.ts";
import { type Part, SNAP_CM } from "./shapes.ts";

/** What is chosen is read out when the keys have rested so long [ms]. */
const REST_MS = 400;
const SNAP = "mat-snap";

class MatMaker extends LitElement {
  readonly #worlds: readonly World[];
  readonly #ways: MatWays;
  readonly #desk: MatDesk;
  readonly #drag: MatDrag;
  readonly #own: OwnMats;
  #finger = matchMedia("(pointer: coarse)").matches;
  #scale = 3;
  #checked: { world: World; finding: Finding } | null = null;
  #readOut = "";
  #resting: ReturnType<typeof setTimeout> | undefined;
  #stopElsewhere: (() => void) | null = null;
  #hadFocus = false;
  /** The button that brings a deleted mat back, once it has been pointed out. */
  #undo: HTMLElement | null = null;
  readonly #onLeave = (): void => void this.#desk.flush();
  readonly #resize = new ResizeObserver(() => {
    this.#scale = this.#picture.getBoundingClientRect().width / WIDTH || this.#scale;
    this.requestUpdate();
  });

  constructor(place: Place, asked: string | null) {
    super();
    this.#worlds = place.worlds;
    this.#own = new OwnMats(place.store);
    this.#desk = new MatDesk(this.#own, asked);
    this.#ways = new MatWays(this.#desk, place);
    this.#drag = new MatDrag(this.#desk, () => (this.#snaps ? SNAP_CM : 0));
    this.#desk.addEventListener("change", () => this.requestUpdate());
  }

  /** In the page itself, not in a shadow: one style sheet, and ids that can be referred to. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener("pagehide", this.#onLeave);
    this.#stopElsewhere = this.#own.onElsewhere(() => this.#desk.followElsewhere());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("pagehide", this.#onLeave);
    this.#stopElsewhere?.();
    this.#resize.disconnect();
    this.#desk.flush();
  }

  override firstUpdated(): void {
    this.#resize.observe(this.#picture);
  }

  /** What had the focus may go: it is held here, for the keys to go on. */
  override willUpdate(): void {
    this.#hadFocus = this.contains(document.activeElement);
  }

  override updated(): void {
    const undo = this.querySelector<HTMLElement>(".own-mats .said button");
    if (undo && undo !== this.#undo) undo.focus();
    else if (this.#hadFocus && document.activeElement === document.body) this.#focusMat();
    this.#undo = undo;
    this.#showAddress();
  }

  /** A reload shows the same mat again. */
  #showAddress(): void {
    const { mats, world } = this.#desk;
    const query = new URLSearchParams(location.search);
    query.delete("mat");
    if (mats.some(({ world: { name } }) => name === world.name)) query.set("mat", world.name);
    const search = query.size > 0 ? `?${query}` : "";
    if (search !== location.search) history.replaceState(null, "", location.pathname + search);
  }

  /** Another mat is on the desk: there it is. */
  #goToDesk(): void {
    this.querySelector(".mat-desk")?.scrollIntoView();
    this.#focusMat();
  }

  #focusMat(): void {
    this.querySelector<HTMLElement>(".mat-hold")?.focus({ preventScroll: true });
  }

  get #picture(): SVGSVGElement {
    const picture = this.querySelector<SVGSVGElement>("svg.mat-picture");
    if (!picture) throw new Error("<mat-maker> was asked for its picture before it had one");
    return picture;
  }

  get #snaps(): boolean {
    return recall(SNAP) !== "off";
  }

  // -- what is drawn ---------------------------------------------------------------

  override render(): TemplateResult {
    const { world } = this.#desk;
    const change = (key: "title" | "description") => (text: string) =>
      this.#desk.change({ ...world, [key]: text }, `field ${key}`);
    return html`<section class="mat-desk" aria-labelledby="mat-desk-title">
        <h2 id="mat-desk-title" class="out-of-sight">${world.title}</h2>
        <div class="mat-bar">
          ${textField(this.#desk, words.title, world.title, change("title"))}
          <div class="mat-row">${this.#steps()} ${this.#tryIt()}</div>
        </div>
        <div class="mat-columns">
          <div class="mat-stage">${this.#stage()}</div>
          <div class="mat-side">
            <div class="mat-chosen" role="group" aria-label=${this.#nameOf(this.#desk.chosen)}>
              <h3>${this.#nameOf(this.#desk.chosen)}</h3>
              ${chosenFields(this.#desk)}
            </div>
            <h3>${words.onMat}</h3>
            ${partList(this.#desk, (event) => this.#onKey(event))}
            ${textField(this.#desk, words.about, world.description, change("description"))}
          </div>
        </div>
        <div class="mat-files">
          <button type="button" @click=${() => this.#ways.save()}>${words.save}</button>
          <button type="button" @click=${() => this.#ways.open()}>${words.open}</button>
          <button type="button" @click=${() => this.#ways.share()}>${words.share}</button>
          <button type="button" class="keys" @click=${() => showKeyList(matKeyWords)}>${words.keys}</button>
        </div>
      </section>
      ${ownMatsList(this.#desk, this.#worlds, () => this.#goToDesk())}
      <p class="out-of-sight" role="status">${this.#readOut}</p>`;
  }

  #steps(): TemplateResult {
    const desk = this.#desk;
    return html`<button type="button" ?disabled=${!desk.canUndo} @click=${() => desk.undo()}>${words.undo}</button>
      <button type="button" ?disabled=${!desk.canRedo} @click=${() => desk.redo()}>${words.redo}</button>`;
  }

  #tryIt(): TemplateResult {
    const usable = this.#finding.kind !== "fault";
    return html`<button type="button" class="go" ?disabled=${!usable} @click=${() => this.#ways.tryInLab()}>
      ${icons.play}${words.tryIt}
    </button>`;
  }

  #stage(): TemplateResult {
    const { world, chosen } = this.#desk;
    const { kind, text } = this.#finding;
    const stories = words.described(world.obstacles, this.#storyOf("robot"));
    return html`<div class="mat-tools">
        <button type="button" @click=${() => this.#desk.addBox()}>${words.addBox}</button>
        <label class="mat-tick">
          <input type="checkbox" .checked=${this.#snaps} @change=${this.#onSnap} />${words.snap(SNAP_CM)}
        </label>
      </div>
      <div
        class="mat-hold"
        tabindex="0"
        role="application"
        aria-label=${words.mat}
        aria-describedby="mat-help"
        @keydown=${this.#onKey}
      >
        <svg
          class="mat-picture"
          viewBox=${VIEW_BOX}
          role="img"
          aria-label=${words.mat}
          aria-describedby="mat-described"
          @pointerdown=${this.#onDown}
          @pointermove=${(event: PointerEvent) => this.#drag.move(event, this.#picture)}
          @pointerup=${(event: PointerEvent) => this.#drag.up(event)}
          @pointercancel=${() => this.#drag.cancel()}
          @dragover=${(event: DragEvent) => event.preventDefault()}
          @drop=${(event: DragEvent) => this.#ways.drop(event)}
        >
          ${matPicture({ world, chosen, scale: this.#scale, finger: this.#finger })}
        </svg>
      </div>
      <p class="out-of-sight" id="mat-help">${words.help}</p>
      <p class="out-of-sight" id="mat-described">${stories}</p>
      <p class="mat-story" ?data-asked=${chosen !== null}>
        ${chosen === null ? html`${words.ask} <span class="with-keys">${words.askKeys}</span>` : this.#storyOf(chosen)}
      </p>
      <div class="mat-said">
        <p class="check" data-kind=${kind} role="status" aria-label=${words.checks}>
          ${kind === "fine" ? icons.passed : kind === "fault" ? icons.failed : nothing}${text}
        </p>
        ${saidOf(this.#desk, "mat")}
      </div>`;
  }

  get #finding(): Finding {
    const { world } = this.#desk;
    if (this.#checked?.world !== world) this.#checked = { world, finding: checkMat(world) };
    return this.#checked.finding;
  }

  #nameOf(part: Part | null): string {
    if (part === null) return words.mat;
    return part === "robot" ? words.robotCapital : (this.#desk.world.obstacles[part]?.name ?? "");
  }

  #storyOf(part: Part): string {
    const { obstacles, start } = this.#desk.world;
    if (part === "robot") return words.robotStory(start.x, start.y, start.heading);
    const box = obstacles[part];
    return box ? words.story(box) : "";
  }

  // -- what a person does ----------------------------------------------------------

  #onDown(event: PointerEvent): void {
    this.#finger = event.pointerType === "touch";
    this.#drag.down(event, this.#picture);
    this.requestUpdate();
  }

  #onKey(event: KeyboardEvent): void {
    if (this.#drag.active) {
      if (event.key === "Escape") this.#drag.cancel();
      return;
    }
    if (!matKey(event, this.#desk)) return;
    event.preventDefault();
    clearTimeout(this.#resting);
    this.#resting = setTimeout(() => {
      const { chosen } = this.#desk;
      this.#readOut = chosen === null ? words.letGo : this.#storyOf(chosen);
      this.requestUpdate();
    }, REST_MS);
  }

  #onSnap({ target }: Event): void {
    remember(SNAP, (target as HTMLInputElement).checked ? "on" : "off");
    this.requestUpdate();
  }
}

/** Puts the editor on its page, with the mat that the address asks for. */
export function showMatMaker(host: HTMLElement, place: Place): void {
  customElements.define("mat-maker", MatMaker);
  host.replaceChildren(new MatMaker(place, new URLSearchParams(location.search).get("mat")));
}
