/**
 * Which world, which noise, and how often. May import `trace` and `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import type { World } from "../trace/events.ts";
import { noiseWords, repeatWords } from "../ui/noise-words.ts";
import { pickerWords } from "../ui/strings.ts";
import { MOST_SEED, readSeed } from "./address.ts";
import { isOwnMat } from "./mats/own-name.ts";
import { TIMES } from "./repeat.ts";

export interface PickersInput {
  /** None where the world is not to be chosen. */
  worlds: readonly World[];
  world: string;
  seed: number;
  /** Each run has a new seed, and not the one before's. */
  freshNoise: boolean;
  onWorld(name: string): void;
  onSeed(seed: number): void;
  /** Called with a plain message where what was typed is no seed. */
  onBadSeed(message: string): void;
  onFreshNoise(fresh: boolean): void;
  onRepeat(): void;
}

export function newSeed(): number {
  return 1 + Math.floor(Math.random() * MOST_SEED);
}

export function pickers(input: PickersInput): TemplateResult {
  const { worlds, world, seed } = input;
  const onWorld = (event: Event): void => {
    if (event.target instanceof HTMLSelectElement) input.onWorld(event.target.value);
  };
  const onSeed = (event: Event): void => {
    if (!(event.target instanceof HTMLInputElement)) return;
    const typed = event.target.value;
    const read = readSeed(typed);
    if (read === null) {
      event.target.value = String(seed);
      input.onBadSeed(pickerWords.badSeed(typed, MOST_SEED, seed));
    } else {
      input.onSeed(read);
    }
  };
  return html`<div class="lab-pickers">
    ${
      worlds.length > 0
        ? html`<label class="world">
            <span>${pickerWords.world}</span>
            <select .value=${world} @change=${onWorld}>
              ${options(
                worlds.filter(({ name }) => !isOwnMat(name)),
                world,
              )}
              ${
                worlds.some(({ name }) => isOwnMat(name))
                  ? html`<optgroup label=${pickerWords.ownMats}>
                      ${options(
                        worlds.filter(({ name }) => isOwnMat(name)),
                        world,
                      )}
                    </optgroup>`
                  : nothing
              }
            </select>
          </label>`
        : nothing
    }
    ${noise(input, onSeed)}
  </div>`;
}

function options(worlds: readonly World[], chosen: string): TemplateResult[] {
  return worlds.map(
    ({ name, title }) => html`<option value=${name} ?selected=${name === chosen}>${title}</option>`,
  );
}

function noise(input: PickersInput, onSeed: (event: Event) => void): TemplateResult {
  const { seed, freshNoise } = input;
  const onNoise = (event: Event): void => {
    if (event.target instanceof HTMLSelectElement) input.onFreshNoise(event.target.value === "new");
  };
  return html`<label title=${noiseWords.help}>
      <span>${pickerWords.seed}</span>
      <input
        type="text"
        inputmode="numeric"
        autocomplete="off"
        size="6"
        maxlength="6"
        .value=${String(seed)}
        @change=${onSeed}
      />
    </label>
    <select aria-label=${noiseWords.name} title=${noiseWords.help} @change=${onNoise}>
      <option value="same" ?selected=${!freshNoise}>${noiseWords.same}</option>
      <option value="new" ?selected=${freshNoise}>${noiseWords.fresh}</option>
    </select>
    <button type="button" class="repeat" title=${repeatWords.help(TIMES)} @click=${input.onRepeat}>
      ${repeatWords.start(TIMES)}<span>&nbsp;${repeatWords.times}</span>
    </button>`;
}
