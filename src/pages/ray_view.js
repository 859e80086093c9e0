// The paths of a sample's rays in space, orthographic, turned by dragging or by arrow keys, moved by dragging with Shift.
"use strict";

const vec = {
  add: (a, b, s = 1) => a.map((x, i) => x + s * b[i]),
  dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
  length: (a) => Math.sqrt(vec.dot(a, a)),
  scale: (a, s) => a.map((x) => x * s),
  unit: (a) => vec.scale(a, 1 / (vec.length(a) || 1)),
  finite: (a) => a.every(Number.isFinite),
};

/** new RayView(svg, {camera, lights, onLight, onPick}): onLight(index or null), onPick(index) are told of rays in it. */
class RayView {
  constructor(svg, options) {
    Object.assign(this, { normals: true, shadows: true, magnified: 1 }, options);
    this.svg = svg;
    this.rays = [];
    this.look("oblique");
    svg.addEventListener("keydown", (event) => this.typed(event));
    svg.addEventListener("pointerdown", (event) => this.pressed(event));
    svg.addEventListener("wheel", (event) => this.wheeled(event), { passive: false });
    new ResizeObserver(() => this.draw()).observe(svg);
  }

  /** Axes of the screen in space: right, up, and into it. They begin as the camera's, so that they fit either handedness. */
  look(from) {
    const { right, up, direction } = this.camera;
    this.axes = [right, up, direction].map((axis) => vec.unit(numbers(axis)));
    const degrees = { oblique: [55, 25], side: [90, 0], top: [0, 90], camera: [0, 0] }[from];
    this.from = from;
    this.turn(...degrees.map((angle) => (angle * Math.PI) / 180));
  }

  /** About the screen's vertical axis, then about its horizontal one. */
  turn(around, over) {
    const mix = (a, b, angle) => [
      vec.add(vec.scale(a, Math.cos(angle)), b, Math.sin(angle)),
      vec.add(vec.scale(b, Math.cos(angle)), a, -Math.sin(angle)),
    ];
    let [right, up, into] = this.axes;
    [right, into] = mix(right, into, around);
    [up, into] = mix(up, into, over);
    this.axes = [right, up, into];
    this.draw();
  }

  show(rays) {
    this.rays = rays;
    this.svg.setAttribute("aria-label", `The paths of ${rays.length} rays in space. Arrow keys turn them, plus and minus zoom, 0 fits.`);
    this.fit();
  }

  /** The sphere that is seen: the points where rays that matter meet surfaces, and some space around a lone one. */
  frame() {
    const matters = (ray) => ray.hit && (ray.parent === null || ray.weight >= 0.05);
    const points = this.rays.filter(matters).map((ray) => numbers(ray.hit.point)).filter(vec.finite);
    const origin = numbers(this.rays[0].origin);
    if (points.length === 0) points.push(vec.add(origin, numbers(this.rays[0].direction)));
    const low = [0, 1, 2].map((c) => Math.min(...points.map((p) => p[c])));
    const high = [0, 1, 2].map((c) => Math.max(...points.map((p) => p[c])));
    this.middle = vec.scale(vec.add(low, high), 0.5);
    const spread = Math.max(...points.map((p) => vec.length(vec.add(p, this.middle, -1))));
    this.radius = Math.max(spread * 1.15, 0.2 * vec.length(vec.add(points[0], origin, -1)), 1e-9);
  }

  project(point) {
    const away = vec.scale(vec.add(point, this.middle, -1), this.zoomScale);
    return [this.svg.clientWidth / 2 + vec.dot(away, this.axes[0]), this.svg.clientHeight / 2 - vec.dot(away, this.axes[1])];
  }

  get zoomScale() {
    return ((Math.min(this.svg.clientWidth, this.svg.clientHeight) / 2) * this.magnified) / this.radius;
  }

