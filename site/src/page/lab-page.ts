/**
 * The lab's own page: what the address asks for goes into the lab, and back. A program behind the
 * # is offered, never opened by itself. May import `trace` and `ui`.
 */
import { html, render, type TemplateResult } from "lit";
import type { World } from "../trace/events.ts";
import { pickerWords } from "../ui/strings.ts";
import { type ReadAddress, readAddress, writeAddress } from "./address.ts";
import type { BugbotLab } from "./lab.ts";
import { packedIn, ShareError, unpack } from "./share.ts";

export function showLabPage(lab: BugbotLab, worlds: readonly World[]): void {
  const asked = readAddress(location.search, worlds);
  lab.world = asked.world;
  lab.seed = asked.seed;
  const wrong = problems(asked, worlds);
  showNotices(wrong);
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
  const onLink = async (): Promise<void> => {
    const broken = await offerLinked(lab);
    showNotices(broken === null ? wrong : [...wrong, html`${broken}`]);
  };
  void onLink();
  addEventListener("hashchange", () => void onLink());
}

/** Offers the program behind the #, if there is one; returns what is wrong with it, or null. */
async function offerLinked(lab: BugbotLab): Promise<string | null> {
  const packed = packedIn(location.hash);
  if (packed === null) return null;
  try {
    await lab.offerShared(await unpack(packed));
  } catch (error) {
    if (error instanceof ShareError) return error.message;
    throw error;
  }
  // It has been answered: a reload need not ask again.
  history.replaceState(null, "", location.pathname + location.search);
  return null;
}

function problems(asked: ReadAddress, worlds: readonly World[]): TemplateResult[] {
  const { unknownWorld, seedProblem, seed } = asked;
  const found: TemplateResult[] = [];
  if (unknownWorld !== null) {
    const used = worlds.find(({ name }) => name === asked.world)?.title ?? asked.world;
    const links = worlds.map(
      ({ name, title }, i) =>
        html`${i ? ", " : ""}<a href=${writeAddress({ world: name, seed })}>${title}</a>`,
    );
    found.push(html`${pickerWords.unknownWorld(unknownWorld, used)} ${links}.`);
  }
  if (seedProblem !== null) found.push(html`${seedProblem}`);
  return found;
}

function showNotices(notices: readonly TemplateResult[]): void {
  const place = document.getElementById("notices");
  if (!place) return;
  const list = notices.map((notice) => html`<p>${notice}</p>`);
  render(list.length > 0 ? html`<div class="notice" role="alert">${list}</div>` : "", place);
}
