// The page of `pixeltrace --html`: a picture whose pixels tell of their rays.
"use strict";

const fromBottom = pageData.origin === "bottom left";
/** Rows of the picture are counted from the top, those of its pixels' names by the profile's rule; there and back is the same. */
const rowOf = (y) => (fromBottom ? pageData.height - 1 - y : y);
for (const pixel of pageData.pixels) pixel.row = rowOf(pixel.y);

const selected = { x: 0, row: 0, pixel: pageData.pixels[0], sample: 0 };
let decoded = null; // the picture's own numbers, once they are unpacked

function lightRay(index) {
  tree.light(index);
  paths.light(index);
}

const tree = new RayTree(byId("rays"), lightRay);
const paths = new RayView(byId("paths"), {
  camera: pageData.camera,
  lights: pageData.lights,
  onLight: lightRay,
  onPick: (index) => tree.reveal(index),
});
const view = new PictureView({
  images: [byId("render")],
  width: pageData.width,
  height: pageData.height,
  label: "The picture. Arrow keys select the next traced pixel.",
  onPick: select,
  onPoint: showPointer,
  onArrow: selectNext,
  draw: drawMarks,
});

function nearestPixel(x, row) {
  const squared = (pixel) => (pixel.x - x) ** 2 + (pixel.row - row) ** 2;
  return pageData.pixels.reduce((best, pixel) => (squared(pixel) < squared(best) ? pixel : best));
}

function select(x, row) {
  Object.assign(selected, { x, row, pixel: nearestPixel(x, row), sample: 0 });
  showPixel();
  showSample();
  view.show();
  showAddress();
}

let laterAddress = 0;

/** Browsers refuse more than some hundred addresses a minute, as a key that is held down asks for: then it follows later. */
function showAddress() {
  clearTimeout(laterAddress);
  try {
    history.replaceState(null, "", `#${selected.x},${rowOf(selected.row)}`);
  } catch {
    laterAddress = setTimeout(showAddress, 1000);
  }
}

/** The traced pixel that lies in a direction: near, and not far aside. */
function selectNext(dx, dy) {
  const { x, row } = selected.pixel;
  let best = null;
  for (const pixel of pageData.pixels) {
    const along = (pixel.x - x) * dx + (pixel.row - row) * dy;
    const aside = Math.abs((pixel.x - x) * dy) + Math.abs((pixel.row - row) * dx);
    if (along > 0 && aside <= along && (best === null || along + 2 * aside < best.cost)) best = { pixel, cost: along + 2 * aside };
  }
  if (best === null) return;
  select(best.pixel.x, best.pixel.row);
  view.reveal(best.pixel.x, best.pixel.row);
}

function colorText(channels) {
  return `(${channels.join(", ")})`;
}

/** The picture's own numbers of a pixel, with a swatch. */
function colorOf(x, row) {
  if (decoded === null) return ["…"];
  const channels = decoded.at(x, row);
  const bytes = decoded.depth === 8 ? channels : channels.map((value) => value >> 8);
  return [swatch(bytes), ` ${colorText(channels)}`];
}

function showPointer(x, row) {
  byId("pointer").replaceChildren(...(x === null ? [] : [`${x}, ${rowOf(row)}  `, ...colorOf(x, row)]));
}

function commandOf(x, y) {
  const words = [...pageData.command.words];
  words[pageData.command.x] = x;
  words[pageData.command.y] = y;
  return words.join(" ");
}

function distanceText(pixel) {
  const distance = Math.hypot(pixel.x - selected.x, pixel.row - selected.row);
  if (distance === 0) return "of this very pixel";
  const far = Number.isInteger(distance) ? distance : distance.toFixed(1);
  return `of the nearest traced pixel, ${pixel.x}, ${pixel.y}: ${far} ${distance === 1 ? "pixel" : "pixels"} away`;
}

function showPixel() {
  const { x, row, pixel } = selected;
  byId("pixel-name").textContent = `Pixel ${x}, ${rowOf(row)}`;
  byId("pixel-color").replaceChildren(...colorOf(x, row));
  byId("pixel-shown").textContent = distanceText(pixel);
  byId("pixel-light-name").textContent = pixel.x === x && pixel.row === row ? "Light" : "Light there";
  byId("pixel-light").replaceChildren(vectorElement(pixel.radiance), " ", lightSwatch(pixel.radiance));
  byId("pixel-command").textContent = commandOf(x, rowOf(row));
  const side = pageData.side;
  byId("sample").replaceChildren(
    ...pixel.samples.map((_, i) => make("option", { value: i }, `${i + 1}: column ${(i % side) + 1}, row ${Math.floor(i / side) + 1}`)),
  );
  byId("sample-choice").hidden = pixel.samples.length === 1;
}

/** The mean of the camera rays. */
function lightOfRays(pixel) {
  return [0, 1, 2].map((c) => sum(pixel.samples.map((rays) => Number(rays[0].radiance[c]))) / pixel.samples.length);
}

/** Does the light of its rays make the pixel? Lines over the picture and anti-aliasing that looks at neighbours say no. */
function raysMakeThePixel(pixel) {
  const light = numbers(pixel.radiance);
  return lightOfRays(pixel).every((mean, c) => Math.abs(mean - light[c]) <= 1e-5 * Math.max(Math.abs(mean), Math.abs(light[c]), 1e-30));
}

