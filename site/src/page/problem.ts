/**
 * What went wrong in the learner's program: plain words first, Python's own one click away.
 * May import `trace` and `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import type { Fault } from "../trace/events.ts";
import { problemWords } from "../ui/strings.ts";

export function problem(fault: Fault | null): TemplateResult {
  if (!fault) return html``;
  return html`<section class="lab-problem" aria-label=${problemWords.region}>
    <p class="message">${fault.message}</p>
    ${fault.hint ? html`<p><b>${problemWords.cause}</b> ${fault.hint}</p>` : nothing}
    <details>
      <summary>${problemWords.details(fault.type)}</summary>
      <pre tabindex="0">${fault.traceback}</pre>
    </details>
  </section>`;
}
