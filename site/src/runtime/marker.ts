/**
 * One marking: the dialogue between a judge and the performers of its jobs.
 *
 * The judge is an interpreter that runs the lesson's check and never a line of the program. What it
 * wants to see the program do is a job; each job has an interpreter of its own, which knows nothing
 * of the check and is ended after it. So a program reaches neither its judge nor another run. Here
 * their texts are carried to and fro.
 */
import { type Job, type Mark, readStep } from "./marks.ts";
import type { FromWorker, JudgeRequest, ToWorker } from "./messages.ts";
import { type Died, type ModuleFiles, provideModules } from "./modules.ts";
import type { Partner, Workers } from "./pool.ts";

/** Jobs done side by side. Most devices have two cores or more. */
const AT_ONCE = 2;
/** A check that wants more rounds of jobs than this would never come to an end. */
const MOST_ROUNDS = 20;
/**
 * The judge only compares: if it takes this long, and this longer for each job, it is the check that
 * does not end [s].
 */
const JUDGE_S = { check: 60, job: 10 } as const;
/** What the judge's archive brings. */
const JUDGING = ["grader", "mapping"];
/** Ends what still goes on behind a marking that has ended; nobody hears it. */
const OVER = "the marking is over";

export interface MarkProgress {
  done: number;
  /** Jobs known of so far; the judge may ask for more. */
  of: number;
  /** The run begun last, and which of the marking's mats it is on; null before the first. */
  now: { mat: number; mats: number; seed: number } | null;
}

export interface MarkListeners {
  onProgress?(progress: MarkProgress): void;
  /** What the marking waits for, such as "Loading NumPy: 40 % of 3.1 MB". */
  onNote?(text: string): void;
}

/** A job and what became of it, as text. */
export interface Performance {
  job: Job;
  result: string;
}

export type Marked =
  | { kind: "marked"; mark: Mark; performances: readonly Performance[] }
  | { kind: "cancelled" }
  /** A fault of ours, in words. */
  | { kind: "failed"; message: string };

export class Marker {
  readonly done: Promise<Marked>;
  readonly #request: JudgeRequest;
  readonly #listeners: MarkListeners;
  readonly #workers: Workers;
  readonly #modules: ModuleFiles;
  /** The interpreters at work, the judge's among them. */
  readonly #partners = new Set<Partner>();
  readonly #performances: Performance[] = [];
  #jobs = 0;
  /** Names of the worlds that jobs are on, in the order they were asked for. */
  readonly #mats = new Set<string>();
  #place: Job["place"] = null;
  #over = false;
  #end: (marked: Marked) => void = () => {};

  constructor(
    request: JudgeRequest,
    listeners: MarkListeners,
    workers: Workers,
    modules: ModuleFiles,
  ) {
    this.#request = request;
    this.#listeners = listeners;
    this.#workers = workers;
    this.#modules = modules;
    this.done = this.#carryOut();
  }

  /** Ends the marking now, without a mark. Nothing happens if it has ended. */
  cancel(): void {
    this.#end({ kind: "cancelled" });
  }

