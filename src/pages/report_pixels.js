// Pictures of a report as numbers: unpacked when they are looked at, drawn as they are stored, and subtracted.
"use strict";

const mostPixels = 2 ** 23; // of a picture: more than 3840 by 2160
const mostSide = 32767; // as much as a canvas of every browser has
const mostUnpacked = 2 ** 28; // bytes of all pictures that are kept
const unpacked = new Map(); // the pictures looked at last, the latest at its end

const isShowable = (width, height) => Math.max(width, height) <= mostSide && width * height <= mostPixels;

/** Drops the pictures that were looked at longest ago until the others are few enough. */
function forgetOldest() {
  let bytes = 0;
  for (const [name, picture] of [...unpacked].reverse()) {
    bytes += picture.bytes;
    if (bytes > mostUnpacked) unpacked.delete(name);
  }
}

/** A promise of the pixels of a picture by its name in the page. */
function pixelsOf(name) {
  const picture = unpacked.get(name) ?? { pixels: decodePng(bytesOfBase64(byId(name).textContent), mostPixels), bytes: 0 };
  unpacked.delete(name);
  unpacked.set(name, picture);
  return picture.pixels.then((pixels) => {
    picture.bytes = pixels.values.byteLength;
    forgetOldest();
    return pixels;
  });
}

const hasAlpha = (pixels) => pixels.channels % 2 === 0;
const fullOf = (pixels) => (pixels.depth === 8 ? 255 : 65535);

/** Calls visit(i, r, g, b, a) for every pixel, in numbers from 0 to 255; grey is all three. */
function eachPixel(pixels, visit) {
  const { values, channels, width, height } = pixels;
  const scale = 255 / fullOf(pixels);
  const [green, blue] = channels >= 3 ? [1, 2] : [0, 0];
  const alpha = hasAlpha(pixels) ? channels - 1 : -1;
  for (let i = 0, at = 0; i < width * height; ++i, at += channels)
    visit(i, values[at] * scale, values[at + green] * scale, values[at + blue] * scale, alpha < 0 ? 255 : values[at + alpha] * scale);
}

function canvasOf(width, height, className) {
  const canvas = make("canvas", { class: className });
  canvas.width = width;
  canvas.height = height;
  return canvas;
}

/** Shows the numbers of a picture, whatever colour space its file states; the canvas may be larger. */
function drawPixels(canvas, pixels) {
  const image = new ImageData(pixels.width, pixels.height);
  const { data } = image;
  eachPixel(pixels, (i, r, g, b, a) => {
    data[4 * i] = r;
    data[4 * i + 1] = g;
    data[4 * i + 2] = b;
    data[4 * i + 3] = a;
  });
  canvas.getContext("2d").putImageData(image, 0, 0);
}

/** How far two pictures are apart, channel by channel, where they overlap; if the first has alpha, colours of both are multiplied by theirs. */
class PictureDifference {
  constructor(a, b) {
    this.width = Math.min(a.width, b.width);
    this.height = Math.min(a.height, b.height);
    this.apart = new Float32Array(3 * this.width * this.height);
    const byAlpha = hasAlpha(a);
    this.gather(a, 1, byAlpha);
    this.gather(b, -1, byAlpha);
    for (let i = 0; i < this.apart.length; ++i) this.apart[i] = Math.abs(this.apart[i]);
  }

  gather(pixels, sign, byAlpha) {
    const { apart, width, height } = this;
    eachPixel(pixels, (i, r, g, b, a) => {
      const x = i % pixels.width;
      const y = (i - x) / pixels.width;
      if (x >= width || y >= height) return;
      const at = 3 * (y * width + x);
      const weight = byAlpha ? (sign * a) / 255 : sign;
      apart[at] += weight * r;
      apart[at + 1] += weight * g;
      apart[at + 2] += weight * b;
    });
  }

  /** Black where they are the same. */
  draw(canvas, gain) {
    const image = new ImageData(this.width, this.height);
    const { data } = image;
    const { apart } = this;
    for (let i = 0, from = 0; i < data.length; i += 4, from += 3) {
      data[i] = gain * apart[from];
      data[i + 1] = gain * apart[from + 1];
      data[i + 2] = gain * apart[from + 2];
      data[i + 3] = 255;
    }
    canvas.getContext("2d").putImageData(image, 0, 0);
  }
}

/** The numbers of a pixel as they stand in the file; none outside of the picture. */
function numbersAt(pixels, x, y) {
  return x >= 0 && y >= 0 && x < pixels.width && y < pixels.height ? pixels.at(x, y) : null;
}

/** What the numbers of both pictures are compared in: those of the files if both count to the same, else of 65535. */
const commonFull = (a, b) => (a.depth === b.depth ? fullOf(a) : 65535);

/** What two pixels differ by, of commonFull(). */
function numbersApart(a, b, x, y) {
  const [one, other] = [numbersAt(a, x, y), numbersAt(b, x, y)];
  if (one === null || other === null) return null;
  const channels = Math.max(one.length, other.length);
  const full = commonFull(a, b);
  const wide = (pixels, numbers) => {
    const color = pixels.channels >= 3 ? numbers.slice(0, 3) : channels >= 3 ? [numbers[0], numbers[0], numbers[0]] : [numbers[0]];
    const all = channels % 2 === 0 ? [...color, hasAlpha(pixels) ? numbers.at(-1) : fullOf(pixels)] : color;
    return all.map((number) => (number * full) / fullOf(pixels));
  };
  const [wideOne, wideOther] = [wide(a, one), wide(b, other)];
  return wideOne.map((number, c) => Math.abs(number - wideOther[c]));
}
