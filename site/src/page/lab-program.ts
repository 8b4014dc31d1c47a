/**
 * The program of a lab: the editor it is written in, what it started as, and what is kept of it.
 * May import `editor` and `ui`.
 */
import { ProgramEditor } from "../editor/editor.ts";
import type { Call } from "../editor/robot-calls.ts";
import { KeptProgram, type ProgramStore } from "./storage.ts";

export interface LabProgramOptions {
  host: HTMLElement;
  /** Id of the element that says how to leave the editor. */
  describedBy: string;
  calls: readonly Call[];
  store: ProgramStore;
  onEdit(): void;
  onRun(): void;
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
    });
  }

  get text(): string {
    return this.#editor.text;
  }

  /** One step that undo takes back. */
  replace(text: string): void {
    this.#editor.replace(text);
  }

  /**
   * Opens the program kept under `key`, or the starter; says whether it is the learner's own.
   * The program that was open is kept first.
   */
  open(key: string, starter: string): boolean {
    this.#kept?.flush();
    const { store, onRefused } = this.#options;
    this.#kept = new KeptProgram(store, key, starter, onRefused);
    this.#starter = starter;
    const own = this.#kept.load();
    this.#editor.open(own ?? starter);
    this.#asRun = false;
    this.#playingLine = null;
    return own !== null;
  }

  /** Back to the starter, as one step that undo takes back; says what it was before. */
  reset(): string {
    const before = this.text;
    this.replace(this.#starter);
    return before;
  }

  /** A run of this text begins: marks of the last one go, and its lines may be followed. */
  beginRun(): void {
    this.#editor.showFault(null);
    this.#asRun = true;
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
