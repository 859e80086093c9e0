// Two texts side by side, line by line, with what differs marked.
"use strict";

const contextLines = 3; // shown around each difference
const mostLines = 400; // shown at once

/** A line's fields with blanks between them; those that differ are marked. */
function lineElement(text, differing) {
  const fields = text.replace(/^ /, "").split(" ");
  const marked = new Set(differing);
  const parts = fields.flatMap((field, i) => {
    const shown = visibleText(field);
    return [i === 0 ? (text.startsWith(" ") ? " " : "") : " ", marked.has(i + 1) ? make("mark", {}, shown) : shown];
  });
  return make("span", { class: "line" }, parts);
}

function lineRow([expectedNumber, expected, actualNumber, actual, differing]) {
  const side = (number, text, sign, label) => {
    if (number === 0) return [make("td", { class: "no" }), make("td", { class: "absent", "aria-label": "no such line" })];
    const alone = expectedNumber === 0 || actualNumber === 0;
    const changed = alone || differing.length > 0;
    const start = changed ? make("span", { class: "sign", "aria-label": label }, sign) : make("span", { class: "sign" }, " ");
    return [make("td", { class: "no" }, number === null ? "" : String(number)), make("td", { class: alone ? "alone" : null }, start, lineElement(text, differing))];
  };
  const same = expectedNumber !== 0 && actualNumber !== 0 && differing.length === 0;
  const cells = [...side(expectedNumber, expected, "−", "expected:"), ...side(actualNumber, actual, "+", "printed:")];
  return make("tr", { class: same ? "same" : "differs" }, cells);
}

const isSame = ([expectedNumber, , actualNumber, , differing]) => expectedNumber !== 0 && actualNumber !== 0 && differing.length === 0;

/** Which lines are near a difference. */
function nearDifferences(lines) {
  const near = lines.map(() => false);
  lines.forEach((line, i) => {
    if (!isSame(line)) near.fill(true, Math.max(i - contextLines, 0), i + contextLines + 1);
  });
  return near;
}

/** A row that stands for lines that are not shown, and shows them. */
function foldedRow(lines) {
  const same = lines.every(isSame);
  const button = make("button", { type: "button" }, `Show ${lines.length} ${same ? "equal " : "more "}${lines.length === 1 ? "line" : "lines"}`);
  const row = make("tr", { class: "folded" }, make("td", { colspan: 4 }, button));
  button.addEventListener("click", () => {
    const [shown, rest] = [lines.slice(0, mostLines), lines.slice(mostLines)];
    row.replaceWith(...shown.map(lineRow), ...(rest.length > 0 ? [foldedRow(rest)] : []));
  });
  return row;
}

function lineRows(lines) {
  const near = nearDifferences(lines);
  const rows = [];
  for (let i = 0; i < lines.length; ) {
    if (rows.length >= mostLines) {
      rows.push(foldedRow(lines.slice(i)));
      break;
    }
    if (near[i]) {
      rows.push(lineRow(lines[i++]));
      continue;
    }
    const first = i;
    while (i < lines.length && !near[i]) ++i;
    rows.push(i - first === 1 ? lineRow(lines[first]) : foldedRow(lines.slice(first, i)));
  }
  return rows;
}

/** Shows the texts of a row in `section`, or hides it. */
function showLines(section, row) {
  section.hidden = !row.lines;
  if (!row.lines) return section.replaceChildren();
  const heading = (text) => make("th", { scope: "col", colspan: 2 }, text);
  const columns = make("colgroup", {}, ["no", "text", "no", "text"].map((kind) => make("col", { class: kind })));
  const head = make("thead", {}, make("tr", {}, heading("Expected"), heading("Printed")));
  const differing = row.lines.filter((line) => !isSame(line)).length;
  section.replaceChildren(
    make("h3", {}, "Texts side by side"),
    make("p", { class: "hint" }, `${differing} of ${row.lines.length} lines differ. ${row.lines_note ?? ""}`),
    make("div", { class: "scroller", tabindex: 0, role: "region", "aria-label": "Both texts" }, make("table", { class: "lines" }, columns, head, make("tbody", {}, lineRows(row.lines)))),
  );
}
