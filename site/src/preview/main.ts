/**
 * The authors' page of a lesson, which only the development server has: wires what the server tells,
 * the marking, and the page together. May import `page`, `runtime`, `trace` and `ui`.
 */
import { render } from "lit";
import { showThemeSwitch } from "../page/theme-switch.ts";
import { readPreview } from "./data.ts";
import { Opened } from "./opened.ts";
import { pageFace } from "./page-face.ts";
import { PreviewServer } from "./server.ts";

for (const place of document.querySelectorAll<HTMLElement>(".theme-switch")) showThemeSwitch(place);

const server = new PreviewServer(readPreview(document));
const opened = new Opened();
const place = document.querySelector<HTMLElement>("main.preview");

const draw = (): void => {
  if (place) render(pageFace({ server, opened, redraw: draw }), place);
};
server.addEventListener("change", draw);
draw();
opened.scroll();
for (const { name } of server.tasks) if (opened.asked.has(name)) void server.mark(name);
