/**
 * The same map as map-picture.mjs as a PNG, for other sites to show beside a link: 1200 by 630, the
 * mat in the middle. Drawn by hand: boxes and a disc need no library.
 *
 * @typedef {import("./figure-value.mjs").Outcome} Outcome
 * @typedef {import("../../src/trace/events.ts").World} World
 */
import { png } from "../png.mjs";

const WIDTH = 1200;
const HEIGHT = 630;
const MAT_CM = 200;
const EDGE_CM = 4;
const ROBOT_CM = 5;
const SCALE = 590 / (MAT_CM + 2 * EDGE_CM);

/** The light theme's colours, from tokens.css. */
const COLOURS = {
  paper: "#fbfaf7",
  wall: "#c9b899",
  mat: "#efe9dc",
  thing: "#a48b62",
  robot: "#0b6e62",
  nose: "#ffffff",
};

/**
 * @param {Outcome} outcome
 * @param {World} world
 * @returns {Uint8Array}
 */
export function mapImage(outcome, world) {
  const pixels = new Uint8Array(WIDTH * HEIGHT * 3);
  const left = (WIDTH - MAT_CM * SCALE) / 2;
  const bottom = (HEIGHT + MAT_CM * SCALE) / 2;
  /**
   * Paints the pixels of a box on the mat [cm] whose middles lie where `inside` says.
   * @param {number[]} box left, bottom, width, height
   * @param {string} colour as #rrggbb
   * @param {(x: number, y: number) => boolean} inside
   */
  const paint = ([x = 0, y = 0, width = 0, height = 0], colour, inside = () => true) => {
    const rgb = [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16));
    const [firstColumn, endColumn] = [x, x + width].map((cm) => Math.round(left + cm * SCALE));
    const [firstRow, endRow] = [y + height, y].map((cm) => Math.round(bottom - cm * SCALE));
    for (let row = Math.max(0, firstRow ?? 0); row < Math.min(HEIGHT, endRow ?? 0); row += 1) {
      for (
        let column = Math.max(0, firstColumn ?? 0);
        column < Math.min(WIDTH, endColumn ?? 0);
        column += 1
      ) {
        const [cmX, cmY] = [(column + 0.5 - left) / SCALE, (bottom - row - 0.5) / SCALE];
        if (inside(cmX, cmY)) pixels.set(rgb, 3 * (row * WIDTH + column));
      }
    }
  };
  /** @param {number} x @param {number} y @param {number} radius @param {string} colour */
  const disc = (x, y, radius, colour) =>
    paint(
      [x - radius, y - radius, 2 * radius, 2 * radius],
      colour,
      (cmX, cmY) => Math.hypot(cmX - x, cmY - y) < radius,
    );

  paint([-MAT_CM, -MAT_CM, 3 * MAT_CM, 3 * MAT_CM], COLOURS.paper);
  const side = MAT_CM + 2 * EDGE_CM;
  paint([-EDGE_CM, -EDGE_CM, side, side], COLOURS.wall);
  paint([0, 0, MAT_CM, MAT_CM], COLOURS.mat);
  for (const { x, y, width, height } of world.obstacles)
    paint([x, y, width, height], COLOURS.thing);
  for (const { shape, size, colour, points } of Object.values(outcome.layers)) {
    if (shape !== "squares") continue;
    const named = colour === "black" ? "#000000" : colour;
    for (const [x, y] of points) paint([x - size / 2, y - size / 2, size, size], named);
  }
  const { x, y, heading } = outcome.pose;
  const angle = (heading * Math.PI) / 180;
  const nose = ROBOT_CM * 0.55;
  disc(x, y, ROBOT_CM, COLOURS.robot);
  disc(x + nose * Math.sin(angle), y + nose * Math.cos(angle), 1.5, COLOURS.nose);
  return png(WIDTH, HEIGHT, pixels);
}
