/**
 * The live figures by name: what the build puts into a page for `::live NAME`, complete and
 * readable with scripts off. May import each figure's `html`.
 */

import { beamHtml } from "./beam/html.ts";
import { EXAMPLES, FIRST_RULE } from "./beam/scene.ts";
import { evidenceHtml, FIRST_PRESSES } from "./evidence/html.ts";

export const LIVE_FIGURES: Readonly<Record<string, string>> = {
  beam: whole(
    "beam",
    beamHtml({ beam: EXAMPLES.slant, rule: FIRST_RULE, id: "beam", live: false }),
  ),
  evidence: whole(
    "evidence",
    evidenceHtml({ system: "ours", presses: FIRST_PRESSES, id: "evidence", live: false }),
  ),
};

/** Markdown takes an empty line for the end of HTML, and four spaces for a program. */
function whole(name: string, inside: string): string {
  const lines = inside.split("\n").map((line) => line.trim());
  return `<bugbot-${name} class="live-figure">${lines.filter(Boolean).join("\n")}</bugbot-${name}>`;
}
