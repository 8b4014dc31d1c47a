/**
 * Reads a JSON file that an instructor wrote and holds it against its JSON schema, saying on which
 * line what is wrong. Knows the part of JSON Schema that lessons/lesson.schema.json uses, and
 * refuses a schema that uses more, so that no rule is there in vain.
 */
import { readFileSync } from "node:fs";
import { findNodeAtLocation, parseTree, printParseErrorCode } from "jsonc-parser";
import { shownPath } from "./faults.mjs";

/**
 * @typedef {import("./faults.mjs").Fault} Fault
 * @typedef {(string | number)[]} Path
 * @typedef {{
 *   data: any,
 *   faults: Fault[],
 *   lineOf: (path: Path) => number,
 * }} ReadJson data is undefined where the file is not JSON; lineOf gives the line of a value
 * @typedef {Record<string, any>} Schema
 */

const STRICT = { disallowComments: true, allowTrailingComma: false };
const KNOWN = new Set(
  "$schema $id title description type const enum properties required additionalProperties patternProperties items minItems maxItems uniqueItems minLength pattern minimum maximum".split(
    " ",
  ),
);

/**
 * @param {string} path
 * @param {Schema} [schema]
 * @returns {ReadJson}
 */
export function readJson(path, schema) {
  const text = readFileSync(path, "utf8");
  const file = shownPath(path);
  /** @type {import("jsonc-parser").ParseError[]} */
  const errors = [];
  const tree = parseTree(text, errors, STRICT);
  const [error] = errors;
  if (error || !tree) {
    const what = error ? printParseErrorCode(error.error) : "it is empty";
    const line = lineAt(text, error?.offset ?? 0);
    const remedy = "mend the JSON here or just before: a comma, a quote or a bracket is wrong.";
    return {
      data: undefined,
      faults: [{ file, line, fault: `this is not JSON (${what})`, remedy }],
      lineOf: () => 1,
    };
  }
  /** @param {Path} at */
  const lineOf = (at) => {
    const node = findNodeAtLocation(tree, at);
    return lineAt(text, node?.offset ?? 0);
  };
  const data = JSON.parse(text);
  const faults = schema
    ? check(data, schema, []).map(({ at, fault, remedy }) => ({
        file,
        line: lineOf(at),
        fault: `${at.length > 0 ? pathText(at) : "the file"} ${fault}`,
        remedy,
      }))
    : [];
  return { data, faults, lineOf };
}

/**
 * @param {string} text
 * @param {number} offset
 */
export function lineAt(text, offset) {
  return text.slice(0, offset).split("\n").length;
}

/**
 * @param {Path} path
 */
function pathText(path) {
  return path
    .map((part, index) =>
      typeof part === "number" ? `[${part}]` : index > 0 ? `.${part}` : `${part}`,
    )
    .join("");
}

/**
 * @param {unknown} value
 * @param {Schema} schema
 * @param {Path} at
 * @returns {{ at: Path, fault: string, remedy: string }[]}
 */
function check(value, schema, at) {
  for (const key of Object.keys(schema)) {
    if (!KNOWN.has(key)) throw new Error(`the schema uses "${key}", which schema.mjs cannot check`);
  }
  /** @param {string} fault @param {string} remedy */
  const wrong = (fault, remedy) => [{ at, fault, remedy }];
  const meaning = schema.description ? ` (${schema.description})` : "";
  if ("const" in schema && value !== schema.const) {
    return wrong(`should be ${JSON.stringify(schema.const)}`, "write exactly that.");
  }
  if (schema.enum && !schema.enum.includes(value)) {
    return wrong(`is none of ${schema.enum.join(", ")}`, `choose one of them${meaning}.`);
  }
  const type = typeOf(value);
  const fits = type === schema.type || (type === "integer" && schema.type === "number");
  if (schema.type && !fits) {
    return wrong(
      `is ${aType(type)}, not ${aType(schema.type)}`,
      `give ${aType(schema.type)}${meaning}.`,
    );
  }
  if (typeof value === "string") return checkText(value, schema, wrong, meaning);
  if (typeof value === "number") return checkNumber(value, schema, wrong, meaning);
  if (Array.isArray(value)) return checkList(value, schema, at, wrong, meaning);
  if (typeof value === "object" && value !== null) return checkObject(value, schema, at, wrong);
  return [];
}

