// The pictures of a row: side by side with their difference, over each other, and what their pixels are.
"use strict";

const gainOf = (steps) => 2 ** steps;
const modes = [["side", "Side by side"], ["wipe", "Wipe"], ["blink", "Blink"]];

function pressable(text, attributes, onPress) {
  const button = make("button", { type: "button", ...attributes }, text);
  button.addEventListener("click", onPress);
  return button;
}

/** All of what a section of pictures shows. `settings` (mode, gain, marks) stay from row to row. */
class RowPictures {
  constructor(section) {
    this.section = section;
    this.settings = { mode: "side", gainSteps: 3, marks: true };
    this.turn = 0; // how often a row was shown: what is unpacked too late is dropped
  }

  /** Resolves once the pictures are seen. */
  async show(row) {
    const turn = ++this.turn;
    this.overlay?.play(false);
    this.overlay = this.view = this.gain = null;
    this.row = row;
    this.pointed = null;
    const pictures = row.pictures ?? [];
    this.section.hidden = pictures.length === 0;
    if (pictures.length === 0) return this.section.replaceChildren();
    const found = await Promise.all(pictures.map((picture) => this.load(picture)));
    if (turn !== this.turn) return;
    this.entries = found;
    this.measure();
    this.choice = this.firstPair();
    try {
      this.build();
    } catch (error) {
      this.overlay?.play(false);
      this.section.replaceChildren(make("h3", {}, "Pictures"), make("p", { class: "missing" }, `cannot be shown: ${error.message}`));
    }
  }

  /** The size of what has room for all pictures upon each other; one that makes it too large is not shown. */
  measure() {
    [this.width, this.height] = [0, 0];
    for (const entry of this.entries.filter(({ pixels }) => pixels)) {
      const { pixels } = entry;
      const [width, height] = [Math.max(this.width, pixels.width), Math.max(this.height, pixels.height)];
      if (isShowable(width, height)) {
        [this.width, this.height] = [width, height];
      } else {
        delete entry.pixels;
        entry.problem = `cannot be shown: a picture of ${pixels.width} × ${pixels.height} pixels, too large for this page`;
      }
    }
  }

  /** The two that the row names, else the first two that there are. */
  firstPair() {
    const named = this.row.pair ?? [];
    if (named.length === 2 && named.every((index) => this.entries[index]?.pixels)) return [...named];
    return this.entries.flatMap(({ pixels }, index) => (pixels ? [index] : [])).slice(0, 2);
  }

  async load({ label, picture, missing, note }) {
    if (picture === undefined) return { label, problem: missing };
    try {
      return { label, note, pixels: await pixelsOf(picture), name: picture };
    } catch (error) {
      return { label, problem: `cannot be shown: ${error.message}` };
    }
  }

  get pair() {
    const pair = this.choice.map((index) => this.entries[index]);
    return pair.length === 2 ? pair : null;
  }

  build() {
    const seen = this.entries.filter((entry) => entry.pixels);
    const { region } = this.row;
    this.cursor = region?.pixel ?? [this.width >> 1, this.height >> 1];
    this.bar = make("div", { class: "bar" });
    this.sideBySide = make("div", { class: "panes" });
    this.over = make("div", { class: "panes over" });
    this.values = make("table", { class: "values", "aria-label": "Values of the pixel", "aria-atomic": "true" });
    this.section.replaceChildren(make("h3", {}, "Pictures"), this.bar, this.sideBySide, this.over, this.values);
    if (seen.length === 0) {
      this.bar.hidden = this.values.hidden = true;
      this.sideBySide.append(...this.entries.map((entry) => this.figure(entry, null)));
      return;
    }
    this.section.append(this.hints());
    this.fillPanes();
    this.fillBar();
    this.setMode(this.pair ? this.settings.mode : "side");
    this.showValues();
  }

  hints() {
    const texts = ["Wheel or + − 0 zoom, dragging or Shift with an arrow key moves, a click or an arrow key chooses a pixel."];
    for (const { label, note } of this.entries) if (note) texts.push(`${label}: ${note}.`);
    const [first] = this.entries.filter((entry) => entry.pixels);
    if (this.entries.some(({ pixels }) => pixels && (pixels.width !== first.pixels.width || pixels.height !== first.pixels.height)))
      texts.push("The pictures differ in size; they lie with their upper left corners on each other.");
    return make("p", { class: "hint" }, texts.join(" "));
  }

