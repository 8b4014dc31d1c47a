/**
 * Asks the development server for marks and mutants, one asking at a time for each task, and knows how
 * far they are. Dispatches "change". Imports the data.
 */
import type { FailedRun, LessonPreview, Mutants, TaskPreview, Told } from "./data.ts";

/** What is under way for a task. */
export interface Work {
  done: number;
  /** 0 as long as nobody knows. */
  of: number;
  /** Files still to be marked. */
  waiting: ReadonlySet<string>;
}

interface Line {
  file?: string;
  told?: Told;
  key?: string;
  trouble?: string;
  mutants?: Mutants;
  done?: number;
  of?: number;
}

export class PreviewServer extends EventTarget {
  readonly lesson: LessonPreview;
  readonly #tasks: Map<string, TaskPreview>;
  readonly #work = new Map<string, { work: Work; stop: AbortController }>();
  readonly #troubles = new Map<string, string>();
  readonly #runs = new Map<string, Promise<FailedRun | null>>();

  constructor(lesson: LessonPreview) {
    super();
    this.lesson = lesson;
    this.#tasks = new Map(lesson.tasks.map((task) => [task.name, task]));
  }

  /** In the order of the lesson. */
  get tasks(): readonly TaskPreview[] {
    return [...this.#tasks.values()];
  }

  /** What is under way: "marks" or "mutants" of a task. */
  work(task: string, what: "marks" | "mutants"): Work | null {
    return this.#work.get(`${what} ${task}`)?.work ?? null;
  }

  /** What went wrong with a task's "marks" or "mutants", or with one of its files. */
  trouble(task: string, what: string): string | null {
    return this.#troubles.get(`${what} ${task}`) ?? null;
  }

  /** Marks these files of a task, or all of it that is not marked yet. */
  async mark(name: string, files?: readonly string[]): Promise<void> {
    const task = this.#tasks.get(name);
    const wanted = files ?? task?.files.filter(({ told }) => !told).map(({ file }) => file) ?? [];
    if (!task || wanted.length === 0) return;
    const waiting = new Set(wanted);
    const work = { done: 0, of: wanted.length, waiting };
    await this.#ask(name, "marks", work, JSON.stringify(wanted), (line) => {
      const file = line.file ?? "";
      waiting.delete(file);
      work.done = work.of - waiting.size;
      if (line.told && line.key) this.#marked(name, file, line.told, line.key);
      if (line.trouble) this.#troubles.set(`${file} ${name}`, line.trouble);
    });
  }

  /** Tries the small changes of a task's solution. */
  async tryMutants(name: string): Promise<void> {
    const work = { done: 0, of: 0, waiting: new Set<string>() };
    await this.#ask(name, "mutants", work, "", ({ done, of, mutants }) => {
      if (done !== undefined && of !== undefined) Object.assign(work, { done, of });
      const task = this.#tasks.get(name);
      if (task && mutants) this.#tasks.set(name, { ...task, mutants });
    });
  }

  cancel(task: string, what: "marks" | "mutants"): void {
    this.#work.get(`${what} ${task}`)?.stop.abort();
  }

  /** The run in which the check failed that a mark tells of; fetched once. */
  run(key: string): Promise<FailedRun | null> {
    const known = this.#runs.get(key);
    if (known) return known;
    const run = fetch(`run?key=${key}`).then((response) =>
      response.ok ? (response.json() as Promise<FailedRun | null>) : null,
    );
    this.#runs.set(key, run);
    return run;
  }

  #marked(name: string, file: string, told: Told, key: string): void {
    const task = this.#tasks.get(name);
    if (!task) return;
    const files = task.files.map((each) => (each.file === file ? { ...each, told, key } : each));
    this.#tasks.set(name, { ...task, files });
  }

  async #ask(
    name: string,
    what: "marks" | "mutants",
    work: Work,
    body: string,
    hear: (line: Line) => void,
  ): Promise<void> {
    const id = `${what} ${name}`;
    if (this.#work.has(id)) return;
    const stop = new AbortController();
    this.#work.set(id, { work, stop });
    this.#troubles.delete(id);
    this.#changed();
    try {
      const address = `${what}?task=${encodeURIComponent(name)}`;
      const response = await fetch(address, { method: "POST", body, signal: stop.signal });
      if (!response.ok || !response.body) throw new Error(await response.text());
      for await (const line of linesOf(response.body)) {
        const said = JSON.parse(line) as Line;
        if (said.trouble && said.file === undefined) throw new Error(said.trouble);
        hear(said);
        this.#changed();
      }
    } catch (error) {
      if (!stop.signal.aborted) this.#troubles.set(id, String(error));
    } finally {
      this.#work.delete(id);
      this.#changed();
    }
  }

  #changed(): void {
    this.dispatchEvent(new Event("change"));
  }
}

async function* linesOf(body: ReadableStream<Uint8Array<ArrayBuffer>>): AsyncGenerator<string> {
  const reader = body.pipeThrough(new TextDecoderStream()).getReader();
  let rest = "";
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    const lines = (rest + part.value).split("\n");
    rest = lines.pop() ?? "";
    yield* lines;
  }
  if (rest) yield rest;
}
