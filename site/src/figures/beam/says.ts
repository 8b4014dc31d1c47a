/**
 * What the beam figure says in words: beside the picture, and to those who do not see it.
 * May import `scene`, `geometry` and `ui`.
 */
import { beamWords } from "../../ui/figure-words.ts";
import { FAR_CM } from "./geometry.ts";
import { type Beam, passedBy, type Reading, type Rule, readingOf, stepOf } from "./scene.ts";

/** The reading, what it says of the floor, and which cells the rule finds. */
export function beamSentence(beam: Beam, rule: Rule): string {
  const reading = readingOf(beam);
  const { looks, cells, missed, longestMissed, beside } = passedBy(rule, beam.start, reading);
  const more = beamWords.more(missed.length, longestMissed);
  const named =
    rule === "bresenham"
      ? beamWords.line(cells.length, beside.length, more)
      : beamWords.steps(looks.length, stepOf(rule), cells.length, more);
  return `${beamWords.reading(reading.cm)} ${floor(reading)} ${named}`;
}

function floor({ hit, clear }: Reading): string {
  if (hit === null) return beamWords.nothing(FAR_CM);
  return clear > 0 ? beamWords.found(clear) : beamWords.tooClose;
}

/** What a rule comes to for this beam, in a few words. */
export function tally(beam: Beam, rule: Rule): string {
  const { cells, missed, beside } = passedBy(rule, beam.start, readingOf(beam));
  return beamWords.tally(cells.length, missed.length, beside.length);
}

/** Where a handle is, and what the sensor reads there. */
export function place(beam: Beam, handle: keyof Beam): string {
  const { x, y } = beam[handle];
  return beamWords.place(x, y, readingOf(beam).cm);
}

export type Mark = "free" | "hit" | "look" | "missed" | "beside";

/** The marks of the picture: how many there are, and what they mean. */
export function legend(beam: Beam, rule: Rule): { mark: Mark; text: string; count: number }[] {
  const reading = readingOf(beam);
  const { looks, cells, missed, beside } = passedBy(rule, beam.start, reading);
  return [
    { mark: "free", text: beamWords.free, count: cells.length },
    { mark: "hit", text: beamWords.hit, count: reading.hit === null ? 0 : 1 },
    { mark: "look", text: beamWords.look, count: looks.length },
    { mark: "missed", text: beamWords.missed, count: missed.length },
    { mark: "beside", text: beamWords.beside, count: beside.length },
  ];
}
