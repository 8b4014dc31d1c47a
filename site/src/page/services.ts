/**
 * What every lab of a page shares. `main.ts` puts it together and hands it to `defineLab`.
 */
import type { Call } from "../editor/calls.ts";
import type { Runtime } from "../runtime/client.ts";
import type { World } from "../trace/events.ts";
import type { ProgramStore } from "./storage.ts";

export interface Services {
  runtime: Runtime;
  /** In the order they are offered; the first is the one a lab has if it names none. */
  worlds: readonly World[];
  /** Programs that map a world, for labs that bring none of their own. */
  readyPrograms: readonly { world: string; title: string; source: string }[];
  calls: readonly Call[];
  store: ProgramStore;
  /** Address of the lab's own page, for links. */
  labAddress: string;
}
