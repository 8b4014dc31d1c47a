/**
 * A run as the page holds it: events come in as they are made, and everything is looked up by
 * time, forwards and backwards alike. Imports `events`, `decode`, `store`, `frames`.
 *
 * Built to be asked 60 times a second about any moment of a ten minute run: numbers lie in
 * columns, look-ups halve, and a layer's points are never copied.
 */
import type { Column } from "./columns.ts";
import { checkLayer, decodeRow, decodeRows, TraceError, weight } from "./decode.ts";
import type {
  Beep,
  Bump,
  Chunk,
  ConsoleEntry,
  End,
  Fault,
  Header,
  Layer,
  Led,
  Note,
  Pose,
  Scan,
  TraceEvent,
} from "./events.ts";
import { turnBetween, wrapHeading } from "./frames.ts";
import { EventStore, type Series } from "./store.ts";

/** A trace may take this much before it is refused; the runtime stops a run well before. */
export const TRACE_BYTES = 80_000_000;

export class Trace {
  readonly header: Header;
  readonly #limitBytes: number;
  readonly #store = new EventStore();
  #bytes = 0;
  #duration = 0;

  constructor(header: Header, limitBytes = TRACE_BYTES) {
    this.header = header;
    this.#limitBytes = limitBytes;
  }

  // -- growing ---------------------------------------------------------------

