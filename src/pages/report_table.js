// A table of results that is sorted by any column and filtered by words and outcome.
"use strict";

const collator = new Intl.Collator("en", { numeric: true });
const integer = new Intl.NumberFormat("en", { maximumFractionDigits: 3 });

/** How a kind of cell is written. */
const cellTexts = {
  text: (value) => visibleText(value),
  outcome: (value) => value,
  count: (value) => integer.format(value),
  points: ([have, of]) => `${integer.format(have)} / ${integer.format(of)}`,
  figure: (value) => (value === 0 ? "0" : value < 5e-5 ? value.toExponential(0) : value.toFixed(4)),
  seconds: (value) => `${value.toFixed(value < 100 ? 3 : 1)} s`,
  bytes: (value) => `${(value / 2 ** 20).toFixed(1)} MiB`,
};

const isNumeric = (kind) => kind !== "text" && kind !== "outcome";
const numberOf = (value) => (Array.isArray(value) ? value[0] : value);

/** The order of two cells, growing; what is missing comes last whichever way a table is sorted. */
function compareCells(kind, a, b, direction) {
  if (a === undefined || b === undefined) return (a === undefined) - (b === undefined);
  return direction * (isNumeric(kind) ? numberOf(a) - numberOf(b) : collator.compare(a, b));
}

function outcomeElement(row, text) {
  return make("span", { class: row.good ? "good" : "bad" }, make("span", { "aria-hidden": "true" }, row.good ? "✓ " : "✗ "), text);
}

/**
 * new ReportTable(element, data, onSelect)
 *
 * data      columns, rows, rows_name and bad_name as report_page.h has them
 * onSelect  (index): a row was selected; without it rows are only links
 *
 * Arrow keys, Home, End, Page Up and Page Down go from row to row.
 */
class ReportTable {
  constructor(element, data, onSelect = null) {
    Object.assign(this, { columns: data.columns, rows: data.rows, rowsName: data.rows_name, badName: data.bad_name, onSelect });
    this.sorted = { key: null, direction: 1 };
    this.selected = null;
    this.texts = this.rows.map((row) => {
      const words = [row.name, row.reason, row.tag, ...this.columns.filter((c) => !isNumeric(c.kind)).map((c) => row.cells[c.key])];
      return words.filter((word) => word !== undefined).join(" ").toLowerCase();
    });
    this.body = make("tbody");
    this.head = make("thead", {}, make("tr", {}, this.columns.map((column) => this.heading(column))));
    this.lines = this.rows.map((row, index) => this.line(row, index));
    const grid = make("table", { "aria-label": `All ${this.rowsName}`, role: onSelect ? "grid" : null }, this.head, this.body);
    this.scroller = make("div", { class: "scroller" }, grid);
    element.append(this.filterBar(), this.scroller);
    this.body.addEventListener("keydown", (event) => this.typed(event));
    this.order();
  }

  heading(column) {
    const button = make("button", { type: "button", title: column.hint ?? null }, column.title, make("span", { class: "arrow", "aria-hidden": "true" }));
    button.addEventListener("click", () => this.sort(column));
    return make("th", { scope: "col", class: isNumeric(column.kind) ? "number" : null, "aria-sort": "none", "data-key": column.key }, button);
  }

  line(row, index) {
    const cells = this.columns.map((column, at) => this.cell(row, column, at === 0));
    const line = make("tr", { "data-index": index, tabindex: this.onSelect ? -1 : null, "aria-selected": this.onSelect ? "false" : null }, cells);
    if (this.onSelect) line.addEventListener("click", () => this.select(index, true));
    return line;
  }

  cell(row, column, first) {
    const value = row.cells[column.key];
    const text = value === undefined ? "" : cellTexts[column.kind](value);
    if (first) {
      const name = row.href ? make("a", { href: row.href }, text) : text;
      return make("th", { scope: "row" }, name, row.tag ? make("span", { class: "tag" }, row.tag) : "");
    }
    if (column.kind === "outcome") return make("td", {}, outcomeElement(row, text));
    return make("td", { class: isNumeric(column.kind) ? "number" : null }, text);
  }

