// Pictures that are looked at closely: zoomed by wheel and keys, moved by dragging, several of one size side by side that move together.
"use strict";

/**
 * new PictureView({images, width, height, label, onPick, onPoint, onArrow, draw})
 *
 * images   <img> or <canvas> elements of pictures of the same size; each is put into a pane of its own, where it stood. A list of some
 *          makes one pane with all of them over each other, where the first stood. One view is all panes': what is done to one happens in
 *          the others. Panes that are not shown follow.
 * label    what the panes are called for who does not see them
 * onPick   (x, y, pane): a pixel was clicked; pixels are counted from the top left, panes from 0
 * onPoint  (x, y, pane), or (null): the pixel under the pointer
 * onArrow  (dx, dy, pane): an arrow key without Shift; without it arrow keys move the view, as they do with Shift
 * draw     (context, view, pane): draws over a pane, in CSS pixels; view.place(x, y) is where the picture's point (x, y) is
 */
class PictureView {
  constructor(options) {
    Object.assign(this, { onPick() {}, onPoint() {}, onArrow: null, draw() {}, label: "Picture" }, options);
    this.fitted = true;
    this.scale = 1; // CSS pixels for one of the picture's
    this.left = 0; // where the picture's corner is in a pane
    this.top = 0;
    this.panes = this.images.map((layers, index) => this.makePane([layers].flat(), index));
    const observer = new ResizeObserver(() => this.resized());
    for (const pane of this.panes) observer.observe(pane.element);
  }

  makePane(layers, index) {
    const element = document.createElement("div");
    element.className = "pane";
    element.tabIndex = 0;
    element.setAttribute("role", "application");
    element.setAttribute("aria-label", this.label);
    element.style.aspectRatio = `${this.width} / ${this.height}`;
    element.style.setProperty("--aspect", this.width / this.height); // for styles that limit the height
    layers[0].replaceWith(element);
    for (const layer of layers) {
      layer.draggable = false;
      layer.classList.add("picture");
    }
    const canvas = document.createElement("canvas");
    canvas.className = "marks";
    element.append(...layers, canvas);
    this.listen(element, index);
    return { element, layers, canvas };
  }

  listen(element, index) {
    element.addEventListener("wheel", (event) => this.wheeled(event), { passive: false });
    element.addEventListener("keydown", (event) => this.typed(event, index));
    element.addEventListener("pointerdown", (event) => this.pressed(event, index));
    element.addEventListener("pointermove", (event) => {
      const [x, y] = this.pixelAt(event);
      if (this.contains(x, y)) this.onPoint(x, y, index);
      else this.onPoint(null);
    });
    element.addEventListener("pointerleave", () => this.onPoint(null));
  }

  contains(x, y) {
    return x >= 0 && y >= 0 && x < this.width && y < this.height;
  }

  /** Where a point of the picture is in a pane. */
  place(x, y) {
    return [this.left + x * this.scale, this.top + y * this.scale];
  }

  pixelAt(event) {
    const box = event.currentTarget.getBoundingClientRect();
    const { clientLeft, clientTop } = event.currentTarget;
    return [
      Math.floor((event.clientX - box.left - clientLeft - this.left) / this.scale),
      Math.floor((event.clientY - box.top - clientTop - this.top) / this.scale),
    ];
  }

  get size() {
    const { element } = this.panes.find((pane) => pane.element.clientWidth > 0) ?? this.panes[0];
    return [element.clientWidth, element.clientHeight];
  }

  /** All of the picture is seen; above 0 where no pane is shown, too. */
  get fitScale() {
    const [width, height] = this.size;
    return Math.min(Math.max(width, 1) / this.width, Math.max(height, 1) / this.height);
  }

  fit() {
    const [width, height] = this.size;
    this.fitted = true;
    this.scale = this.fitScale;
    this.left = (width - this.width * this.scale) / 2;
    this.top = (height - this.height * this.scale) / 2;
    this.show();
  }

