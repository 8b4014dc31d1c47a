/**
 * <bugbot-lab>: a program, a robot on its mat, and everything to run, watch and mend it.
 *
 * Attributes: `world` and `seed`; `program`, the text to start from; `label`, the lab's title;
 * `pickers`, to let the world be chosen. Properties: `world`, `seed`, and `program`, the text in
 * the editor now. `await run()` gives the outcome; `await try({NAME: number})` runs an experiment;
 * `stop()`; `seek(seconds)`.
 * Fires `place-change` when the world or the seed has been chosen here, and `program-change`
 * (which bubbles) when the program in the editor has changed.
 *
 * The element is the desk where the parts meet: `lab-program` (what is written), `lab-runs` (what
 * is run and shown), `lab-try` (experiments), `lab-place` (where), `lab-files` (what is kept and
 * shared), `lab-face` (what it looks like).
 * May import every room of the site but `worker`.
 */
import { LitElement, type PropertyValues, type TemplateResult } from "lit";
import type { RunRequest } from "../runtime/client.ts";
import type { Outcome } from "../trace/events.ts";
import { outcomeOf } from "../trace/outcome.ts";
import type { Trace } from "../trace/trace.ts";
import { guestWords, repeatWords } from "../ui/noise-words.ts";
import { part } from "../ui/part.ts";
import { pickerWords, statusWords } from "../ui/strings.ts";
import type { Backdrop } from "../views/overhead/backdrop.ts";
import { FIRST_SEED } from "./address.ts";
import { applyCodeSize, changeCodeSize } from "./code-size.ts";
import { emptyTrace } from "./empty-trace.ts";
import { inTurn, takeTurn } from "./in-turn.ts";
import { labFace } from "./lab-face.ts";
import { LabFiles } from "./lab-files.ts";
import { LabPlace } from "./lab-place.ts";
import { LabProgram } from "./lab-program.ts";
import { type GuestOptions, LabRuns } from "./lab-runs.ts";
import { Experiment, type Values } from "./lab-try.ts";
import { fitForPaper } from "./print.ts";
import type { Services } from "./services.ts";
import type { Note, StatusInput } from "./status.ts";
import type { LabTransport } from "./transport.ts";
import type { Tried } from "./try-result.ts";

export class BugbotLab extends LitElement {
  static override properties = {
    world: { type: String, reflect: true },
    seed: { type: Number, reflect: true },
    label: { type: String },
    pickers: { type: Boolean },
    choices: { attribute: false },
    backdrop: { attribute: false },
  };

  declare world: string;
  declare seed: number;
  declare label: string;
  declare pickers: boolean;
  /** The names of the worlds that `pickers` offers; all there are if null. */
  declare choices: readonly string[] | null;
  /** What lies on the mat under the program's layers, such as a map from a file. */
  declare backdrop: Backdrop | null;

