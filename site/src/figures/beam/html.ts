/**
 * The whole beam figure as text: what the build puts into the page, and what the element writes
 * again with its controls enabled, so that nothing moves when the script arrives. Words and numbers
 * of our own only. May import `picture`, `says`, `scene` and `ui`.
 */
import { beamWords } from "../../ui/figure-words.ts";
import { beamPicture, onPicture, VIEW_BOX } from "./picture.ts";
import { beamSentence, legend, type Mark, place, tally } from "./says.ts";
import { type Beam, CELL_CM, EXAMPLES, RULES, type Rule, readingOf, WIDE_CM } from "./scene.ts";

export interface BeamFigure {
  beam: Beam;
  rule: Rule;
  /** Begins the ids in it. */
  id: string;
  live: boolean;
}

export function beamHtml({ beam, rule, id, live }: BeamFigure): string {
  const disabled = live ? "" : " disabled";
  return `
    <div class="figure-stage">
      <svg class="picture" role="img" aria-label="${beamWords.picture}" aria-describedby="${id}-says" viewBox="${VIEW_BOX}">${beamPicture(beam, rule)}</svg>
      <svg class="handles" viewBox="${VIEW_BOX}"${live ? "" : ' aria-hidden="true"'}>
        ${handle("end", beamWords.end, beam, live)}
        ${handle("start", beamWords.robot, beam, live)}
      </svg>
    </div>
    <ul class="figure-legend" aria-label="${beamWords.legend}">${legendItems(beam, rule)}</ul>
    <p class="figure-says" id="${id}-says"${live ? ' role="status"' : ""}>${beamSentence(beam, rule)}</p>
    <fieldset class="figure-rules"${disabled}>
      <legend>${beamWords.rules}</legend>
      ${RULES.map((each) => ruleChoice(each, each === rule, beam, id)).join("")}
    </fieldset>
    <div class="figure-controls" role="group" aria-label="${beamWords.examples}">
      ${Object.keys(EXAMPLES)
        .map((name) => example(name as keyof typeof EXAMPLES, disabled))
        .join("")}
    </div>
    <p class="figure-help">${beamWords.help(CELL_CM)} <span class="live-only">${beamWords.drag}</span></p>`;
}

/** How many of each mark there are, beside what it means. */
export function legendItems(beam: Beam, rule: Rule): string {
  return legend(beam, rule)
    .map(({ mark, text, count }) => `<li>${KEY[mark]}${text} <b>${count}</b></li>`)
    .join("");
}

const key = (shape: string): string =>
  `<svg viewBox="0 0 10 10" aria-hidden="true"><rect class="mat" width="10" height="10"/>${shape}<rect class="dim" width="10" height="10"/></svg>`;

const KEY: Readonly<Record<Mark, string>> = {
  free: key(`<rect class="free" width="10" height="10"/>`),
  hit: key(`<rect class="hit" width="10" height="10"/>`),
  look: key(`<circle class="look" cx="5" cy="5" r="1.6"/>`),
  missed: key(`<path class="missed" d="M.5 .5h9v9h-9zM2.5 2.5l5 5m0-5l-5 5"/>`),
  beside: key(`<circle class="beside" cx="5" cy="5" r="3"/>`),
};

/** The robot or the end of its beam: something to take hold of, with a finger's reach round it. */
function handle(which: keyof Beam, name: string, beam: Beam, live: boolean): string {
  const slider = live
    ? ` tabindex="0" role="slider" aria-label="${name}" aria-valuemin="0" aria-valuemax="${WIDE_CM}" aria-valuenow="${beam[which].x}" aria-valuetext="${place(beam, which)}"`
    : "";
  const shape =
    which === "start"
      ? `<circle class="body" r="5"/><path class="nose" d="M0 -4.2L2.3 3L0 1.7L-2.3 3z"/>`
      : `<circle class="body" r="4"/><path class="nose" d="M0 -6.5V6.5M-6.5 0H6.5"/>`;
  return `<g class="handle ${which}" data-handle="${which}" transform="${placed(beam, which)}"${slider}><circle class="reach" r="13"/>${shape}</g>`;
}

/** Where a handle stands on the picture; the robot looks along its beam. */
export function placed(beam: Beam, which: keyof Beam): string {
  const { x, y } = onPicture(beam[which]);
  const turn = which === "start" ? ` rotate(${readingOf(beam).angle.toFixed(2)})` : "";
  return `translate(${x} ${y})${turn}`;
}

function example(name: keyof typeof EXAMPLES, disabled: string): string {
  return `<button type="button" data-example="${name}"${disabled}>${beamWords[name]}</button>`;
}

function ruleChoice(rule: Rule, checked: boolean, beam: Beam, id: string): string {
  return `<label><input type="radio" name="${id}-rule" value="${rule}"${checked ? " checked" : ""}><span>${beamWords[rule]}</span><small data-tally="${rule}">${tally(beam, rule)}</small></label>`;
}
