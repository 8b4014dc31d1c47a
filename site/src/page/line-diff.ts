/** Which lines of two texts differ. Pure. Imports nothing of ours. */

export interface LineDiff {
  /** Lines of the first text that have no partner in the second, 1 first; and the other way round. */
  first: number[];
  second: number[];
}

/** Larger differences are not compared line by line: all their lines count as different. */
const MOST_PAIRS = 4_000_000;

/** The fewest lines that must go from one text and come into it to make it the other. */
export function lineDiff(first: string, second: string): LineDiff {
  const a = first.split("\n");
  const b = second.split("\n");
  let start = 0;
  while (start < a.length && start < b.length && a[start] === b[start]) start++;
  let endA = a.length;
  let endB = b.length;
  while (endA > start && endB > start && a[endA - 1] === b[endB - 1]) {
    endA--;
    endB--;
  }
  return compared(a.slice(start, endA), b.slice(start, endB), start);
}

/** The differing middles; `before` lines precede both. */
function compared(a: readonly string[], b: readonly string[], before: number): LineDiff {
  const diff: LineDiff = { first: [], second: [] };
  const common = a.length * b.length > MOST_PAIRS ? null : commonLengths(a, b);
  let i = 0;
  let j = 0;
  while (i < a.length || j < b.length) {
    if (common && i < a.length && j < b.length && a[i] === b[j]) {
      i++;
      j++;
    } else if (j === b.length || (i < a.length && (!common || down(common, i, j)))) {
      diff.first.push(before + ++i);
    } else {
      diff.second.push(before + ++j);
    }
  }
  return diff;
}

/** Whether leaving out line i of the first keeps as much in common as leaving out line j. */
function down(common: readonly Uint32Array[], i: number, j: number): boolean {
  return (common[i + 1]?.[j] ?? 0) >= (common[i]?.[j + 1] ?? 0);
}

/** `[i][j]`: the most lines that the rest from line i on and the rest from line j on share in order. */
function commonLengths(a: readonly string[], b: readonly string[]): Uint32Array[] {
  const lengths = Array.from({ length: a.length + 1 }, () => new Uint32Array(b.length + 1));
  for (let i = a.length - 1; i >= 0; i--) {
    const row = lengths[i] as Uint32Array;
    const below = lengths[i + 1] as Uint32Array;
    for (let j = b.length - 1; j >= 0; j--) {
      row[j] = a[i] === b[j] ? (below[j + 1] ?? 0) + 1 : Math.max(below[j] ?? 0, row[j + 1] ?? 0);
    }
  }
  return lengths;
}
