// Settings as points of time and error, the front that no other beats, and a card with the pictures of the one that is pointed at.
"use strict";

const chartHeight = 440;
const costs = [["wall", "Seconds of the clock"], ["cpu", "Seconds of all processors"]];
const figures = [["rmse", "RMSE"], ["p99", "99th percentile"], ["max", "Maximum"], ["flip", "FLIP"]];
const cardGain = 8; // of the difference on the card

/** Of points with `x` and `y` those that no other beats, as front.h has it. */
function frontOf(points, { worth, same_time: sameTime, same_error: sameError }) {
  const order = points.map((_, i) => i).sort((a, b) => points[a].x - points[b].x || points[a].y - points[b].y || a - b);
  const front = [];
  for (const i of order) if (front.length === 0 || points[i].y < (1 - worth) * points[front.at(-1)].y) front.push(i);
  const asGood = (best) => points.findIndex(({ x, y }) => x <= (1 + sameTime) * best.x && y <= (1 + sameError) * best.y);
  return [...new Set(front.map((i) => asGood(points[i])))];
}

class TradePlot {
  constructor(trade, onChoose) {
    Object.assign(this, { trade, onChoose, cost: trade.cost, figure: "rmse", knob: "" });
    this.settings = trade.settings.filter((setting) => setting.state === "measured");
    this.chosen = null; // name
    const choice = (label, options, value, onChange) => {
      const select = make("select", { "aria-label": label }, options.map(([key, text]) => make("option", { value: key }, text)));
      select.value = value;
      select.addEventListener("change", () => onChange(select.value));
      return make("label", {}, label, select);
    };
    const knobs = [["", "nothing"], ...trade.knobs.map(({ name }) => [name, name])];
    byId("plot-bar").append(
      make("h3", {}, "Time and error"),
      choice("Time", costs, this.cost, (value) => this.change({ cost: value })),
      choice("Error", figures, this.figure, (value) => this.change({ figure: value })),
      choice("Colour by", knobs, "", (value) => this.change({ knob: value })),
      (this.legend = make("span", { class: "legend" })),
    );
    chart.addEventListener("keydown", (event) => this.typed(event));
    chart.addEventListener("pointerleave", () => this.hide());
    chart.addEventListener("focusout", () => this.hide());
    this.build();
    new ResizeObserver(() => chart.clientWidth !== this.width && this.build()).observe(chart);
  }

  change(choices) {
    Object.assign(this, choices);
    this.build();
  }

  xOf(setting) {
    return setting[this.cost].total;
  }

  yOf(setting) {
    return setting.error[this.figure];
  }

  build() {
    this.width = chart.clientWidth;
    const width = Math.max(this.width, 320);
    chart.setAttribute("viewBox", `0 0 ${width} ${chartHeight}`);
    this.area = { left: 66, right: width - 12, top: 12, bottom: chartHeight - 48 };
    const xs = this.settings.map((setting) => this.xOf(setting));
    const ys = this.settings.map((setting) => this.yOf(setting));
    const limit = this.figure === "rmse" ? this.trade.reference.rmse_told_apart : 0;
    this.x = new LogScale(xs, this.area.left, this.area.right);
    this.y = new LogScale([...ys, limit], this.area.bottom, this.area.top);
    const counted = this.settings.filter((setting) => setting.comparable);
    this.front = frontOf(counted.map((setting) => ({ x: this.xOf(setting), y: Math.max(this.yOf(setting), limit) })), this.trade.front_margins).map((i) => counted[i]);
    this.points = new Map();
    chart.replaceChildren(...this.axes(), ...this.limitLine(limit), this.frontLine(), ...this.inLayers().map((s) => this.point(s)), ...this.labels());
    this.order = [...this.settings].sort((a, b) => this.xOf(a) - this.xOf(b));
    this.showLegend();
    this.mark(this.chosen);
    byId("plot-hint").textContent = this.hintText(limit);
  }

