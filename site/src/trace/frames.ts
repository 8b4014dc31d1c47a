/**
 * The conventions of the mat, as `py/bugbot/frames.py` has them (a test holds the two equal).
 * Imports nothing of ours.
 *
 * x runs to the right, y up the mat, from the lower left corner, in cm. A heading is clockwise
 * from straight up, so its direction is (sin, cos). A cell holds its lower and left edges; the
 * upper and right ones belong to its neighbours.
 */

/** Side of the square mat [cm]. */
export const MAT_CM = 200;
/** Radius of the round robot [cm]. */
export const ROBOT_RADIUS_CM = 5;
/** What the depth sensor reads when nothing is in range [cm]. */
export const SENSOR_RANGE_CM = 200;

/** Unit vector of a heading [degrees clockwise from up the mat]. */
export function direction(headingDeg: number): [x: number, y: number] {
  const angle = (headingDeg * Math.PI) / 180;
  return [Math.sin(angle), Math.cos(angle)];
}

/** The same heading as a number from 0 (included) to 360 (excluded). */
export function wrapHeading(headingDeg: number): number {
  const wrapped = ((headingDeg % 360) + 360) % 360;
  return wrapped >= 360 ? 0 : wrapped;
}

/** Shortest turn between two headings, from -180 (excluded) to 180, clockwise positive. */
export function turnBetween(fromDeg: number, toDeg: number): number {
  const turn = wrapHeading(toDeg - fromDeg);
  return turn > 180 ? turn - 360 : turn;
}

/** A square of the map, by its lower left corner and its side [cm]. */
export interface Cell {
  x: number;
  y: number;
  size: number;
}

/** The cell of side `sizeCm` that holds a point, or null beyond the mat. */
export function cellOf(x: number, y: number, sizeCm: number): Cell | null {
  if (!(x >= 0 && x < MAT_CM && y >= 0 && y < MAT_CM)) return null;
  return {
    x: Math.floor(x / sizeCm) * sizeCm,
    y: Math.floor(y / sizeCm) * sizeCm,
    size: sizeCm,
  };
}

/** How many cells of side `sizeCm` cover a side of the mat; the last may hang over the edge. */
export function cellsAcross(sizeCm: number): number {
  return Math.ceil(MAT_CM / sizeCm - 1e-9);
}