  readonly #services: Services;
  readonly #place: LabPlace;
  readonly #runs: LabRuns;
  readonly #experiment: Experiment;
  #program: LabProgram | null = null;
  #files: LabFiles | null = null;
  /** Set before there is an editor to hold it, or with a world that is not on show yet. */
  #programToBe: string | null = null;
  #worldOnShow: string | null = null;
  #note: Note | null = null;
  readonly #onRuntime = (): void => this.#runs.runtimeChanged();
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
    this.choices = null;
    this.backdrop = null;
    this.#place = new LabPlace(this, services);
    this.#runs = new LabRuns({
      runtime: services.runtime,
      empty: emptyTrace(this.#place.world),
      request: () => this.#request,
      onShow: (trace) => this.#program?.shows(trace.header.program),
      onPlay: () => this.querySelector<LabTransport>("lab-transport")?.begin(),
      onFault: (line, message) => this.#program?.showFault(line, message),
      onFailed: (trace) => {
        const { seed } = trace.header;
        this.#place.choose({ seed });
        this.say({ text: repeatWords.stopped(seed) });
      },
    });
    this.#experiment = new Experiment({
      request: () => this.#request,
      replace: (program) => this.#program?.replace(program),
      reset: () => this.#files?.reset(),
      run: () => this.#begin(),
      runAside: (request) => services.runtime.run(request),
      shown: () => this.#runs,
      compareWith: (earlier) => this.#runs.compareWith(earlier),
      restore: (trace, earlier) => this.#runs.restore(trace, earlier),
      say: (note) => this.say(note),
      focusStatus: () => this.focusStatus(),
    });
    this.#runs.addEventListener("change", () => this.requestUpdate());
    this.#runs.player.addEventListener("change", () => this.#follow());
  }

  /** In the page itself, not in a shadow: one style sheet, and ids that can be referred to. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  override async scheduleUpdate(): Promise<void> {
    if (!this.hasUpdated) {
      await inTurn(this);
      // What a page has here for readers without scripts has served.
      this.replaceChildren();
    }
    super.scheduleUpdate();
  }

  /** Who waits for the lab does not wait for its turn. */
  override getUpdateComplete(): Promise<boolean> {
    takeTurn(this);
    return super.getUpdateComplete();
  }

  // -- what a page or a person can ask of a lab --------------------------------

  /** The text in the editor. Setting it is one step that undo takes back. */
  get program(): string {
    return this.#programToBe ?? this.#program?.text ?? this.#place.starter;
  }

  set program(text: string) {
    this.#programToBe = text;
    if (this.#worldOnShow === this.world) this.#takeProgram();
  }

  #takeProgram(): void {
    if (this.#programToBe !== null) this.#program?.replace(this.#programToBe);
    this.#programToBe = null;
  }

  /** Runs the program and resolves to the outcome, however the run ends. */
  async run(): Promise<Outcome> {
    await this.updateComplete;
    return outcomeOf(await this.#begin());
  }

  #begin(): Promise<Trace> {
    this.say(null);
    this.#place.begin();
    this.#program?.putAside();
    return this.#runs.run();
  }

  /**
   * Sets constants of the program and runs it, beside the run without them, and offers to undo it.
   * Resolves to the outcome; to null, with nothing changed, if the program lacks one of them.
   */
  async try(values: Values): Promise<Outcome | null> {
    await this.updateComplete;
    const trace = await this.#experiment.begin(values);
    return trace && outcomeOf(trace);
  }

  /** The same for a page that tells of it beside its own words: with the run it is compared with. */
  async experiment(values: Values): Promise<Tried> {
    await this.updateComplete;
    const trace = await this.#experiment.begin(values);
    const onShow = trace !== null && trace === this.#runs.trace;
    return {
      words: this.#experiment.words,
      trace,
      before: onShow ? this.#runs.earlier : null,
      changed: onShow && this.#experiment.inForce,
    };
  }

  /** Takes the experiment back that is in force; in words, null if the program is another by now. */
  undoExperiment(): string | null {
    return this.#experiment.undo();
  }

  /** Another value for `NAME = number` in the program, one step for undo; a RangeError if none. */
  setConstant(name: string, value: number): void {
    this.setConstants({ [name]: value });
  }

  /** The same for several at once: one step for undo. None is set if one of them is not there. */
  setConstants(values: Readonly<Record<string, number>>): void {
    this.#program?.setConstants(values);
  }

  /** Ends the run now; what it has shown is kept. */
  stop(): void {
    this.#runs.stop();
  }

  /** Resolves when a run would start at once: Python is up, with an interpreter to spare. */
  ready(): Promise<void> {
    return this.#services.runtime.ready();
  }

  /** The run on show as the text of a trace file; null before the first run. */
  async traceText(): Promise<string | null> {
    const { writeTraceFile } = await part(() => import("../trace/file.ts"));
    const { trace } = this.#runs;
    return trace && writeTraceFile(trace);
  }

  /** Shows the run at a moment [s]. */
  seek(seconds: number): void {
    this.#runs.player.seek(seconds);
  }

  /**
   * Shows a run that is not this lab's own, and says so. It stays until a run, or until the reader
   * or the page goes `backToOwnRun()`.
   */
  showRun(trace: Trace, guest: GuestOptions): void {
    this.#runs.openGuest(trace, guest);
  }

  /** Shows again what was on show before `showRun`. */
  backToOwnRun(): void {
    this.#runs.backToOwn();
  }

  /** Says something in the status line until the next run or edit, with what can be done about it. */
  say(note: Note | null): void {
    this.#note = note;
    this.requestUpdate();
  }

  /** Puts the focus where the lab says what has happened, without scrolling there. */
  focusStatus(): void {
    const status = this.#part(".lab-status p");
    status.tabIndex = -1;
    status.focus({ preventScroll: true });
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
    const { calls, store, worlds, labAddress, runtime } = this.#services;
    const host = this.#part(".lab-editor");
    this.#program = new LabProgram({
      host,
      describedBy: this.#hintId,
      calls,
      store,
      onEdit: () => {
        this.say(null);
        this.dispatchEvent(new Event("program-change", { bubbles: true }));
      },
      onRun: () => void this.run(),
      onNumber: (event) => this.#runs.follow(event),
      // What is being said at the moment matters more.
      onRefused: () => this.#note ?? this.say({ text: statusWords.notKept }),
    });
    this.#files = new LabFiles({
      lab: this,
      program: this.#program,
      worlds,
      labAddress,
      run: () => this.#runs.trace,
      runtime,
      shown: this.#runs.player,
      show: (run) => this.#showSaved(run),
      say: (note) => this.say(note),
    });
    this.#files.acceptDrops(this);
    this.#open();
    this.#takeProgram();
  }

  override updated(changed: PropertyValues<this>): void {
    const before = changed.get("world");
    if (before === undefined || !this.#program) return;
    const text = this.#program.text;
    this.#open();
    if (this.#programToBe === null) this.#offer(before, text);
    else this.#takeProgram();
  }

  get #request(): RunRequest {
    return { program: this.program, world: this.#place.world, seed: this.seed };
  }

  get #hintId(): string {
    return `${this.id || "lab"}-hint`;
  }

  // -- program and world -----------------------------------------------------------

  /** Shows this world, empty, and the program that belongs to it here. */
  #open(): void {
    const page = location.pathname.replace(/index\.html$/, "");
    this.#worldOnShow = this.world;
    this.#runs.clear(emptyTrace(this.#place.world));
    const opened = this.#program?.open(`${page}#${this.id}:${this.world}`, this.#place.starter);
    this.#files?.tellOpened(opened);
  }

  /** After a change of world: the program that was here may come along. */
  #offer(before: string, text: string): void {
    if (text === this.#program?.text) return;
    this.say({
      text: pickerWords.ownProgram(this.#place.world.title),
      action: {
        label: pickerWords.bring(this.#place.titleOf(before)),
        act: () => this.#program?.replace(text),
      },
    });
  }

  /** Shows a run made before; its world and seed are chosen, if the site has that world. */
  async #showSaved(trace: Trace): Promise<void> {
    const { world, seed } = trace.header;
    if (this.#place.knows(world.name)) this.#place.choose({ world: world.name, seed });
    await this.updateComplete;
    this.#runs.open(trace);
  }

  #repeat(): void {
    this.say(null);
    this.#program?.putAside();
    this.#runs.repeat();
  }

  #follow(): void {
    const { trace, time, duration } = this.#runs.player;
    const over = trace.complete && time >= duration;
    this.#program?.follow(over ? null : trace.lineAt(time));
  }

  // -- what is drawn -----------------------------------------------------------------

  override render(): TemplateResult {
    const { player, earlier, series, guest } = this.#runs;
    return labFace({
      label: this.label,
      hintId: this.#hintId,
      player,
      earlier,
      outlined: guest?.outlined ?? [],
      backdrop: this.backdrop,
      pickers: this.#place.pickers(() => this.#repeat()),
      status: this.#status(),
      runs: series.runs,
      report: series.report,
      menu: this.#files?.menu ?? [],
      onMenu: async () => {
        await this.#files?.open();
        this.requestUpdate();
        await this.updateComplete;
      },
      onReset: () => this.#files?.reset(),
      onStop: () => {
        this.stop();
        // The Stop button goes out with the run; the focus must not go with it.
        this.#part(".lab-bar .go").focus();
      },
      onRun: () => void this.run(),
      onCodeSize: (by) => changeCodeSize(this, by),
    });
  }

  #status(): StatusInput {
    const { trace, series, guest } = this.#runs;
    const { phase, note: runNote } = this.#runs.state;
    const ended = phase === "ended" ? trace : null;
    const back = { label: guestWords.back, act: () => this.backToOwnRun() };
    return {
      phase,
      runtime: this.#services.runtime,
      reached: trace?.duration ?? 0,
      end: ended?.end ?? null,
      fault: ended?.fault ?? null,
      notes: [guest && { text: guest.note, action: back }, this.#note].filter((note) => !!note),
      runNote,
      series: series.progress,
      onCancel: () => {
        this.#runs.cancelSeries();
        this.querySelector<HTMLElement>(".lab-pickers .repeat")?.focus();
      },
      onRetry: () => this.#services.runtime.warm(),
      onLine: (line) => this.#program?.goToLine(line),
    };
  }

  #part<Part extends HTMLElement>(selector: string): Part {
    const part = this.querySelector<Part>(selector);
    if (!part) throw new Error(`<bugbot-lab> was drawn without a ${selector}`);
    return part;
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
