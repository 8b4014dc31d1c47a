/**
 * An experiment: other values for some of a program's constants, its run beside the run without
 * them, and the way back. Knows no element; what a lab can do is handed in.
 * May import `editor`, `runtime`, `trace` and `ui`.
 *
 * While the program is as an experiment has left it, the next one starts from the program before
 * the first, so that each is compared with the same run. Once the reader has changed anything else,
 * the program is theirs, and an experiment starts from that.
 */
import { withValues } from "../editor/numbers.ts";
import { constantsIn } from "../editor/program-constants.ts";
import type { Running, RunRequest } from "../runtime/client.ts";
import type { Trace } from "../trace/trace.ts";
import { labWords } from "../ui/strings.ts";
import { type Change, tryWords } from "../ui/try-words.ts";
import type { Note } from "./status.ts";

export type Values = Readonly<Record<string, number>>;

export interface TryDesk {
  /** What would be run now. */
  request(): RunRequest;
  /** Puts a text in place of the program, as one step that undo takes back. */
  replace(program: string): void;
  /** Back to the page's own program. */
  reset(): void;
  /** Runs the program and shows it. */
  run(): Promise<Trace>;
  /** Runs something that is not shown. */
  runAside(request: RunRequest): Running;
  /** The run on show, and the one it is compared with. */
  shown(): { trace: Trace | null; earlier: Trace | null };
  compareWith(earlier: Trace | null): void;
  /** Shows these again; nothing if there was no run. */
  restore(trace: Trace | null, earlier: Trace | null): void;
  say(note: Note): void;
  /** What was pressed goes away: the focus goes to where it is said what has happened. */
  focusStatus(): void;
}

interface Base {
  program: string;
  /** What was on show before the first experiment. */
  trace: Trace | null;
  earlier: Trace | null;
}

export class Experiment {
  readonly #desk: TryDesk;
  #base: Base | null = null;
  /** The program as the experiment has left it. */
  #changed: string | null = null;
  #aside: Running | null = null;
  /** What was changed by the one in force; null if there is nothing to undo. */
  #changes: readonly Change[] | null = null;
  #words = "";

  constructor(desk: TryDesk) {
    this.#desk = desk;
  }

  /** What the last one has changed, or why it could not be begun. */
  get words(): string {
    return this.#words;
  }

  /** Sets the constants, runs, and offers to undo it; null if the program lacks one of them. */
  async begin(values: Values): Promise<Trace | null> {
    const base = this.#baseNow();
    const constants = constantsIn(base.program);
    const missing = Object.keys(values).filter((name) => !constants.some((c) => c.name === name));
    if (missing.length > 0) {
      const reset = { label: labWords.reset, act: () => this.#desk.reset() };
      this.#changes = null;
      this.#words = tryWords.missing(missing);
      this.#desk.say({ text: this.#words, action: reset });
      return null;
    }
    const changed = withValues(base.program, constants, values);
    const changes = changesBetween(base.program, changed, Object.keys(values));
    this.#base = base;
    this.#changed = changed;
    this.#desk.replace(changed);
    const running = this.#desk.run();
    if (changed === base.program) {
      this.#changes = null;
      this.#words = tryWords.same(changes);
      this.#desk.say({ text: this.#words });
      return running;
    }
    this.#changes = changes;
    this.#words = tryWords.changed(changes);
    const action = {
      label: labWords.undo,
      act: () => {
        this.undo();
        this.#desk.focusStatus();
      },
    };
    this.#desk.say({ text: tryWords.tried(changes), action });
    const before = this.#runOf(base);
    this.#desk.compareWith(before);
    const trace = await running;
    if (!before) await this.#runBaseFor(base, trace);
    return trace;
  }

  /** What to start from and go back to: the same as for the experiment in force, if there is one. */
  #baseNow(): Base {
    const { program } = this.#desk.request();
    if (this.#base && program === this.#changed) return this.#base;
    const { trace, earlier } = this.#desk.shown();
    return { program, trace, earlier };
  }

  /** The run to compare with, if it has been made: finished, in this world and with this noise. */
  #runOf({ program, trace }: Base): Trace | null {
    const { world, seed } = this.#desk.request();
    const fits =
      trace?.end?.status === "finished" &&
      trace.header.program === program &&
      trace.header.world.name === world.name &&
      trace.header.seed === seed;
    return fits ? trace : null;
  }

  /** Makes the run to compare with, out of sight, once the experiment itself is on show. */
  async #runBaseFor(base: Base, shown: Trace): Promise<void> {
    this.#aside?.stop();
    const mine = this.#desk.runAside({ ...this.#desk.request(), program: base.program });
    this.#aside = mine;
    const trace = await mine.done;
    if (this.#aside !== mine) return;
    this.#aside = null;
    if (trace.end?.status !== "finished" || this.#desk.shown().trace !== shown) return;
    base.trace = trace;
    this.#desk.compareWith(trace);
  }

  /** Whether the program is as the last one has left it. */
  get inForce(): boolean {
    return this.#changes !== null && this.#desk.request().program === this.#changed;
  }

  /** Takes back the one in force; in words, null if there is none. */
  undo(): string | null {
    if (!this.#base || !this.#changes || !this.inForce) return null;
    const words = tryWords.undone(this.#changes);
    const { program, trace, earlier } = this.#base;
    this.#aside?.stop();
    this.#aside = null;
    this.#base = null;
    this.#changed = null;
    this.#changes = null;
    this.#desk.replace(program);
    this.#desk.restore(trace, earlier);
    this.#desk.say({ text: words });
    return words;
  }
}

/** The constants as they stand in the two programs. */
function changesBetween(before: string, after: string, names: readonly string[]): Change[] {
  const [old, now] = [constantsIn(before), constantsIn(after)];
  const textOf = (constants: typeof old, name: string): string =>
    constants.find((constant) => constant.name === name)?.text ?? "";
  return names.map((name) => ({ name, from: textOf(old, name), to: textOf(now, name) }));
}