  figure(entry, content) {
    const missing = content ?? make("div", { class: "missing" }, visibleText(entry.problem ?? ""));
    const size = entry.pixels ? ` ${entry.pixels.width} × ${entry.pixels.height}` : "";
    return make("figure", {}, make("figcaption", {}, entry.label, make("span", { class: "size" }, size)), missing);
  }

  /** A pane for each picture, one for the difference, one for two pictures over each other; all of one view. */
  fillPanes() {
    const canvases = [];
    for (const entry of this.entries) {
      const canvas = entry.pixels ? canvasOf(this.width, this.height, "") : null;
      if (canvas) {
        drawPixels(canvas, entry.pixels);
        canvases.push(canvas);
        entry.canvas = canvas;
      }
      this.sideBySide.append(this.figure(entry, canvas));
    }
    if (this.pair) {
      this.difference = canvasOf(this.width, this.height, "");
      this.sideBySide.append(this.figure({ label: "Difference" }, this.difference));
      this.overlay = new PictureOverlay(this.width, this.height, this.pair.map((entry) => entry.label));
      this.over.append(this.overlay.layers[0]);
      canvases.push(this.difference, this.overlay.layers);
      this.fillPair();
    }
    this.view = new PictureView({
      images: canvases,
      width: this.width,
      height: this.height,
      label: "Picture. Arrow keys choose a pixel, plus and minus zoom.",
      onPoint: (x, y) => this.point(x === null ? null : [x, y]),
      onPick: (x, y) => this.choosePixel(x, y),
      onArrow: (dx, dy) => this.choosePixel(this.cursor[0] + dx, this.cursor[1] + dy),
      draw: (context, view) => this.drawMarks(context, view),
    });
    if (this.overlay) this.overlay.enter(this.view, this.view.panes.at(-1).element);
  }

  /** Draws what shows the two chosen pictures. */
  fillPair() {
    const [first, second] = this.pair;
    this.apart = new PictureDifference(first.pixels, second.pixels);
    this.apart.draw(this.difference, gainOf(this.settings.gainSteps));
    this.overlay.layers.forEach((layer, i) => {
      layer.getContext("2d").clearRect(0, 0, layer.width, layer.height);
      layer.getContext("2d").drawImage(this.pair[i].canvas, 0, 0);
    });
  }

  fillBar() {
    this.modeButtons = modes.map(([mode, text]) => pressable(text, { "data-mode": mode }, () => this.setMode(mode)));
    this.playButton = pressable("Pause", { class: "play" }, () => this.overlay.play(!this.overlay.playing));
    const zoom = [
      pressable("−", { "aria-label": "Zoom out" }, () => this.view.zoom(1 / 1.5)),
      pressable("+", { "aria-label": "Zoom in" }, () => this.view.zoom(1.5)),
      pressable("Fit", {}, () => this.view.fit()),
    ];
    if (this.row.region) zoom.push(pressable("Region", { class: "to-region" }, () => this.zoomToRegion()));
    const marks = make("input", { type: "checkbox" });
    marks.checked = this.settings.marks;
    marks.addEventListener("change", () => {
      this.settings.marks = marks.checked;
      this.view.show();
    });
    if (this.pair) {
      this.overlay.onPlay = (playing) => (this.playButton.textContent = playing ? "Pause" : "Play");
      this.bar.append(make("span", { role: "group", "aria-label": "View" }, this.modeButtons), this.playButton, this.pairChoice(), this.gainSlider());
    }
    this.bar.append(make("span", { role: "group", "aria-label": "Zoom" }, zoom), make("label", {}, marks, "marks"));
  }

  /** Which two are subtracted and laid over each other; where there are only two, nothing. */
  pairChoice() {
    const seen = this.entries.map((entry, index) => [entry, index]).filter(([entry]) => entry.pixels);
    if (seen.length < 3) return "";
    const selects = this.choice.map((chosen, side) => {
      const options = seen.map(([entry, index]) => make("option", { value: index }, entry.label));
      const select = make("select", { "aria-label": side === 0 ? "First picture of the pair" : "Second picture of the pair" }, options);
      select.value = chosen;
      select.addEventListener("change", () => this.choosePair(side, Number(select.value)));
      return select;
    });
    return make("span", { class: "pair" }, selects[0], " and ", selects[1]);
  }

  choosePair(side, index) {
    this.choice[side] = index;
    this.overlay.names = this.pair.map((entry) => entry.label);
    this.fillPair();
    this.overlay.show();
    this.showValues();
  }

