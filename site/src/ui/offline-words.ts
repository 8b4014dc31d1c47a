/** Words about using the site without a network. Imports nothing of ours. */

export const offlineWords = {
  open: "Use offline",
  title: "Use offline",
  ready: "Ready: this site works on this device without a network.",
  readyToo: "The pages, the lab and Python are here.",
  keeping: (have: string, of: string): string => `${have} of ${of} MB are here.`,
  begin: (mb: string): string =>
    `Not kept yet. What is kept on this device works without a network. Most of it is Python: ${mb} MB.`,
  partly: "Not all of it is here yet.",
  keep: "Keep it on this device",
  goOn: "Fetch the rest",
  numpyHere: "NumPy is here as well.",
  numpyNot: (mb: string): string =>
    `NumPy (${mb} MB) comes along when a program first imports it with the network there.`,
  numpyKeep: "Keep NumPy too",
  size: (mb: string): string => `On this device: ${mb} MB.`,
  promised: "The browser has promised not to clear it by itself.",
  mayClear: "The browser may clear it when the device runs short of space.",
  ask: "Ask the browser not to",
  refused: "The browser makes no promise yet. It may after some more visits.",
  untouched: "Your programs and your progress are kept apart from this; removing it leaves them.",
  remove: "Remove from this device",
  removed: "Removed. It is not kept again unless you ask for it here.",
  noRoom:
    "This device has no room for it. With a network the site works all the same; free some space and try again.",
  problem: (what: string): string => `That did not work: ${what}.`,
  insecure:
    "Browsers keep sites for offline use only if their address begins with https (or is this very computer's). This one's does not.",
  unable: "This browser does not keep sites for offline use, at least not in a private window.",
  newVersion: "A new version of this site is ready.",
  useNow: "Use it now",
  later: "Later",
};
