/**
 * The ways of a mat out of the world editor and back: into the lab, a file, a link.
 * May import `trace` and `ui`.
 */
import type { World } from "../../trace/events.ts";
import { matShareWords, matWords as words } from "../../ui/mat-words.ts";
import { showLink } from "../share-dialog.ts";
import type { ProgramStore } from "../storage.ts";
import { chooseFile, FileError, saveFile } from "../text-file.ts";
import type { MatDesk } from "./mat-desk.ts";
import { linkToMat, matFile, readMatFile } from "./mat-file.ts";

/** Where the editor is. */
export interface Place {
  store: ProgramStore;
  /** The worlds of the site, to make a mat from. */
  worlds: readonly World[];
  /** Address of the lab's own page. */
  labAddress: string;
}

export class MatWays {
  readonly #desk: MatDesk;
  readonly #place: Place;

  constructor(desk: MatDesk, place: Place) {
    this.#desk = desk;
    this.#place = place;
  }

  /** The lab finds the mat on this device; where nothing is kept, the link carries it. */
  async tryInLab(): Promise<void> {
    const { labAddress } = this.#place;
    const kept = this.#desk.keep();
    const { world } = this.#desk;
    location.href = kept
      ? `${labAddress}?${new URLSearchParams({ world: world.name })}`
      : await linkToMat(labAddress, world);
  }

  save(): void {
    const taken = this.#place.worlds.map(({ name }) => name);
    const { name, text } = matFile(this.#desk.world, taken);
    saveFile(name, text, "application/json");
    this.#desk.say(words.saved(name));
  }

  async open(): Promise<void> {
    const file = await chooseFile(".json,application/json");
    if (file) await this.#take(file);
  }

  /** A file dropped on the mat. */
  drop(event: DragEvent): void {
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    if (file) void this.#take(file);
  }

  async share(): Promise<void> {
    const link = await linkToMat(this.#place.labAddress, this.#desk.world);
    showLink(link, () => this.save(), matShareWords);
  }

  async #take(file: File): Promise<void> {
    try {
      this.#desk.take(await readMatFile(file), file.name);
    } catch (error) {
      if (!(error instanceof FileError)) throw error;
      this.#desk.say(error.message);
    }
  }
}
