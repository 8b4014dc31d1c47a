/**
 * A lesson's page as a SCORM 1.2 object: it takes up the progress that the platform keeps, and
 * tells the platform what changes. A classic script of its own, in packages made by
 * `npm run lesson:scorm` only (site/build/scorm.mjs); it runs before the page's own.
 * May import `page/progress` (types).
 */
import type { Progress } from "../page/progress.ts";
import { type ProgressRecord, readAll, writeProgress } from "../page/progress-record.ts";
import { Session } from "./scorm-api.ts";
import { readSuspended } from "./scorm-data.ts";
import { type Lesson, reportOf } from "./scorm-report.ts";

const FOREIGN =
  "Your learning platform holds progress of this lesson that this version can’t read. It stays as it is, so what you do now is not kept there: save it as a file if you need it.";

const session = Session.begin(window, Date.now());

if (session) {
  // Learners who share a device do not share what is kept on it. One who is not named has nothing kept.
  document.documentElement.dataset.keptFor = session.get("cmi.core.student_id");
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
  const kept = readSuspended(session.get("cmi.suspend_data"));
  if (kept === "foreign") sayForeign();
  else if (kept !== "nothing" && kept.record.tasks.size > 0) {
    progress.import(writeProgress(kept.record));
  }
  let readToEnd = false;
  const tell = (): void => {
    const record: ProgressRecord = readAll(progress.export()).record;
    session.set(reportOf(lesson, record, before, readToEnd, kept !== "foreign"));
  };
  progress.addEventListener("change", tell);
  whenRead(() => {
    readToEnd = true;
    tell();
  });
  tell();
}

/** The platform's own record is not ours to write over. */
function sayForeign(): void {
  const notice = document.createElement("p");
  notice.className = "notice";
  notice.setAttribute("role", "status");
  notice.textContent = FOREIGN;
  document.querySelector(".lesson-head")?.append(notice);
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
