/**
 * A run, its chart and its picture as files, and a saved run on show again.
 * May import `trace`, `views` and `ui`.
 */
import { writeTraceFile } from "../trace/file.ts";
import type { Trace } from "../trace/trace.ts";
import { fileWords, menuWords } from "../ui/file-words.ts";
import type { ChartView } from "../views/chart.ts";
import type { OverheadView } from "../views/overhead/overhead.ts";
import { type LabDesk, placeOfRun } from "./lab-desk.ts";
import type { MenuItem } from "./lab-menu.ts";
import { saveFile } from "./text-file.ts";

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