  hintText(limit) {
    const told = limit > 0 ? ` Below the dashed line, twice the RMSE that the reference itself is estimated to have, nothing is told apart.` : "";
    const none = this.settings.filter((setting) => this.yOf(setting) === 0).length;
    const edge = none > 0 ? ` ${none} points of no error at all stand at the lower edge.` : "";
    const others = this.settings.length - this.settings.filter((s) => s.comparable).length;
    const grey = others > 0 ? ` ${others} hollow points show other surfaces than the reference and do not count.` : "";
    return `Blue points are those that no other beats; the large ones are presets. Point at one for its picture and the difference (× ${cardGain}).${told}${edge}${grey}`;
  }

  axes() {
    const { left, right, top, bottom } = this.area;
    const lines = this.x.ticks(60).flatMap((value) => {
      const x = this.x.place(value);
      return [draw("line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom }), draw("text", { class: "tick", x, y: bottom + 18, "text-anchor": "middle" }, timeTick(value))];
    });
    const rows = this.y.ticks(20).flatMap((value) => {
      const y = this.y.place(value);
      return [draw("line", { class: "grid", x1: left, x2: right, y1: y, y2: y }), draw("text", { class: "tick", x: left - 8, y: y + 4, "text-anchor": "end" }, plainNumber(value))];
    });
    const titles = [
      draw("text", { class: "title", x: right, y: bottom + 40, "text-anchor": "end" }, costs.find(([key]) => key === this.cost)[1]),
      draw("text", { class: "title", x: left + 6, y: top + 14 }, figures.find(([key]) => key === this.figure)[1]),
    ];
    return [...lines, ...rows, ...titles, draw("rect", { class: "frame", x: left, y: top, width: right - left, height: bottom - top })];
  }

  limitLine(limit) {
    if (!(limit > 0)) return [];
    const y = this.y.place(limit);
    return [draw("line", { class: "limit", x1: this.area.left, x2: this.area.right, y1: y, y2: y })];
  }

  /** Steps: until the next point of the front is paid for, nothing is better than the last. */
  frontLine() {
    let path = "";
    for (const setting of this.front) {
      const [x, y] = this.placeOf(setting);
      path += path === "" ? `M${x} ${y}` : `H${x}V${y}`;
    }
    if (path !== "") path += `H${this.area.right}`;
    return draw("path", { class: "front", d: path });
  }

  placeOf(setting) {
    return [this.x.place(this.xOf(setting)), this.y.place(this.yOf(setting))].map((place) => Math.round(10 * place) / 10);
  }

  colorOf(setting) {
    const knob = this.trade.knobs.find(({ name }) => name === this.knob);
    if (!knob) return null;
    const index = knob.values.findIndex(({ name }) => name === setting.values[this.knob]);
    return index < 0 ? "var(--quiet)" : stepColor(index, knob.values.length);
  }

  point(setting) {
    const [x, y] = this.placeOf(setting);
    const onFront = this.front.includes(setting);
    const size = setting.origin === "preset" ? 7 : 5;
    const kind = ["point", onFront ? "on-front" : "", setting.comparable ? "" : "other"].join(" ");
    const color = this.colorOf(setting);
    const label = `${setting.name}: ${timeText(this.xOf(setting))}, ${errorText(this.yOf(setting))}${onFront ? ", on the front" : ""}`;
    const element = draw("g", { class: kind, role: "button", tabindex: -1, "aria-label": label, "data-name": setting.name, transform: `translate(${x} ${y})` },
      draw("circle", { class: "reach", r: 11 }),
      draw("circle", { class: "dot", r: size, style: color && `--dot: ${color}` }));
    element.addEventListener("pointerenter", () => this.show(setting));
    element.addEventListener("focus", () => this.show(setting));
    element.addEventListener("click", () => this.onChoose(setting.name));
    this.points.set(setting.name, element);
    return element;
  }

  /** What matters most is drawn last. */
  inLayers() {
    const layer = (setting) => 2 * this.front.includes(setting) + (setting.origin === "preset");
    return [...this.settings].sort((a, b) => layer(a) - layer(b));
  }

  /** Names of the presets beside their points; where the texts would touch, one text for all of them. */
  labels() {
    const groups = [];
    for (const setting of this.settings.filter(({ origin }) => origin === "preset")) {
      const [x, y] = this.placeOf(setting);
      const near = groups.find((group) => Math.abs(group.x - x) < 60 && Math.abs(group.y - y) < 18);
      if (near) near.names.push(setting.name);
      else groups.push({ x, y, names: [setting.name] });
    }
    return groups.map(({ x, y, names }) => {
      const atEnd = x > this.area.right - 90;
      return draw("text", { class: "label", x: atEnd ? x - 10 : x + 10, y: y < 40 ? y + 20 : y - 8, "text-anchor": atEnd ? "end" : "start" }, names.join(", "));
    });
  }

  showLegend() {
    const knob = this.trade.knobs.find(({ name }) => name === this.knob);
    this.legend.replaceChildren(...(knob?.values ?? []).map(({ name }, i) => {
      const sample = make("span", { class: "swatch", "aria-hidden": "true" });
      sample.style.background = stepColor(i, knob.values.length);
      return make("span", {}, sample, ` ${name}`);
    }));
  }

  /** Rings the setting that is shown in full, and lets Tab reach it. */
  mark(name) {
    this.chosen = name;
    for (const [other, element] of this.points) {
      element.classList.toggle("chosen", other === name);
      element.setAttribute("tabindex", -1);
    }
    const reached = this.points.get(name) ?? this.points.get(this.order[0]?.name);
    reached?.setAttribute("tabindex", 0);
  }

  typed(event) {
    const name = event.target.closest("g")?.dataset.name;
    const at = this.order.findIndex((setting) => setting.name === name);
    if (at < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
    const last = this.order.length - 1;
    const next = { ArrowRight: Math.min(at + 1, last), ArrowLeft: Math.max(at - 1, 0), Home: 0, End: last }[event.key];
    if (next !== undefined) this.points.get(this.order[next].name).focus();
    else if (event.key === "Enter" || event.key === " ") this.onChoose(name);
    else return;
    event.preventDefault();
  }

  hide() {
    this.pointed = null;
    byId("card").hidden = true;
  }

  show(setting) {
    this.pointed = setting;
    const card = byId("card");
    const [x] = this.placeOf(setting);
    const width = this.area.right;
    const [side, other] = x < width / 2 ? ["left", "right"] : ["right", "left"];
    card.style[side] = `${(side === "left" ? x : width - x) + 24}px`;
    card.style[other] = "auto";
    const { rmse, p99, max, flip } = setting.error;
    const pictures = make("div", { class: "card-pictures" });
    card.replaceChildren(
      make("strong", {}, setting.name),
      make("p", {}, `${timeText(setting.wall.total)} of the clock, ${timeText(setting.cpu.total)} of processors`),
      make("p", {}, `RMSE ${errorText(rmse)}, p99 ${errorText(p99)}, max ${errorText(max)}, FLIP ${errorText(flip)}`),
      setting.unstable === undefined ? "" : make("p", {}, `${setting.unstable.pixels} pixels move with rounding`),
      pictures,
    );
    card.hidden = false;
    this.showPictures(setting, pictures);
  }

  /** Unpacked when they are wanted for the first time; whoever has gone on does not get them. */
  async showPictures(setting, element) {
    const row = pageData.rows.find((other) => other.name === setting.name);
    const [reference, own] = row.pictures;
    if (own.picture === undefined || reference.picture === undefined) {
      element.append(make("p", { class: "hint" }, own.missing ?? reference.missing));
      return;
    }
    const [a, b] = await Promise.all([pixelsOf(reference.picture), pixelsOf(own.picture)]);
    if (this.pointed !== setting) return;
    const canvases = [canvasOf(b.width, b.height, ""), canvasOf(b.width, b.height, "")];
    drawPixels(canvases[0], b);
    new PictureDifference(a, b).draw(canvases[1], cardGain);
    element.append(...canvases);
  }
}

/** A colour for a place between cheap and exact. */
function stepColor(index, count) {
  const share = count > 1 ? index / (count - 1) : 0;
  return `oklch(${0.74 - 0.3 * share} 0.16 ${40 + 250 * share})`;
}
