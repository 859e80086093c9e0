// A sample's rays as a list that is indented like the tree, each to be opened.
"use strict";

const kindTexts = {
  camera: "camera",
  reflected: "mirrored",
  refracted: "refracted",
  straight: "straight on",
  total: "total mirror",
};
const endTexts = {
  background: "background",
  level: "not followed: as deep as rays go",
  weight: "not followed: too faint to matter",
};

/** new RayTree(list, onLight): `list` is an <ol>; onLight(index or null) is told which ray is looked at. */
class RayTree {
  constructor(list, onLight) {
    this.list = list;
    this.onLight = onLight;
  }

  /** The rays of one sample of a pixel; `samples` is how many it has. */
  show(rays, pixel, samples) {
    this.rays = rays;
    this.pixel = pixel;
    this.paths = pathFactors(rays, samples);
    this.depths = [];
    for (const ray of rays) this.depths.push(ray.parent === null ? 0 : this.depths[ray.parent] + 1);
    this.items = rays.map((ray, index) => this.item(ray, index));
    this.list.replaceChildren(...this.items);
    if (rays.length === 1) this.open(0); // of several, the list itself says most
  }

  item(ray, index) {
    const share = shareOfPixel(ray.radiance, this.paths[index], this.pixel.radiance);
    const summary = make(
      "summary",
      { "aria-label": this.spoken(ray, index, share) },
      make("span", {}, String(index + 1)),
      make("span", { class: ray.kind }, kindTexts[ray.kind]),
      make("span", { class: "target" }, this.target(ray)),
      make("span", { class: "percent" }, percentText(share)),
      shareBar(share),
      lightSwatch(ray.radiance),
    );
    const details = make("details", {}, summary);
    details.addEventListener("toggle", () => this.fill(details, ray, index));
    const item = make("li", { class: `ray ${ray.kind}`, "data-ray": index }, details);
    item.style.setProperty("--depth", this.depths[index]);
    for (const name of ["pointerenter", "focusin"]) item.addEventListener(name, () => this.onLight(index));
    for (const name of ["pointerleave", "focusout"]) item.addEventListener(name, () => this.onLight(null));
    return item;
  }

  spoken(ray, index, share) {
    const parent = ray.parent === null ? "" : `, caused by ray ${ray.parent + 1}`;
    return `Ray ${index + 1}, ${kindTexts[ray.kind]}${parent}, meets ${this.target(ray)}, ${percentText(share)} of the pixel`;
  }

  target(ray) {
    if (!ray.hit) return endTexts[ray.end];
    return `${ray.hit.type} #${ray.hit.object}${ray.hit.inside ? ", from inside" : ""}`;
  }

  /** What is not looked at is not made: a page has thousands of numbers. */
  fill(details, ray, index) {
    if (details.open && details.children.length === 1) details.append(this.body(ray, index));
  }

  open(index) {
    const details = this.items[index].firstElementChild;
    details.open = true;
    this.fill(details, this.rays[index], index);
  }

  openAll(open) {
    for (const item of this.items) item.firstElementChild.open = open;
  }

  light(index) {
    for (const [i, item] of this.items.entries()) item.classList.toggle("lit", i === index);
  }

  reveal(index) {
    this.open(index);
    this.items[index].querySelector("summary").focus({ preventScroll: true });
    this.items[index].scrollIntoView({ block: "nearest" });
  }

  body(ray, index) {
    return make(
      "div",
      { class: "body" },
      this.facts(ray, index),
      ray.hit ? this.layers(ray.hit) : null,
      ray.hit ? this.shadows(ray.hit) : null,
      this.parts(ray, index),
      ray.left_out ? make("p", { class: "note" }, `${ray.left_out} rays more below this one are not in the page: use --json.`) : null,
    );
  }

