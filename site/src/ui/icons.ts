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
  more: icon("M1.5 6.5h3v3h-3zM6.5 6.5h3v3h-3zM11.5 6.5h3v3h-3z"),
};