  gainSlider() {
    const slider = make("input", { type: "range", min: 0, max: 7, step: 0.5, value: this.settings.gainSteps, class: "gain" });
    const told = make("output");
    const tell = () => (told.textContent = `× ${Math.round(gainOf(Number(slider.value)) * 10) / 10}`);
    slider.addEventListener("input", () => {
      this.settings.gainSteps = Number(slider.value);
      this.apart.draw(this.difference, gainOf(this.settings.gainSteps));
      tell();
    });
    tell();
    return (this.gain = make("label", {}, "Gain", slider, told));
  }

  setMode(mode) {
    if (this.pair) this.settings.mode = mode;
    for (const button of this.modeButtons) button.setAttribute("aria-pressed", String(button.dataset.mode === mode));
    this.sideBySide.hidden = mode !== "side";
    this.over.hidden = mode === "side";
    this.playButton.hidden = mode !== "blink";
    if (this.gain) this.gain.hidden = mode !== "side";
    this.overlay?.setMode(mode);
    this.view.resized();
    this.overlay?.show();
  }

  zoomToRegion() {
    const [x0, y0, x1, y1] = this.row.region.box;
    const [width, height] = this.view.size;
    const scale = Math.min(width / (x1 - x0 + 8), height / (y1 - y0 + 8), 32);
    const { fitScale } = this.view;
    this.view.fit();
    if (scale <= fitScale) return;
    this.view.zoom(scale / fitScale);
    const [x, y] = this.view.place((x0 + x1) / 2, (y0 + y1) / 2);
    this.view.pan(width / 2 - x, height / 2 - y);
  }

  point(pixel) {
    this.pointed = pixel;
    this.showValues();
  }

  choosePixel(x, y) {
    this.cursor = [Math.min(Math.max(x, 0), this.width - 1), Math.min(Math.max(y, 0), this.height - 1)];
    this.pointed = null;
    this.view.reveal(...this.cursor);
    this.view.show();
    this.showValues();
  }

  /** The pixel under the pointer, else the chosen one, in every picture. */
  showValues() {
    const [x, y] = this.pointed ?? this.cursor;
    this.values.setAttribute("aria-live", this.pointed ? "off" : "polite"); // a pointer is too quick to be told of
    const shown = this.entries.filter((entry) => entry.pixels);
    const mixed = new Set(shown.map(({ pixels }) => fullOf(pixels))).size > 1; // then each number says of how many
    const line = (label, numbers, full, color) => {
      const sample = color ? swatch(color) : "";
      const text = numbers === null ? "outside" : numbers.map((number) => integer.format(number)).join("  ") + (mixed ? ` of ${integer.format(full)}` : "");
      return make("td", { "data-label": label }, make("span", { class: "label" }, `${label} `), sample, make("data", { value: (numbers ?? []).join(" ") }, text));
    };
    const cells = shown.map(({ label, pixels }) => {
      const numbers = numbersAt(pixels, x, y);
      return line(label, numbers, fullOf(pixels), numbers && shownColor(pixels, numbers));
    });
    if (this.pair) {
      const [a, b] = this.pair.map((entry) => entry.pixels);
      cells.push(line("Difference", numbersApart(a, b, x, y), commonFull(a, b)));
    }
    const place = make("th", { scope: "row" }, `Pixel ${x}, ${y}`, make("span", { class: "size" }, ` from the top; ${this.height - 1 - y} from the bottom`));
    this.values.replaceChildren(make("tr", { "data-pixel": `${x},${y}` }, place, cells));
  }

  drawMarks(context, view) {
    this.overlay?.pane && this.overlay.show();
    if (!this.settings.marks) return;
    const box = (x0, y0, x1, y1, color) => {
      const [left, top] = view.place(x0, y0);
      const [right, bottom] = view.place(x1, y1);
      for (const [style, width] of [["#000b", 3.5], [color, 1.5]]) {
        context.strokeStyle = style;
        context.lineWidth = width;
        context.strokeRect(left - 2, top - 2, right - left + 4, bottom - top + 4);
      }
    };
    const { region } = this.row;
    if (region) box(...region.box, "#ff5fd2");
    const [x, y] = this.cursor;
    const more = Math.max(3 / view.scale - 0.5, 0);
    box(x - more, y - more, x + 1 + more, y + 1 + more, "#ffd23f");
  }
}

/** Numbers of a pixel as a colour on a screen. */
function shownColor(pixels, numbers) {
  const bytes = numbers.map((number) => (number * 255) / fullOf(pixels));
  return pixels.channels >= 3 ? bytes.slice(0, 3) : [bytes[0], bytes[0], bytes[0]];
}