  async #carryOut(): Promise<Marked> {
    const ended = new Promise<Marked>((resolve) => {
      this.#end = resolve;
    });
    this.#converse().then(this.#end, (error: unknown) => {
      const message = error instanceof Error ? error.message : String(error);
      this.#end({ kind: "failed", message });
    });
    const marked = await ended;
    this.#over = true;
    for (const partner of [...this.#partners]) this.#dismiss(partner);
    return marked;
  }

  async #converse(): Promise<Marked> {
    const judge = await this.#engage(this.#request.check, true);
    const begin = { kind: "judge", id: 0, request: JSON.stringify(this.#request) } as const;
    let said = await ask(judge, begin, JUDGE_S.check);
    for (let round = 0; round < MOST_ROUNDS; round++) {
      const step = readStep(said);
      if ("mark" in step) {
        return { kind: "marked", mark: step.mark, performances: this.#performances };
      }
      this.#jobs += step.jobs.length;
      for (const { place } of step.jobs) if (place) this.#mats.add(place.world.name);
      this.#tell();
      const results = await this.#perform(step.jobs);
      const patience = JUDGE_S.check + JUDGE_S.job * this.#jobs;
      said = await ask(judge, { kind: "results", id: 0, results }, patience);
    }
    throw new Error(`the check asked for jobs ${MOST_ROUNDS} times and gave no mark`);
  }

  /** Does the jobs, a few at a time; the results come in the order of the jobs. */
  async #perform(jobs: readonly Job[]): Promise<string[]> {
    const results: string[] = [];
    let next = 0;
    const lane = async (): Promise<void> => {
      for (let index = next++; index < jobs.length; index = next++) {
        const job = jobs[index] as Job;
        this.#place = job.place;
        this.#tell();
        const result = await this.#do(job);
        results[index] = result;
        this.#performances.push({ job, result });
        this.#tell();
      }
    };
    const lanes = this.#workers.oneAtATime ? 1 : AT_ONCE;
    await Promise.all(Array.from({ length: lanes }, lane));
    return results;
  }

  async #do(job: Job): Promise<string> {
    const { program } = this.#request;
    const performer = await this.#engage(program);
    const answer = await answerOf(
      performer,
      { kind: "perform", id: 0, program, job: job.text },
      { real_s: job.limits.real_s, silent_s: job.place ? job.limits.silent_s : null },
    );
    this.#dismiss(performer);
    if (answer === null) return endedEarly(job, "time");
    if (answer.kind === "performed") return answer.result;
    if (answer.kind === "died" && answer.reason !== "internal") return endedEarly(job, "crash");
    throw unexpected(answer, "the performer");
  }

  /** An interpreter with what a source imports; the judge and the reference come to a judge alone. */
  async #engage(source: string, judges = false): Promise<Partner> {
    if (this.#over) throw new Error(OVER);
    const partner = await this.#workers.take();
    if (this.#over) {
      partner.end();
      throw new Error(OVER);
    }
    this.#partners.add(partner);
    // The next one starts while this one works; a failure shows when it is needed.
    if (!this.#workers.oneAtATime) this.#workers.prepare().catch(() => {});
    const note = (text: string) => this.#listeners.onNote?.(text);
    const given = judges ? JUDGING : [];
    if (judges) {
      // The judge imports more of the standard library than a first run needs.
      const [stdlib, bytes] = await Promise.all([this.#modules.stdlib(), this.#modules.judging()]);
      partner.send({ kind: "stdlib", bytes: stdlib });
      partner.send({ kind: "package", name: "judging", bytes });
    }
    const died = await provideModules(partner, source, this.#modules, note, given);
    if (died) throw new Error(died.message);
    return partner;
  }

  #dismiss(partner: Partner): void {
    partner.end();
    this.#partners.delete(partner);
  }

  #tell(): void {
    if (this.#over) return;
    const place = this.#place;
    const mats = [...this.#mats];
    this.#listeners.onProgress?.({
      done: this.#performances.length,
      of: this.#jobs,
      now: place && {
        mat: mats.indexOf(place.world.name) + 1,
        mats: mats.length,
        seed: place.number,
      },
    });
  }
}

/** What the judge answers; rejects if it has no step to say. */
async function ask(judge: Partner, message: ToWorker, real_s: number): Promise<string> {
  const answer = await answerOf(judge, message, { real_s, silent_s: null });
  if (answer === null) throw new Error(`the check did not come to an end within ${real_s} s`);
  if (answer.kind !== "step") throw unexpected(answer, "the judge");
  return answer.step;
}

/**
 * What an interpreter answers to a message; null if it takes longer than `real_s` or, unless
 * `silent_s` is null, for so long tells of no simulated time passing.
 */
function answerOf(
  partner: Partner,
  message: ToWorker,
  { real_s, silent_s }: { real_s: number; silent_s: number | null },
): Promise<Exclude<FromWorker, { kind: "beat" }> | null> {
  return new Promise((resolve) => {
    const over = (): void => resolve(null);
    const wait = (seconds: number | null) =>
      seconds === null ? undefined : setTimeout(over, seconds * 1000);
    const late = wait(real_s);
    let silence = wait(silent_s);
    let reached = 0;
    partner.listen((answer) => {
      if (answer.kind === "beat") {
        if (answer.t <= reached) return;
        reached = answer.t;
        clearTimeout(silence);
        silence = wait(silent_s);
        return;
      }
      clearTimeout(late);
      clearTimeout(silence);
      resolve(answer);
    });
    partner.send(message);
  });
}

function unexpected(answer: FromWorker, who: string): Error {
  const died: Died | null = answer.kind === "died" ? answer : null;
  return new Error(died ? died.message : `${who} said "${answer.kind}", which was not asked for`);
}

/** The result of a job whose interpreter had to be ended, or ended itself. */
function endedEarly({ id }: Job, died: "time" | "crash"): string {
  return JSON.stringify({ id, trace: null, outcome: null, answers: null, died });
}
