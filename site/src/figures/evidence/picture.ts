/**
 * The two number lines of a cell as the inside of an SVG: log odds, where each hit is a step of the
 * same length, and probability, where the steps shrink towards 0 and 1. Places along a line are in
 * per cent, so the picture is as wide as there is room and its words stay readable.
 * Made of numbers and our own words only. May import `cell` and `ui`.
 */
import { evidenceWords, signed } from "../../ui/figure-words.ts";
import { call, course, type Numbers, type Press, probability } from "./cell.ts";

export const HIGH_PX = 170;

/** Dots for the last values only: more would blacken the line. */
const TRAIL = 40;
/** Room beyond the limits, as a share of the way between them. */
const MARGIN = 0.06;
/** Where a system has no lower limit, the line ends here. */
const LOWEST = -12;

interface Line {
  title: string;
  /** Height of the line in the picture. */
  y: number;
  /** Where log odds are on the line, in per cent of its length. */
  place(l: number): number;
  /** Log odds as this line's number. */
  written(l: number): string;
  /** Log odds to write a number at. */
  marks: number[];
}

export function evidencePicture(numbers: Numbers, presses: readonly Press[]): string {
  const values = course(numbers, presses);
  return [logOddsLine(numbers), probabilityLine(numbers)]
    .map((line) => drawn(line, numbers, values))
    .join("");
}

function logOddsLine({ low, high, free, occupied }: Numbers): Line {
  const from = Math.max(low, LOWEST);
  const room = MARGIN * (high - from);
  const place = (l: number): number => (100 * (l - from + room)) / (high - from + 2 * room);
  const marks = [low, free, 0, occupied, high].filter(Number.isFinite);
  const written = (l: number): string => signed(l, Number.isInteger(l) ? 0 : 1);
  return { title: evidenceWords.logOdds, y: 50, place, written, marks };
}

function probabilityLine({ free, occupied }: Numbers): Line {
  const { NEGATIVE_INFINITY: never, POSITIVE_INFINITY: surely } = Number;
  const place = (l: number): number => 100 * probability(l);
  const marks = [never, free, 0, occupied, surely];
  const written = (l: number): string => String(Math.round(100 * probability(l)) / 100);
  return { title: evidenceWords.p, y: 136, place, written, marks };
}

function drawn(line: Line, numbers: Numbers, values: readonly number[]): string {
  const l = values.at(-1) ?? 0;
  const at = percent(line.place(l));
  return [
    `<text class="title" x="-12" y="${line.y - 32}">${line.title}</text>`,
    zones(line, numbers),
    limits(line, numbers),
    labels(line),
    ...values
      .slice(-TRAIL - 1, -1)
      .map(
        (value) =>
          `<circle class="before" cx="${percent(line.place(value))}" cy="${line.y - 10}" r="2.5"/>`,
      ),
    `<svg class="now ${call(numbers, l)}" x="${at}" y="${line.y - 10}"><path d="M0 0l-6 -11h12z"/></svg>`,
  ].join("");
}

/** Free, unknown and occupied, each in its own colour between the limits. */
function zones({ y, place }: Line, { low, high, free, occupied }: Numbers): string {
  const zone = (kind: string, from: number, to: number): string =>
    from < to
      ? `<rect class="${kind}" x="${percent(place(from))}" y="${y - 7}" width="${(within(place(to)) - within(place(from))).toFixed(2)}%" height="14"/>`
      : "";
  return (
    zone("free", low, free) + zone("unknown", free, occupied) + zone("occupied", occupied, high)
  );
}

/** A bar where the log odds are held. */
function limits({ y, place }: Line, { low, high }: Numbers): string {
  return [low, high]
    .filter(Number.isFinite)
    .map((limit) => {
      const x = percent(place(limit));
      return `<line class="limit" x1="${x}" x2="${x}" y1="${y - 13}" y2="${y + 13}"/>`;
    })
    .join("");
}

function labels({ y, place, written, marks }: Line): string {
  return [...new Set(marks)]
    .map((mark) => {
      const x = percent(place(mark));
      return `<line class="tick" x1="${x}" x2="${x}" y1="${y + 7}" y2="${y + 12}"/><text x="${x}" y="${y + 26}" text-anchor="middle">${written(mark)}</text>`;
    })
    .join("");
}

/** Beyond the line's ends is at its end. */
const within = (place: number): number => Math.min(100, Math.max(0, place));
const percent = (place: number): string => `${within(place).toFixed(2)}%`;
