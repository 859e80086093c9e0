// The numbers of a PNG file as they stand in it. A canvas would convert them: it knows 8 bits, one colour space and multiplied alpha.
"use strict";

/** The bytes behind the src of an <img> with a data: URL. */
function bytesOfImage(image) {
  const binary = atob(image.src.slice(image.src.indexOf(",") + 1));
  return Uint8Array.from(binary, (char) => char.charCodeAt(0));
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

/** Undoes the filter of one row in place (PNG specification, section 9); `above` is the row above, or zeros. */
function unfilterRow(filter, row, above, step) {
  for (let i = 0; i < row.length; ++i) {
    const a = i < step ? 0 : row[i - step];
    const b = above[i];
    const c = i < step ? 0 : above[i - step];
    const p = a + b - c;
    const [pa, pb, pc] = [Math.abs(p - a), Math.abs(p - b), Math.abs(p - c)];
    const paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
    row[i] += [0, a, b, (a + b) >> 1, paeth][filter];
  }
}

/**
 * Pixels of a PNG with 8 or 16 bits and no palette: {width, height, channels, depth, at(x, y)}, where `at` gives the channels of a
 * pixel, counted from the top left. Rejects for other files.
 */
async function decodePng(bytes) {
  const { header, packed } = pngChunks(bytes);
  const channels = { 0: 1, 2: 3, 4: 2, 6: 4 }[header?.kind];
  if (!channels || header.interlaced || header.depth < 8) throw new Error("a kind of PNG that this page does not read");
  const unpacked = packed.stream().pipeThrough(new DecompressionStream("deflate"));
  const data = new Uint8Array(await new Response(unpacked).arrayBuffer());
  const size = header.depth / 8;
  const step = channels * size;
  const length = header.width * step;
  let above = new Uint8Array(length);
  const rows = [];
  for (let y = 0; y < header.height; ++y) {
    const start = y * (length + 1);
    const row = data.subarray(start + 1, start + 1 + length);
    unfilterRow(data[start], row, above, step);
    rows.push((above = row));
  }
  const at = (x, y) =>
    Array.from({ length: channels }, (_, c) => {
      const i = x * step + c * size;
      return size === 1 ? rows[y][i] : rows[y][i] * 256 + rows[y][i + 1];
    });
  return { width: header.width, height: header.height, channels, depth: header.depth, at };
}