  facts(ray, index) {
    const list = make("dl", { class: "facts" });
    const fact = (name, field, ...values) => list.append(make("dt", {}, name), make("dd", { "data-field": field }, ...values));
    fact("Level", "level", countElement(ray.level), " · weight ", numberElement(ray.weight));
    if (ray.parent !== null) fact(`Factor in ray ${ray.parent + 1}`, "factor", vectorElement(ray.factor));
    if (Number(ray.exponent) !== 1) fact("Exponent", "exponent", numberElement(ray.exponent));
    fact("Factor in the pixel", "path", vectorElement(this.paths[index]));
    fact("Origin", "origin", vectorElement(ray.origin));
    fact("Direction", "direction", vectorElement(ray.direction));
    if (ray.hit) {
      fact("Meets", "object", `${ray.hit.type}, object ${ray.hit.object}, part ${ray.hit.part}, ${ray.hit.inside ? "inside" : "outside"}`);
      fact("t", "t", numberElement(ray.hit.t));
      fact("Point", "point", vectorElement(ray.hit.point));
      fact("Normal", "normal", vectorElement(ray.hit.normal));
    } else {
      fact("Ends", "end", endTexts[ray.end]);
    }
    if (ray.shares) {
      const { local, reflection, transmission } = ray.shares;
      fact("Parts", "shares", "own light ", numberElement(local), " · mirror ", numberElement(reflection), " · behind ", numberElement(transmission));
    }
    return list;
  }

  table(head, rows) {
    const cells = head.map((text) => make("th", { scope: "col" }, text));
    return make("div", { class: "wide" }, make("table", {}, make("thead", {}, make("tr", {}, cells)), make("tbody", {}, rows)));
  }

  layers(hit) {
    const rows = hit.layers.map((layer, i) =>
      make(
        "tr",
        { "data-field": "layer" },
        make("th", { scope: "row" }, i === 0 ? "top" : String(i + 1)),
        [...layer.rgb, layer.filter, layer.transmit].map((x) => make("td", {}, numberElement(x))),
        make("td", {}, lightSwatch(layer.rgb)),
      ),
    );
    return make("div", {}, make("h3", {}, "Colours of the pattern"), this.table(["layer", "red", "green", "blue", "filter", "transmit", ""], rows));
  }

  shadows(hit) {
    if (hit.shadows.length === 0) return null;
    const items = hit.shadows.map((shadow) => {
      const crossed = shadow.crossed.length === 0 ? "" : `, through ${shadow.crossed.map((object) => `#${object}`).join(", ")}`;
      const arrives = numbers(shadow.transmitted);
      const tinted = arrives.some((x) => x !== 1) && arrives.some((x) => x !== 0);
      return make(
        "li",
        { "data-field": "shadow" },
        `Light ${shadow.light}: ${this.answer(shadow)}${crossed}`,
        tinted ? make("span", {}, " · ", vectorElement(shadow.transmitted), " ", lightSwatch(arrives)) : null,
      );
    });
    return make("div", {}, make("h3", {}, "Rays to lights"), make("ul", {}, items));
  }

  answer({ samples, hidden, transmitted }) {
    if (samples > 1 && hidden > 0 && hidden < samples) return `${samples - hidden} of its ${samples} samples arrive`;
    if (hidden === samples) return "hidden";
    return numbers(transmitted).every((x) => x === 1) ? "arrives" : "arrives weakened";
  }

  parts(ray, index) {
    const row = (name, light, kind) => {
      const share = shareOfPixel(light, this.paths[index], this.pixel.radiance);
      return make(
        "tr",
        { "data-field": name, class: kind },
        make("th", { scope: "row" }, name),
        light.map((x) => make("td", {}, numberElement(x))),
        make("td", {}, lightSwatch(light)),
        make("td", {}, shareBar(share)),
        make("td", {}, percentText(share)),
      );
    };
    const rows = contributions.map((name) => row(name, ray[name], null));
    rows.push(row("radiance", ray.radiance, "sum"));
    const table = this.table(["light", "red", "green", "blue", "", "of the pixel", ""], rows);
    return make("div", {}, make("h3", {}, "What the ray brings"), table);
  }
}
