/**
 * Undoes the filters of a PNG file's rows, in place: the one loop of `mapping/png.py` that takes a
 * step for each byte, which Python in a page would need minutes for. Imports nothing of ours.
 *
 * @param rows each row is a byte that tells its filter (0 to 4) and `rowBytes` bytes
 * @param pixelBytes from a byte to the one of the same sample to the left
 */
export function undoFilters(rows: Uint8Array, rowBytes: number, pixelBytes: number): void {
  let above = new Uint8Array(rowBytes);
  for (let start = 0; start < rows.length; start += rowBytes + 1) {
    const row = rows.subarray(start + 1, start + 1 + rowBytes);
    undoRow(rows[start] as number, row, above, pixelBytes);
    above = row as Uint8Array<ArrayBuffer>;
  }
}

/** Section 9 of the specification. A byte holds what is left of a sum that is too large for it. */
function undoRow(filter: number, row: Uint8Array, above: Uint8Array, pixelBytes: number): void {
  const at = (bytes: Uint8Array, i: number): number => (i < 0 ? 0 : (bytes[i] as number));
  for (let i = 0; i < row.length; i++) {
    const left = at(row, i - pixelBytes);
    const up = above[i] as number;
    let guess = 0;
    if (filter === 1) guess = left;
    else if (filter === 2) guess = up;
    else if (filter === 3) guess = (left + up) >> 1;
    else if (filter === 4) guess = paeth(left, up, at(above, i - pixelBytes));
    row[i] = (row[i] as number) + guess;
  }
}

function paeth(left: number, up: number, corner: number): number {
  const guess = left + up - corner;
  const toLeft = Math.abs(guess - left);
  const toUp = Math.abs(guess - up);
  const toCorner = Math.abs(guess - corner);
  if (toLeft <= toUp && toLeft <= toCorner) return left;
  return toUp <= toCorner ? up : corner;
}
