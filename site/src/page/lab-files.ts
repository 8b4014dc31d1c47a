/**
 * What becomes of a lab's program besides being run: it is reset, found again, changed in another tab.
 * Files, links and earlier versions, the items behind the More button, are in `lab-items`, which is
 * fetched when they are wanted. Whatever replaces the program is one step that undo takes back.
 * May import `ui`.
 */
import { printWords, starterWords, tabWords } from "../ui/kept-words.ts";
import { part } from "../ui/part.ts";
import { labWords, statusWords } from "../ui/strings.ts";
import { type LabDesk, placeOfRun, titleOf } from "./lab-desk.ts";
import type { LabItems } from "./lab-items.ts";
import type { MenuGroup } from "./lab-menu.ts";
import type { Sheet } from "./print.ts";

export class LabFiles {
  readonly #desk: LabDesk;
  #items: LabItems | null = null;

  constructor(desk: LabDesk) {
    this.#desk = desk;
  }

  /** What the More button opens; nothing before `open`. */
  get menu(): MenuGroup[] {
    return this.#items?.menu ?? [];
  }

  /** Has the items at hand. */
  async open(): Promise<LabItems> {
    const { LabItems } = await part(() => import("./lab-items.ts"));
    this.#items ??= new LabItems(this.#desk, (text, said) => this.#replace(text, said));
    return this.#items;
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
        const files = [...(event.dataTransfer?.files ?? [])];
        if (files.length === 0) return;
        event.preventDefault();
        event.stopPropagation();
        void this.open().then((items) => items.openDropped(files));
      },
      { capture: true },
    );
  }

  /** Back to the page's own program. */
  reset(): void {
    const { program, say } = this.#desk;
    if (program.text === program.starter) say({ text: statusWords.reset });
    else this.#replace(program.starter, statusWords.reset);
  }

  /** Says whose program has been opened. */
  tellOpened(whose: "starter" | "own" | "outgrown" | undefined): void {
    const { say } = this.#desk;
    const see = {
      label: starterWords.see,
      act: () => void this.open().then((items) => items.offerStarter()),
    };
    if (whose === "outgrown") say({ text: starterWords.changed, action: see });
    else say(whose === "own" ? { text: statusWords.restored } : null);
  }

  /** Another tab has kept something: if it is this program, the reader may have it here. */
  tellElsewhere(name: string): void {
    const { program, say } = this.#desk;
    const theirs = program.elsewhere(name);
    if (theirs === null) return;
    const act = (): void => this.#replace(theirs, tabWords.shown);
    say({ text: tabWords.changed, action: { label: tabWords.show, act } });
  }

  /** What is written on paper besides what the lab shows. */
  get sheet(): Sheet {
    const { lab, program } = this.#desk;
    const { world, seed } = placeOfRun(this.#desk);
    return {
      heading: printWords.heading(lab.label, titleOf(this.#desk, world), seed),
      program: program.text,
    };
  }

  /** Shows a program that came in a link, and opens it if the reader says so. */
  async offerShared(program: string): Promise<void> {
    await (await this.open()).offerShared(program);
  }

  #replace(text: string, said: string): void {
    const { program, say } = this.#desk;
    const before = program.text;
    program.replace(text);
    say({ text: said, action: { label: labWords.undo, act: () => program.replace(before) } });
  }
}
