/**
 * `embed.js`: <bugbot-lab> for pages of other sites, by one script and one tag.
 *
 *     <script async src="https://SITE/embed.js"></script>
 *     <bugbot-lab world="wall-ahead" seed="1"><pre>print("hello")</pre></bugbot-lab>
 *
 * The lab runs in a frame that this makes: with the site's own address, and so with its policy, its
 * workers and its style, and out of reach of the page around it but for the calls below. They are
 * those of the site's own element: `program`, `world`, `seed`, `await run()`, `stop()`, `seek()`.
 * Imports its own room and the type of the outcome.
 */
import type { Outcome } from "../trace/events.ts";
import {
  COMING,
  type FromLab,
  HELLO,
  type LabState,
  MISSING,
  type Start,
  type ToLab,
} from "./messages.ts";
import { whenParsed } from "./parsed.ts";
import { HostRuns } from "./runs.ts";

const script = document.currentScript;
if (!(script instanceof HTMLScriptElement)) {
  throw new Error("embed.js: load it by a <script src> of its own, without type=module");
}
/** The site that this script came from. */
const SITE = new URL(".", script.src);

/** What the frame is high until the lab has told its own height. */
const FIRST_HEIGHT = 760;
/** A frame that has loaded something that is no lab has said nothing by then [ms]. */
const FIRST_WORD_MS = 3000;
/** A page that does not answer, and a lab that is on its way and does not come [ms]. */
const PATIENCE_MS = { answer: 20_000, lab: 120_000 };

const words = {
  removed: "it was taken out of the page",
  left: "its page was left or loaded anew while the program was running",
  noLab: `${SITE.href}lab/ did not answer with a lab`,
  noAnswer: `${SITE.href}lab/ has not answered for ${PATIENCE_MS.answer / 1000} s`,
  noStart: `the lab could not start within ${PATIENCE_MS.lab / 1000} s`,
};

class EmbeddedLab extends HTMLElement {
  static readonly observedAttributes = ["world", "seed"];

  #frame: HTMLIFrameElement | null = null;
  #port: MessagePort | null = null;
  #state: Partial<LabState> = {};
  /** What was asked before the lab was there. */
  #early: ToLab[] = [];
  readonly #runs = new HostRuns();
  /** The frame's page has said something since it was loaded. */
  #isComing = false;
  /** What the frame has loaded is no lab. */
  #isAbsent = false;
  #patience: ReturnType<typeof setTimeout> | undefined;
  readonly #onMessage = (event: MessageEvent<unknown>): void => this.#receive(event);

