/**
 * Where a lab's program runs: the world, and the noise its seed makes. The element's attributes
 * hold both; here is what goes with choosing them. May import `trace` and `ui`.
 */
import type { World } from "../trace/events.ts";
import { starterProgram } from "../ui/strings.ts";
import type { Place } from "./address.ts";
import { isOwnMat } from "./mats/own-name.ts";
import { ownStarter } from "./mats/own-starter.ts";
import { newSeed, type PickersInput } from "./pickers.ts";
import type { Services } from "./services.ts";
import type { Note } from "./status.ts";

/** What of the element is needed here. */
type PlacedLab = HTMLElement &
  Place & {
    pickers: boolean;
    choices: readonly string[] | null;
    say(note: Note | null): void;
  };

export class LabPlace {
  readonly #lab: PlacedLab;
  readonly #services: Pick<Services, "worlds" | "readyPrograms">;
  /** Every run has a new seed. */
  #freshNoise = false;

  constructor(lab: PlacedLab, services: Pick<Services, "worlds" | "readyPrograms">) {
    this.#lab = lab;
    this.#services = services;
  }

  /** The lab's world. Throws a RangeError that names the worlds there are if it has another. */
  get world(): World {
    const { worlds } = this.#services;
    const world = worlds.find(({ name }) => name === this.#lab.world);
    if (world) return world;
    const names = worlds.map(({ name }) => name).join(", ");
    throw new RangeError(`<bugbot-lab>: no world "${this.#lab.world}". There are: ${names}`);
  }

  /** The program to begin with: the page's own, or one that maps this world. */
  get starter(): string {
    const { readyPrograms } = this.#services;
    const first = readyPrograms[0];
    if (first && isOwnMat(this.#lab.world)) return ownStarter(first.source, this.world);
    const ready = readyPrograms.find(({ world }) => world === this.#lab.world);
    return this.#lab.getAttribute("program") ?? ready?.source ?? starterProgram;
  }

  /** What readers call a world; one that is none of this site's goes by its name. */
  titleOf(name: string): string {
    return this.#services.worlds.find((world) => world.name === name)?.title ?? name;
  }

  /** Whether the site has a world of this name. */
  knows(name: string): boolean {
    return this.#services.worlds.some((world) => world.name === name);
  }

  choose({ world, seed }: Partial<Place>): void {
    if (world !== undefined) this.#lab.world = world;
    if (seed !== undefined) this.#lab.seed = seed;
    this.#lab.say(null);
    this.#lab.dispatchEvent(new Event("place-change"));
  }

  /** A run begins: with new noise, if that was chosen. */
  begin(): void {
    if (this.#freshNoise) this.choose({ seed: newSeed() });
  }

  /** What there is to choose. */
  pickers(onRepeat: () => void): PickersInput {
    const { world, seed, pickers, choices } = this.#lab;
    const offered = this.#services.worlds.filter(({ name }) => choices?.includes(name) ?? true);
    return {
      worlds: pickers ? offered : [],
      world,
      seed,
      freshNoise: this.#freshNoise,
      onWorld: (name) => this.choose({ world: name }),
      onSeed: (chosen) => {
        // Who names a seed wants it again.
        this.#freshNoise = false;
        this.choose({ seed: chosen });
      },
      onBadSeed: (text) => this.#lab.say({ text }),
      onFreshNoise: (fresh) => {
        this.#freshNoise = fresh;
        this.#lab.say(null);
      },
      onRepeat,
    };
  }
}
