/**
 * What the home page draws itself: the worlds to choose from. Everything else is in `index.html`.
 */
import { html, render } from "lit";
import type { World } from "../trace/events.ts";
import { writeAddress } from "./address.ts";
import { worldPicture } from "./world-picture.ts";

export function showHome(worlds: readonly World[]): void {
  const list = document.getElementById("worlds");
  if (!list) return;
  const cards = worlds.map(
    (world) => html`<li>
      <a href=${`./lab/${writeAddress({ world: world.name, seed: 1 })}`}>
        ${worldPicture(world)}
        <b>${world.title}</b>
        <span>${world.description}</span>
      </a>
    </li>`,
  );
  render(cards, list);
}
