/**
 * The one place that wires the rooms together: what the build knows, Python, and the elements.
 */
import { api, readyPrograms, worlds } from "virtual:bugbot";
import { startFigures } from "./figures/start.ts";
import { followContents } from "./page/contents.ts";
import { showHome } from "./page/home.ts";
import { type LessonData, readLessonData } from "./page/lesson-data.ts";
import { showLessonPage } from "./page/lesson-page.ts";
import { keepSoon, showOffline } from "./page/offline.ts";
import { Progress } from "./page/progress.ts";
import { ProgramStore } from "./page/storage.ts";
import { showThemeSwitch } from "./page/theme-switch.ts";
import { whenNear, whenWanted } from "./page/when-wanted.ts";
import type { Runtime } from "./runtime/client.ts";
import { part, tellMissing } from "./ui/part.ts";
import { printInLight } from "./ui/theme.ts";

for (const place of document.querySelectorAll<HTMLElement>(".theme-switch")) showThemeSwitch(place);

printInLight();

type World = (typeof worlds)[number];

const worldsInOrder = [...worlds].sort((a, b) => placeOf(a) - placeOf(b));
startFigures(document);

// Every page's header leads home, from whatever folder the site is in.
const header = document.querySelector<HTMLAnchorElement>(".site-header .name");
const home = header?.href ?? new URL(".", location.href).href;

const embedded = document.documentElement.dataset.embed !== undefined;
// The development server has no service worker, and what a frame keeps is kept for that frame only.
const keeps = import.meta.env.PROD && !embedded;
if (keeps) showOffline(home);
const framed = embedded ? part(() => import("./page/embedded.ts")) : null;
void framed?.then(({ openLinksOutside }) => openLinksOutside());

// In a learning platform (src/scorm) each learner's things are kept apart.
const { keptFor } = document.documentElement.dataset;
const store = new ProgramStore(undefined, keptFor);
const progress = new Progress(store);
progress.listen();
document.dispatchEvent(new CustomEvent("bugbot-progress", { detail: progress }));
showHome(worldsInOrder, progress);
if (document.querySelector("progress-tools")) {
  const { defineProgressTools } = await part(() => import("./page/progress-tools.ts"));
  defineProgressTools(progress);
}

const progressShown = document.querySelector<HTMLElement>(".lesson-head, progress-tools");
if (progressShown && progress.unread.length > 0) {
  const { showUnread } = await part(() => import("./page/progress-unread.ts"));
  showUnread(progressShown, progress);
}

followContents(document);
const lesson = readLessonData(document);
if (lesson) showLessonPage(document, lesson, progress);

const matPlace = document.querySelector<HTMLElement>(".mat-place");
if (matPlace) {
  const { showMatMaker } = await part(() => import("./page/mats/mat-maker.ts"));
  showMatMaker(matPlace, { store, worlds: worldsInOrder, labAddress: new URL("lab/", home).href });
}

// The editor is the largest part of the site: it comes when a lab is near, or the page is idle.
const places = [...document.querySelectorAll("bugbot-lab, bugbot-task")];
const begin = (): void => void startLabs().catch(tellMissing);
// Browsers hold up a frame that is out of sight, and the page around it may ask for a run all the same.
if (document.documentElement.dataset.embed === "host") begin();
else if (places.length > 0) whenNear(places, begin);
else if (keeps) whenWanted([], () => keepSoon(home));
// Whatever of the page has not come by now, site/src/early tells of.
document.dispatchEvent(new Event("bugbot-up"));

async function startLabs(): Promise<void> {
  const own = document.querySelector<HTMLElement>(".lab-page bugbot-lab");
  const parts = Promise.all([
    part(() => import("./page/lab.ts")),
    own ? part(() => import("./page/lab-page.ts")) : null,
    part(() => import("./page/try.ts")),
  ]);
  // Python may be on its way while the editor still is.
  const { Runtime } = await part(() => import("./runtime/client.ts"));
  const runtime = new Runtime(warmUp());
  // A small device starts Python for the first run, and not before.
  if (!runtime.isSmall) whenWanted(places, () => runtime.warm());
  // What the reader came for is fetched before anything is kept for later.
  if (keeps) whenReady(runtime, () => keepSoon(home));
  const [{ BugbotLab, defineLab }, labPage, { startTries }] = await parts;
  const labAddress = new URL("lab/", home).href;
  const all = [...worldsInOrder, ...(lesson?.worlds ?? [])];
  const frame = await framed;
  const prepared = own && frame ? await frame.prepareLab(own, worldsInOrder) : null;
  frame?.restOutOfSight(runtime);
  defineLab({ runtime, worlds: all, readyPrograms, calls: api, store, labAddress });
  if (lesson && document.querySelector("bugbot-task")) await startTasks(runtime, lesson);
  if (own instanceof BugbotLab) {
    if (frame && prepared) frame.connectLab(own, prepared, worldsInOrder);
    else labPage?.showLabPage(own, all, store);
  }
  startTries(document);
}

/** Once Python is up. */
function whenReady(runtime: Runtime, callback: () => void): void {
  const listener = (): void => {
    if (runtime.state !== "ready") return;
    runtime.removeEventListener("change", listener);
    callback();
  };
  runtime.addEventListener("change", listener);
}

async function startTasks(runtime: Runtime, lesson: LessonData): Promise<void> {
  const { defineTask } = await part(() => import("./page/task.ts"));
  defineTask({ runtime, progress, lesson });
}

/** Worlds come in the order of their programs: the order to meet them in. */
function placeOf(world: World): number {
  const at = readyPrograms.findIndex((program) => program.world === world.name);
  return at < 0 ? readyPrograms.length : at;
}

/** A real program to run out of sight, so that the first Run is a fast one. */
function warmUp(): { program: string; world: World } | null {
  const ready = readyPrograms[0];
  const world = worlds.find(({ name }) => name === ready?.world);
  return ready && world ? { program: ready.source, world } : null;
}
