/** What the main pages look like in an engine, in both themes, for somebody to look at. */
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Lab } from "./lab.mjs";

const PAGES = {
  home: "",
  lab: "lab/?world=doorway",
  article: "occupancy-grid-mapping/",
  demo: "occupancy-grid-mapping/#lab-demo-1",
  task: "lessons/u8-1-a-map-of-cells/#task-cell-of-a-point",
};
const THEMES = ["Light", "Dark"];

/**
 * @param {import("./tab.mjs").Tab} tab
 * @param {string} folder
 * @param {string} engine
 */
export async function takePictures(tab, folder, engine) {
  mkdirSync(folder, { recursive: true });
  for (const [page, path] of Object.entries(PAGES)) {
    await tab.open(path);
    if (page === "lab") {
      const lab = new Lab(tab);
      await tab.choose(lab.its("combobox", "Speed"), "to the end");
      await lab.run();
      await lab.status(/^Finished/);
    }
    if (page === "demo" || page === "task") await tab.see({ role: "textbox", name: "Program" });
    for (const theme of THEMES) {
      await tab.choose({ role: "combobox", name: "Colours" }, theme);
      const file = join(folder, `${engine}-${page}-${theme.toLowerCase()}.png`);
      writeFileSync(file, await tab.picture());
    }
  }
}
