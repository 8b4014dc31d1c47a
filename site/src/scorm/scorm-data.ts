/**
 * A lesson's progress as a platform keeps it (cmi.suspend_data): as the page's own JSON where that fits,
 * and packed tighter where it does not. It is never left out: of what does not fit even so, passes go
 * first and details are dropped. Pure. May import `page/progress-record`.
 */
import {
  keyOf,
  type ProgressRecord,
  readAll,
  type TaskRecord,
  writeProgress,
} from "../page/progress-record.ts";

/** SCORM 1.2 promises room for so many characters. */
export const MOST_CHARACTERS = 4096;

/** A packed text begins with this, and the lesson. */
const PACKED = "bugbot1 ";

/** What a platform holds for a lesson. */
export type Suspended = { record: ProgressRecord } | "nothing" | "foreign";

export function writeSuspended(lesson: string, progress: ProgressRecord): string {
  const own = [...progress.tasks].filter(([key]) => key.startsWith(`${lesson}/`));
  const plain = JSON.stringify(JSON.parse(writeProgress({ tasks: new Map(own), last: null })));
  if (plain.length <= MOST_CHARACTERS) return plain;
  // What is passed matters most.
  const sorted = own.toSorted(([, one], [, other]) => rank(one) - rank(other));
  const named = sorted.map(([key, task]) => [key.slice(lesson.length + 1), task] as const);
  const full = named.map(([name, task]) => packed(name, task));
  const short = named.map(([name, task]) => `${name},${task.state[0]}`);
  const head = `${PACKED}${lesson}`;
  // As many with all that is known of them as leave room for the bare state of the others.
  const lengthOf = (items: readonly string[]): number =>
    items.reduce((sum, item) => sum + item.length + 1, head.length);
  for (let detailed = full.length; detailed >= 0; detailed -= 1) {
    const items = [...full.slice(0, detailed), ...short.slice(detailed)];
    if (lengthOf(items) <= MOST_CHARACTERS) return [head, ...items].join(";");
  }
  let fitting = short.length;
  while (lengthOf(short.slice(0, fitting)) > MOST_CHARACTERS) fitting -= 1;
  return [head, ...short.slice(0, fitting)].join(";");
}

/** What a platform gave back. Somebody else's text, or a newer version's, is "foreign". */
export function readSuspended(text: string): Suspended {
  if (text.trim() === "") return "nothing";
  const record = text.startsWith(PACKED) ? unpacked(text) : null;
  if (record) return { record };
  const { record: read, whole } = readAll(text);
  return whole ? { record: read } : "foreign";
}

function rank({ state }: TaskRecord): number {
  return state === "passed" ? 0 : 1;
}

/** `name,p,2,1,kg3x…`: state, hints, solution seen, moment; and five numbers for each score. */
function packed(
  name: string,
  { state, hints, solution, at, score, others = [] }: TaskRecord,
): string {
  const scores = (score ? [score, ...others] : others).map(({ best, bestAt, last, lastAt, of }) =>
    [best, moment(bestAt), last, moment(lastAt), of].join(","),
  );
  const item = [name, state[0], hints, solution ? 1 : 0, moment(at), ...scores];
  return item.join(",");
}

function unpacked(text: string): ProgressRecord | null {
  const [lesson = "", ...items] = text.slice(PACKED.length).split(";");
  const tasks: Record<string, unknown> = {};
  for (const item of items) {
    const [name = "", state, hints = "0", solution, at = "0", ...numbers] = item.split(",");
    const scores = [];
    for (let i = 0; i + 5 <= numbers.length; i += 5) {
      const [best, bestAt, last, lastAt, of] = numbers.slice(i, i + 5) as string[];
      scores.push({
        ...{ best: Number(best), last: Number(last), of: Number(of) },
        ...{ bestAt: momentIn(bestAt), lastAt: momentIn(lastAt) },
      });
    }
    const [score, ...others] = scores;
    tasks[keyOf(lesson, name)] = {
      ...{ state: state === "p" ? "passed" : "tried", hints: Number(hints) },
      ...{ solution: solution === "1", at: momentIn(at) },
      ...(score ? { score } : {}),
      ...(others.length > 0 ? { others } : {}),
    };
  }
  const { format, version } = JSON.parse(writeProgress({ tasks: new Map(), last: null }));
  const { record, whole } = readAll(JSON.stringify({ format, version, tasks, last: null }));
  return whole ? record : null;
}

/** Milliseconds since 1970, in as few signs as can be. */
function moment(at: number): string {
  return Math.round(at).toString(36);
}

function momentIn(text = ""): number {
  return Number.parseInt(text, 36);
}
