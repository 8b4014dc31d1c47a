/**
 * What is chosen on the mat, to the centimetre: a field for each of its numbers and its word. What
 * can't be used is said, and the value before comes back. May import `trace` and `ui`.
 */
import { html, type TemplateResult } from "lit";
import type { Obstacle } from "../../trace/events.ts";
import { MAT_CM, ROBOT_RADIUS_CM } from "../../trace/frames.ts";
import { matWords as words } from "../../ui/mat-words.ts";
import { isPlainLine } from "./check-world.ts";
import type { MatDesk } from "./mat-desk.ts";
import { LEAST_SIDE_CM, withObstacle, withStart } from "./shapes.ts";

interface NumberField {
  name: string;
  value: number;
  low: number;
  high: number;
  unit: string;
  /** What is said where the number is below the lowest; the range if left out. */
  tooLow?: string;
  use(value: number): void;
}

export function chosenFields(desk: MatDesk): TemplateResult {
  const { chosen, world } = desk;
  if (chosen === "robot") return robotFields(desk);
  const box = typeof chosen === "number" ? world.obstacles[chosen] : undefined;
  if (typeof chosen !== "number" || !box) return html`<p class="mat-hint">${words.chooseOne}</p>`;
  return boxFields(desk, chosen, box);
}

function boxFields(desk: MatDesk, index: number, box: Obstacle): TemplateResult {
  const set = (key: string) => (value: number | string) =>
    desk.change(withObstacle(desk.world, index, { ...box, [key]: value }), `field ${index} ${key}`);
  const unit = words.unitCm;
  const thin = (name: string): string => words.thin(name, LEAST_SIDE_CM);
  const side = { low: LEAST_SIDE_CM, unit };
  const { x, y, width, height } = box;
  return html`<div class="mat-fields">
      ${textField(desk, words.word, box.name, set("name"))}
      ${[
        { name: words.x, value: x, low: 0, high: MAT_CM - width, unit, use: set("x") },
        { name: words.y, value: y, low: 0, high: MAT_CM - height, unit, use: set("y") },
        {
          ...side,
          name: words.width,
          value: width,
          high: MAT_CM - x,
          tooLow: thin(words.width),
          use: set("width"),
        },
        {
          ...side,
          name: words.height,
          value: height,
          high: MAT_CM - y,
          tooLow: thin(words.height),
          use: set("height"),
        },
      ].map((field) => numberField(desk, field))}
    </div>
    <p class="mat-hint">${words.corner}</p>
    <div class="mat-row">
      <button type="button" @click=${() => desk.duplicate()}>${words.duplicate}</button>
      <button type="button" @click=${() => desk.remove()}>${words.remove}</button>
    </div>`;
}

function robotFields(desk: MatDesk): TemplateResult {
  const { start, camera = true } = desk.world;
  const set = (key: string) => (value: number) =>
    desk.change(withStart(desk.world, { [key]: value }), `field robot ${key}`);
  const range = { low: ROBOT_RADIUS_CM, high: MAT_CM - ROBOT_RADIUS_CM, unit: words.unitCm };
  const onCamera = ({ target }: Event): void => {
    const { camera: _was, ...rest } = desk.world;
    const sees = (target as HTMLInputElement).checked;
    desk.change(sees ? rest : { ...rest, camera: false });
  };
  return html`<div class="mat-fields">
      ${[
        { ...range, name: words.x, value: start.x, use: set("x") },
        { ...range, name: words.y, value: start.y, use: set("y") },
        {
          name: words.heading,
          value: start.heading,
          low: -360,
          high: 360,
          unit: words.unitDegrees,
          use: set("heading"),
        },
      ].map((field) => numberField(desk, field))}
    </div>
    <label class="mat-tick">
      <input type="checkbox" .checked=${camera} @change=${onCamera} />${words.camera}
    </label>
    <p class="mat-hint">${words.cameraHelp}</p>`;
}

function numberField(desk: MatDesk, field: NumberField): TemplateResult {
  const { name, value, low, high, unit, tooLow, use } = field;
  const read = (input: HTMLInputElement): number | null => {
    const typed = input.valueAsNumber;
    return typed >= low && typed <= high ? Math.round(typed * 100) / 100 : null;
  };
  const onInput = ({ target }: Event): void => {
    const typed = read(target as HTMLInputElement);
    if (typed !== null && typed !== value) use(typed);
  };
  const onChange = ({ target }: Event): void => {
    const input = target as HTMLInputElement;
    desk.settle();
    if (read(input) !== null) return;
    const why = input.valueAsNumber < low ? tooLow : undefined;
    input.value = String(value);
    desk.say(why ?? words.badNumber(name, low, high, unit));
  };
  return html`<label class="mat-number">
    <span>${name}</span>
    <input
      type="number"
      inputmode="decimal"
      step="1"
      .value=${String(value)}
      @input=${onInput}
      @change=${onChange}
    />
    <span>${unit}</span>
  </label>`;
}

/** A word or a line of text; one that can't be used is said, and the one before comes back. */
export function textField(
  desk: MatDesk,
  name: string,
  value: string,
  use: (text: string) => void,
): TemplateResult {
  const usable = (text: string): boolean => text.trim() !== "" && isPlainLine(text);
  const onInput = ({ target }: Event): void => {
    const text = (target as HTMLInputElement).value;
    if (usable(text) && text !== value) use(text);
  };
  const onChange = ({ target }: Event): void => {
    const input = target as HTMLInputElement;
    desk.settle();
    if (usable(input.value)) return;
    input.value = value;
    desk.say(words.badText(name));
  };
  return html`<label class="mat-text">
    <span>${name}</span>
    <input type="text" autocomplete="off" .value=${value} @input=${onInput} @change=${onChange} />
  </label>`;
}

/** Everything on the mat, to choose from: the robot first, then the obstacles as they lie. */
export function partList(desk: MatDesk, onKey: (event: KeyboardEvent) => void): TemplateResult {
  const { world, chosen } = desk;
  const { start } = world;
  const entry = (part: number | "robot", name: string, facts: string): TemplateResult => html`<li>
    <button
      type="button"
      aria-pressed=${part === chosen ? "true" : "false"}
      @click=${() => desk.choose(part === chosen ? null : part)}
    >
      <b>${name}</b> <span>${facts}</span>
    </button>
  </li>`;
  return html`<ol class="mat-list" aria-label=${words.onMat} @keydown=${onKey}>
    ${entry("robot", words.robotCapital, `${words.place(start)}, ${words.degrees(start.heading)}`)}
    ${world.obstacles.map((box, i) => entry(i, box.name, `${words.size(box)} ${words.place(box)}`))}
  </ol>`;
}
