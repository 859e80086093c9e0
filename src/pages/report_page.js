// The page of a report: the table, and everything about the row that is selected.
"use strict";

/** Puts a text on the clipboard; where that is not allowed, selects it. */
async function copyText(element, told) {
  try {
    await navigator.clipboard.writeText(element.textContent);
    told.textContent = "Copied";
  } catch {
    getSelection().selectAllChildren(element);
    told.textContent = "Selected: copy it with Ctrl C";
  }
}

function commandElement(command, title = null) {
  const code = make("code", { id: title ? null : "command" }, command);
  const told = make("output", { class: "hint" });
  const copy = pressable("Copy", { id: title ? null : "copy", "aria-label": title ? `Copy the command of ${title}` : null }, () => copyText(code, told));
  return make("section", { class: "card command", "aria-label": title ? `Command of ${title}` : "Command" },
    make("div", { class: "bar" }, make("h3", {}, title ?? "Command"), copy, told),
    code,
  );
}

function factsElement(facts) {
  const list = make("dl", { class: "facts" }, facts.flatMap(([name, text]) => [make("dt", {}, name), make("dd", {}, visibleText(text))]));
  return make("section", { class: "card", "aria-label": "Run" }, make("h3", {}, "Run"), list);
}

function outputElement(row) {
  const note = row.output_note ? make("span", { class: "size" }, ` ${row.output_note}`) : "";
  return make("section", { class: "card", "aria-label": "Printed" },
    make("h3", {}, "Printed", note),
    make("pre", { tabindex: 0, id: "output" }, visibleText(row.output)),
  );
}

function showCause(element, { cause, explanation }) {
  element.hidden = !cause && !explanation;
  element.replaceChildren(
    cause ? make("h3", {}, "Likely cause: ", visibleText(cause)) : "",
    explanation ? make("p", { class: "explanation" }, visibleText(explanation)) : "",
  );
}

const pictures = new RowPictures(byId("pictures"));

/** Resolves once everything is seen. */
function showRow(index) {
  const row = pageData.rows[index];
  history.replaceState(null, "", `#${encodeURIComponent(row.name)}`);
  byId("row-name").textContent = visibleText(row.name);
  byId("row-outcome").replaceChildren(outcomeElement(row, row.cells.outcome ?? ""));
  byId("row-reason").textContent = visibleText(row.reason ?? "");
  byId("row-reason").hidden = !row.reason;
  showCause(byId("row-cause"), row);
  showLines(byId("lines"), row);
  byId("told").replaceChildren(
    row.phases?.length ? phasesElement(row.phases) : "",
    row.command ? commandElement(row.command) : "",
    ...(row.commands ?? []).map(([title, command]) => commandElement(command, title)),
    row.facts ? factsElement(row.facts) : "",
    row.output ? outputElement(row) : "",
  );
  shown = pictures.show(row);
}

/** The row that the address names, else the one that the page names, else the first one that is not good. */
function firstRow() {
  let name = null;
  try {
    name = decodeURIComponent(location.hash.slice(1));
  } catch {
    // An address that nobody wrote for this page.
  }
  for (const wanted of [name, pageData.first]) {
    const named = pageData.rows.findIndex((row) => row.name === wanted);
    if (named >= 0) return named;
  }
  return Math.max(pageData.rows.findIndex((row) => !row.good), 0);
}

let shown = null; // a promise: the pictures of the selected row are seen
showReportHead();
const table = new ReportTable(byId("table"), pageData, showRow);
byId("previous").addEventListener("click", () => table.step(-1));
byId("next").addEventListener("click", () => table.step(1));
addEventListener("hashchange", () => table.select(firstRow()));
table.select(firstRow());
shown.then(() => (document.documentElement.dataset.ready = ""));
