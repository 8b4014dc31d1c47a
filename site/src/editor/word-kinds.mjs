/**
 * The kinds of words in a program that have a colour of their own, `--code-KIND` in tokens.css.
 * For the editor, and for the build, which colours the programs in prose: a plain script, since the
 * build runs in Node as it is. Imports nothing of ours.
 */
import { tags as t } from "@lezer/highlight";

/** @type {{ kind: string, tags: import("@lezer/highlight").Tag[] }[]} */
export const wordKinds = [
  {
    kind: "keyword",
    tags: [t.keyword, t.controlKeyword, t.operatorKeyword, t.definitionKeyword, t.moduleKeyword],
  },
  { kind: "number", tags: [t.number, t.bool, t.null] },
  { kind: "string", tags: [t.string, t.special(t.string)] },
  { kind: "comment", tags: [t.comment] },
  {
    kind: "call",
    tags: [
      t.function(t.variableName),
      t.function(t.definition(t.variableName)),
      t.function(t.propertyName),
      t.definition(t.className),
    ],
  },
];