function notes(pixel) {
  const texts = [];
  if (pixel.left_out > 0) texts.push(`${pixel.left_out} rays more of this pixel are not in the page: use --json.`);
  if (!pageData.averaged) texts.push("Anti-aliasing has taken more samples than the one shown here.");
  if (!lightOfRays(pixel).every(Number.isFinite)) texts.push("The light of its rays is not a finite number: the picture has black there.");
  else if (pageData.averaged && !raysMakeThePixel(pixel)) texts.push("The pixel is not what its rays bring: a line is drawn over it.");
  return texts.join(" ");
}

function showSample() {
  const { pixel, sample } = selected;
  const rays = pixel.samples[sample];
  byId("sample").value = sample;
  byId("rays-count").textContent =
    pixel.samples.length === 1 ? `${rays.length} of pixel ${pixel.x}, ${pixel.y}` : `${rays.length} of one of ${pixel.samples.length} samples`;
  byId("rays-note").textContent = notes(pixel);
  byId("rays-note").hidden = byId("rays-note").textContent === "";
  tree.show(rays, pixel, pixel.samples.length);
  paths.show(rays);
}

function ring(context, x, y, radius, color, width) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
}

/** Dark and light, so that it is seen on every ground. */
function drawMarks(context, picture) {
  const at = (pixel) => picture.place(pixel.x + 0.5, pixel.row + 0.5);
  if (byId("marks").checked) {
    for (const pixel of pageData.pixels) {
      const [x, y] = at(pixel);
      context.fillStyle = "#0009";
      context.fillRect(x - 1.5, y - 1.5, 3, 3);
      context.fillStyle = "#fffc";
      context.fillRect(x - 0.75, y - 0.75, 1.5, 1.5);
      if (pixel.asked) {
        ring(context, x, y, 6, "#000a", 3);
        ring(context, x, y, 6, "#fff", 1.2);
      }
    }
  }
  drawSelected(context, picture.scale, at);
}

function drawSelected(context, scale, at) {
  const [x, y] = at(selected);
  const [tx, ty] = at(selected.pixel);
  const side = Math.max(scale, 7);
  for (const [color, width] of [["#000b", 3.5], ["#ffd23f", 1.5]]) {
    context.strokeStyle = color;
    context.lineWidth = width;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(tx, ty);
    context.stroke();
    context.strokeRect(x - side / 2, y - side / 2, side, side);
    ring(context, tx, ty, Math.max(scale, 10), color, width);
  }
}

function selectFragment() {
  const match = /^#(\d+),(\d+)$/.exec(location.hash);
  const [x, row] = match ? [Number(match[1]), rowOf(Number(match[2]))] : [pageData.pixels[0].x, pageData.pixels[0].row];
  if (view.contains(x, row)) select(x, row);
  else select(pageData.pixels[0].x, pageData.pixels[0].row);
}

function showHead() {
  const { scene, width, height, profile, shading, version, pixels, spacing } = pageData;
  document.title = `Pixels of ${scene}`;
  byId("scene").textContent = scene;
  const grid = spacing === 0 ? "" : `, a grid of every ${spacing === 1 ? "pixel" : `${spacing} pixels`} among them`;
  byId("about").textContent =
    `${width} × ${height} · profile ${profile} · shading ${shading} · raytrace ${version} · ` +
    `${pixels.length} ${pixels.length === 1 ? "pixel" : "pixels"} traced${grid} · counted from the ${pageData.origin}`;
}

function showLegend() {
  const used = new Set(pageData.pixels.flatMap((pixel) => pixel.samples.flat().map((ray) => ray.kind)));
  const lines = Object.keys(kindTexts).filter((kind) => used.has(kind)).map((kind) => [kind, kindTexts[kind]]);
  lines.push(["normal", "normal"], ["to-light", "light arrives"], ["hidden", "light is hidden"]);
  byId("legend").replaceChildren(...lines.map(([kind, text]) => make("li", { class: kind === "hidden" ? kind : null }, make("i", { class: kind }), text)));
}

function listen() {
  byId("zoom-in").addEventListener("click", () => view.zoom(1.5));
  byId("zoom-out").addEventListener("click", () => view.zoom(1 / 1.5));
  byId("zoom-fit").addEventListener("click", () => view.fit());
  byId("marks").addEventListener("change", () => view.show());
  byId("digits").addEventListener("change", (event) => showAllDigits(event.target.checked));
  byId("open-all").addEventListener("click", () => tree.openAll(true));
  byId("close-all").addEventListener("click", () => tree.openAll(false));
  byId("paths-in").addEventListener("click", () => paths.zoom(1.5));
  byId("paths-out").addEventListener("click", () => paths.zoom(1 / 1.5));
  byId("paths-fit").addEventListener("click", () => paths.fit());
  for (const button of document.querySelectorAll("[data-view]")) button.addEventListener("click", () => paths.look(button.dataset.view));
  byId("normals").addEventListener("change", (event) => {
    paths.normals = event.target.checked;
    paths.draw();
  });
  byId("lights").addEventListener("change", (event) => {
    paths.shadows = event.target.checked;
    paths.draw();
  });
  byId("sample").addEventListener("change", (event) => {
    selected.sample = Number(event.target.value);
    showSample();
  });
  addEventListener("hashchange", selectFragment);
}

showHead();
showLegend();
listen();
selectFragment();
decodePng(bytesOfImage(byId("render"))).then((picture) => {
  decoded = picture;
  showPixel();
  byId("sample").value = selected.sample;
  document.documentElement.dataset.ready = "";
});
