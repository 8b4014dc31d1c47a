/**
 * The mats kept on this device, as cards to open or delete, and what a new one is made from.
 * May import `trace` and `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import type { World } from "../../trace/events.ts";
import { icons } from "../../ui/icons.ts";
import { ownMatsWords as words } from "../../ui/mat-words.ts";
import { worldPicture } from "../world-picture.ts";
import type { MatDesk, Said } from "./mat-desk.ts";
import type { OwnMat } from "./own-mats.ts";
import "./own-mats-list.css";

/** `onShow` is called when another mat is on the desk. */
export function ownMatsList(
  desk: MatDesk,
  worlds: readonly World[],
  onShow: () => void,
): TemplateResult {
  const { mats } = desk;
  return html`<section class="own-mats" aria-labelledby="own-mats-title">
    <h2 id="own-mats-title">${words.title}</h2>
    <p>${mats.length > 0 ? words.lead : words.none}</p>
    ${starter(desk, worlds, onShow)}
    ${saidOf(desk, "mats")}
    <ul>
      ${mats.map((mat) => card(desk, mat, onShow))}
    </ul>
  </section>`;
}

/** What was done, with what takes it back. */
export function saidOf(desk: MatDesk, about: Said["about"]): TemplateResult {
  const said = desk.said.about === about ? desk.said : null;
  return html`<div class="said">
    <p role="status">${said?.text ?? ""}</p>
    ${said?.undo ? html`<button type="button" @click=${said.undo}>${words.undo}</button>` : nothing}
  </div>`;
}

function starter(desk: MatDesk, worlds: readonly World[], onShow: () => void): TemplateResult {
  const onMake = (event: Event): void => {
    event.preventDefault();
    const select = (event.currentTarget as HTMLFormElement).querySelector("select");
    const from = worlds.find(({ name }) => name === select?.value) ?? null;
    desk.make(from);
    desk.say(words.made(from?.title ?? words.bare));
    onShow();
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

function card(desk: MatDesk, { world, at }: OwnMat, onShow: () => void): TemplateResult {
  const { name, title, obstacles } = world;
  const current = name === desk.world.name;
  const open = (): void => {
    desk.open(name);
    onShow();
  };
  return html`<li ?data-current=${current}>
    <button type="button" class="open" aria-label=${words.open(title)} aria-current=${current ? "true" : "false"} @click=${open}>
      ${worldPicture(world)}
      <b>${title}</b>
      <span>${current ? words.current : words.facts(obstacles.length, new Date(at))}</span>
    </button>
    <button type="button" class="delete" aria-label=${words.remove(title)} title=${words.remove(title)} @click=${() => desk.discard(name)}>
      ${icons.close}
    </button>
  </li>`;
}
