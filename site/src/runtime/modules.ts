/** Sees to it that what a source imports is in its interpreter before it is carried out. */
import type { Assets } from "./assets.ts";
import type { FromWorker } from "./messages.ts";
import type { Partner } from "./pool.ts";

export type Died = Extract<FromWorker, { kind: "died" }>;
type Imports = Extract<FromWorker, { kind: "imports" }>;

/** Downloads of modules that not every interpreter has. */
export type ModuleFiles = Pick<Assets, "stdlib" | "numpy" | "judging">;

/**
 * Resolves to null when the modules are there, and to the interpreter's last message if it died.
 * `note` hears what there is to wait for, in words; `given` names what is there, though not yet imported.
 */
export async function provideModules(
  partner: Partner,
  source: string,
  files: ModuleFiles,
  note: (text: string) => void,
  given: readonly string[] = [],
): Promise<Died | null> {
  const answer = await inspect(partner, source);
  if (answer.kind === "died") return answer;
  const { hasStdlib } = answer;
  const missing = answer.missing.filter((name) => !given.includes(name));
  if (missing.length === 0) return null;
  if (!hasStdlib) {
    note("Loading Python's standard library");
    partner.send({ kind: "stdlib", bytes: await files.stdlib() });
  }
  if (missing.includes("numpy")) {
    const bytes = await files.numpy(note);
    note("Starting NumPy");
    partner.send({ kind: "package", name: "numpy", bytes });
  }
  // It answers in order: when it has answered this, it has unpacked those.
  const unpacked = await inspect(partner, "");
  return unpacked.kind === "died" ? unpacked : null;
}

function inspect(partner: Partner, source: string): Promise<Imports | Died> {
  return new Promise((resolve) => {
    partner.listen((message) => {
      if (message.kind === "imports" || message.kind === "died") resolve(message);
    });
    partner.send({ kind: "inspect", id: 0, program: source });
  });
}