  /** What is in the middle stays there. */
  resized() {
    if (this.fitted) return this.fit();
    const [width, height] = this.size;
    this.left += (width - this.shown[0]) / 2;
    this.top += (height - this.shown[1]) / 2;
    this.show();
  }

  /** By a factor, about a point of the pane (its middle unless said). */
  zoom(factor, x = this.size[0] / 2, y = this.size[1] / 2) {
    const scale = Math.min(Math.max(this.scale * factor, this.fitScale), Math.max(64, 4 * this.fitScale));
    if (scale === this.fitScale) return this.fit();
    this.left = x - ((x - this.left) * scale) / this.scale;
    this.top = y - ((y - this.top) * scale) / this.scale;
    this.scale = scale;
    this.fitted = false;
    this.show();
  }

  pan(dx, dy) {
    this.left += dx;
    this.top += dy;
    this.fitted = false;
    this.show();
  }

  /** Moves the view no more than it takes to see this pixel. */
  reveal(x, y) {
    const [width, height] = this.size;
    const margin = Math.min(width, height) / 8;
    const [px, py] = this.place(x + 0.5, y + 0.5);
    if (this.fitted) return;
    const dx = Math.max(margin - px, 0) + Math.min(width - margin - px, 0);
    const dy = Math.max(margin - py, 0) + Math.min(height - margin - py, 0);
    if (dx !== 0 || dy !== 0) this.pan(dx, dy);
  }

  /** Keeps a part of the picture in sight. */
  clamp() {
    const [width, height] = this.size;
    const limit = (at, pane, picture) => Math.min(Math.max(at, pane / 2 - picture), pane / 2);
    this.left = limit(this.left, width, this.width * this.scale);
    this.top = limit(this.top, height, this.height * this.scale);
  }

  show() {
    this.clamp();
    this.shown = this.size;
    for (const [index, { element, layers, canvas }] of this.panes.entries()) {
      element.classList.toggle("crisp", this.scale * devicePixelRatio >= 1);
      for (const layer of layers) layer.style.transform = `translate(${this.left}px, ${this.top}px) scale(${this.scale})`;
      canvas.width = element.clientWidth * devicePixelRatio;
      canvas.height = element.clientHeight * devicePixelRatio;
      const context = canvas.getContext("2d");
      context.scale(devicePixelRatio, devicePixelRatio);
      this.draw(context, this, index);
    }
  }

  wheeled(event) {
    event.preventDefault();
    const box = event.currentTarget.getBoundingClientRect();
    this.zoom(2 ** (-event.deltaY / 200), event.clientX - box.left, event.clientY - box.top);
  }

  typed(event, index) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (step && this.onArrow && !event.shiftKey) this.onArrow(step[0], step[1], index);
    else if (step) this.pan(-60 * step[0], -60 * step[1]);
    else if (event.key === "+" || event.key === "=") this.zoom(1.5);
    else if (event.key === "-") this.zoom(1 / 1.5);
    else if (event.key === "0") this.fit();
    else return;
    event.preventDefault();
  }

  /** A drag moves the view; a press that goes nowhere is a click. */
  pressed(event, index) {
    if (event.button !== 0) return;
    const element = event.currentTarget;
    const picked = this.pixelAt(event);
    let [x, y] = [event.clientX, event.clientY];
    let dragged = false;
    const move = (next) => {
      if (!dragged && Math.hypot(next.clientX - x, next.clientY - y) < 4) return;
      dragged = true;
      element.classList.add("dragged");
      this.pan(next.clientX - x, next.clientY - y);
      [x, y] = [next.clientX, next.clientY];
    };
    const end = (last) => {
      for (const [name, listener] of listeners) element.removeEventListener(name, listener);
      element.classList.remove("dragged");
      if (!dragged && last.type === "pointerup" && this.contains(...picked)) this.onPick(...picked, index);
    };
    const listeners = [["pointermove", move], ["pointerup", end], ["pointercancel", end]];
    element.setPointerCapture(event.pointerId);
    for (const [name, listener] of listeners) element.addEventListener(name, listener);
  }
}