  /** Adds what a run has sent. Throws TraceError, and then has taken nothing of the chunk. */
  append(chunk: Chunk): void {
    if (chunk.events.length > this.#limitBytes) throw this.#tooLarge();
    const first = this.length + 1;
    const rows = decodeRows(chunk.events, `rows from ${first} on`);
    this.appendRows(rows, chunk.points, (i) => `row ${first + i}`);
  }

  /** The same for rows that are parsed already; `where(i)` names row i in a message. */
  appendRows(rows: readonly unknown[], points: Int16Array, where: (i: number) => string): void {
    if (points.length % 2 !== 0) {
      throw new TraceError(`${where(0)}: the points do not come in pairs`);
    }
    const available = this.#store.points.length + points.length / 2;
    let bytes = this.#bytes + points.byteLength;
    let t = this.#duration;
    let ended = this.complete;
    const events: TraceEvent[] = [];
    for (const row of rows) {
      const place = where(events.length);
      const event = decodeRow(row, place);
      if (ended) throw new TraceError(`${place}: ${event.kind} after the end of the run`);
      if (event.t < t) throw new TraceError(`${place}: time goes back from ${t} to ${event.t} s`);
      if (event.kind === "layer") checkLayer(event, available, place);
      t = event.t;
      ended = event.kind === "end";
      bytes += weight(event);
      if (bytes > this.#limitBytes) throw this.#tooLarge();
      events.push(event);
    }
    this.#bytes = bytes;
    this.#duration = t;
    this.#store.points.append(points);
    for (const event of events) this.#store.push(event);
  }

  #tooLarge(): TraceError {
    return new TraceError(`the trace would grow beyond ${this.#limitBytes / 1e6} MB`);
  }

  // -- the run as a whole ----------------------------------------------------

  /** Simulated seconds so far. */
  get duration(): number {
    return this.#duration;
  }

  /** True once the end event is here. */
  get complete(): boolean {
    return this.end !== null;
  }

  get end(): End | null {
    return this.#store.ends[0] ?? null;
  }

  get fault(): Fault | null {
    return this.#store.faults[0] ?? null;
  }

  /** Events so far. */
  get length(): number {
    return this.#store.length;
  }

  /** Rough size in memory [bytes]. */
  get bytes(): number {
    return this.#bytes;
  }

  /** The distinct times at which the program did something, 0 first: what Step steps through. */
  get ticks(): Column {
    return this.#store.ticks;
  }

  /** Every plotted line by name, in order of first plotting. */
  get series(): ReadonlyMap<string, Series> {
    return this.#store.series;
  }

  /** Every event in the order it came. */
  events(): Generator<TraceEvent> {
    return this.#store.events();
  }

  /** The point store as the arrays it came in. */
  pointBlocks(): readonly Int16Array[] {
    return this.#store.points.blocks();
  }

  // -- a moment --------------------------------------------------------------

  /** Where the robot is, between two poses along the straight line and the shorter turn. */
  poseAt(t: number): Pose {
    const { poses } = this.#store;
    const before = poses.indexAt(t);
    if (before < 0) return { t, ...this.header.world.start };
    const a = poses.row(before);
    if (before + 1 === poses.length) return { ...a, t };
    const b = poses.row(before + 1);
    const share = (t - a.t) / (b.t - a.t);
    return {
      t,
      x: a.x + share * (b.x - a.x),
      y: a.y + share * (b.y - a.y),
      heading: wrapHeading(a.heading + share * turnBetween(a.heading, b.heading)),
    };
  }

  /**
   * The way from one time to another: x, y, x, y, … [cm]. Of poses less than `apartCm` from the
   * last one kept, only the final one is in it.
   */
  trail(from: number, to: number, apartCm = 0): Float64Array {
    const { poses } = this.#store;
    const xs = poses.columns.x.view();
    const ys = poses.columns.y.view();
    const first = poses.indexAt(from) + 1;
    const end = Math.max(first, poses.indexAt(to) + 1);
    const way = new Float64Array(2 * (end - first + 2));
    let { x, y } = this.poseAt(from);
    let length = 0;
    const keep = (nextX: number, nextY: number) => {
      way[length++] = x = nextX;
      way[length++] = y = nextY;
    };
    keep(x, y);
    for (let i = first; i < end; i++) {
      const nextX = xs[i] as number;
      const nextY = ys[i] as number;
      if (Math.abs(nextX - x) + Math.abs(nextY - y) >= apartCm) keep(nextX, nextY);
    }
    const last = this.poseAt(to);
    keep(last.x, last.y);
    return way.subarray(0, length);
  }

  get scanCount(): number {
    return this.#store.scans.length;
  }

  /**
   * Each beam of the scans from number `first` on: the pose it was taken from, its angle from
   * straight ahead, its reading. Makes no objects: a long run has 50,000 beams.
   */
  forEachBeam(
    first: number,
    use: (t: number, x: number, y: number, heading: number, angle: number, cm: number) => void,
  ): void {
    const { scans, beams } = this.#store;
    const { t, x, y, heading, firstBeam } = scans.columns;
    for (let i = first; i < scans.length; i++) {
      const end = i + 1 < scans.length ? firstBeam.at(i + 1) : beams.length;
      for (let k = firstBeam.at(i); k < end; k += 2) {
        use(t.at(i), x.at(i), y.at(i), heading.at(i), beams.at(k), beams.at(k + 1));
      }
    }
  }

  /** The last look of the depth sensor at or before a time. */
  scanAt(t: number): Scan | null {
    const index = this.#store.scans.indexAt(t);
    return index < 0 ? null : this.#store.scan(index);
  }

  /** What is drawn at a time, one layer a name, in order of first drawing. */
  layersAt(t: number): Layer[] {
    const shown: Layer[] = [];
    for (const { times, layers } of this.#store.histories.values()) {
      const layer = layers[times.lastUpTo(t)];
      if (layer) shown.push(layer);
    }
    return shown;
  }

  /** A layer's points as x, y, x, y, … in hundredths of a cm; a view, not to be written to. */
  pointsOf(layer: Layer): Int16Array {
    return this.#store.points.view(layer.first, layer.count);
  }

  /** What the console shows, oldest first: all that was printed, and the notes. */
  get console(): readonly ConsoleEntry[] {
    return this.#store.console;
  }

  /** How many entries of `console` there were by a time. */
  consoleUpTo(t: number): number {
    return this.#store.consoleTimes.lastUpTo(t) + 1;
  }

  /** All that had been printed by a time, both streams. */
  consoleText(t: number): string {
    const entries = this.console.slice(0, this.consoleUpTo(t));
    return entries.map((entry) => ("stream" in entry ? entry.text : "")).join("");
  }

  /** What calls did not do as they were told, oldest first. */
  get notes(): readonly Note[] {
    return this.#store.notes;
  }

  /** The learner's line being carried out, 1 first, or null before the first. */
  lineAt(t: number): number | null {
    return this.#store.lines.at(t)?.line ?? null;
  }

  /** The light's colour, or null before it was first set. */
  ledAt(t: number): Led | null {
    return this.#store.leds.at(t);
  }

  /** The tone that sounds at a time, or null. */
  beepAt(t: number): Beep | null {
    const beep = this.#store.beeps.at(t);
    return beep && t < beep.t + beep.ms / 1000 ? beep : null;
  }

  /** The last touches up to a time, at most `most`, oldest first. */
  bumpsUpTo(t: number, most = Number.POSITIVE_INFINITY): Bump[] {
    const { bumps } = this.#store;
    const end = bumps.indexAt(t) + 1;
    const found: Bump[] = [];
    for (let i = Math.max(0, end - most); i < end; i++) found.push(bumps.row(i));
    return found;
  }
}
