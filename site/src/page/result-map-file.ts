/**
 * The map of a mark's run as ROS map files. Fetched on use. May import `runtime` and `ui`.
 */
import type { Runtime } from "../runtime/client.ts";
import { CELL, type Result, type ResultMap } from "../runtime/results.ts";
import { type DrawnMap, saveRosMap } from "./ros-map.ts";
import { FileError } from "./text-file.ts";

/** Saves it; resolves to what to say of it, good or bad. */
export async function saveResultMap(
  runtime: Pick<Runtime, "convert">,
  { map, world, seed }: Result,
): Promise<string> {
  if (!map) throw new Error("a result without a map has none to save");
  try {
    return await saveRosMap(runtime, `${world.name}-seed-${seed}`, drawn(map));
  } catch (error) {
    if (!(error instanceof FileError)) throw error;
    return error.message;
  }
}

/** As the run drew it: what is wrong in it stays in it. */
function drawn(map: ResultMap): DrawnMap {
  return {
    cell_cm: map.cell_cm,
    free: middles(map, CELL.free + CELL.wrongFloor),
    occupied: middles(map, CELL.occupied + CELL.wrongWall),
  };
}

function middles({ across, cell_cm: side, cells }: ResultMap, letters: string): number[][] {
  return [...cells].flatMap((cell, i) =>
    letters.includes(cell)
      ? [[((i % across) + 0.5) * side, (Math.floor(i / across) + 0.5) * side]]
      : [],
  );
}
