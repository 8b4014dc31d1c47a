/**
 * Where a trace keeps its events: each kind in a form made for its look-ups, and the order of all
 * of them, so that they can be had again as they came. Checks nothing: `Trace` has done so.
 * Imports `events`, `columns`, `points`.
 */
import { Column, Table } from "./columns.ts";
import type {
  ConsoleEntry,
  End,
  Fault,
  Kind,
  Layer,
  Note,
  Print,
  Scan,
  TraceEvent,
} from "./events.ts";
import { PointStore } from "./points.ts";

/** Kinds that come while time passes by itself; all others mark something the program did. */
const IN_PASSING: ReadonlySet<Kind> = new Set<Kind>(["pose", "bump"]);

/** The drawings of one name, oldest first. */
interface LayerHistory {
  readonly times: Column;
  readonly layers: Layer[];
}

/** One line of the chart: `value.at(i)` was plotted at `t.at(i)`. */
export interface Series {
  readonly t: Column;
  readonly value: Column;
}

export class EventStore {
  readonly poses = new Table(["x", "y", "heading"]);
  readonly scans = new Table(["x", "y", "heading", "firstBeam"]);
  /** angle, distance, angle, distance, … of all scans. */
  readonly beams = new Column();
  readonly layers: Layer[] = [];
  readonly histories = new Map<string, LayerHistory>();
  readonly points = new PointStore();
  readonly series = new Map<string, Series>();
  readonly prints: Print[] = [];
  readonly notes: Note[] = [];
  /** Prints and notes in the order they came. */
  readonly console: ConsoleEntry[] = [];
  readonly consoleTimes = new Column();
  readonly lines = new Table(["line"]);
  readonly leds = new Table(["red", "green", "blue"]);
  readonly beeps = new Table(["freq", "ms"]);
  readonly bumps = new Table(["x", "y"]);
  readonly faults: Fault[] = [];
  readonly ends: End[] = [];
  /** The distinct times at which the program did something; the start is one. */
  readonly ticks = new Column();
  /** The kind of every event, and for a plot its name. */
  readonly #order: Kind[] = [];
  readonly #plotted: string[] = [];

  constructor() {
    this.ticks.push(0);
  }

  get length(): number {
    return this.#order.length;
  }

  push(event: TraceEvent): void {
    this.#order.push(event.kind);
    if (!IN_PASSING.has(event.kind) && event.t > this.ticks.at(this.ticks.length - 1)) {
      this.ticks.push(event.t);
    }
    switch (event.kind) {
      case "pose":
        this.poses.push(event);
        break;
      case "scan":
        this.scans.push({ ...event, firstBeam: this.beams.length });
        for (const value of event.beams) this.beams.push(value);
        break;
      case "layer": {
        const history = entry(this.histories, event.name, () => ({
          times: new Column(),
          layers: [],
        }));
        history.times.push(event.t);
        history.layers.push(event);
        this.layers.push(event);
        break;
      }
      case "plot": {
        const series = entry(this.series, event.name, () => ({
          t: new Column(),
          value: new Column(),
        }));
        series.t.push(event.t);
        series.value.push(event.value);
        this.#plotted.push(event.name);
        break;
      }
      case "print":
        this.prints.push(event);
        this.#toConsole(event);
        break;
      case "note":
        this.notes.push(event);
        this.#toConsole(event);
        break;
      case "line":
        this.lines.push(event);
        break;
      case "led":
        this.leds.push(event);
        break;
      case "beep":
        this.beeps.push(event);
        break;
      case "bump":
        this.bumps.push(event);
        break;
      case "fault":
        this.faults.push(event);
        break;
      case "end":
        this.ends.push(event);
        break;
    }
  }

  #toConsole(entry: ConsoleEntry): void {
    this.console.push(entry);
    this.consoleTimes.push(entry.t);
  }

  scan(index: number): Scan {
    const { firstBeam, ...pose } = this.scans.row(index);
    const isLast = index + 1 === this.scans.length;
    const end = isLast ? this.beams.length : this.scans.columns.firstBeam.at(index + 1);
    return { ...pose, beams: Array.from(this.beams.view(firstBeam, end)) };
  }

  /** Every event in the order it came. */
  *events(): Generator<TraceEvent> {
    const taken = new Map<string, number>();
    const next = (of: string): number => {
      const index = taken.get(of) ?? 0;
      taken.set(of, index + 1);
      return index;
    };
    for (const kind of this.#order) yield this.#event(kind, next(kind), next);
  }

  #event(kind: Kind, index: number, next: (of: string) => number): TraceEvent {
    switch (kind) {
      case "pose":
        return { kind, ...this.poses.row(index) };
      case "scan":
        return { kind, ...this.scan(index) };
      case "layer":
        return { kind, ...(this.layers[index] as Layer) };
      case "plot": {
        const name = this.#plotted[index] as string;
        const { t, value } = this.series.get(name) as Series;
        const i = next(`plot ${name}`);
        return { kind, t: t.at(i), name, value: value.at(i) };
      }
      case "print":
        return { kind, ...(this.prints[index] as Print) };
      case "note":
        return { kind, ...(this.notes[index] as Note) };
      case "line":
        return { kind, ...this.lines.row(index) };
      case "led":
        return { kind, ...this.leds.row(index) };
      case "beep":
        return { kind, ...this.beeps.row(index) };
      case "bump":
        return { kind, ...this.bumps.row(index) };
      case "fault":
        return { kind, ...(this.faults[index] as Fault) };
      case "end":
        return { kind, ...(this.ends[index] as End) };
    }
  }
}

/** The value of a key, made when it is asked for the first time. */
function entry<V>(map: Map<string, V>, key: string, make: () => V): V {
  let value = map.get(key);
  if (value === undefined) {
    value = make();
    map.set(key, value);
  }
  return value;
}
