/**
 * What the home page draws itself: the worlds to choose from, and what this device knows of the
 * reader's way through the lessons. Everything else is in its HTML. May import `trace` and `ui`.
 */
import { html, render } from "lit";
import type { World } from "../trace/events.ts";
import { courseWords } from "../ui/course-words.ts";
import { writeAddress } from "./address.ts";
import type { Progress } from "./progress.ts";
import { worldPicture } from "./world-picture.ts";

export function showHome(worlds: readonly World[], progress: Progress): void {
  const list = document.getElementById("worlds");
  const course = document.getElementById("lessons");
  if (!list || !course) return;
  const cards = worlds.map(
    (world) => html`<li>
      <a href=${`./lab/${writeAddress({ world: world.name, seed: 1 })}`}>
        ${worldPicture(world)}
        <b>${world.title}</b>
        <span>${world.description}</span>
      </a>
    </li>`,
  );
  render(cards, list);
  const tell = (): void => showProgress(course, progress);
  progress.addEventListener("change", tell);
  tell();
}

/** How much of each lesson is done, and the way back to where the reader was. */
function showProgress(course: HTMLElement, progress: Progress): void {
  for (const item of course.querySelectorAll<HTMLElement>("[data-lesson]")) {
    const { lesson = "", tasks = "[]" } = item.dataset;
    const { passed, tried, of } = progress.count(lesson, JSON.parse(tasks) as string[]);
    const done = item.querySelector(".done");
    const begun = passed + tried > 0;
    if (done) done.textContent = begun ? courseWords.done(passed, of) : "";
    item.dataset.state = begun ? (passed === of ? "passed" : "tried") : "new";
  }
  showWayBack(course, progress);
}

function showWayBack(course: HTMLElement, { last }: Progress): void {
  const link = document.querySelector<HTMLAnchorElement>("a.go-on");
  const first = document.querySelector<HTMLElement>("a.begin");
  const item =
    last && course.querySelector<HTMLElement>(`[data-lesson="${CSS.escape(last.lesson)}"]`);
  const there = item?.querySelector("a");
  if (!link || !first) return;
  // In the same place: nothing moves when one takes it from the other.
  link.hidden = !there;
  first.hidden = Boolean(there);
  if (!there) return;
  link.href = there.href + (last?.task ? `#task-${last.task}` : "");
  link.textContent = courseWords.goOn(there.textContent);
}
