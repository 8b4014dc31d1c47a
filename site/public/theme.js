// Sets the chosen colour theme before the first paint; src/ui/theme.ts is the rest of it.
// It also marks that scripts run, so that what they put in place of other things has its room at once.
// A file of its own because the site's security policy allows no scripts inside pages.
document.documentElement.dataset.scripts = "";
try {
  const theme = localStorage.getItem("bugbot:theme");
  if (theme === "light" || theme === "dark") document.documentElement.dataset.theme = theme;
} catch {
  // Storage is refused: the device's own theme it is.
}
