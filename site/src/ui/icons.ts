/**
 * The few pictures on buttons. Drawn here, because the arrows that fonts have look different on
 * every device and turn into coloured emoji on some. Imports nothing of ours.
 */
import { type SVGTemplateResult, svg } from "lit";

const icon = (path: string): SVGTemplateResult =>
  svg`<svg class="icon" viewBox="0 0 16 16" aria-hidden="true"><path d=${path} /></svg>`;

export const icons = {
  play: icon("M4 2.5v11l9-5.5z"),
  pause: icon("M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z"),
  step: icon("M3 2.5v11l7-5.5zM11 2.5h2v11h-2z"),
  back: icon("M13 2.5v11L6 8zM3 2.5h2v11H3z"),
  stop: icon("M3 3h10v10H3z"),
  close: icon(
    "M3.7 2.3 8 6.6l4.3-4.3 1.4 1.4L9.4 8l4.3 4.3-1.4 1.4L8 9.4l-4.3 4.3-1.4-1.4L6.6 8 2.3 3.7z",
  ),
  check: icon("M13.7 4 6.4 12.5 2.1 8.7l1.2-1.4 2.9 2.6 6.2-7.2z"),
  // Whole disc, ring with a cross, ring with a dash: told apart without colour.
  passed: icon("M8 1a7 7 0 1 0 0 14A7 7 0 0 0 8 1zM11.9 6 7.2 10.9 4.2 8l1.1-1.1 1.9 1.8 3.6-3.8z"),
  failed: icon(
    "M8 1a7 7 0 1 0 0 14A7 7 0 0 0 8 1zm0 1.5a5.5 5.5 0 1 1 0 11 5.5 5.5 0 0 1 0-11zM5.6 4.6 8 7l2.4-2.4 1 1L9 8l2.4 2.4-1 1L8 9l-2.4 2.4-1-1L7 8 4.6 5.6z",
  ),
  notRun: icon(
    "M8 1a7 7 0 1 0 0 14A7 7 0 0 0 8 1zm0 1.5a5.5 5.5 0 1 1 0 11 5.5 5.5 0 0 1 0-11zM5 7.2h6v1.6H5z",
  ),
  notTried: icon("M8 1a7 7 0 1 0 0 14A7 7 0 0 0 8 1zm0 1.5a5.5 5.5 0 1 1 0 11 5.5 5.5 0 0 1 0-11z"),
  tried: icon(
    "M8 1a7 7 0 1 0 0 14A7 7 0 0 0 8 1zm0 1.5a5.5 5.5 0 1 1 0 11 5.5 5.5 0 0 1 0-11zM8 4.3v7.4a3.7 3.7 0 0 1 0-7.4z",
  ),
  more: icon("M1.5 6.5h3v3h-3zM6.5 6.5h3v3h-3zM11.5 6.5h3v3h-3z"),
};
