/**
 * The beam over its cells as the inside of an SVG: made of numbers only, the same for the page as
 * it is built and for the figure that moves. y runs up the mat and down the screen, so it is turned
 * here and nowhere else. May import `geometry` and `scene`.
 */
import type { Cell, Point } from "./geometry.ts";
import {
  type Beam,
  CELL_CM,
  HIGH_CM,
  type Passed,
  passedBy,
  type Reading,
  type Rule,
  readingOf,
  WIDE_CM,
} from "./scene.ts";

export const VIEW_BOX = `0 0 ${WIDE_CM} ${HIGH_CM}`;

/** Where a point of the mat is on the picture. */
export function onPicture({ x, y }: Point): Point {
  return { x, y: HIGH_CM - y };
}

/** Where a point of the picture is on the mat. */
export const onMatOf = onPicture;

export function beamPicture(beam: Beam, rule: Rule): string {
  const reading = readingOf(beam);
  const passed = passedBy(rule, beam.start, reading);
  return [
    `<rect class="mat" width="${WIDE_CM}" height="${HIGH_CM}"/>`,
    cells(passed, reading),
    grid(),
    marks(passed),
    line(beam, reading, passed),
    `<rect class="dim" width="${WIDE_CM}" height="${HIGH_CM}"/>`,
  ].join("");
}

function cells({ cells }: Passed, { hit }: Reading): string {
  const square = (kind: string, cell: Cell): string => {
    const { x, y } = corner(cell);
    return `<rect class="${kind}" x="${x}" y="${y}" width="${CELL_CM}" height="${CELL_CM}"/>`;
  };
  return cells.map((cell) => square("free", cell)).join("") + (hit ? square("hit", hit) : "");
}

function grid(): string {
  let path = "";
  for (let x = CELL_CM; x < WIDE_CM; x += CELL_CM) path += `M${x} 0V${HIGH_CM}`;
  for (let y = CELL_CM; y < HIGH_CM; y += CELL_CM) path += `M0 ${y}H${WIDE_CM}`;
  return `<path class="grid" d="${path}"/>`;
}

/** A cross in a cell that was missed, a ring in one that is none of the beam's. */
function marks({ missed, beside }: Passed): string {
  const cross = missed.map((cell) => {
    const { x, y } = corner(cell);
    return `M${x + 2.5} ${y + 2.5}l5 5m0-5l-5 5`;
  });
  const ring = beside.map((cell) => {
    const { x, y } = corner(cell);
    return `<circle class="beside" cx="${x + 5}" cy="${y + 5}" r="3"/>`;
  });
  const outlines = missed.map((cell) => {
    const { x, y } = corner(cell);
    return `M${x} ${y}h${CELL_CM}v${CELL_CM}h-${CELL_CM}z`;
  });
  return `<path class="missed" d="${outlines.join("")}${cross.join("")}"/>${ring.join("")}`;
}

/** Solid as far as the floor counts as free, thin for the rest of the way. */
function line({ start, end }: Beam, { clearEnd }: Reading, { looks }: Passed): string {
  const [from, clear, to] = [start, clearEnd, end].map(onPicture).map(at);
  const dots = looks.map((look) => {
    const { x, y } = onPicture(look);
    return `<circle class="look" cx="${short(x)}" cy="${short(y)}" r="1.3"/>`;
  });
  return `<path class="rest" d="M${clear}L${to}"/><path class="beam" d="M${from}L${clear}"/>${dots.join("")}`;
}

/** The upper left corner of a cell on the picture. */
function corner([column, row]: Cell): Point {
  return { x: column * CELL_CM, y: HIGH_CM - (row + 1) * CELL_CM };
}

const short = (value: number): string => String(Math.round(value * 100) / 100);
const at = ({ x, y }: Point): string => `${short(x)} ${short(y)}`;
