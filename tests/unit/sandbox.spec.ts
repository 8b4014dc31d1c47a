/**
 * The locked-down Python under Node lets nothing out, even without the fences that Python has itself. The
 * other ways are tried there by `npm run test:engines -- --ways`.
 */
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";
import { options } from "../../site/build/sandbox.mjs";
import { THE_MACHINE } from "../ways/machine.mjs";
import { sandboxForWays } from "../ways/node.mjs";
import { PYODIDES_OWN_MODULES } from "../ways/pyodide.mjs";
import { faultsOf, tryWays } from "../ways/runs.mjs";

test("no way out of the locked-down Python is open", async () => {
  test.setTimeout(180_000);
  const secret = join(mkdtempSync(join(tmpdir(), "secret-")), "secret.txt");
  const written = `${secret}.written`;
  writeFileSync(secret, "the teacher's password");
  const sandbox = await sandboxForWays({ PATH_OF_TEST: "1" });
  const [read, write] = [JSON.stringify(secret), JSON.stringify(written)];
  const ways = [
    ...PYODIDES_OWN_MODULES.ways,
    ...THE_MACHINE.ways,
    { name: "a file of the host", program: `print("OPEN", open(${read}).read())` },
    { name: "writing on the host", program: `open(${write}, "w").write("x")` },
    {
      name: "the host's users",
      program: `print("OPEN" if "root" in open("/etc/passwd").read() else "")`,
    },
    {
      name: "the judge and the reference",
      program: `import sys
from importlib.util import find_spec
for name in ("grader", "mapping", "bridge.judging", "bridge.ros"):
    if name in sys.modules or find_spec(name): print("OPEN", name)`,
    },
    {
      name: "the host's environment",
      program: `import os\nprint("OPEN" if "PATH_OF_TEST" in str(os.environ) else os.environ)`,
    },
    {
      name: "mounting the host's files",
      program: `import pyodide_js\npyodide_js.mountNodeFS("/mnt", "/")\nprint("OPEN")`,
    },
  ];
  try {
    const said = await tryWays(ways, 1, sandbox.run);
    expect(said.size).toBe(ways.length);
    expect(faultsOf(said)).toEqual([]);
    expect(existsSync(written)).toBe(false);
  } finally {
    sandbox.remove();
  }
});

test("and were JavaScript to run there, Node would refuse files, processes, threads and the network", async () => {
  const server = createServer((_request, response) => response.end("reached"));
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  const { port } = server.address() as AddressInfo;
  const fences = new URL("../../site/sandbox/node-fences.mjs", import.meta.url);
  const folder = join(ROOT, "site/sandbox");
  const script = `
import { closeGlobals, closeNetwork } from ${JSON.stringify(String(fences))};
import { writeSync } from "node:fs";
const said = {};
closeNetwork();
closeGlobals(() => {});
const roads = {
  file: async () => (await import("node:fs")).readFileSync(${JSON.stringify(join(ROOT, "package.json"))}),
  folder: async () => (await import("node:fs")).readdirSync("/"),
  write: async () => (await import("node:fs")).writeFileSync("/tmp/sandbox-was-here", ""),
  spawn: async () => (await import("node:child_process")).spawnSync("ls"),
  thread: async () => new (await import("node:worker_threads")).Worker("1", { eval: true }),
  connect: async () => (await import("node:net")).connect(${port}, "127.0.0.1"),
  socket: async () => new (await import("node:net")).Socket().connect(${port}, "127.0.0.1"),
  listen: async () => new (await import("node:net")).Server().listen(0),
  http: async () => (await import("node:http")).get("http://127.0.0.1:${port}/"),
  datagram: async () => (await import("node:dgram")).createSocket("udp4"),
  name: async () => (await import("node:dns")).lookup("localhost", () => {}),
  names: async () => (await import("node:dns/promises")).resolve("localhost"),
  fetch: async () => fetch("http://127.0.0.1:${port}/"),
  process: async () => process.env,
  binding: async () => (await import("node:process")).default.binding("tcp_wrap"),
  text: async () => new Function("return 1")(),
};
for (const [name, road] of Object.entries(roads)) {
  try {
    await road();
    said[name] = "OPEN";
  } catch (error) {
    said[name] = error.code ?? error.message;
  }
}
writeSync(1, JSON.stringify(said));
`;
  const done = spawnSync(
    process.execPath,
    [...options(folder), "--input-type=module", "-e", script],
    { encoding: "utf8", timeout: 30_000 },
  );
  server.close();
  const said = JSON.parse(done.stdout || "{}") as Record<string, string>;
  expect(Object.keys(said).length, done.stderr).toBe(16);
  expect(Object.entries(said).filter(([, text]) => text === "OPEN")).toEqual([]);
  expect(existsSync("/tmp/sandbox-was-here")).toBe(false);
});
