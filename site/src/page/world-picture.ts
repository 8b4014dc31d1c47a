/**
 * A small picture of a world, for choosing one: the mat from above, with what stands on it and the
 * robot where it starts. May import `trace`.
 */
import { type SVGTemplateResult, svg } from "lit";
import type { World } from "../trace/events.ts";
import { direction, MAT_CM, ROBOT_RADIUS_CM } from "../trace/frames.ts";

/** In the picture y runs down, on the mat it runs up. */
const down = (y: number): number => MAT_CM - y;

export function worldPicture(world: World): SVGTemplateResult {
  const { x, y, heading } = world.start;
  const [right, up] = direction(heading);
  const nose = ROBOT_RADIUS_CM * 0.55;
  return svg`<svg class="world-picture" viewBox="-4 -4 208 208" aria-hidden="true">
    <rect class="wall" x="-4" y="-4" width="208" height="208" />
    <rect class="mat" width=${MAT_CM} height=${MAT_CM} />
    ${world.obstacles.map(
      (box) => svg`<rect class="thing" x=${box.x} y=${down(box.y + box.height)}
        width=${box.width} height=${box.height} />`,
    )}
    <circle class="robot" cx=${x} cy=${down(y)} r=${ROBOT_RADIUS_CM + 1} />
    <circle class="nose" cx=${x + nose * right} cy=${down(y) - nose * up} r="1.8" />
    <rect class="dim" x="-4" y="-4" width="208" height="208" />
  </svg>`;
}
