/**
 * <bugbot-lab>: a program, a robot on its mat, and everything to run, watch and mend it.
 *
 * Attributes: `world` and `seed`; `program`, the text to start from; `label`, the lab's title;
 * `pickers`, to let the world and the noise be chosen. Properties: `world`, `seed`, and `program`,
 * the text in the editor now. `await run()` gives the outcome; `stop()`; `seek(seconds)`.
 * Fires `place-change` when the world or the seed has been chosen here.
 *
 * May import every room of the site but `worker`.
 */
import { LitElement, type PropertyValues, type TemplateResult } from "lit";
import { Player } from "../player/player.ts";
import type { Outcome, World } from "../trace/events.ts";
import { writeTraceFile } from "../trace/file.ts";
import { outcomeOf } from "../trace/outcome.ts";
import type { Trace } from "../trace/trace.ts";
import { repeatWords } from "../ui/noise-words.ts";
import { pickerWords, starterProgram, statusWords } from "../ui/strings.ts";
import { FIRST_SEED } from "./address.ts";
import { applyCodeSize, changeCodeSize } from "./code-size.ts";
import { emptyTrace } from "./empty-trace.ts";
import { labFace } from "./lab-face.ts";
import { LabFiles } from "./lab-files.ts";
import { LabProgram } from "./lab-program.ts";
import { newSeed, type PickersInput } from "./pickers.ts";
import { fitForPaper } from "./print.ts";
import { Redoing } from "./redoing.ts";
import { Repeat } from "./repeat.ts";
import { Runner } from "./runner.ts";
import type { Services } from "./services.ts";
import type { Note, StatusInput } from "./status.ts";
import type { LabTransport } from "./transport.ts";

export class BugbotLab extends LitElement {
  static override properties = {
    world: { type: String, reflect: true },
    seed: { type: Number, reflect: true },
    label: { type: String },
    pickers: { type: Boolean },
  };

  declare world: string;
  declare seed: number;
  declare label: string;
  declare pickers: boolean;

  readonly #services: Services;
  readonly #runner: Runner;
  readonly #player: Player;
  readonly #redoing: Redoing;
  readonly #repeat: Repeat;
  /** Every run has a new seed. */
  #freshNoise = false;
  #program: LabProgram | null = null;
  #files: LabFiles | null = null;
  /** The run before the one on show, to compare it with. */
  #earlier: Trace | null = null;
  /** Set before there is an editor to hold it. */
  #programToBe: string | null = null;
  #note: Note | null = null;
  readonly #redraw = (): void => this.requestUpdate();
  readonly #onRuntime = (): void => this.#runner.runtimeChanged();
  readonly #onLeave = (): void => this.#program?.flush();
  #stopElsewhere: (() => void) | null = null;
  #stopPaper: (() => void) | null = null;