  connectedCallback(): void {
    addEventListener("message", this.#onMessage);
    // Where this script was there before the tag, the program in it is still to come.
    whenParsed(this, () => {
      if (this.isConnected && !this.#frame) this.#build();
    });
  }

  #build(): void {
    const program = this.getAttribute("program") ?? this.querySelector("pre")?.textContent;
    if (program) this.#state.program ??= program.replace(/^\n/, "");
    const frame = document.createElement("iframe");
    const theme = this.getAttribute("theme");
    frame.src = new URL(`lab/?embed=host${theme ? `&theme=${theme}` : ""}`, SITE).href;
    frame.title = this.getAttribute("label") ?? "Robot lab";
    frame.allow = "clipboard-write";
    // A run that is asked for already does not wait until the reader comes near.
    frame.loading = this.#runs.any ? "eager" : "lazy";
    const style = `display: block; width: 100%; height: ${FIRST_HEIGHT}px; border: 0`;
    frame.setAttribute("style", style);
    this.style.display ||= "block";
    frame.addEventListener("load", () => this.#loaded());
    this.replaceChildren(frame);
    this.#frame = frame;
    if (this.#runs.any) this.#wait(PATIENCE_MS.answer, words.noAnswer);
  }

  disconnectedCallback(): void {
    removeEventListener("message", this.#onMessage);
    this.#leave(words.removed);
    this.#frame = null;
    this.#early = [];
  }

  attributeChangedCallback(name: string, _before: string | null, value: string | null): void {
    if (value === null) return;
    if (name === "world" && value !== this.#state.world) this.world = value;
    if (name === "seed" && Number(value) !== this.#state.seed) this.seed = Number(value);
  }

  /** The text in the editor. Setting it is one step that the reader can undo. */
  get program(): string {
    return this.#state.program ?? "";
  }

  set program(program: string) {
    this.#set("program", program, typeof program === "string");
  }

  get world(): string {
    return this.#state.world ?? "";
  }

  set world(world: string) {
    this.#set("world", world, typeof world === "string");
  }

  get seed(): number {
    return this.#state.seed ?? 1;
  }

  set seed(seed: number) {
    this.#set("seed", seed, Number.isSafeInteger(seed) && seed >= 0);
  }

  /**
   * Runs the program and resolves to the outcome, however the run ends; rejects with an Error that says
   * why if there is no lab to run it.
   */
  run(): Promise<Outcome> {
    const run = this.#runs.begin((id) => this.#say({ kind: "run", id }));
    if (!this.isConnected) this.#runs.failAll(words.removed);
    const frame = this.#frame;
    if (!frame || this.#port || this.#patience !== undefined) return run;
    // A frame far down the page has not been loaded yet.
    frame.loading = "eager";
    // One that has failed is loaded again: it is asked for.
    if (this.#isAbsent) frame.src = `${frame.src}`;
    this.#isAbsent = false;
    if (this.#isComing) this.#wait(PATIENCE_MS.lab, words.noStart);
    else this.#wait(PATIENCE_MS.answer, words.noAnswer);
    return run;
  }

  /** Ends the run now; what it has shown is kept. */
  stop(): void {
    this.#say({ kind: "stop" });
  }

  /** Shows the run at a moment [s]. */
  seek(seconds: number): void {
    if (Number.isFinite(seconds)) this.#say({ kind: "seek", seconds });
    else this.#say({ kind: "wrong", what: "seek", got: nameOf(seconds) });
  }

  #set<Name extends keyof LabState>(what: Name, value: LabState[Name], fits: boolean): void {
    if (!fits) {
      this.#say({ kind: "wrong", what, got: nameOf(value) });
      return;
    }
    this.#state[what] = value;
    // Before there is a lab, it simply begins like that.
    if (this.#port) this.#say({ kind: "set", state: { [what]: value } });
  }

  #say(message: ToLab): void {
    if (this.#port) this.#port.postMessage(message);
    else this.#early.push(message);
  }

  // -- the frame's page: comes, stays away, goes ---------------------------------------

  #wait(ms: number, words: string): void {
    clearTimeout(this.#patience);
    this.#patience = setTimeout(() => this.#leave(words), ms);
  }

  #settle(): void {
    clearTimeout(this.#patience);
    this.#patience = undefined;
  }

  /** There is no lab to speak with: whoever waits for a run hears why. */
  #leave(why: string): void {
    this.#settle();
    this.#isAbsent = true;
    this.#port?.close();
    this.#port = null;
    // A lab that comes later has nothing to do with what has been given up.
    this.#early = this.#early.filter(({ kind }) => kind === "wrong");
    this.#runs.failAll(why);
  }

  /** The frame has loaded a page: a first, or another one than it had. */
  #loaded(): void {
    if (this.#port || this.#isComing) return;
    this.#wait(FIRST_WORD_MS, words.noLab);
  }

  #receive({ source, origin, data }: MessageEvent<unknown>): void {
    const window = this.#frame?.contentWindow;
    if (!window || source !== window || origin !== SITE.origin) return;
    if (data === COMING) {
      // Another page than the one that was spoken with.
      if (this.#port) this.#leave(words.left);
      this.#isComing = true;
      this.#isAbsent = false;
      this.#wait(PATIENCE_MS.lab, words.noStart);
    }
    if (data === HELLO) this.#greet(window);
    if (typeof data === "string" && data.startsWith(MISSING) && !this.#port) {
      this.#leave(data.slice(MISSING.length));
    }
  }

  #greet(window: Window): void {
    if (this.#port) this.#leave(words.left);
    this.#settle();
    this.#isAbsent = false;
    const { port1, port2 } = new MessageChannel();
    this.#port = port1;
    port1.onmessage = (event: MessageEvent<FromLab>) => this.#hear(event.data);
    const { program, world, seed } = this.#state;
    const start: Start = {
      program: program ?? null,
      world: world ?? null,
      seed: seed === undefined ? null : String(seed),
      label: this.getAttribute("label"),
      pickers: this.hasAttribute("pickers"),
      name: this.getAttribute("name") ?? `${location.pathname} ${this.#number()}`,
    };
    window.postMessage({ kind: HELLO, start }, SITE.origin, [port2]);
    for (const message of this.#early.splice(0)) port1.postMessage(message);
  }

  #hear(message: FromLab): void {
    switch (message.kind) {
      case "state":
        this.#state = message.state;
        return;
      case "height":
        if (this.#frame) this.#frame.style.height = `${message.pixels}px`;
        return;
      case "outcome":
        this.#runs.end(message.id, message.outcome);
        return;
      case "failed":
        this.#runs.fail(message.id, message.message);
        return;
      case "gone":
        this.#isComing = false;
        this.#leave(words.left);
    }
  }

  /** The place of this lab among those of the page. */
  #number(): number {
    return [...document.querySelectorAll("bugbot-lab")].indexOf(this) + 1;
  }
}

/** What a value is, for a message: some can't be sent. */
function nameOf(value: unknown): string {
  if (value === null || typeof value === "number") return String(value);
  return typeof value === "object" ? "an object" : `a ${typeof value}`;
}

customElements.define("bugbot-lab", EmbeddedLab);
