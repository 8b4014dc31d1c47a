/**
 * Help with the robot's calls: completion while typing, and their docstrings on hover.
 * The calls are handed in; they come from the docstrings of `py/bugbot`.
 */
import type { Completion, CompletionContext, CompletionResult } from "@codemirror/autocomplete";
import { pythonLanguage } from "@codemirror/lang-python";
import { syntaxTree } from "@codemirror/language";
import type { Extension } from "@codemirror/state";
import { hoverTooltip } from "@codemirror/view";

export interface Call {
  name: string;
  signature: string;
  summary: string;
  doc: string;
}

/** Names that hold the robot: `robot = connect()`, `with Robot() as robot`, `import bugbot`. */
const HOLDS_ROBOT =
  /\b(\w+)\s*=\s*(?:bugbot\.)?(?:connect|Robot)\(|(?:connect|Robot)\([^)\n]*\)\s+as\s+(\w+)|\bimport\s+(bugbot)\b/g;

export function robotCalls(calls: readonly Call[]): Extension {
  const byName = new Map(calls.map((call) => [call.name, call]));
  const options = calls.map(completion);
  return [
    pythonLanguage.data.of({
      autocomplete: (context: CompletionContext) => complete(context, options),
    }),
    hoverTooltip((view, at) => {
      const node = syntaxTree(view.state).resolveInner(at, 0);
      if (node.name !== "VariableName" && node.name !== "PropertyName") return null;
      const call = byName.get(view.state.sliceDoc(node.from, node.to));
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

function robotNames(program: string): Set<string> {
  const names = new Set<string>();
  for (const match of program.matchAll(HOLDS_ROBOT)) {
    const name = match[1] ?? match[2] ?? match[3];
    if (name) names.add(name);
  }
  return names;
}

function help(call: Call, text: string): HTMLElement {
  const dom = document.createElement("div");
  dom.className = "cm-call-help";
  const signature = document.createElement("code");
  signature.textContent = call.signature;
  dom.append(signature, text);
  return dom;
}
