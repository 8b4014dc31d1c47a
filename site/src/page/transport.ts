/**
 * <lab-transport>: play, step, time and speed of the run on show.
 *
 * An element of its own, so that a playing run redraws this bar at every frame and not the lab.
 * May import `player` and `ui`.
 */
import { html, LitElement, type TemplateResult } from "lit";
import type { Player } from "../player/player.ts";
import { seconds } from "../ui/dom.ts";
import { icons } from "../ui/icons.ts";
import { transportWords } from "../ui/strings.ts";
import { PACES, type Pace, rememberedPace, rememberPace, USUAL_SPEED } from "./pace.ts";
import { playbackKey, sliderKey } from "./playback-keys.ts";
import "./transport.css";

export class LabTransport extends LitElement {
  declare player: Player;
  #pace: Pace = rememberedPace();
  readonly #redraw = (): void => this.requestUpdate();

  /** In the page itself, not in a shadow: one style sheet, and ids that can be referred to. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.setAttribute("role", "group");
    this.setAttribute("aria-label", transportWords.region);
    this.player.addEventListener("change", this.#redraw);
    this.player.speed = this.#pace === "end" ? USUAL_SPEED : this.#pace;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.player.removeEventListener("change", this.#redraw);
  }

  /** Sets the run on show going, at the chosen speed or to its end. */
  begin(): void {
    if (this.#pace === "end") this.player.toEnd();
    else this.player.play();
  }

  override render(): TemplateResult {
    const { player } = this;
    const { playing, time, duration } = player;
    const empty = player.trace.length === 0;
    return html`
      <button
        type="button"
        aria-label=${transportWords.back}
        title=${transportWords.back}
        ?disabled=${empty}
        @click=${() => player.step(-1)}
      >
        ${icons.back}
      </button>
      <button
        type="button"
        aria-label=${playing ? transportWords.pause : transportWords.play}
        title=${playing ? transportWords.pause : transportWords.play}
        ?disabled=${empty}
        @click=${() => player.toggle()}
      >
        ${playing ? icons.pause : icons.play}
      </button>
      <button
        type="button"
        aria-label=${transportWords.step}
        title=${transportWords.step}
        ?disabled=${empty}
        @click=${() => player.step(1)}
      >
        ${icons.step}
      </button>
      <input
        type="range"
        aria-label=${transportWords.time}
        aria-valuetext=${seconds(time)}
        min="0"
        max=${duration || 1}
        step="any"
        ?disabled=${empty}
        .value=${String(time)}
        @input=${this.#onSlide}
        @keydown=${(event: KeyboardEvent) => sliderKey(event, player)}
      />
      <span class="time">${transportWords.shown(time, duration)}</span>
      <select aria-label=${transportWords.speed} @change=${this.#onPace}>
        ${PACES.map(
          (pace) => html`<option value=${pace} ?selected=${pace === this.#pace}>
            ${pace === "end" ? transportWords.toEnd : transportWords.times(pace)}
          </option>`,
        )}
      </select>
    `;
  }

  override firstUpdated(): void {
    this.addEventListener("keydown", (event) => playbackKey(event, this.player));
  }

  #onSlide(event: Event): void {
    if (event.target instanceof HTMLInputElement) this.player.seek(event.target.valueAsNumber);
  }

  #onPace(event: Event): void {
    if (!(event.target instanceof HTMLSelectElement)) return;
    const { value } = event.target;
    const pace = PACES.find((one) => String(one) === value);
    if (pace === undefined) return;
    this.#pace = pace;
    rememberPace(pace);
    if (pace === "end") this.player.toEnd();
    else this.player.speed = pace;
  }
}

customElements.define("lab-transport", LabTransport);
