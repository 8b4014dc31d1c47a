/**
 * Which world, and which noise. May import `trace` and `ui`.
 */
import { html, type TemplateResult } from "lit";
import type { World } from "../trace/events.ts";
import { icons } from "../ui/icons.ts";
import { pickerWords } from "../ui/strings.ts";
import { MOST_SEED, readSeed } from "./address.ts";

export interface PickersInput {
  worlds: readonly World[];
  world: string;
  seed: number;
  onWorld(name: string): void;
  onSeed(seed: number): void;
  /** Called with a plain message where what was typed is no seed. */
  onBadSeed(message: string): void;
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
  const newNoise = (): void => input.onSeed(1 + Math.floor(Math.random() * MOST_SEED));
  return html`<div class="lab-pickers">
    <label>
      <span>${pickerWords.world}</span>
      <select .value=${world} @change=${onWorld}>
        ${worlds.map(
          ({ name, title }) =>
            html`<option value=${name} ?selected=${name === world}>${title}</option>`,
        )}
      </select>
    </label>
    <label title=${pickerWords.seedHelp}>
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
    <button type="button" title=${pickerWords.newNoise} @click=${newNoise}>
      ${icons.dice}<span>${pickerWords.newNoise}</span>
    </button>
  </div>`;
}
