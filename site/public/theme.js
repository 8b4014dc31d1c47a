// Sets the chosen colour theme before the first paint; src/ui/theme.ts is the rest of it.
// It also marks that scripts run, so that what they put in place of other things has its room at once.
// A page in a frame of another site (?embed) has neither header nor footer, and its theme is the frame's.
// A file of its own because the site's security policy allows no scripts inside pages.
const { dataset } = document.documentElement;
dataset.scripts = "";
const query = new URLSearchParams(location.search);
const embed = query.get("embed");
if (embed !== null) dataset.embed = embed;
try {
  const theme = embed === null ? localStorage.getItem("bugbot:theme") : query.get("theme");
  if (theme === "light" || theme === "dark") dataset.theme = theme;
} catch {
  // Storage is refused: the device's own theme it is.
}
