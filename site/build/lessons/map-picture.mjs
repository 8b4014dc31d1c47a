/**
 * A run's map as a picture: the mat from above as the overhead view has it, in SVG. The style sheet
 * of the home page has its colours, but for those that the program itself named.
 *
 * @typedef {import("./figure-value.mjs").Outcome} Outcome
 * @typedef {import("../../src/trace/events.ts").World} World
 */
import { escapeHtml } from "./html.mjs";

const MAT_CM = 200;
const EDGE_CM = 4;
const ROBOT_CM = 5;

/**
 * @param {Outcome} outcome
 * @param {World} world
 * @param {{ title: string, description: string }} words for who can't see it
 */
export function mapPicture(outcome, world, { title, description }) {
  const side = MAT_CM + 2 * EDGE_CM;
  const cells = Object.values(outcome.layers)
    .filter(({ shape }) => shape === "squares")
    .map((layer) => `<path fill="${escapeHtml(layer.colour)}" d="${squaresPath(layer)}" />`);
  const things = world.obstacles.map(
    ({ x, y, width, height }) =>
      `<rect class="thing" x="${x}" y="${MAT_CM - y - height}" width="${width}" height="${height}" />`,
  );
  const { x, y, heading } = outcome.pose;
  const angle = (heading * Math.PI) / 180;
  const nose = ROBOT_CM * 0.55;
  const [noseX, noseY] = [x + nose * Math.sin(angle), MAT_CM - y - nose * Math.cos(angle)];
  return `<svg class="world-picture map" viewBox="${-EDGE_CM} ${-EDGE_CM} ${side} ${side}" role="img" aria-labelledby="map-title map-description">
<title id="map-title">${escapeHtml(title)}</title>
<desc id="map-description">${escapeHtml(description)}</desc>
<rect class="wall" x="${-EDGE_CM}" y="${-EDGE_CM}" width="${side}" height="${side}" />
<rect class="mat" width="${MAT_CM}" height="${MAT_CM}" />
${things.join("\n")}
${cells.join("\n")}
<circle class="robot" cx="${round(x)}" cy="${round(MAT_CM - y)}" r="${ROBOT_CM}" />
<circle class="nose" cx="${round(noseX)}" cy="${round(noseY)}" r="1.5" />
<rect class="dim" x="${-EDGE_CM}" y="${-EDGE_CM}" width="${side}" height="${side}" />
</svg>`;
}

/**
 * The squares of a layer as few long boxes: neighbours in a row are one.
 * @param {{ size: number, points: readonly [number, number][] }} layer centres [cm]
 */
function squaresPath({ size, points }) {
  const sorted = [...points].sort(([ax, ay], [bx, by]) => ay - by || ax - bx);
  /** @type {{ x: number, y: number, count: number }[]} */
  const boxes = [];
  for (const [x, y] of sorted) {
    const last = boxes.at(-1);
    if (last && last.y === y && Math.abs(last.x + last.count * size - x) < 0.01) last.count += 1;
    else boxes.push({ x, y, count: 1 });
  }
  return boxes
    .map(({ x, y, count }) => {
      const [left, top] = [round(x - size / 2), round(MAT_CM - y - size / 2)];
      return `M${left} ${top}h${round(count * size)}v${round(size)}h${round(-count * size)}z`;
    })
    .join("");
}

/** @param {number} cm */
function round(cm) {
  return Math.round(cm * 100) / 100;
}
