/**
 * The program of a lab: the editor it is written in, what it started as, and what is kept of it.
 * May import `editor` and `ui`.
 */
import type { Call } from "../editor/calls.ts";
import { ProgramEditor } from "../editor/editor.ts";
import type { OnNumber } from "../editor/gesture.ts";
import { KeptProgram } from "./kept-program.ts";
import type { ProgramStore } from "./storage.ts";
import type { Version } from "./versions.ts";

export interface LabProgramOptions {
  host: HTMLElement;
  /** Id of the element that says how to leave the editor. */
  describedBy: string;
  calls: readonly Call[];
  store: ProgramStore;
  onEdit(): void;
  onRun(): void;
  /** A number is being moved: the run may follow it. */
  onNumber: OnNumber;
  /** The device will not keep what is typed. */
  onRefused(): void;
}

export class LabProgram {
  readonly #options: LabProgramOptions;
  readonly #editor: ProgramEditor;
  #kept: KeptProgram | null = null;
  #starter = "";
  #playingLine: number | null = null;
  /** The line numbers of the last run are those of this text still. */
  #asRun = false;

  constructor(options: LabProgramOptions) {
    this.#options = options;
    this.#editor = new ProgramEditor(options.host, {
      text: "",
      calls: options.calls,
      describedBy: options.describedBy,
      onChange: (text) => {
        this.#asRun = false;
        this.#playingLine = null;
        this.#kept?.changed(text);
        options.onEdit();
      },
      onRun: options.onRun,
      onNumber: options.onNumber,
    });
  }

  get text(): string {
    return this.#editor.text;
  }

  /** What the page gives to begin with. */
  get starter(): string {
    return this.#starter;
  }

  /** One step that undo takes back; the program before goes into the versions. */
  replace(text: string): void {
    if (text !== this.text) this.#kept?.putAside(this.text);
    this.#editor.replace(text);
  }

  /** Other values for `NAME = number` at the top level, as one step; a RangeError if one is missing. */
  setConstants(values: Readonly<Record<string, number>>): void {
    this.#editor.setConstants(values);
  }

  /**
   * Opens the program kept under `key`, or the starter; says whether it is the learner's own, and
   * whether that was begun from another starter. The program that was open is kept first.
   */
  open(key: string, starter: string): "starter" | "own" | "outgrown" {
    this.#kept?.flush();
    const { store, onRefused } = this.#options;
    this.#kept = new KeptProgram(store, key, starter, onRefused);
    this.#starter = starter;
    const own = this.#kept.load();
    this.#editor.open(own ?? starter);
    this.#asRun = false;
    this.#playingLine = null;
    if (own === null) return "starter";
    return this.#kept.outgrown ? "outgrown" : "own";
  }

  /** Keeps the text as it is now as a version to go back to. */
  putAside(): void {
    this.#kept?.putAside(this.text);
  }

  /** A run of a program is on show: its lines are followed if it is the one in the editor. */
  shows(program: string): void {
    this.#editor.showFault(null);
    this.#asRun = program === this.text;
  }

  /** Earlier versions, newest first. */
  versions(): Version[] {
    return this.#kept?.versions() ?? [];
  }

  /** From now on the program counts as begun from the page's present starter. */
  beginsHere(): void {
    this.#kept?.beginsHere();
  }

  /** The program as another tab has kept it under this name; null if it is no other than here. */
  elsewhere(name: string): string | null {
    const theirs = this.#kept?.isNamed(name) ? this.#kept.load() : null;
    return theirs === this.text ? null : theirs;
  }

  /** Marks the line of the shown moment, as long as the text is the one that ran. */
  follow(line: number | null): void {
    const shown = this.#asRun ? line : null;
    if (shown === this.#playingLine) return;
    this.#playingLine = shown;
    this.#editor.showPlaying(shown);
  }

  showFault(line: number, message: string): void {
    if (this.#asRun) this.#editor.showFault({ line, message });
  }

  goToLine(line: number): void {
    this.#editor.goToLine(line);
  }

  /** Keeps what has been typed up to now. */
  flush(): void {
    this.#kept?.flush();
  }
}
