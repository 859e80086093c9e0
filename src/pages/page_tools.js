// What the scripts of all pages share: making elements, numbers as text, colours of light.
"use strict";

const pageData = JSON.parse(document.getElementById("data").textContent);

/** An element with attributes and children; texts become text, never markup. What is null is left out. */
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) if (value !== null) element.setAttribute(name, value);
  element.append(...children.flat().filter((child) => child !== null));
  return element;
}

function byId(id) {
  return document.getElementById(id);
}

/** JSON has no infinity: the data holds "Infinity", "-Infinity" and "NaN". */
function numbers(values) {
  return values.map(Number);
}

/** Five decimals where they say something; an exponent where they would not. */
function shortNumber(x) {
  if (x === 0 || !Number.isFinite(x)) return String(x);
  const size = Math.abs(x);
  return size >= 1e-4 && size < 1e6 ? x.toFixed(5) : x.toExponential(3);
}

/** A number whose `value` has every digit; `showAllDigits` chooses what is seen. */
function numberElement(x) {
  const value = Number(x);
  return make("data", { value: String(value), class: value === 0 ? "zero" : null }, allDigits ? String(value) : shortNumber(value));
}

/** A number that counts something. */
function countElement(x) {
  return make("data", { value: String(x), class: "count" }, String(x));
}

let allDigits = false;

function showAllDigits(all) {
  allDigits = all;
  for (const element of document.querySelectorAll("data:not(.count)")) {
    const value = Number(element.value);
    element.textContent = all ? String(value) : shortNumber(value);
  }
}

function vectorElement(vector) {
  return make("span", { class: "triple" }, vector.map(numberElement));
}

/** A share of 1 as percent; none where it cannot be said. */
function percentText(share) {
  if (!Number.isFinite(share)) return "–";
  const percent = 100 * share;
  if (percent !== 0 && Math.abs(percent) < 0.05) return percent < 0 ? "> −0.1 %" : "< 0.1 %";
  return `${percent.toFixed(1)} %`;
}

function shareBar(share) {
  const width = Number.isFinite(share) ? Math.min(Math.max(share, 0), 1) : 0;
  const fill = make("span");
  fill.style.width = `${100 * width}%`;
  return make("span", { class: "share", "aria-hidden": "true" }, fill);
}

function swatch(bytes) {
  const element = make("span", { class: "swatch", "aria-hidden": "true" });
  element.style.backgroundColor = `rgb(${bytes.slice(0, 3).join(" ")})`;
  return element;
}
