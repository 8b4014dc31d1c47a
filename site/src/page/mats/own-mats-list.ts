/**
 * The mats kept on this device, as cards to open or delete, and what a new one is made from.
 * May import `trace` and `ui`.
 */
import { html, type TemplateResult } from "lit";
import type { World } from "../../trace/events.ts";
import { icons } from "../../ui/icons.ts";
import { ownMatsWords as words } from "../../ui/mat-words.ts";
import { worldPicture } from "../world-picture.ts";
import type { MatDesk } from "./mat-desk.ts";
import type { OwnMat } from "./own-mats.ts";
import "./own-mats-list.css";

export function ownMatsList(desk: MatDesk, worlds: readonly World[]): TemplateResult {
  const { mats } = desk;
  return html`<section class="own-mats" aria-labelledby="own-mats-title">
    <h2 id="own-mats-title">${words.title}</h2>
    <p>${mats.length > 0 ? words.lead : words.none}</p>
    ${starter(desk, worlds)}
    <ul>
      ${mats.map((mat) => card(desk, mat))}
    </ul>
  </section>`;
}

function starter(desk: MatDesk, worlds: readonly World[]): TemplateResult {
  const onMake = (event: Event): void => {
    event.preventDefault();
    const select = (event.currentTarget as HTMLFormElement).querySelector("select");
    const from = worlds.find(({ name }) => name === select?.value) ?? null;
    desk.make(from);
    desk.say(words.made(from?.title ?? words.bare));
  };
  return html`<form @submit=${onMake}>
    <label>
      <span>${words.start}</span>
      <select>
        <option value="">${words.bare}</option>
        ${worlds
          .filter(({ obstacles }) => obstacles.length > 0)
          .map(({ name, title }) => html`<option value=${name}>${title}</option>`)}
      </select>
    </label>
    <button type="submit">${words.make}</button>
  </form>`;
}

function card(desk: MatDesk, { world, at }: OwnMat): TemplateResult {
  const { name, title, obstacles } = world;
  const current = name === desk.world.name;
  return html`<li ?data-current=${current}>
    <button type="button" class="open" aria-label=${words.open(title)} aria-current=${current ? "true" : "false"} @click=${() => desk.open(name)}>
      ${worldPicture(world)}
      <b>${title}</b>
      <span>${current ? words.current : words.facts(obstacles.length, new Date(at))}</span>
    </button>
    <button type="button" class="delete" aria-label=${words.remove(title)} title=${words.remove(title)} @click=${() => desk.discard(name)}>
      ${icons.close}
    </button>
  </li>`;
}
