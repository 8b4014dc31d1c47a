/**
 * A lesson's page as a SCORM 1.2 object: it takes up the progress that the platform keeps, and
 * tells the platform what changes. A classic script of its own, in packages made by
 * `npm run lesson:scorm` only (site/build/scorm.mjs); it runs before the page's own.
 * May import `page/progress` (types).
 */
import type { Progress } from "../page/progress.ts";
import { Session } from "./scorm-api.ts";
import { type Lesson, recordIn, reportOf } from "./scorm-report.ts";

const session = Session.begin(window, Date.now());

if (session) {
  // Learners who share a device do not share what is kept on it.
  document.documentElement.dataset.keptFor = session.get("cmi.core.student_id") || "lms";
  document.addEventListener("bugbot-progress", (event) => {
    follow(session, (event as CustomEvent<Progress>).detail);
  });
  addEventListener("pagehide", () => session.finish(Date.now()));
  // A page that comes back as it was left has no session any more.
  addEventListener("pageshow", ({ persisted }) => {
    if (persisted) location.reload();
  });
}

function follow(session: Session, progress: Progress): void {
  const lesson = lessonHere();
  if (!lesson) return;
  const before = session.get("cmi.core.lesson_status");
  let readToEnd = false;
  const tell = (): void => {
    session.set(reportOf(lesson, recordIn(progress.export()), before, readToEnd));
  };
  const kept = session.get("cmi.suspend_data");
  // A text that is no progress of ours is left alone until there is something to tell.
  if (recordIn(kept).tasks.size > 0) progress.import(kept);
  progress.addEventListener("change", tell);
  whenRead(() => {
    readToEnd = true;
    tell();
  });
  tell();
}

function lessonHere(): Lesson | null {
  const data = document.querySelector("#lesson-data")?.textContent;
  return data ? (JSON.parse(data) as Lesson) : null;
}

/** Once the end of the text has been on the screen. */
function whenRead(callback: () => void): void {
  const end = document.querySelector(".prose > :last-child");
  if (!end) return;
  const observer = new IntersectionObserver((entries) => {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
    observer.disconnect();
    callback();
  });
  observer.observe(end);
}