  element(tag, attributes, text = null) {
    const element = document.createElementNS(this.svg.namespaceURI, tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    if (text !== null) element.textContent = text;
    return element;
  }

  line(from, to, kind) {
    const [[x1, y1], [x2, y2]] = [this.project(from), this.project(to)];
    return this.element("line", { x1, y1, x2, y2, class: kind });
  }

  /** Where a ray's line ends: at the surface, or out of sight. */
  end(ray) {
    if (ray.hit && vec.finite(numbers(ray.hit.point))) return numbers(ray.hit.point);
    const followed = ray.end === "background";
    return vec.add(numbers(ray.origin), numbers(ray.direction), (followed ? 4 : 0.35) * this.radius);
  }

  draw() {
    if (this.rays.length === 0 || this.svg.clientWidth === 0) return;
    this.named = [];
    this.groups = this.rays.map((ray, index) => this.group(ray, index));
    this.svg.replaceChildren(...this.groups, ...(this.shadows ? this.lamps() : []));
    this.light(this.lit ?? null);
  }

  group(ray, index) {
    const group = this.element("g", { class: ray.kind, "data-ray": index });
    const [from, to] = [numbers(ray.origin), this.end(ray)];
    if (ray.hit && this.shadows) group.append(...ray.hit.shadows.map((shadow) => this.toLight(to, shadow)).filter(Boolean));
    if (ray.hit && this.normals) group.append(...this.normal(to, numbers(ray.hit.normal)));
    group.append(this.line(from, to, ray.hit || ray.end === "background" ? "path" : "stub"));
    if (ray.hit) {
      const [cx, cy] = this.project(to);
      group.append(this.element("circle", { cx, cy, r: 3 }));
      group.append(this.name(cx + 6, cy + 13, index));
    }
    const reach = this.line(from, to, "reach");
    reach.addEventListener("pointerenter", () => this.onLight(index));
    reach.addEventListener("pointerleave", () => this.onLight(null));
    reach.addEventListener("click", () => this.onPick(index));
    group.append(reach);
    return group;
  }

  /** A ray's number, seen only while the ray is looked at where it would lie on another one's. */
  name(x, y, index) {
    const crowded = this.named.some(([nx, ny]) => Math.abs(nx - x) < 16 && Math.abs(ny - y) < 12);
    if (!crowded) this.named.push([x, y]);
    return this.element("text", { x, y, class: crowded ? "crowded" : "named" }, String(index + 1));
  }

  normal(point, direction) {
    const tip = vec.add(point, direction, 0.22 * this.radius);
    const line = this.line(point, tip, "normal");
    const [[x1, y1], [x2, y2]] = [this.project(point), this.project(tip)];
    const along = Math.atan2(y2 - y1, x2 - x1);
    const size = Math.min(6, Math.hypot(x2 - x1, y2 - y1) / 2);
    const corner = (angle) => `${x2 - size * Math.cos(along + angle)},${y2 - size * Math.sin(along + angle)}`;
    const head = this.element("polygon", { points: `${x2},${y2} ${corner(0.45)} ${corner(-0.45)}`, class: "normal", fill: "currentColor" });
    return [line, head];
  }

  toLight(point, shadow) {
    const light = this.lights[shadow.light];
    if (!light) return null;
    const way = light.toward ? numbers(light.toward) : vec.add(numbers(light.location), point, -1);
    const distance = light.toward ? Infinity : vec.length(way);
    const tip = vec.add(point, vec.unit(way), Math.min(distance, 8 * this.radius));
    return this.line(point, tip, shadow.hidden === shadow.samples ? "to-light hidden" : "to-light");
  }

  /** Those that the rays ask for, where they are; parallel ones are nowhere. */
  lamps() {
    const asked = new Set(this.rays.flatMap((ray) => (ray.hit ? ray.hit.shadows.map((shadow) => shadow.light) : [])));
    return [...asked].filter((i) => this.lights[i] && !this.lights[i].toward).map((i) => {
      const [cx, cy] = this.project(numbers(this.lights[i].location));
      const lamp = this.element("g", { class: "lamp" });
      lamp.append(this.element("circle", { cx, cy, r: 4.5 }), this.element("text", { x: cx, y: cy - 9, "text-anchor": "middle" }, `light ${i}`));
      return lamp;
    });
  }

  light(index) {
    this.lit = index;
    for (const [i, group] of (this.groups ?? []).entries()) {
      group.classList.toggle("lit", i === index);
      group.classList.toggle("unlit", index !== null && i !== index);
    }
  }

  /** The point of space at (x, y) from the middle of the screen, in its middle plane, comes by (x, y) nearer to the middle. */
  pan(x, y) {
    this.middle = vec.add(this.middle, this.axes[0], x / this.zoomScale);
    this.middle = vec.add(this.middle, this.axes[1], -y / this.zoomScale);
  }

  /** What is at (x, y) from the middle of the screen stays there. */
  zoom(factor, x = 0, y = 0) {
    this.pan(x, y);
    this.magnified = Math.min(Math.max(this.magnified * factor, 0.02), 1000);
    this.pan(-x, -y);
    this.draw();
  }

  fit() {
    this.magnified = 1;
    this.frame();
    this.draw();
  }

  wheeled(event) {
    event.preventDefault();
    const box = this.svg.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2];
    this.zoom(2 ** (-event.deltaY / 300), x, y);
  }

  typed(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = Math.PI / 24;
    const turn = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[event.key];
    if (turn) this.turn(...turn);
    else if (event.key === "+" || event.key === "=") this.zoom(1.25);
    else if (event.key === "-") this.zoom(0.8);
    else if (event.key === "0") this.fit();
    else return;
    event.preventDefault();
  }

  pressed(event) {
    if (event.button !== 0) return;
    let [x, y] = [event.clientX, event.clientY];
    const move = (next) => {
      if (event.shiftKey) {
        this.pan(x - next.clientX, y - next.clientY);
        this.draw();
      } else {
        this.turn((next.clientX - x) / 120, (next.clientY - y) / 120);
      }
      [x, y] = [next.clientX, next.clientY];
    };
    const end = () => {
      removeEventListener("pointermove", move);
      removeEventListener("pointerup", end);
      removeEventListener("pointercancel", end);
    };
    addEventListener("pointermove", move);
    addEventListener("pointerup", end);
    addEventListener("pointercancel", end);
  }
}
