/**
 * The first script of every page, written into the page itself (site/build/early.mjs), so that it is
 * there whatever else fails to load. It sets the theme before the first paint, and sees to what does
 * not arrive: each part is tried once more, and then the reader is told. May import
 * `offline/drop`, to be rid of a damaged copy, and the messages of `embed`.
 */
import { COMING } from "../embed/messages.ts";
import { Arrivals } from "./arrivals.ts";

const { dataset } = document.documentElement;
// Scripts run: what they put in place of other things has its room at once.
dataset.scripts = "";
// A page in a frame of another site has neither header nor footer, and its theme is the frame's.
const query = new URLSearchParams(location.search);
const embed = query.get("embed");
if (embed !== null) dataset.embed = embed;
if (embed === "host") parent.postMessage(COMING, "*");
try {
  const theme = embed === null ? localStorage.getItem("bugbot:theme") : query.get("theme");
  if (theme === "light" || theme === "dark") dataset.theme = theme;
} catch {
  // Storage is refused: the device's own theme it is.
}
new Arrivals(document).watch();
