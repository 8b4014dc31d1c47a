import { randomBytes } from "node:crypto";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { budget } from "../../site/build/budget.mjs";
import { write } from "../../site/build/files.mjs";

test("what a page names is weighed as it is sent, each file once", () => {
  const folder = test.info().outputPath("site");
  const script = randomBytes(3000).toString("base64");
  write(
    join(folder, "index.html"),
    '<script src="./assets/a.js"></script><link href="./assets/a.js">',
  );
  write(join(folder, "lab/index.html"), '<script src="../assets/a.js"></script>');
  write(join(folder, "assets/a.js"), script);
  write(join(folder, "python/interpreter-1.bin"), randomBytes(5000));
  write(join(folder, "python/numpy-1.bin"), randomBytes(700));
  const rows = new Map(budget(folder).map(({ what, bytes }) => [what.replace(/ \(.*/, ""), bytes]));
  // Base64 holds 6 bits a byte, and gzip finds that out.
  expect(rows.get("script and style before a lab")).toBeGreaterThan(3000);
  expect(rows.get("script and style before a lab")).toBeLessThan(3200);
  expect(rows.get("Python up to the first output")).toBe(5000);
  expect(rows.get("NumPy")).toBe(700);
});
