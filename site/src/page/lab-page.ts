/**
 * The lab's own page: what the address asks for goes into the lab, and back. A mat or a program
 * behind the # is offered, never opened by itself. May import `trace` and `ui`.
 */
import { html, render, type TemplateResult } from "lit";
import type { World } from "../trace/events.ts";
import { labMatWords } from "../ui/mat-words.ts";
import { pickerWords } from "../ui/strings.ts";
import { type ReadAddress, readAddress, writeAddress } from "./address.ts";
import type { BugbotLab } from "./lab.ts";
import { LabMats } from "./mats/lab-mats.ts";
import { isOwnMat } from "./mats/own-name.ts";
import { packedIn, ShareError, unpack } from "./share.ts";
import type { ProgramStore } from "./storage.ts";

/** `worlds` is the list that the lab has: the mats made on this device are added to it. */
export function showLabPage(lab: BugbotLab, worlds: World[], store: ProgramStore): void {
  const mats = new LabMats(store, worlds);
  const asked = readAddress(location.search, worlds);
  lab.world = asked.world;
  lab.seed = asked.seed;
  const wrong = problems(asked, worlds);
  showNotices(wrong);
  const showDescription = (): void => {
    const description = document.getElementById("world-description");
    const world = worlds.find(({ name }) => name === lab.world);
    if (description && world) description.textContent = world.description;
    const way = document.getElementById("mat-way");
    if (way) mats.showWay(way, lab.world);
  };
  showDescription();
  mats.follow(lab);
  lab.addEventListener("place-change", () => {
    const { world, seed } = lab;
    history.replaceState(null, "", `${writeAddress({ world, seed })}${location.hash}`);
    showDescription();
  });
  const onLink = async (): Promise<void> => {
    const broken = await offerLinked(lab, mats);
    showNotices(broken === null ? wrong : [...wrong, html`${broken}`]);
  };
  void onLink();
  addEventListener("hashchange", () => void onLink());
}

/**
 * Offers the mat and the program behind the #, where there are any; a program that came with a mat
 * belongs to it. Returns what is wrong with them, or null.
 */
async function offerLinked(lab: BugbotLab, mats: LabMats): Promise<string | null> {
  const { hash } = location;
  const packed = packedIn(hash);
  const withMat = packedIn(hash, "mat") !== null;
  if (packed === null && !withMat) return null;
  try {
    const mat = await mats.take(hash);
    if (mat !== null) {
      lab.world = mat;
      await lab.updateComplete;
      lab.dispatchEvent(new Event("place-change"));
    }
    if (packed !== null && (mat !== null || !withMat)) await lab.offerShared(await unpack(packed));
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
    const why = isOwnMat(unknownWorld)
      ? labMatWords.gone(used)
      : pickerWords.unknownWorld(unknownWorld, used);
    found.push(html`${why} ${links}.`);
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
