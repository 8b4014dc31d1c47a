/** What came of the stories, as a table "stories by engines" in Markdown. */

/**
 * @typedef {{ story: string, result: "passed" | "failed" | "not here", seconds: number, detail: string }} Told
 * @typedef {{ title: string, version: string, missing: string | null, told: Told[] }} Report
 */

/**
 * @param {Report[]} reports
 * @param {string[]} stories
 */
export function tableOf(reports, stories) {
  /** @type {string[]} */
  const notes = [];
  /** @param {string} text */
  const note = (text) => {
    if (!notes.includes(text)) notes.push(text);
    return `(${notes.indexOf(text) + 1})`;
  };
  /** @param {Report} report @param {string} story */
  const cell = (report, story) => {
    if (report.missing) return "not installed";
    const told = report.told.find((each) => each.story === story);
    if (!told) return "";
    const { result, seconds, detail } = told;
    const took = seconds < 0.05 ? "" : `${seconds.toFixed(1)} s`;
    if (result === "passed") return [took, detail].filter(Boolean).join(", ");
    return `${result === "failed" ? "FAILED" : "not here"} ${note(`${report.title}, ${story}: ${detail}`)}`;
  };
  const rows = [
    ["Story", ...reports.map(({ title, version }) => version || title)],
    ...stories.map((story) => [story, ...reports.map((report) => cell(report, story))]),
  ];
  const widths = (rows[0] ?? []).map((_, column) =>
    Math.max(...rows.map((row) => row[column]?.length ?? 0)),
  );
  const lines = rows.map(
    (row) => `| ${row.map((text, column) => text.padEnd(widths[column] ?? 0)).join(" | ")} |`,
  );
  lines.splice(1, 0, `|${widths.map((width) => "-".repeat(width + 2)).join("|")}|`);
  const below = notes.map((text, index) => `${index + 1}. ${text.replace(/\s+/g, " ")}`);
  for (const { title, missing } of reports) if (missing) below.push(`- ${title}: ${missing}.`);
  return [...lines, ...(below.length > 0 ? ["", ...below] : [])].join("\n");
}
