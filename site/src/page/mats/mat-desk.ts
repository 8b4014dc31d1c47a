/**
 * What is on the world editor's desk: one mat, what of it is chosen, and its steps back and forth.
 * Every change is kept on the device. Knows nothing of the screen; fires "change".
 * May import `trace` and `ui`.
 */
import type { World } from "../../trace/events.ts";
import { matWords, ownMatsWords } from "../../ui/mat-words.ts";
import { MOST_OBSTACLES } from "./check-world.ts";
import { History } from "./history.ts";
import { sameMat } from "./mat-file.ts";
import type { OwnMat, OwnMats } from "./own-mats.ts";
import { added, copyOf, freePlace, grown, kindOf, nudged, type Part, without } from "./shapes.ts";

/** A change is kept once nothing has followed for this long; leaving the page keeps it at once. */
const PAUSE_MS = 250;

interface State {
  world: World;
  chosen: Part | null;
}

/** What was done, and how it can be taken back. */
export interface Said {
  /** What it is about: the mat on the desk, or the mats of this device. */
  about: "mat" | "mats";
  text: string;
  undo?: () => void;
}

const NOTHING: Said = { about: "mat", text: "" };

export class MatDesk extends EventTarget {
  readonly #own: OwnMats;
  #history: History<State>;
  #unkept = false;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** What this tab kept or found last: anything else on the device is another tab's. */
  #last: World | null = null;
  said: Said = NOTHING;

  /** With the mat of that name; the last one changed; or a new one. */
  constructor(own: OwnMats, asked: string | null = null) {
    super();
    this.#own = own;
    const kept = asked === null ? own.all()[0]?.world : own.find(asked);
    const world = kept ?? this.#fresh(null);
    this.#last = kept ?? null;
    this.#history = new History<State>({ world, chosen: null });
    if (asked !== null && !kept) this.said = { about: "mat", text: matWords.unknown };
  }

  get world(): World {
    return this.#history.now.world;
  }

  get chosen(): Part | null {
    return this.#history.now.chosen;
  }

  get canUndo(): boolean {
    return this.#history.canUndo;
  }

  get canRedo(): boolean {
    return this.#history.canRedo;
  }

  get mats(): OwnMat[] {
    return this.#own.all();
  }

  // -- changes ---------------------------------------------------------------------

  /** A new state of the mat; changes with the same key one after another are one step. */
  change(world: World, key: string | null = null, chosen: Part | null = this.chosen): void {
    this.#history.change({ world, chosen }, key);
    this.said = NOTHING;
    this.#keepSoon();
    this.#changed();
  }

  /** What is chosen belongs to the state, but choosing is no step. */
  choose(part: Part | null): void {
    this.#history.settle();
    this.#history.show({ world: this.world, chosen: part });
    this.#changed();
  }

  /** The next thing on the mat, or the one before; the robot comes first. */
  chooseNext(by: 1 | -1): void {
    const count = this.world.obstacles.length + 1;
    const { chosen } = this;
    const place = chosen === null ? (by > 0 ? -1 : 0) : chosen === "robot" ? 0 : chosen + 1;
    const next = (place + by + count) % count;
    this.choose(next === 0 ? "robot" : next - 1);
  }

  nudge(dx: number, dy: number): void {
    const { chosen, world } = this;
    if (chosen !== null) this.change(nudged(world, chosen, dx, dy), `nudge ${chosen}`);
  }

  grow(dx: number, dy: number): void {
    const { chosen, world } = this;
    if (chosen !== null) this.change(grown(world, chosen, dx, dy), `grow ${chosen}`);
  }

  /** Ends a movement of many small changes. */
  settle(): void {
    this.#history.settle();
  }

  /** Takes back the movement of this key. */
  abandon(key: string): void {
    this.#history.abandon(key);
    this.#keepSoon();
    this.#changed();
  }

  /** A box where there is room for one. */
  addBox(): void {
    if (!this.hasRoom()) return;
    const box = freePlace(this.world);
    const { world } = this;
    this.change(added(world, { ...box, name: kindOf(box) }), null, world.obstacles.length);
    this.say(matWords.added(kindOf(box)));
  }

  /** Whether one more obstacle goes on the mat; says so if not. */
  hasRoom(): boolean {
    if (this.world.obstacles.length < MOST_OBSTACLES) return true;
    this.say(matWords.full(MOST_OBSTACLES));
    return false;
  }

