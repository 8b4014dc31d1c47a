/**
 * `embed.js`: <bugbot-lab> for pages of other sites, by one script and one tag.
 *
 *     <script async src="https://SITE/embed.js"></script>
 *     <bugbot-lab world="wall-ahead" seed="1"><pre>print("hello")</pre></bugbot-lab>
 *
 * The lab runs in a frame that this makes: with the site's own address, and so with its policy, its
 * workers and its style, and out of reach of the page around it but for the calls below. They are
 * those of the site's own element: `program`, `world`, `seed`, `await run()`, `stop()`, `seek()`.
 * Imports the messages only.
 */
import type { Outcome } from "../trace/events.ts";
import { type FromLab, HELLO, type LabState, type Start, type ToLab } from "./messages.ts";

const script = document.currentScript;
if (!(script instanceof HTMLScriptElement)) {
  throw new Error("embed.js: load it by a <script src> of its own, without type=module");
}
/** The site that this script came from. */
const SITE = new URL(".", script.src);

/** What the frame is high until the lab has told its own height. */
const FIRST_HEIGHT = 760;

interface Waiting {
  resolve(outcome: Outcome): void;
  reject(error: Error): void;
}

class EmbeddedLab extends HTMLElement {
  static readonly observedAttributes = ["world", "seed"];

  #frame: HTMLIFrameElement | null = null;
  #port: MessagePort | null = null;
  #state: Partial<LabState> = {};
  /** What was asked before the lab was there. */
  #early: ToLab[] = [];
  readonly #runs = new Map<number, Waiting>();
  #runCount = 0;
  readonly #onMessage = (event: MessageEvent<unknown>): void => this.#greet(event);

  connectedCallback(): void {
    const program = this.getAttribute("program") ?? this.querySelector("pre")?.textContent;
    if (program) this.#state.program ??= program.replace(/^\n/, "");
    addEventListener("message", this.#onMessage);
    const frame = document.createElement("iframe");
    const theme = this.getAttribute("theme");
    frame.src = new URL(`lab/?embed=host${theme ? `&theme=${theme}` : ""}`, SITE).href;
    frame.title = this.getAttribute("label") ?? "Robot lab";
    frame.allow = "clipboard-write";
    frame.loading = "lazy";
    const style = `display: block; width: 100%; height: ${FIRST_HEIGHT}px; border: 0`;
    frame.setAttribute("style", style);
    this.style.display ||= "block";
    this.replaceChildren(frame);
    this.#frame = frame;
  }

  disconnectedCallback(): void {
    removeEventListener("message", this.#onMessage);
    this.#port?.close();
    this.#port = null;
    for (const { reject } of this.#runs.values()) {
      reject(new Error("<bugbot-lab> was taken out of the page"));
    }
    this.#runs.clear();
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
    this.#set({ program });
  }

  get world(): string {
    return this.#state.world ?? "";
  }

  set world(world: string) {
    this.#set({ world });
  }

  get seed(): number {
    return this.#state.seed ?? 1;
  }

  set seed(seed: number) {
    this.#set({ seed });
  }

  /** Runs the program and resolves to the outcome, however the run ends. */
  run(): Promise<Outcome> {
    this.#runCount += 1;
    const id = this.#runCount;
    // A frame far down the page has not been loaded yet.
    if (this.#frame) this.#frame.loading = "eager";
    return new Promise((resolve, reject) => {
      this.#runs.set(id, { resolve, reject });
      this.#say({ kind: "run", id });
    });
  }

  /** Ends the run now; what it has shown is kept. */
  stop(): void {
    this.#say({ kind: "stop" });
  }

  /** Shows the run at a moment [s]. */
  seek(seconds: number): void {
    this.#say({ kind: "seek", seconds });
  }

  #set(state: Partial<LabState>): void {
    Object.assign(this.#state, state);
    // Before there is a lab, it simply begins like that.
    if (this.#port) this.#port.postMessage({ kind: "set", state } satisfies ToLab);
  }

  #say(message: ToLab): void {
    if (this.#port) this.#port.postMessage(message);
    else this.#early.push(message);
  }

  #greet({ source, origin, data }: MessageEvent<unknown>): void {
    const window = this.#frame?.contentWindow;
    if (!window || source !== window || origin !== SITE.origin || data !== HELLO) return;
    const { port1, port2 } = new MessageChannel();
    this.#port?.close();
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
        this.#runs.get(message.id)?.resolve(message.outcome);
        break;
      case "failed":
        this.#runs.get(message.id)?.reject(new Error(message.message));
        break;
    }
    this.#runs.delete(message.id);
  }

  /** The place of this lab among those of the page. */
  #number(): number {
    return [...document.querySelectorAll("bugbot-lab")].indexOf(this) + 1;
  }
}

customElements.define("bugbot-lab", EmbeddedLab);
