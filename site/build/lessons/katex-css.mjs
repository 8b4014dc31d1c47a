/**
 * KaTeX's style sheet without what the site's formulas do not use: half of its rules, and most of
 * its sixty font files. Imports nothing of ours.
 */

/**
 * @param {string} css KaTeX's own, minified: rules without nesting
 * @param {readonly string[]} pages HTML with formulas in it
 */
export function slimMathematics(css, pages) {
  const used = new Set(
    pages
      .flatMap((html) => [...html.matchAll(/class="([^"]*)"/g)])
      .flatMap(([, names = ""]) => names.split(" ")),
  );
  const rules = css.match(/[^{}]+\{[^{}]*\}/g) ?? [];
  const kept = rules
    .filter((rule) => !rule.startsWith("@font-face"))
    .flatMap((rule) => usedPart(rule, used));
  const fonts = rules
    .filter((rule) => rule.startsWith("@font-face") && fontIsNamed(rule, kept))
    .map((rule) =>
      rule.replace(/src:[^;}]*?(url\([^)]*\.woff2\) format\("woff2"\))[^;}]*/, "src:$1"),
    );
  return [...fonts, ...kept].join("");
}

/**
 * The rule with those of its selectors whose classes all occur; nothing if none is left.
 * @param {string} rule
 * @param {ReadonlySet<string>} used
 */
function usedPart(rule, used) {
  const at = rule.indexOf("{");
  const selectors = rule
    .slice(0, at)
    .split(",")
    .filter((selector) =>
      [...selector.matchAll(/\.([\w-]+)/g)].every(([, name = ""]) => used.has(name)),
    );
  return selectors.length > 0 ? [selectors.join(",") + rule.slice(at)] : [];
}

/**
 * Whether the rules ask for the font's family, and for its weight and style.
 * @param {string} face
 * @param {readonly string[]} rules
 */
function fontIsNamed(face, rules) {
  const family = /font-family:"?(\w+)/.exec(face)?.[1] ?? "";
  const ours = rules.filter((rule) => rule.includes(family) || !rule.includes("KaTeX_"));
  if (!ours.some((rule) => rule.includes(family))) return false;
  if (
    face.includes("font-weight:700") &&
    !ours.some((rule) => /font-weight:(700|bold)/.test(rule))
  ) {
    return false;
  }
  // Letters of formulas are italic by their font, not by their style.
  return !/Main-.*Italic/.test(face) || ours.some((rule) => /font-style:italic/.test(rule));
}
