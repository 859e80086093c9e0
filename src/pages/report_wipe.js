// Two pictures over each other in one pane: a border between them that is moved, or one after the other.
"use strict";

const blinkMilliseconds = 700;

/**
 * new PictureOverlay(names, onChange): `names` of the lower and the upper picture.
 *
 * mode "wipe": the lower picture left of the border, the upper one right of it; the border (`handle`, a slider) is dragged or moved by
 * arrow keys, Page Up and Down, Home and End. Mode "blink": one of them, in turn. `layers` are drawn on by whoever has the pixels.
 */
class PictureOverlay {
  constructor(width, height, names) {
    this.names = names;
    this.layers = [canvasOf(width, height, "lower"), canvasOf(width, height, "upper")];
    this.mode = "wipe";
    this.border = 0.5; // as a part of the pane's width
    this.upper = true; // which one is seen
    this.timer = null;
    this.handle = make("div", {
      class: "wipe",
      role: "slider",
      tabindex: 0,
      "aria-label": `Border between ${names[0]} and ${names[1]}`,
      "aria-valuemin": 0,
      "aria-valuemax": 100,
      "aria-orientation": "horizontal",
    });
    this.labels = [make("span", { class: "corner left" }), make("span", { class: "corner right" })];
    this.handle.addEventListener("keydown", (event) => this.typed(event));
    this.handle.addEventListener("pointerdown", (event) => this.pressed(event));
  }

  /** Once its layers are in a pane of `view`. */
  enter(view, pane) {
    this.view = view;
    this.pane = pane;
    pane.append(this.handle, ...this.labels);
    pane.addEventListener("keydown", (event) => {
      if (this.mode !== "blink" || event.key !== " ") return;
      event.preventDefault();
      this.play(false);
      this.swap();
    });
    this.show();
  }

  show() {
    const wiping = this.mode === "wipe";
    this.handle.hidden = !wiping;
    this.handle.style.left = `${100 * this.border}%`;
    this.handle.setAttribute("aria-valuenow", Math.round(100 * this.border));
    this.handle.setAttribute("aria-valuetext", `${Math.round(100 * this.border)} % ${this.names[0]}`);
    const place = (this.border * this.pane.clientWidth - this.view.left) / this.view.scale;
    this.layers[1].style.clipPath = wiping ? `inset(0 0 0 ${Math.min(Math.max(place, 0), this.view.width)}px)` : "none";
    this.layers[0].style.clipPath = wiping ? `inset(0 ${Math.min(Math.max(this.view.width - place, 0), this.view.width)}px 0 0)` : "none";
    this.layers[0].style.visibility = wiping || !this.upper ? "visible" : "hidden";
    this.layers[1].style.visibility = wiping || this.upper ? "visible" : "hidden";
    this.labels[0].textContent = wiping ? this.names[0] : this.names[Number(this.upper)];
    this.labels[1].textContent = wiping ? this.names[1] : "";
  }

  setMode(mode) {
    this.mode = mode;
    this.play(mode === "blink" && !matchMedia("(prefers-reduced-motion: reduce)").matches);
    this.show();
  }

  moveBorder(border) {
    this.border = Math.min(Math.max(border, 0), 1);
    this.show();
  }

  swap() {
    this.upper = !this.upper;
    this.show();
  }

  get playing() {
    return this.timer !== null;
  }

  play(playing) {
    clearInterval(this.timer);
    this.timer = playing ? setInterval(() => this.swap(), blinkMilliseconds) : null;
    this.onPlay?.(playing);
  }

  typed(event) {
    const steps = { ArrowLeft: -0.01, ArrowRight: 0.01, ArrowDown: -0.01, ArrowUp: 0.01, PageDown: -0.1, PageUp: 0.1, Home: -1, End: 1 };
    if (!(event.key in steps)) return;
    event.preventDefault();
    event.stopPropagation();
    this.moveBorder(this.border + steps[event.key]);
  }

  pressed(event) {
    if (event.button !== 0) return;
    event.stopPropagation();
    const move = (next) => {
      const box = this.pane.getBoundingClientRect();
      this.moveBorder((next.clientX - box.left - this.pane.clientLeft) / this.pane.clientWidth);
    };
    const end = () => {
      this.handle.removeEventListener("pointermove", move);
      this.handle.removeEventListener("pointerup", end);
      this.handle.removeEventListener("pointercancel", end);
    };
    this.handle.setPointerCapture(event.pointerId);
    this.handle.addEventListener("pointermove", move);
    this.handle.addEventListener("pointerup", end);
    this.handle.addEventListener("pointercancel", end);
  }
}