  /** Words, and one outcome or all of them. */
  filterBar() {
    this.words = make("input", { type: "search", placeholder: "Filter", "aria-label": `Filter ${this.rowsName} by words`, spellcheck: "false" });
    const outcomes = [...new Set(this.rows.map((row) => row.cells.outcome))].filter((outcome) => outcome !== undefined);
    const count = (test) => this.rows.filter(test).length;
    const choices = [["all", "All", () => true], ["bad", this.badName, (row) => !row.good]];
    for (const outcome of outcomes) choices.push([`= ${outcome}`, outcome, (row) => row.cells.outcome === outcome]);
    this.choices = new Map(choices.map(([value, , test]) => [value, test]));
    const options = choices.map(([value, text, test]) => make("option", { value }, `${text} (${count(test)})`));
    const column = this.columns.find(({ kind }) => kind === "outcome");
    this.outcome = make("select", { "aria-label": column?.title ?? "Outcome" }, options);
    this.count = make("output", { "aria-label": `${this.rowsName} shown` });
    this.words.addEventListener("input", () => this.order());
    this.outcome.addEventListener("change", () => this.order());
    return make("div", { class: "bar filter", role: "search" }, this.words, this.outcome, this.count);
  }

  isShown(index) {
    const words = this.words.value.toLowerCase().split(/\s+/);
    return this.choices.get(this.outcome.value)(this.rows[index]) && words.every((word) => this.texts[index].includes(word));
  }

  /** A column once more turns the order round, a third time brings back the first one. Numbers begin with the largest. */
  sort(column) {
    const first = isNumeric(column.kind) ? -1 : 1;
    if (this.sorted.key !== column.key) this.sorted = { key: column.key, kind: column.kind, direction: first };
    else if (this.sorted.direction === first) this.sorted.direction = -first;
    else this.sorted = { key: null, direction: 1 };
    for (const heading of this.head.rows[0].cells) {
      const direction = heading.dataset.key !== this.sorted.key ? "none" : this.sorted.direction > 0 ? "ascending" : "descending";
      heading.setAttribute("aria-sort", direction);
    }
    this.order();
  }

  /** Puts the rows that are shown into their order. */
  order() {
    const { key, kind, direction } = this.sorted;
    this.shown = this.rows.map((_, index) => index).filter((index) => this.isShown(index));
    if (key !== null) this.shown.sort((a, b) => compareCells(kind, this.rows[a].cells[key], this.rows[b].cells[key], direction) || a - b);
    this.body.replaceChildren(...this.shown.map((index) => this.lines[index]));
    this.count.textContent = `${this.shown.length} of ${this.rows.length} ${this.rowsName}`;
    this.makeReachable();
  }

  /** One row is reached by Tab: the selected one, or the first where that is not shown. */
  makeReachable() {
    if (!this.onSelect) return;
    for (const line of this.lines) line.tabIndex = -1;
    const index = this.shown.includes(this.selected) ? this.selected : this.shown[0];
    if (index !== undefined) this.lines[index].tabIndex = 0;
  }

  select(index, focus = false) {
    if (this.selected !== null) this.lines[this.selected].setAttribute("aria-selected", "false");
    this.selected = index;
    this.lines[index].setAttribute("aria-selected", "true");
    this.makeReachable();
    if (focus) this.lines[index].focus({ preventScroll: true });
    this.reveal(this.lines[index]);
    this.onSelect(index);
  }

  /** Scrolls the table alone, so that what is below it stays. */
  reveal(line) {
    const top = line.offsetTop - this.head.offsetHeight;
    const bottom = line.offsetTop + line.offsetHeight - this.scroller.clientHeight;
    if (this.scroller.scrollTop > top) this.scroller.scrollTop = top;
    else if (this.scroller.scrollTop < bottom) this.scroller.scrollTop = bottom;
  }

  /** The row so many steps behind the selected one. */
  step(steps, focus = false) {
    const at = this.shown.indexOf(this.selected);
    const next = this.shown[Math.min(Math.max(at + steps, 0), this.shown.length - 1)];
    if (next !== undefined) this.select(next, focus);
  }

  typed(event) {
    if (!this.onSelect || event.ctrlKey || event.metaKey || event.altKey) return;
    const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10, Home: -Infinity, End: Infinity }[event.key];
    if (steps !== undefined) this.step(steps, true);
    else if (event.key === "Enter" || event.key === " ") this.select(Number(event.target.closest("tr").dataset.index), true);
    else return;
    event.preventDefault();
  }
}
