/**
 * Help with the robot's calls: completion while typing, and their docstrings on hover.
 * May import `calls`.
 */
import type { Completion, CompletionContext, CompletionResult } from "@codemirror/autocomplete";
import { pythonLanguage } from "@codemirror/lang-python";
import { syntaxTree } from "@codemirror/language";
import type { Extension } from "@codemirror/state";
import { hoverTooltip } from "@codemirror/view";
import { type Call, robotCall, robotNames } from "./calls.ts";

export function robotCalls(calls: readonly Call[]): Extension {
  const byName = new Map(calls.map((call) => [call.name, call]));
  const options = calls.map(completion);
  return [
    pythonLanguage.data.of({
      autocomplete: (context: CompletionContext) => complete(context, options),
    }),
    hoverTooltip((view, at) => {
      const node = syntaxTree(view.state).resolveInner(at, 0);
      const call = robotCall(node, view.state.doc.toString(), byName);
      if (!call) return null;
      return {
        pos: node.from,
        end: node.to,
        above: true,
        create: () => ({ dom: help(call, call.doc) }),
      };
    }),
  ];
}

function completion(call: Call): Completion {
  return {
    label: call.name,
    type: "function",
    detail: call.signature.slice(call.name.length),
    info: () => help(call, call.summary),
    boost: 2,
  };
}

function complete(context: CompletionContext, options: Completion[]): CompletionResult | null {
  const node = syntaxTree(context.state).resolveInner(context.pos, -1);
  if (/String|Comment|Format/.test(node.name)) return null;
  const word = context.matchBefore(/\w*/);
  if (!word) return null;
  const before = context.state.sliceDoc(Math.max(0, word.from - 60), word.from);
  const owner = /(\w+)\.$/.exec(before)?.[1];
  if (before.endsWith(".")) {
    if (!owner || !robotNames(context.state.doc.toString()).has(owner)) return null;
  } else if (word.from === word.to && !context.explicit) {
    return null;
  }
  return { from: word.from, options, validFor: /^\w*$/ };
}

function help(call: Call, text: string): HTMLElement {
  const dom = document.createElement("div");
  dom.className = "cm-call-help";
  const signature = document.createElement("code");
  signature.textContent = call.signature;
  dom.append(signature, text);
  return dom;
}
