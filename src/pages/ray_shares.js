// How much of a pixel each of its rays brings.
"use strict";

const contributions = ["ambient", "diffuse", "specular", "reflection", "refraction", "background"];

function sum(values) {
  return values.reduce((total, value) => total + value, 0);
}

/**
 * What a ray's radiance is multiplied by in its parent's, for each channel. A mirror with an exponent makes of radiance L the light
 * factor L^(1 / exponent): what L was multiplied by is factor L^(1 / exponent) / L.
 */
function factorInParent(ray) {
  const exponent = Number(ray.exponent);
  const radiance = numbers(ray.radiance);
  return numbers(ray.factor).map((factor, c) => {
    if (exponent === 1) return factor;
    return radiance[c] > 0 ? (factor * radiance[c] ** (1 / exponent)) / radiance[c] : 0;
  });
}

/**
 * For each ray of a sample the product of the factors on its way to the pixel, 1 / (number of samples) for the camera ray: radiance times
 * that is what the ray brings to the pixel.
 */
function pathFactors(rays, samples) {
  const paths = [];
  for (const ray of rays) {
    const factor = factorInParent(ray);
    paths.push(ray.parent === null ? factor.map((f) => f / samples) : factor.map((f, c) => f * paths[ray.parent][c]));
  }
  return paths;
}

/** The part of a pixel that light along a ray is, all channels together; NaN where the pixel is black. */
function shareOfPixel(light, path, pixel) {
  return sum(numbers(light).map((value, c) => (value === 0 ? 0 : value * path[c]))) / sum(numbers(pixel));
}