/** @typedef {(fault: string, remedy: string) => { at: Path, fault: string, remedy: string }[]} Wrong */

/**
 * @param {string} value
 * @param {Schema} schema
 * @param {Wrong} wrong
 * @param {string} meaning
 */
function checkText(value, schema, wrong, meaning) {
  if (value.trim().length < (schema.minLength ?? 0)) {
    return wrong("is empty", `write some text${meaning}.`);
  }
  if (schema.pattern && !new RegExp(schema.pattern, "u").test(value)) {
    return wrong(`is "${value}", which does not fit`, `write it as ${schema.pattern}${meaning}.`);
  }
  return [];
}

/**
 * @param {number} value
 * @param {Schema} schema
 * @param {Wrong} wrong
 * @param {string} meaning
 */
function checkNumber(value, schema, wrong, meaning) {
  const { minimum = Number.NEGATIVE_INFINITY, maximum = Number.POSITIVE_INFINITY } = schema;
  if (value >= minimum && value <= maximum) return [];
  const bounds =
    maximum === Number.POSITIVE_INFINITY ? `${minimum} or more` : `${minimum} to ${maximum}`;
  return wrong(`is ${value}`, `give ${bounds}${meaning}.`);
}

/**
 * @param {unknown[]} value
 * @param {Schema} schema
 * @param {Path} at
 * @param {Wrong} wrong
 * @param {string} meaning
 */
function checkList(value, schema, at, wrong, meaning) {
  const { minItems = 0, maxItems = Number.POSITIVE_INFINITY } = schema;
  if (value.length < minItems || value.length > maxItems) {
    const wanted = minItems === maxItems ? `${minItems}` : `at least ${minItems}`;
    return wrong(`has ${value.length} entries`, `give ${wanted}${meaning}.`);
  }
  if (
    schema.uniqueItems &&
    new Set(value.map((item) => JSON.stringify(item))).size < value.length
  ) {
    return wrong("names something twice", "leave one of them out.");
  }
  return value.flatMap((item, index) => check(item, schema.items ?? {}, [...at, index]));
}

/**
 * @param {object} value
 * @param {Schema} schema
 * @param {Path} at
 * @param {Wrong} wrong
 */
function checkObject(value, schema, at, wrong) {
  const { properties = {}, required = [], patternProperties = {} } = schema;
  const missing = required
    .filter((/** @type {string} */ key) => !(key in value))
    .flatMap((/** @type {string} */ key) => {
      const meaning = properties[key]?.description;
      return wrong(`has no "${key}"`, `add it${meaning ? `: ${meaning}` : ""}.`);
    });
  const inside = Object.entries(value).flatMap(([key, item]) => {
    const pattern = Object.keys(patternProperties).find((each) => new RegExp(each, "u").test(key));
    const own = properties[key] ?? (pattern && patternProperties[pattern]);
    if (own) return check(item, own, [...at, key]);
    if (schema.additionalProperties !== false) return [];
    const patterns = Object.keys(patternProperties);
    const known = [...Object.keys(properties), ...patterns].join(", ");
    const remedy = `take it out or mend its name; known here: ${known}.`;
    return [{ at: [...at, key], fault: "is not known here", remedy }];
  });
  return [...missing, ...inside];
}

/** @param {unknown} value */
function typeOf(value) {
  if (value === null) return "null";
  if (Array.isArray(value)) return "array";
  if (typeof value === "number") return Number.isInteger(value) ? "integer" : "number";
  return typeof value;
}

/** @param {string} type */
function aType(type) {
  const words = {
    array: "a list",
    object: "an object {…}",
    integer: "a whole number",
    string: "a text",
  };
  return words[/** @type {keyof typeof words} */ (type)] ?? `a ${type}`;
}
