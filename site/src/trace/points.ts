/**
 * The point store: x, y, x, y, … in hundredths of a cm, kept as the very arrays that came out of
 * the worker. A layer's points are one view into one of them. Imports nothing of ours.
 */
export class PointStore {
  readonly #blocks: Int16Array[] = [];
  /** Number of the first point of each block. */
  readonly #firsts: number[] = [];
  #length = 0;

  /** Points stored so far. */
  get length(): number {
    return this.#length;
  }

  append(points: Int16Array): void {
    if (points.length === 0) return;
    this.#blocks.push(points);
    this.#firsts.push(this.#length);
    this.#length += points.length / 2;
  }

  /**
   * `count` points from number `first` on, as x, y, x, y, … Not copied when they came in one piece,
   * as the points of one drawing always do.
   */
  view(first: number, count: number): Int16Array {
    let block = this.#blockOf(first);
    const start = first - (this.#firsts[block] ?? 0);
    const whole =
      this.#blocks[block]?.subarray(2 * start, 2 * (start + count)) ?? new Int16Array(0);
    if (whole.length === 2 * count) return whole;
    const joined = new Int16Array(2 * count);
    joined.set(whole);
    for (let filled = whole.length; filled < joined.length; ) {
      const next = this.#blocks[++block];
      if (!next) throw new RangeError(`points ${first} to ${first + count} of ${this.#length}`);
      const piece = next.subarray(0, joined.length - filled);
      joined.set(piece, filled);
      filled += piece.length;
    }
    return joined;
  }

  /** The stored arrays, in order. */
  blocks(): readonly Int16Array[] {
    return this.#blocks;
  }

  #blockOf(point: number): number {
    let low = 0;
    let high = this.#firsts.length;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if ((this.#firsts[middle] as number) <= point) low = middle + 1;
      else high = middle;
    }
    return Math.max(0, low - 1);
  }
}
