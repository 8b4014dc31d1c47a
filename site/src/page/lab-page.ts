/**
 * The lab's own page: what the address asks for goes into the lab, and back.
 * May import `trace` and `ui`.
 */
import { html, nothing, render } from "lit";
import type { World } from "../trace/events.ts";
import { pickerWords } from "../ui/strings.ts";
import { type ReadAddress, readAddress, writeAddress } from "./address.ts";
import type { BugbotLab } from "./lab.ts";

export function showLabPage(lab: BugbotLab, worlds: readonly World[]): void {
  const asked = readAddress(location.search, worlds);
  lab.world = asked.world;
  lab.seed = asked.seed;
  showNotices(asked, worlds);
  const showDescription = (): void => {
    const description = document.getElementById("world-description");
    const world = worlds.find(({ name }) => name === lab.world);
    if (description && world) description.textContent = world.description;
  };
  showDescription();
  lab.addEventListener("place-change", () => {
    const { world, seed } = lab;
    history.replaceState(null, "", `${writeAddress({ world, seed })}${location.hash}`);
    showDescription();
  });
}

function showNotices(asked: ReadAddress, worlds: readonly World[]): void {
  const place = document.getElementById("notices");
  if (!place) return;
  const used = worlds.find(({ name }) => name === asked.world)?.title ?? asked.world;
  const { unknownWorld, seedProblem, seed } = asked;
  if (unknownWorld === null && seedProblem === null) return;
  const links = worlds.map(
    ({ name, title }, i) =>
      html`${i ? ", " : ""}<a href=${writeAddress({ world: name, seed })}>${title}</a>`,
  );
  render(
    html`<div class="notice" role="alert">
      ${
        unknownWorld === null
          ? nothing
          : html`<p>${pickerWords.unknownWorld(unknownWorld, used)} ${links}.</p>`
      }
      ${seedProblem === null ? nothing : html`<p>${seedProblem}</p>`}
    </div>`,
    place,
  );
}
