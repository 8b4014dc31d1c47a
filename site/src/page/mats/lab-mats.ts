/**
 * The mats of one's own on the lab's page: among its worlds, in a link that somebody sent, and on
 * the way to the world editor and back. May import `trace` and `ui`.
 */
import { html, render } from "lit";
import type { World } from "../../trace/events.ts";
import { Dialog } from "../../ui/dialog.ts";
import { labMatWords, offeredMatWords as words } from "../../ui/mat-words.ts";
import type { BugbotLab } from "../lab.ts";
import { packedIn } from "../share.ts";
import type { ProgramStore } from "../storage.ts";
import { worldPicture } from "../world-picture.ts";
import "./lab-mats.css";
import { matIn, sameMat } from "./mat-file.ts";
import { OwnMats } from "./own-mats.ts";
import { isOwnMat } from "./own-name.ts";

export class LabMats {
  readonly #own: OwnMats;
  readonly #worlds: World[];

  /** `worlds` is the list that the lab itself has: the mats of this device are added to it. */
  constructor(store: ProgramStore, worlds: World[]) {
    this.#own = new OwnMats(store);
    this.#worlds = worlds;
    worlds.push(...this.#own.worlds());
  }

  /**
   * The name of the mat that a link carries, once it is one of the reader's own: at once where it
   * is already, otherwise if the reader takes it. Null if it is left, or none is there. Throws
   * ShareError.
   */
  async take(hash: string): Promise<string | null> {
    const packed = packedIn(hash, "mat");
    if (packed === null) return null;
    const mat = await matIn(packed);
    const same = this.#worlds.find((world) => isOwnMat(world.name) && sameMat(world, mat));
    if (same) return same.name;
    if (!(await offer(mat, packedIn(hash) !== null))) return null;
    const world = { ...mat, name: this.#own.newName() };
    this.#own.keep(world);
    this.#worlds.push(world);
    return world.name;
  }

  /** Says so where the mat on show has been changed in the world editor meanwhile. */
  follow(lab: BugbotLab): void {
    const look = (): void => {
      const shown = this.#worlds.find(({ name }) => name === lab.world);
      const now = isOwnMat(lab.world) ? this.#own.find(lab.world) : null;
      if (!shown || !now || sameMat(shown, now)) return;
      const act = (): void => location.reload();
      lab.say({ text: labMatWords.changed, action: { label: labMatWords.show, act } });
    };
    this.#own.onElsewhere(look);
    // The browser may show the page as it was left.
    addEventListener("pageshow", ({ persisted }) => persisted && look());
  }

  /** A link to the world editor, with the mat on show if it is one's own. */
  showWay(place: HTMLElement, world: string): void {
    const own = isOwnMat(world);
    const query = own ? `?${new URLSearchParams({ mat: world })}` : "";
    render(
      html`<a href=${`../worlds/${query}`}>${own ? labMatWords.edit : labMatWords.make}</a>`,
      place,
    );
  }
}

/** Shows a mat that came in a link; true if the reader takes it. */
async function offer(mat: World, withProgram: boolean): Promise<boolean> {
  const dialog = new Dialog<boolean>(words.title);
  dialog.element.classList.add("narrow");
  dialog.show(
    html`<p>${words.lead(mat.title, mat.obstacles.length)} ${mat.description}</p>
      <div class="offered-mat">${worldPicture(mat)}</div>
      <p>${words.keeps} ${withProgram ? words.program : ""}</p>
      <footer>
        <button type="button" autofocus @click=${() => dialog.answer(false)}>${words.refuse}</button>
        <button type="button" class="go" @click=${() => dialog.answer(true)}>${words.take}</button>
      </footer>`,
  );
  return (await dialog.answered) === true;
}