  duplicate(): void {
    const { chosen, world } = this;
    const box = typeof chosen === "number" ? world.obstacles[chosen] : undefined;
    if (!box || !this.hasRoom()) return;
    this.change(added(world, copyOf(box)), null, world.obstacles.length);
    this.say(matWords.added(box.name));
  }

  remove(): void {
    const { chosen, world } = this;
    const box = typeof chosen === "number" ? world.obstacles[chosen] : undefined;
    if (typeof chosen !== "number" || !box) return;
    this.change(without(world, chosen), null, null);
    this.say(matWords.deleted(box.name), () => this.undo());
  }

  undo(): void {
    const done = this.#history.undo();
    if (done) this.#keepSoon();
    this.say(done ? matWords.undone : matWords.nothingToUndo);
  }

  redo(): void {
    const done = this.#history.redo();
    if (done) this.#keepSoon();
    this.say(done ? matWords.redone : matWords.nothingToRedo);
  }

  say(text: string, undo?: () => void, about: Said["about"] = "mat"): void {
    this.said = { about, text, ...(undo ? { undo } : {}) };
    this.#changed();
  }

  // -- mats ------------------------------------------------------------------------

  /** Another of the mats on this device. */
  open(name: string): void {
    this.flush();
    const world = this.#own.find(name);
    if (world) this.#show(world, world);
  }

  /** A new mat, made from a world of the site; it is kept from the first change on. */
  make(from: World | null): void {
    this.flush();
    this.#show(this.#fresh(from), null);
  }

  /** A mat that came in a file: kept as one of one's own, unless it is one already. */
  take(world: World, file: string): void {
    this.flush();
    const same = this.mats.find((each) => sameMat(each.world, world));
    if (same) {
      this.#show(same.world, same.world);
      this.say(matWords.openedBefore(file));
      return;
    }
    this.#show({ ...world, name: this.#own.newName() }, null);
    this.keep();
    this.say(matWords.opened(file));
  }

  /** Deletes a mat; the one on the desk makes room for another. */
  discard(name: string): void {
    this.flush();
    const gone = this.#own.find(name);
    if (!gone) return;
    const bringBack = this.#own.remove(name);
    if (name === this.world.name) {
      const next = this.mats[0]?.world;
      this.#show(next ?? this.#fresh(null), next ?? null);
    }
    const undo = (): void => {
      bringBack();
      this.open(name);
      this.say(ownMatsWords.back(gone.title), undefined, "mats");
    };
    this.say(ownMatsWords.removed(gone.title), undo, "mats");
  }

  /** Keeps the mat as it is, also one that nothing has been done to; false if the device won't. */
  keep(): boolean {
    this.#unkept = true;
    return this.flush();
  }

  /** Keeps what has been changed now. */
  flush(): boolean {
    clearTimeout(this.#timer);
    if (!this.#unkept) return true;
    this.#unkept = false;
    this.#last = this.world;
    const kept = this.#own.keep(this.world);
    if (!kept) this.say(matWords.notKept);
    else this.#changed();
    return kept;
  }

  /** Another tab has changed the mats. If this one is among them, theirs is a step to undo. */
  followElsewhere(): void {
    const theirs = this.#own.find(this.world.name);
    if (theirs && this.#last && !sameMat(theirs, this.#last) && !sameMat(theirs, this.world)) {
      this.#last = theirs;
      this.#history.change({ world: theirs, chosen: null });
      this.said = { about: "mat", text: matWords.elsewhere };
    }
    this.#changed();
  }

  #keepSoon(): void {
    this.#unkept = true;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.flush(), PAUSE_MS);
  }

  #show(world: World, last: World | null): void {
    this.#history = new History<State>({ world, chosen: null });
    this.#last = last;
    this.said = NOTHING;
    this.#changed();
  }

  #fresh(from: World | null): World {
    return {
      ...(from ?? { obstacles: [], start: { x: 100, y: 25, heading: 0 } }),
      name: this.#own.newName(),
      title: from ? matWords.copyTitle(from.title) : matWords.newTitle,
      description: matWords.description,
    };
  }

  #changed(): void {
    this.dispatchEvent(new Event("change"));
  }
}
