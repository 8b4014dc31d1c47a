/**
 * What a lab says of a program that was kept, and of one on paper; `strings.ts` has the rest and the
 * voice. Imports nothing of ours.
 */
export const starterWords = {
  changed: "This page’s program has changed since you started yours.",
  see: "See the new one",
  title: "The new program of this page",
  lead: "Yours is still here, as you left it. If you take the new one, yours goes into the earlier versions.",
  take: "Take the new one",
  keep: "Keep mine",
  taken: "This is the new program of this page.",
};

export const tabWords = {
  changed: "This program has been changed in another tab.",
  show: "Show that one",
  shown: "This is the program from the other tab.",
};

export const printWords = {
  heading: (lab: string, world: string, seed: number) =>
    `${lab ? `${lab}: ` : ""}${world}, seed ${seed}`,
};
