/** All ways out, kind by kind. */
import { BYTECODE_AND_LOADERS, CODE_OF_ONES_OWN } from "./code.mjs";
import { PYODIDES_OWN_CLASSES, WHAT_IS_HELD_BY_WHOM } from "./held.mjs";
import { IMPORTS } from "./imports.mjs";
import { WHAT_OUTLIVES_A_RUN } from "./lasting.mjs";
import { LIVING_OBJECTS } from "./living.mjs";
import { FILES_THAT_ARE_NONE, THE_MACHINE } from "./machine.mjs";
import { INTERPRETERS_MEMORY } from "./memory.mjs";
import { MESSAGES, RUNNING_OUT_IN_THE_MIDDLE } from "./messages.mjs";
import { NETWORK, PYTHONS_LIBRARY } from "./network.mjs";
import { PLANTING_IN_JAVASCRIPTS_OWN_OBJECTS } from "./planting.mjs";
import { PYODIDES_OWN_MODULES } from "./pyodide.mjs";
import { FUNCTIONS_REVIVED } from "./revived.mjs";
import { WHAT_A_PAGE_SHOWS } from "./shown.mjs";

/** @type {import("./tools.mjs").Kind[]} */
export const KINDS = [
  IMPORTS,
  PYODIDES_OWN_MODULES,
  LIVING_OBJECTS,
  WHAT_IS_HELD_BY_WHOM,
  PYODIDES_OWN_CLASSES,
  PLANTING_IN_JAVASCRIPTS_OWN_OBJECTS,
  CODE_OF_ONES_OWN,
  BYTECODE_AND_LOADERS,
  INTERPRETERS_MEMORY,
  FUNCTIONS_REVIVED,
  NETWORK,
  PYTHONS_LIBRARY,
  THE_MACHINE,
  FILES_THAT_ARE_NONE,
  MESSAGES,
  WHAT_OUTLIVES_A_RUN,
  WHAT_A_PAGE_SHOWS,
  RUNNING_OUT_IN_THE_MIDDLE,
];
