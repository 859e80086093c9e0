// Light as the picture's numbers show it.
"use strict";

/** The exponent to linear light; those near 1 are it. */
function exponentOf(curve) {
  return Math.abs(curve - 1) <= 0.01 ? 1 : curve;
}

function linearOf(value, curve) {
  if (curve !== "srgb") return value ** exponentOf(curve);
  return value < 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

function storedOf(linear, curve) {
  if (curve !== "srgb") return linear ** (1 / exponentOf(curve));
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
}

/** What an 8-bit picture has of a channel's light, 0 to 255: by the rule of film/encode, without dithering and over black. */
function shownByte(value, { raw, working, file } = pageData.encoding) {
  const light = Math.max(Number(value) || 0, 0);
  const stored = raw || working === file ? light : storedOf(linearOf(light, working), file);
  return Math.floor(Math.fround(Math.fround(Math.min(stored, 1)) * 255) + 0.5);
}

function lightSwatch(rgb) {
  return swatch(rgb.map((value) => shownByte(value)));
}
