// The numbers of a PNG file as they stand in it. A canvas would convert them: it knows 8 bits, one colour space and multiplied alpha.
"use strict";

function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** The bytes behind the src of an <img> with a data: URL. */
function bytesOfImage(image) {
  return bytesOfBase64(image.src.slice(image.src.indexOf(",") + 1));
}

/** Header and joined IDAT chunks. */
function pngChunks(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const parts = [];
  let header = null;
  for (let at = 8; at + 12 <= bytes.length; ) {
    const length = view.getUint32(at);
    const kind = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    const content = at + 8;
    if (kind === "IHDR")
      header = {
        width: view.getUint32(content),
        height: view.getUint32(content + 4),
        depth: bytes[content + 8],
        kind: bytes[content + 9],
        interlaced: bytes[content + 12] !== 0,
      };
    if (kind === "IDAT") parts.push(bytes.subarray(content, content + length));
    at = content + length + 4;
  }
  return { header, packed: new Blob(parts) };
}

const paeth = (a, b, c) => {
  const p = a + b - c;
  const [pa, pb, pc] = [Math.abs(p - a), Math.abs(p - b), Math.abs(p - c)];
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
};

/** What a filter predicts of a byte from those to its left, above, and above to the left (PNG specification, section 9). */
const predictions = [() => 0, (a) => a, (a, b) => b, (a, b) => (a + b) >> 1, paeth];

/** Undoes the filter of one row in place; `above` is the row above, or zeros. */
function unfilterRow(filter, row, above, step) {
  if (filter === 0) return;
  const predict = predictions[filter];
  for (let i = 0; i < Math.min(step, row.length); ++i) row[i] += predict(0, above[i], 0);
  for (let i = step; i < row.length; ++i) row[i] += predict(row[i - step], above[i], above[i - step]);
}

/** So many bytes of what is packed. A file may promise little and hold a lot. */
async function unpack(packed, size) {
  const reader = packed.stream().pipeThrough(new DecompressionStream("deflate")).getReader();
  const data = new Uint8Array(size);
  for (let at = 0; at < size; ) {
    const { done, value } = await reader.read();
    if (done) throw new Error("a PNG that ends too soon");
    data.set(value.subarray(0, size - at), at);
    at += value.length;
  }
  await reader.cancel();
  return data;
}

/**
 * Pixels of a PNG with 8 or 16 bits and no palette: {width, height, channels, depth, values, at(x, y)}. `values` are all numbers, row by
 * row from the top; `at` gives the channels of a pixel, counted from the top left. Rejects for other files, and for more than `most` pixels.
 */
async function decodePng(bytes, most = 64e6) {
  const { header, packed } = pngChunks(bytes);
  const channels = { 0: 1, 2: 3, 4: 2, 6: 4 }[header?.kind];
  if (!channels || header.interlaced || header.depth < 8) throw new Error("a kind of PNG that this page does not read");
  const { width, height, depth } = header;
  if (width === 0 || height === 0) throw new Error("a picture without pixels");
  if (width * height > most) throw new Error(`a picture of ${width} × ${height} pixels, too large for this page`);
  const step = (channels * depth) / 8;
  const length = width * step;
  const data = await unpack(packed, height * (length + 1));
  const values = depth === 8 ? new Uint8Array(width * height * channels) : new Uint16Array(width * height * channels);
  let above = new Uint8Array(length);
  for (let y = 0; y < height; ++y) {
    const start = y * (length + 1);
    const row = data.subarray(start + 1, start + 1 + length);
    unfilterRow(data[start], row, above, step);
    above = row;
    const first = y * width * channels;
    if (depth === 8) values.set(row, first);
    else for (let i = 0; i < width * channels; ++i) values[first + i] = row[2 * i] * 256 + row[2 * i + 1];
  }
  const at = (x, y) => Array.from(values.subarray((y * width + x) * channels, (y * width + x + 1) * channels));
  return { width, height, channels, depth, values, at };
}
