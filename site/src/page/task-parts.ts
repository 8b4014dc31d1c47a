/**
 * The page's own nodes of a task: statement and hints are in its HTML already, for readers without
 * scripts, and are moved to where they belong. Imports nothing of ours.
 */

export interface TaskParts {
  title: Element;
  statement: Element;
  hints: readonly Element[];
}

/** Takes them out of the element, which is empty afterwards. */
export function takeOver(task: HTMLElement): TaskParts {
  const part = (selector: string): Element => {
    const found = task.querySelector(selector);
    if (found) return found;
    throw new Error(`<bugbot-task name="${task.getAttribute("name")}"> has no ${selector} in it`);
  };
  const title = part("h2, h3, h4");
  title.id ||= `${task.id}-title`;
  const hints = [...task.querySelectorAll("details.task-hint")].map((details) => {
    details.querySelector("summary")?.remove();
    const hint = document.createElement("div");
    hint.className = "hint-text";
    hint.append(...details.childNodes);
    return hint;
  });
  const parts = { title, statement: part(".task-statement"), hints };
  task.replaceChildren();
  return parts;
}
