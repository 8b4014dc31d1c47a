/** The words for what is kept of a learner's progress; `strings.ts` has the rest and the voice. */
import { counted } from "./counted.ts";

export const progressWords = {
  region: "Your progress",
  save: "Save progress as a file",
  open: "Open a file of progress…",
  clear: "Clear progress",
  undo: "Undo",
  fileName: "bugbot-progress.json",
  saved: "The file has been handed to the browser to save.",
  opened: (added: number) =>
    added === 0
      ? "Everything in the file was here already."
      : `The file is in: ${counted(added, "task")} further than before. Nothing that was here is lost.`,
  cleared: "The progress kept on this device is gone. Your programs are still here.",
  back: "Your progress is back.",
  notKept:
    "This browser does not let the site keep your progress, so it lasts until you leave. Save it as a file to keep it.",
  notFile: (name: string, why: string) => `${name} was not opened: ${why}`,
  tooMany: (most: number) =>
    `together with what is here that would be more than ${counted(most, "task")}. Nothing has changed.`,
  unread: {
    newer:
      "This device has progress from a newer version of this site. It stays as it is; what you do now is kept beside it. Reload the page to get the newer version.",
    damaged:
      "The progress on this device was damaged. What could be read is here, and the damaged record has been put aside.",
  },
  saveUnread: "Save it as a file",
  forgetUnread: "Delete it",
  unreadFile: "bugbot-progress-as-found.json",
  tooLarge: "it is too large to be a file of progress.",
  noText: "it does not hold text.",
  unreadable: {
    "no progress": "it is not a file of progress saved from this site.",
    newer: "it was saved by a newer version of this site. Reload the page and try again.",
    damaged: "it is damaged, and nothing of it was used.",
  },
};
