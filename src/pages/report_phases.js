// How long each phase of several programs took, as bars of one scale.
"use strict";

function phaseBar(phases, longest) {
  const parts = phases.map(([phase, seconds]) => {
    const part = make("span", { class: `phase ${phase}`, title: `${phase} ${seconds.toFixed(4)} s` });
    part.style.width = `${(100 * seconds) / longest}%`;
    return part;
  });
  return make("span", { class: "phases", "aria-hidden": "true" }, parts);
}

/** phases: [[program, [[phase, seconds], ...]], ...], the same phases for all. */
function phasesElement(phases) {
  const sum = (parts) => parts.reduce((total, [, seconds]) => total + seconds, 0);
  const longest = Math.max(...phases.map(([, parts]) => sum(parts)), 1e-9);
  const names = phases[0][1].map(([phase]) => phase);
  const head = make("tr", {}, make("th", { scope: "col" }, "Seconds"), make("th", {}), names.map((phase) =>
    make("th", { scope: "col", class: "number" }, make("span", { class: `key phase ${phase}`, "aria-hidden": "true" }), ` ${phase}`)));
  const lines = phases.map(([program, parts]) =>
    make("tr", {}, make("th", { scope: "row" }, program), make("td", { class: "bars" }, phaseBar(parts, longest)),
      parts.map(([, seconds]) => make("td", { class: "number" }, seconds.toFixed(4)))));
  return make("section", { class: "card wide", "aria-label": "Phases" },
    make("h3", {}, "Phases"),
    make("table", { class: "phase-table" }, make("thead", {}, head), make("tbody", {}, lines)),
  );
}