  constructor(services: Services) {
    super();
    this.#services = services;
    this.world = services.worlds[0]?.name ?? "";
    this.seed = FIRST_SEED;
    this.label = "";
    this.pickers = false;
    this.#runner = new Runner(services.runtime, {
      onTrace: (trace, end) => this.#show(trace, end),
      onGrown: () => this.#player.grown(),
      onEnd: (trace) => this.#ended(trace),
    });
    this.#player = new Player(emptyTrace(this.#world), (callback) =>
      requestAnimationFrame(callback),
    );
    this.#redoing = new Redoing({
      begin: () => this.#leaveRun(),
      ready: (runs) => services.runtime.ready(runs),
      run: () => this.#run("end"),
      expect: (spares) => services.runtime.expect(spares),
    });
    this.#repeat = new Repeat(services.runtime, {
      onFirst: (trace) => this.#showOne(trace),
      onFailed: (trace) => {
        const { seed } = trace.header;
        this.#choose({ seed });
        this.#showOne(trace);
        this.#say({ text: repeatWords.stopped(seed) });
      },
    });
    this.#repeat.addEventListener("change", this.#redraw);
    this.#runner.addEventListener("change", this.#redraw);
    this.#player.addEventListener("change", () => this.#follow());
  }

  /** In the page itself, not in a shadow: one style sheet, and ids that can be referred to. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  // -- what a page or a person can ask of a lab --------------------------------

  /** The text in the editor. Setting it is one step that undo takes back. */
  get program(): string {
    return this.#program?.text ?? this.#programToBe ?? this.#starter;
  }

  set program(text: string) {
    if (this.#program) this.#program.replace(text);
    else this.#programToBe = text;
  }

  /** Runs the program and resolves to the outcome, however the run ends. */
  async run(): Promise<Outcome> {
    await this.updateComplete;
    this.#note = null;
    if (this.#freshNoise) this.#choose({ seed: newSeed() });
    this.#leaveRun();
    this.#program?.putAside();
    return outcomeOf(await this.#run("all"));
  }

  /** Another run comes: the one on show is what it is compared with. */
  #leaveRun(): void {
    this.#repeat.clear();
    this.#earlier = this.#runner.trace;
  }

  /** Runs the program as it is now, to be shown as it comes or only its end. */
  #run(shown: "all" | "end"): Promise<Trace> {
    this.#program?.shows(this.program);
    const { program, seed } = this;
    return this.#runner.run({ program, world: this.#world, seed }, shown === "end");
  }

  /** Another value for `NAME = number` in the program, one step for undo; a RangeError if none. */
  setConstant(name: string, value: number): void {
    this.#program?.setConstant(name, value);
  }

  /** Ends the run now; what it has shown is kept. */
  stop(): void {
    this.#repeat.cancel();
    this.#runner.stop();
  }

  /** Resolves when a run would start at once: Python is up, with an interpreter to spare. */
  ready(): Promise<void> {
    return this.#services.runtime.ready();
  }

  /** The run on show as the text of a trace file; null before the first run. */
  traceText(): string | null {
    const { trace } = this.#runner;
    return trace && writeTraceFile(trace);
  }

  /** Shows the run at a moment [s]. */
  seek(seconds: number): void {
    this.#player.seek(seconds);
  }

  /** Shows a program that came in a link; it replaces the one here only if the reader says so. */
  async offerShared(program: string): Promise<void> {
    await this.updateComplete;
    await this.#files?.offerShared(program);
  }

  // -- the element's life --------------------------------------------------------

  override connectedCallback(): void {
    super.connectedCallback();
    applyCodeSize(this);
    this.#services.runtime.addEventListener("change", this.#onRuntime);
    addEventListener("pagehide", this.#onLeave);
    this.#stopPaper = fitForPaper(this, () => this.#files?.sheet);
    this.#stopElsewhere = this.#services.store.onElsewhere((name) =>
      this.#files?.tellElsewhere(name),
    );
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#services.runtime.removeEventListener("change", this.#onRuntime);
    removeEventListener("pagehide", this.#onLeave);
    this.#stopElsewhere?.();
    this.#stopPaper?.();
    this.#program?.flush();
    this.stop();
  }

  override firstUpdated(): void {
    const { calls, store } = this.#services;
    const host = this.#part(".lab-editor");
    this.#program = new LabProgram({
      host,
      describedBy: this.#hintId,
      calls,
      store,
      onEdit: () => this.#say(null),
      onRun: () => void this.run(),
      onNumber: (event) => this.#redoing.on(event),
      // What can be undone at the moment matters more.
      onRefused: () => this.#note?.action ?? this.#say({ text: statusWords.notKept }),
    });
    this.#files = new LabFiles({
      lab: this,
      program: this.#program,
      worlds: this.#services.worlds,
      labAddress: this.#services.labAddress,
      run: () => this.#runner.trace,
      show: (run) => this.#showSaved(run),
      say: (note) => this.#say(note),
    });
    this.#files.acceptDrops(host);
    this.#open();
    if (this.#programToBe !== null) this.#program.replace(this.#programToBe);
  }

  override updated(changed: PropertyValues<this>): void {
    const before = changed.get("world");
    if (before === undefined || !this.#program) return;
    const text = this.#program.text;
    this.#runner.clear();
    this.#open();
    this.#offer(before, text);
  }

  get #world(): World {
    const { worlds } = this.#services;
    const world = worlds.find(({ name }) => name === this.world);
    if (world) return world;
    const names = worlds.map(({ name }) => name).join(", ");
    throw new RangeError(`<bugbot-lab>: no world "${this.world}". There are: ${names}`);
  }

  get #starter(): string {
    const ready = this.#services.readyPrograms.find(({ world }) => world === this.world);
    return this.getAttribute("program") ?? ready?.source ?? starterProgram;
  }

  get #hintId(): string {
    return `${this.id || "lab"}-hint`;
  }

  // -- program and world -----------------------------------------------------------

  /** Shows this world, empty, and the program that belongs to it here. */
  #open(): void {
    const page = location.pathname.replace(/index\.html$/, "");
    const opened = this.#program?.open(`${page}#${this.id}:${this.world}`, this.#starter);
    this.#player.show(emptyTrace(this.#world));
    this.#earlier = null;
    this.#repeat.clear();
    this.#files?.tellOpened(opened);
  }

  /** After a change of world: the program that was here may come along. */
  #offer(before: string, text: string): void {
    const title = this.#services.worlds.find(({ name }) => name === before)?.title ?? before;
    if (text === this.#program?.text) return;
    this.#say({
      text: pickerWords.ownProgram(this.#world.title),
      action: { label: pickerWords.bring(title), act: () => this.#program?.replace(text) },
    });
  }

  #choose(place: { world?: string; seed?: number }): void {
    if (place.world !== undefined) this.world = place.world;
    if (place.seed !== undefined) this.seed = place.seed;
    this.#say(null);
    this.dispatchEvent(new Event("place-change"));
  }

  #say(note: Note | null): void {
    this.#note = note;
    this.requestUpdate();
  }

  // -- runs ------------------------------------------------------------------------

  #show(trace: Trace, end: boolean): void {
    this.#player.show(trace);
    if (end) this.#player.toEnd();
    else this.querySelector<LabTransport>("lab-transport")?.begin();
  }

  /** Shows a run made before; its world and seed are chosen, if the site has that world. */
  async #showSaved(trace: Trace): Promise<void> {
    const { world, seed, program } = trace.header;
    const known = this.#services.worlds.some(({ name }) => name === world.name);
    if (known) this.#choose({ world: world.name, seed });
    await this.updateComplete;
    this.#repeat.clear();
    this.#earlier = null;
    this.#program?.shows(program);
    this.#runner.open(trace);
  }

  /** Runs the program with many seeds. */
  #repeatRun(): void {
    this.#runner.stop();
    this.#say(null);
    this.#program?.putAside();
    const { program, seed } = this;
    this.#program?.shows(program);
    void this.#repeat.start({ program, world: this.#world, seed });
  }

  /** The end of one run of the series, with nothing to compare it with but the others. */
  #showOne(trace: Trace): void {
    this.#earlier = null;
    this.#runner.open(trace);
    this.#player.toEnd();
  }

  #ended(trace: Trace): void {
    const { end, fault } = trace;
    if (fault?.line) this.#program?.showFault(fault.line, fault.message);
    // Where it went wrong or was stopped is what one wants to see, not how it began.
    if (end?.status !== "finished") this.#player.toEnd();
  }

  #follow(): void {
    const { trace, time, duration } = this.#player;
    const over = trace.complete && time >= duration;
    this.#program?.follow(over ? null : trace.lineAt(time));
  }

  #stopAndReturn(): void {
    this.stop();
    // The Stop button goes out with the run; the focus must not go with it.
    this.querySelector<HTMLElement>(".lab-bar .go")?.focus();
  }

  #cancelRepeat(): void {
    this.#repeat.cancel();
    this.querySelector<HTMLElement>(".lab-pickers .repeat")?.focus();
  }

  // -- what is drawn -----------------------------------------------------------------

  override render(): TemplateResult {
    return labFace({
      label: this.label,
      hintId: this.#hintId,
      player: this.#player,
      earlier: this.#earlier,
      pickers: this.pickers ? this.#pickers() : null,
      status: this.#status(),
      runs: this.#repeat.runs,
      report: this.#repeat.report,
      menu: this.#files?.menu ?? [],
      onReset: () => this.#files?.reset(),
      onStop: () => this.#stopAndReturn(),
      onRun: () => void this.run(),
      onCodeSize: (by) => changeCodeSize(this, by),
    });
  }

  #status(): StatusInput {
    const { phase, trace, note } = this.#runner;
    const ended = phase === "ended" ? trace : null;
    return {
      phase,
      runtime: this.#services.runtime,
      reached: trace?.duration ?? 0,
      end: ended?.end ?? null,
      fault: ended?.fault ?? null,
      note: this.#note,
      runNote: note,
      series: this.#repeat.progress,
      onCancel: () => this.#cancelRepeat(),
      onRetry: () => this.#services.runtime.warm(),
      onLine: (line) => this.#program?.goToLine(line),
    };
  }

  #part<Part extends HTMLElement>(selector: string): Part {
    const part = this.querySelector<Part>(selector);
    if (!part) throw new Error(`<bugbot-lab> was drawn without a ${selector}`);
    return part;
  }

  #pickers(): PickersInput {
    return {
      worlds: this.#services.worlds,
      world: this.world,
      seed: this.seed,
      onWorld: (world) => this.#choose({ world }),
      freshNoise: this.#freshNoise,
      onSeed: (seed) => {
        // Who names a seed wants it again.
        this.#freshNoise = false;
        this.#choose({ seed });
      },
      onFreshNoise: (fresh) => {
        this.#freshNoise = fresh;
        this.requestUpdate();
      },
      onRepeat: () => this.#repeatRun(),
      onBadSeed: (text) => this.#say({ text }),
    };
  }
}

/** Makes the element known, with what all labs of the page share. */
export function defineLab(services: Services): void {
  customElements.define(
    "bugbot-lab",
    class extends BugbotLab {
      constructor() {
        super(services);
      }
    },
  );
}
