// What each step of a knob costs, and which part of an error comes from where.
"use strict";

const sourceNames = [["sampling", "sampling"], ["model", "model"], ["precision", "precision"]];
const presetNames = ["draft", "fast", "good", "exact"];

const numberCell = (text) => make("td", { class: "number" }, text);
const headCell = (text, number = true) => make("th", { scope: "col", class: number ? "number" : null }, text);

/** A bar on a logarithmic scale from `least` to `most`. */
function logBar(value, least, most) {
  const share = value > 0 && most > least ? Math.log(value / least) / Math.log(most / least) : 0;
  const bar = make("span", { class: "log-bar", "aria-hidden": "true" }, make("span"));
  bar.firstChild.style.width = `${100 * Math.min(Math.max(share, 0), 1)}%`;
  return make("td", { class: "bars" }, bar);
}

/** The measured setting that has this value of a knob and otherwise what the preset has. */
function beside(trade, preset, knob, value) {
  const wanted = JSON.stringify({ ...preset.values, [knob]: value });
  return trade.settings.find((setting) => setting.state === "measured" && JSON.stringify(setting.values) === wanted);
}

/** What a value's words choose before its numbers, as sensitivity.h has it: steps are within one method. */
function methodOf(words) {
  return words.startsWith("--aa ") ? words.split(",")[0] : words.split(/[ =]/)[0];
}

function knobTable(trade, preset, knob, range) {
  const before = new Map(); // seconds by method
  const lines = knob.values.map(({ name, words, rmse_alone: alone }) => {
    const setting = beside(trade, preset, knob.name, name);
    const seconds = setting?.[trade.cost].total;
    const method = methodOf(words);
    const factor = seconds !== undefined && before.has(method) ? `× ${(seconds / before.get(method)).toFixed(2)}` : "";
    if (seconds !== undefined) before.set(method, seconds);
    return make("tr", { class: preset.values[knob.name] === name ? "of-preset" : null },
      make("th", { scope: "row" }, name),
      numberCell(seconds === undefined ? "" : timeText(seconds)),
      numberCell(factor),
      numberCell(setting ? errorText(setting.error.rmse) : ""),
      numberCell(alone === undefined ? "" : errorText(alone)),
      logBar(alone ?? 0, ...range),
    );
  });
  const note = knob.converges ? "" : " The values are other surfaces; none of them is more exact.";
  return make("section", { "data-knob": knob.name },
    make("h4", {}, knob.name, make("span", { class: "size" }, ` ${knob.changes}; ${knob.source}.${note}`)),
    make("table", { class: "knob-table" },
      make("thead", {}, make("tr", {}, headCell("Value", false), headCell("Time"), headCell("Step"), headCell("RMSE"), headCell("Alone"), make("th"))),
      make("tbody", {}, lines),
    ),
  );
}

/** Tables of all knobs around the preset that is chosen. */
function showKnobs(element, trade) {
  const alone = trade.knobs.flatMap((knob) => knob.values.map((value) => value.rmse_alone ?? 0)).filter((error) => error > 0);
  const range = alone.length ? [Math.min(...alone) / 2, Math.max(...alone)] : [0.1, 1];
  const tables = make("div", { class: "knob-tables" });
  const presets = presetNames.map((name) => trade.settings.find((setting) => setting.name === name)).filter((preset) => preset?.state === "measured");
  const fill = (name) => {
    const preset = presets.find((other) => other.name === name);
    tables.replaceChildren(...(preset ? trade.knobs.map((knob) => knobTable(trade, preset, knob, range)) : []));
  };
  const select = make("select", { "aria-label": "Around" }, presets.map(({ name }) => make("option", { value: name }, name)));
  select.value = presets.some(({ name }) => name === "good") ? "good" : presets[0]?.name;
  select.addEventListener("change", () => fill(select.value));
  fill(select.value);
  element.append(
    make("div", { class: "bar" }, make("h3", {}, "What a step of each knob costs"), make("label", {}, "around", select)),
    make("p", { class: "hint" }, "Time and RMSE with this value and otherwise what the preset has. Step: times as long as the value above that samples by the same method. Alone: the RMSE of this value with everything else exact and converged; its bar is logarithmic."),
    tables,
  );
}

function sourceLine(setting) {
  const { by_source: parts } = setting.alone;
  const squares = sourceNames.map(([key]) => parts[key] ** 2);
  const sum = squares.reduce((total, square) => total + square, 0);
  const bar = make("span", { class: "phases", "aria-hidden": "true" }, sourceNames.map(([key], i) => {
    const part = make("span", { class: `source ${key}` });
    part.style.width = `${sum > 0 ? (100 * squares[i]) / sum : 0}%`;
    return part;
  }));
  return make("tr", {},
    make("th", { scope: "row" }, setting.name),
    numberCell(errorText(setting.error.rmse)),
    numberCell(errorText(Math.sqrt(sum))),
    sourceNames.map(([key]) => numberCell(errorText(parts[key]))),
    make("td", { class: "bars" }, bar),
  );
}

/** For the presets and the front, from quick to exact. */
function showSources(element, trade) {
  const shown = trade.settings.filter((setting) => setting.state === "measured" && setting.alone?.by_source && (setting.front || setting.origin === "preset"));
  shown.sort((a, b) => a[trade.cost].total - b[trade.cost].total);
  const keys = sourceNames.map(([key, name]) => make("th", { scope: "col", class: "number" }, make("span", { class: `key source ${key}`, "aria-hidden": "true" }), ` ${name}`));
  element.append(
    make("h3", {}, "Where the error comes from"),
    make("p", { class: "hint" }, "RMSE of each source with the others exact and converged; together: the root of the sum of their squares, which is the measured RMSE where they are independent. Bars: shares of the squares."),
    make("div", { class: "scroller", tabindex: 0, role: "region", "aria-label": "Sources of the error" },
      make("table", { class: "source-table" },
        make("thead", {}, make("tr", {}, headCell("Setting", false), headCell("RMSE"), headCell("Together"), keys, make("th"))),
        make("tbody", {}, shown.map(sourceLine)),
      ),
    ),
  );
}
