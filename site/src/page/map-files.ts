/**
 * The part of a lab's menu that is about ROS maps: the one drawn, and one from a file. What does
 * the work is fetched on use. May import `runtime`, `trace`, `views` and `ui`.
 */
import type { Trace } from "../trace/trace.ts";
import { mapMenuWords } from "../ui/file-words.ts";
import { part } from "../ui/part.ts";
import { type LabDesk, placeOfRun } from "./lab-desk.ts";
import type { MenuGroup } from "./lab-menu.ts";
import { chooseFiles } from "./text-file.ts";

/** Ends of the names of files that a map consists of. */
const ENDS = /\.(ya?ml|p[bgpn]m|png|zip|bmp|jpe?g|gif|tiff?|webp)$|(^|\/)\.DS_Store$/i;
const ACCEPT = ".yaml,.yml,.pgm,.pbm,.ppm,.pnm,.png,.zip";

export function mapItems(desk: LabDesk, told: (act: () => Promise<void>) => Promise<void>) {
  let moment = momentOf(desk);
  const group: MenuGroup = {
    title: mapMenuWords.map,
    items: [
      {
        // Read when the menu is drawn; what it names is what is saved, though the run plays on.
        get label() {
          moment = momentOf(desk);
          return moment.label;
        },
        act: () => void told(() => save(desk, moment)),
      },
      {
        label: mapMenuWords.open,
        act: () =>
          void told(async () => {
            const files = await chooseFiles(ACCEPT);
            if (files.length > 0) await openMap(desk, files);
          }),
      },
      ...(desk.lab.backdrop ? [{ label: mapMenuWords.remove, act: () => remove(desk) }] : []),
    ],
  };
  return group;
}

/** Whether dropped files are meant as a map. */
export function areMap(files: readonly File[]): boolean {
  return files.length > 0 && files.every(({ name }) => ENDS.test(name));
}

/** Lays the map in these files on the mat; throws FileError. */
export async function openMap(desk: LabDesk, files: readonly File[]): Promise<void> {
  desk.say({ text: mapMenuWords.reading });
  const [{ readRosMap }, { backdropOf, reachOf }, { rosWords }] = await Promise.all([
    part(() => import("./ros-map.ts")),
    part(() => import("./ros-backdrop.ts")),
    part(() => import("../ui/ros-words.ts")),
  ]);
  const map = await readRosMap(desk.runtime, files);
  desk.lab.backdrop = backdropOf(map, () => remove(desk));
  const text = rosWords.opened(map.name, reachOf(map), map.doubts);
  desk.say({ text, action: { label: mapMenuWords.remove, act: () => remove(desk) } });
}

function remove(desk: LabDesk): void {
  desk.lab.backdrop = null;
  desk.say(null);
}

/** A moment of the run on show; `at` is null at its end [s]. */
interface Moment {
  trace: Trace;
  time: number;
  at: number | null;
  label: string;
}

function momentOf({ shown: { trace, time } }: LabDesk): Moment {
  const at = time < trace.duration ? time : null;
  const label = trace.end ? mapMenuWords.saveAt(at) : mapMenuWords.save;
  return { trace, time, at, label };
}

async function save(desk: LabDesk, { trace, time, at }: Moment): Promise<void> {
  const { drawnAt, saveRosMap } = await part(() => import("./ros-map.ts"));
  const { world, seed } = placeOfRun(desk);
  const map = drawnAt(trace, time);
  desk.say({ text: mapMenuWords.working });
  desk.say({ text: await saveRosMap(desk.runtime, `${world}-seed-${seed}`, map, at) });
}
