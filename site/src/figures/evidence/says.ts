/**
 * What the evidence figure says in words. May import `cell` and `ui`.
 */
import { evidenceWords, signed } from "../../ui/figure-words.ts";
import {
  call,
  course,
  type Numbers,
  type Press,
  probability,
  SYSTEMS,
  type System,
  undoing,
} from "./cell.ts";

/** What a system adds, within which limits, and what it calls occupied. */
export function systemSentence(system: System): string {
  const numbers: Numbers = SYSTEMS[system];
  const { hit, pass, low, high, overshoots } = numbers;
  const calls = { ours: evidenceWords.ourCalls, cartographer: evidenceWords.noCalls };
  return [
    evidenceWords.adds(hit, pass),
    overshoots ? evidenceWords.stops(high) : evidenceWords.kept(low, high),
    system === "ours" || system === "cartographer" ? calls[system] : evidenceWords.calls,
  ].join(" ");
}

/** The numbers of the moment: log odds, probability, and what the cell is taken for. */
export function readout(numbers: Numbers, presses: readonly Press[]): Record<ReadoutName, string> {
  const l = course(numbers, presses).at(-1) ?? 0;
  return {
    logOdds: signed(l, 2),
    p: probability(l).toFixed(3),
    call: evidenceWords[call(numbers, l)],
  };
}

export const READOUT = ["logOdds", "p", "call"] as const;
export type ReadoutName = (typeof READOUT)[number];

/** What has been given, what it comes to, and what would undo it. */
export function evidenceSentence(numbers: Numbers, presses: readonly Press[]): string {
  const values = course(numbers, presses);
  const l = values.at(-1) ?? 0;
  const undo = undoing(numbers, l);
  if (presses.length === 0) return evidenceWords.nothingYet;
  const total = (what: Press["what"]): number =>
    presses.reduce((sum, press) => sum + (press.what === what ? press.times : 0), 0);
  return [
    evidenceWords.state(total("hit"), total("pass"), l, probability(l), call(numbers, l)),
    ...(values.at(-2) === l ? [evidenceWords.held] : []),
    undo ? evidenceWords.undoneBy(undo.times, undo.what) : evidenceWords.even,
  ].join(" ");
}
