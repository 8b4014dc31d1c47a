/**
 * A run, its chart and its picture as files, and a saved run on show again.
 * May import `runtime`, `trace`, `views` and `ui`.
 */
import type { Runtime } from "../runtime/client.ts";
import type { World } from "../trace/events.ts";
import { writeTraceFile } from "../trace/file.ts";
import type { Trace } from "../trace/trace.ts";
import { fileWords, menuWords } from "../ui/file-words.ts";
import type { ChartView } from "../views/chart.ts";
import type { Backdrop } from "../views/overhead/backdrop.ts";
import type { OverheadView } from "../views/overhead/overhead.ts";
import type { Place } from "./address.ts";
import type { MenuItem } from "./lab-menu.ts";
import type { LabProgram } from "./lab-program.ts";
import type { Note } from "./status.ts";
import { saveFile } from "./text-file.ts";

/** What files and links ask of the lab. */
export interface LabDesk {
  /** The element, with its world, seed and title as they are now. */
  readonly lab: HTMLElement & Place & { label: string; backdrop: Backdrop | null };
  readonly program: LabProgram;
  readonly worlds: readonly World[];
  /** Address of the lab's own page. */
  readonly labAddress: string;
  /** The run on show; null before the first. */
  run(): Trace | null;
  /** The run and the moment on the mat, a guest's too. */
  readonly shown: { trace: Trace; time: number };
  readonly runtime: Pick<Runtime, "convert">;
  /** Shows a run made before, on its world. */
  show(run: Trace): Promise<void>;
  say(note: Note | null): void;
}

/** The part of the menu that is about the run on show. */
export function runItems(desk: LabDesk, onOpen: () => void): MenuItem[] {
  const run = desk.run();
  const complete = run?.complete === true;
  return [
    { label: menuWords.saveRun, disabled: !complete, act: () => saveRun(desk) },
    { label: menuWords.openRun, act: onOpen },
    { label: menuWords.chart, disabled: !run?.series.size, act: () => saveChart(desk) },
    { label: menuWords.picture, act: () => savePicture(desk) },
    { label: menuWords.print, act: () => print() },
  ];
}

/** Shows a saved run, and says which it is; its program can be had. */
export async function showRun(desk: LabDesk, run: Trace): Promise<void> {
  await desk.show(run);
  const { world, seed, program: ran } = run.header;
  const take = (): void => {
    desk.program.replace(ran);
    desk.program.shows(ran);
  };
  desk.say({
    text: fileWords.run(world.title, seed),
    ...(ran === desk.program.text ? {} : { action: { label: fileWords.takeProgram, act: take } }),
  });
}

/** The place of the run on show, or before the first what it would be. */
export function placeOfRun({ lab, run }: LabDesk): Place {
  const header = run()?.header;
  return header
    ? { world: header.world.name, seed: header.seed }
    : { world: lab.world, seed: lab.seed };
}

/** A world of a saved run may be none of this site's: it goes by its name. */
export function titleOf({ worlds }: LabDesk, name: string): string {
  return worlds.find((world) => world.name === name)?.title ?? name;
}

function saveRun(desk: LabDesk): void {
  const run = desk.run();
  if (run) saveFile(`${nameOf(desk)}.trace`, writeTraceFile(run), "application/x-ndjson");
}

function saveChart(desk: LabDesk): void {
  const chart = view<ChartView>(desk, "chart-view");
  saveFile(`${nameOf(desk)}.csv`, chart.toCsv(), "text/csv");
}

async function savePicture(desk: LabDesk): Promise<void> {
  const overhead = view<OverheadView>(desk, "overhead-view");
  saveFile(`${nameOf(desk)}.png`, await overhead.toPng());
}

function nameOf(desk: LabDesk): string {
  const { world, seed } = placeOfRun(desk);
  return `${world}-seed-${seed}`;
}

function view<View extends HTMLElement>({ lab }: LabDesk, name: string): View {
  const found = lab.querySelector<View>(name);
  if (!found) throw new Error(`<bugbot-lab> was drawn without a ${name}`);
  return found;
}
