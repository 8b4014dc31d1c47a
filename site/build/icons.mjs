/**
 * The site's icon as pictures of fixed sizes, for devices that put it among their apps. The same
 * drawing as public/favicon.svg, painted by hand.
 */
import { png } from "./png.mjs";

const GROUND = 0xefe9dc;
/** The drawing, 32 units wide, the later on top: cells [left, top, width, height, colour], … */
const CELLS = [
  [4, 4, 8, 24, 0x9ecae1],
  [12, 12, 8, 8, 0x9ecae1],
  [12, 4, 16, 8, 0x111111],
];
/** … and on these the robot's discs [x, y, radius, colour]. */
const DISCS = [
  [20, 20, 6.5, 0x0b6e62],
  [21.8, 17.6, 1.7, 0xffffff],
];
/** Looks into each pixel so many times each way: edges are smooth. */
const LOOKS = 3;

/** Some devices cut off all but a circle of 80 %: the drawing keeps within it. */
const INSIDE_A_CIRCLE = 0.7;

/**
 * Every picture by its file name.
 * @returns {Map<string, Uint8Array>}
 */
export function iconFiles() {
  return new Map([
    ["icon-192.png", icon(192, 1)],
    ["icon-512.png", icon(512, 1)],
    ["icon-maskable-512.png", icon(512, INSIDE_A_CIRCLE)],
    // What Apple's devices put on the home screen; they round its corners themselves.
    ["apple-touch-icon.png", icon(180, 0.9)],
  ]);
}

/**
 * @param {number} size width and height [pixels]
 * @param {number} share of it that the drawing takes
 */
function icon(size, share) {
  const pixels = new Uint8Array(size * size * 3);
  const step = 1 / LOOKS;
  const units = 32 / (size * share);
  for (let row = 0; row < size; row += 1) {
    for (let column = 0; column < size; column += 1) {
      let [red, green, blue] = [0, 0, 0];
      for (let y = row + step / 2; y < row + 1; y += step) {
        for (let x = column + step / 2; x < column + 1; x += step) {
          const colour = colourAt(16 + (x - size / 2) * units, 16 + (y - size / 2) * units);
          red += colour >> 16;
          green += (colour >> 8) & 255;
          blue += colour & 255;
        }
      }
      const mean = [red, green, blue].map((sum) => sum / LOOKS ** 2);
      pixels.set(mean, 3 * (row * size + column));
    }
  }
  return png(size, size, pixels);
}

/**
 * The drawing's colour at a point [units], as 0xRRGGBB.
 * @param {number} x
 * @param {number} y
 */
function colourAt(x, y) {
  let found = GROUND;
  for (const [left = 0, top = 0, width = 0, height = 0, colour = 0] of CELLS) {
    if (x >= left && x < left + width && y >= top && y < top + height) found = colour;
  }
  for (const [cx = 0, cy = 0, radius = 0, colour = 0] of DISCS) {
    if ((x - cx) ** 2 + (y - cy) ** 2 < radius ** 2) found = colour;
  }
  return found;
}
