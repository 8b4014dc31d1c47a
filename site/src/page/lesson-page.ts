/**
 * A page of text with labs in it: its labs get their programs, and what has been done on
 * this device is shown. May import types of `trace`.
 */
import { courseWords } from "../ui/course-words.ts";
import type { LessonData } from "./lesson-data.ts";
import type { Progress } from "./progress.ts";

export function showLessonPage(page: Document, lesson: LessonData, progress: Progress): void {
  for (const lab of page.querySelectorAll("bugbot-lab[program-of]")) {
    const program = lesson.programs[lab.getAttribute("program-of") ?? ""];
    if (program) lab.setAttribute("program", program.source);
  }
  const tell = (): void => showProgress(page, lesson, progress);
  progress.addEventListener("change", tell);
  tell();
  // Who comes back to a task of this lesson is still at that task.
  if (progress.last?.lesson !== lesson.lesson) progress.visit(lesson.lesson);
}

/** Marks passed tasks in the contents and counts them at the top. */
function showProgress(page: Document, { lesson, tasks }: LessonData, progress: Progress): void {
  const names = Object.keys(tasks);
  for (const entry of page.querySelectorAll<HTMLElement>(".contents [data-task]")) {
    entry.dataset.state = progress.of(lesson, entry.dataset.task ?? "")?.state ?? "new";
  }
  const count = page.querySelector(".task-count");
  const { passed, of } = progress.count(lesson, names);
  if (count) count.textContent = courseWords.passed(passed, of);
}
