/** What is said when a part of a page does not arrive. Imports nothing of ours. */

export const earlyWords = {
  part: "Part of this page didn’t load, so some of it doesn’t work.",
  cut: "This page broke off before its end, so some of it is missing.",
  slow: "Part of this page is taking long to load.",
  offline: "This device seems to have no network.",
  gone: "The site may have been updated since you opened the page.",
  status: (name: string, status: number) => `The server answered ${name} with status ${status}.`,
  type: (name: string, type: string, wanted: string) =>
    `The server sends ${name} as ${type || "nothing it names"}, not as ${wanted}. Whoever looks after the site can put that right.`,
  file: "The page was opened as a file, and browsers run no programs there. It needs a web server.",
  remedy: "Reload to try again.",
  kept: "What you have written here is kept.",
  reload: "Reload",
  without: "Reload without the offline copy",
  close: "Close",
};
