/** What the build knows and the page is given: made from py/bugbot and lessons/lab. */
declare module "virtual:bugbot" {
  import type { World } from "./trace/events.ts";

  export const worlds: World[];
  /** A program for a world that maps it, from lessons/lab/lab.json. */
  export const readyPrograms: { world: string; title: string; source: string }[];
  /** The robot's calls, from their docstrings. */
  export const api: { name: string; signature: string; summary: string; doc: string }[];
}
