/**
 * Numbers that keep coming, stored side by side instead of one object each: 12,000 poses are four
 * plain arrays, and the last one before a time is found by halving. Imports nothing of ours.
 */

/** A growing array of numbers; grows by doubling, so that adding stays cheap. */
export class Column {
  #values = new Float64Array(16);
  #length = 0;

  get length(): number {
    return this.#length;
  }

  push(value: number): void {
    if (this.#length === this.#values.length) {
      const wider = new Float64Array(2 * this.#length);
      wider.set(this.#values);
      this.#values = wider;
    }
    this.#values[this.#length++] = value;
  }

  at(index: number): number {
    if (!(index >= 0 && index < this.#length)) {
      throw new RangeError(`index ${index} of a column of ${this.#length}`);
    }
    return this.#values[index] as number;
  }

  /** The numbers from one index to before another, not copied; good until the next push. */
  view(from = 0, to = this.#length): Float64Array {
    return this.#values.subarray(from, Math.min(to, this.#length));
  }

  /** In a column that never falls: the index of the last number that is not above `value`, or -1. */
  lastUpTo(value: number): number {
    let low = 0;
    let high = this.#length;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if ((this.#values[middle] as number) <= value) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
}

/** Columns of one length under their names, in order of `t`. */
export class Table<Name extends string> {
  readonly columns: Readonly<Record<Name | "t", Column>>;
  readonly #names: readonly (Name | "t")[];

  constructor(names: readonly Name[]) {
    this.#names = ["t", ...names];
    this.columns = Object.fromEntries(this.#names.map((name) => [name, new Column()])) as Record<
      Name | "t",
      Column
    >;
  }

  get length(): number {
    return this.columns.t.length;
  }

  push(row: Readonly<Record<Name | "t", number>>): void {
    for (const name of this.#names) this.columns[name].push(row[name]);
  }

  row(index: number): Record<Name | "t", number> {
    const row = {} as Record<Name | "t", number>;
    for (const name of this.#names) row[name] = this.columns[name].at(index);
    return row;
  }

  /** Index of the last row at or before a time, or -1. */
  indexAt(t: number): number {
    return this.columns.t.lastUpTo(t);
  }

  /** The last row at or before a time, or null. */
  at(t: number): Record<Name | "t", number> | null {
    const index = this.indexAt(t);
    return index < 0 ? null : this.row(index);
  }
}
