/**
 * What the items behind a lab's More button do, with files dropped on it and with programs that are
 * offered. It is fetched when somebody wants it. May import every room of the site but `worker`.
 */
import { fileWords, menuWords, shareWords, versionWords } from "../ui/file-words.ts";
import { starterWords } from "../ui/kept-words.ts";
import { part } from "../ui/part.ts";
import { type LabDesk, titleOf } from "./lab-desk.ts";
import type { MenuGroup } from "./lab-menu.ts";
import { areMap, mapItems, openMap } from "./map-files.ts";
import { isOwnMat } from "./mats/own-name.ts";
import { runItems, showRun } from "./run-files.ts";
import { linkTo } from "./share.ts";
import { chooseFile, FileError, readFile, readRun, saveFile } from "./text-file.ts";

/** Puts a text in the program's place, and says so. */
type Replace = (text: string, said: string) => void;

export class LabItems {
  readonly #desk: LabDesk;
  readonly #replace: Replace;

  constructor(desk: LabDesk, replace: Replace) {
    this.#desk = desk;
    this.#replace = replace;
  }

  /** What the More button opens. */
  get menu(): MenuGroup[] {
    return [
      {
        title: menuWords.program,
        items: [
          { label: menuWords.versions, act: () => this.#versions() },
          { label: menuWords.open, act: () => this.#open(".py,.txt,text/x-python,text/plain") },
          { label: menuWords.save, act: () => this.#save() },
          { label: menuWords.share, act: () => this.#share() },
        ],
      },
      mapItems(this.#desk, (act) => this.#told(act)),
      {
        title: menuWords.run,
        items: runItems(this.#desk, () => this.#openRun()),
      },
    ];
  }

  /** Opens what has been dropped on the lab. */
  openDropped(files: readonly File[]): Promise<void> {
    const [first] = files;
    if (!first) return Promise.resolve();
    return this.#told(() => (areMap(files) ? openMap(this.#desk, files) : this.#openFile(first)));
  }

  /** Shows a program that came in a link, and opens it if the reader says so. */
  async offerShared(program: string): Promise<void> {
    const { lab, say } = this.#desk;
    const mine = this.#desk.program.text;
    if (program === mine) return say({ text: shareWords.same });
    const { offered: title, offer, take, keep, taken } = shareWords;
    const lead = offer(program, titleOf(this.#desk, lab.world), lab.seed);
    const { offerProgram } = await dialogs();
    if (await offerProgram({ title, lead, program, mine: null, take, keep })) {
      this.#replace(program, taken);
    }
  }

  /** Shows the starter of a newer page beside the program begun from an older one. */
  async offerStarter(): Promise<void> {
    const { program: kept } = this.#desk;
    const { title, lead, take, keep, taken } = starterWords;
    const offer = { title, lead, program: kept.starter, mine: kept.text, take, keep };
    const answer = await (await dialogs()).offerProgram(offer);
    if (answer === true) this.#replace(kept.starter, taken);
    else if (answer === false) kept.beginsHere();
  }

  /** Does something with a file; what is wrong with the file is told. */
  async #told(act: () => Promise<void>): Promise<void> {
    try {
      await act();
    } catch (error) {
      if (!(error instanceof FileError)) throw error;
      this.#desk.say({ text: error.message });
    }
  }

  async #versions(): Promise<void> {
    const { program } = this.#desk;
    const { chooseVersion } = await dialogs();
    const text = await chooseVersion(program.versions(), program.text, program.starter);
    if (text !== null) this.#replace(text, versionWords.restored);
  }

  #open(accept: string): Promise<void> {
    return this.#told(async () => {
      const file = await chooseFile(accept);
      if (file) await this.#openFile(file);
    });
  }

  async #openFile(file: File): Promise<void> {
    const opened = await readFile(file);
    if ("run" in opened) return showRun(this.#desk, opened.run);
    if (opened.program === this.#desk.program.text) {
      this.#desk.say({ text: fileWords.same(file.name) });
    } else {
      this.#replace(opened.program, fileWords.opened(file.name));
    }
  }

  #save(): void {
    saveFile("program.py", this.#desk.program.text, "text/x-python");
  }

  #openRun(): Promise<void> {
    return this.#told(async () => {
      // Any file may be chosen: phones do not know what a .trace is.
      const file = await chooseFile("");
      if (file) await showRun(this.#desk, await readRun(file));
    });
  }

  async #share(): Promise<void> {
    const [{ showLink }, link] = await Promise.all([
      part(() => import("./share-dialog.ts")),
      this.#link(),
    ]);
    showLink(link, () => this.#save());
  }

  /** A link to the program; a mat of the reader's own goes with it. */
  async #link(): Promise<string> {
    const { labAddress, lab, program, worlds } = this.#desk;
    const world = worlds.find(({ name }) => name === lab.world);
    if (!world || !isOwnMat(world.name)) return linkTo(labAddress, lab, program.text);
    const { linkToMat } = await part(() => import("./mats/mat-file.ts"));
    return linkToMat(labAddress, world, { seed: lab.seed, program: program.text });
  }
}

/** What few readers open is fetched when they do. */
const dialogs = (): Promise<typeof import("./program-dialogs.ts")> =>
  part(() => import("./program-dialogs.ts"));
