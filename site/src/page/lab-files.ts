/**
 * What a lab can do with files, links and earlier versions: the items behind its More button, a
 * file dropped on the editor, and programs that are offered. Whatever replaces the program is one
 * step that undo takes back. May import every room of the site but `worker`.
 */
import { writeTraceFile } from "../trace/file.ts";
import type { Trace } from "../trace/trace.ts";
import { fileWords, menuWords, shareWords, starterWords, versionWords } from "../ui/file-words.ts";
import { labWords } from "../ui/strings.ts";
import type { ChartView } from "../views/chart.ts";
import type { OverheadView } from "../views/overhead/overhead.ts";
import type { Place } from "./address.ts";
import type { MenuGroup } from "./lab-menu.ts";
import type { LabProgram } from "./lab-program.ts";
import { chooseVersion, offerProgram } from "./program-dialogs.ts";
import { linkTo } from "./share.ts";
import { showLink } from "./share-dialog.ts";
import type { Note } from "./status.ts";
import { chooseFile, FileError, readFile, readRun, saveFile } from "./text-file.ts";

/** What is asked of the lab. */
export interface LabDesk {
  readonly program: LabProgram;
  readonly place: Place;
  readonly worldTitle: string;
  /** Address of the lab's own page. */
  readonly labAddress: string;
  /** The run on show; null before the first. */
  readonly run: Trace | null;
  readonly overhead: OverheadView;
  readonly chart: ChartView;
  /** Shows a run made before, on its world. */
  show(run: Trace): Promise<void>;
  say(note: Note): void;
}

export class LabFiles {
  readonly #desk: LabDesk;

  constructor(desk: LabDesk) {
    this.#desk = desk;
  }

  /** What the More button opens. */
  get menu(): MenuGroup[] {
    const { run } = this.#desk;
    const complete = run?.complete === true;
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
      {
        title: menuWords.run,
        items: [
          { label: menuWords.saveRun, disabled: !complete, act: () => this.#saveRun() },
          { label: menuWords.openRun, act: () => this.#openRun() },
          { label: menuWords.chart, disabled: !run?.series.size, act: () => this.#saveChart() },
          { label: menuWords.picture, act: () => this.#savePicture() },
          { label: menuWords.print, act: () => print() },
        ],
      },
    ];
  }

  /** Files dropped on an element open as from the menu. */
  acceptDrops(element: HTMLElement): void {
    const file = ({ dataTransfer }: DragEvent) => dataTransfer?.types.includes("Files") === true;
    // Before the editor has it: that would put the file's text where it was dropped.
    element.addEventListener(
      "dragover",
      (event) => {
        if (file(event)) event.preventDefault();
      },
      { capture: true },
    );
    element.addEventListener(
      "drop",
      (event) => {
        const dropped = event.dataTransfer?.files[0];
        if (!dropped) return;
        event.preventDefault();
        event.stopPropagation();
        void this.#told(() => this.#openFile(dropped));
      },
      { capture: true },
    );
  }

  /** Shows a program that came in a link, and opens it if the reader says so. */
  async offerShared(program: string): Promise<void> {
    const { place, worldTitle, say } = this.#desk;
    const mine = this.#desk.program.text;
    if (program === mine) return say({ text: shareWords.same });
    const { offered: title, offer, take, keep, taken } = shareWords;
    const lead = offer(program, worldTitle, place.seed);
    if (await offerProgram({ title, lead, program, mine: null, take, keep })) {
      this.#replace(program, taken);
    }
  }

  /** Shows the starter of a newer page beside the program begun from an older one. */
  async offerStarter(): Promise<void> {
    const { program: kept } = this.#desk;
    const { title, lead, take, keep, taken } = starterWords;
    const offer = { title, lead, program: kept.starter, mine: kept.text, take, keep };
    const answer = await offerProgram(offer);
    if (answer === true) this.#replace(kept.starter, taken);
    else if (answer === false) kept.beginsHere();
  }

  #replace(text: string, said: string): void {
    const { program, say } = this.#desk;
    const before = program.text;
    program.replace(text);
    say({ text: said, action: { label: labWords.undo, act: () => program.replace(before) } });
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
    const text = await chooseVersion(program.versions(), program.text);
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
    if ("run" in opened) return this.#showRun(opened.run);
    if (opened.program === this.#desk.program.text) {
      this.#desk.say({ text: fileWords.same(file.name) });
    } else {
      this.#replace(opened.program, fileWords.opened(file.name));
    }
  }

  #save(): void {
    saveFile("program.py", this.#desk.program.text, "text/x-python");
  }

  async #share(): Promise<void> {
    const { labAddress, place, program } = this.#desk;
    showLink(await linkTo(labAddress, place, program.text), () => this.#save());
  }

  #saveRun(): void {
    const { run } = this.#desk;
    if (run) saveFile(`${this.#runName}.trace`, writeTraceFile(run), "application/x-ndjson");
  }

  #openRun(): Promise<void> {
    return this.#told(async () => {
      // Any file may be chosen: phones do not know what a .trace is.
      const file = await chooseFile("");
      if (file) await this.#showRun(await readRun(file));
    });
  }

  async #showRun(run: Trace): Promise<void> {
    await this.#desk.show(run);
    const { program, say } = this.#desk;
    const { world, seed, program: ran } = run.header;
    const act = (): void => {
      program.replace(ran);
      program.shows(ran);
    };
    say({
      text: fileWords.run(world.title, seed),
      ...(ran === program.text ? {} : { action: { label: fileWords.takeProgram, act } }),
    });
  }

  #saveChart(): void {
    saveFile(`${this.#runName}.csv`, this.#desk.chart.toCsv(), "text/csv");
  }

  async #savePicture(): Promise<void> {
    saveFile(`${this.#runName}.png`, await this.#desk.overhead.toPng());
  }

  /** The run's, or before the first what it would be. */
  get #runName(): string {
    const { run, place } = this.#desk;
    const world = run?.header.world.name ?? place.world;
    return `${world}-seed-${run?.header.seed ?? place.seed}`;
  }
}
