// Logarithmic scales, numbers of time and error as text, and elements of a chart.
"use strict";

const chart = byId("chart");

/** An element of a chart; texts become text. */
function draw(tag, attributes = {}, ...children) {
  const element = document.createElementNS(chart.namespaceURI, tag);
  for (const [name, value] of Object.entries(attributes)) if (value !== null) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** Three digits and a unit that needs no exponent. */
function timeText(seconds) {
  if (seconds < 1e-3) return `${(1e6 * seconds).toPrecision(3)} µs`;
  if (seconds < 1) return `${(1e3 * seconds).toPrecision(3)} ms`;
  return `${seconds < 100 ? seconds.toPrecision(3) : Math.round(seconds)} s`;
}

/** The same without zeros behind the point. */
function timeTick(seconds) {
  return timeText(seconds).replace(/\.0+ /, " ").replace(/(\.\d*?)0+ /, "$1 ");
}

/** Without an exponent. */
function plainNumber(value) {
  return value >= 1 ? String(value) : value.toFixed(Math.min(20, Math.ceil(-Math.log10(value)))).replace(/0+$/, "");
}

function errorText(error) {
  return error === 0 ? "0" : error.toPrecision(3);
}

/** A logarithmic axis that holds all values with room around them, from `start` to `end` in the chart. Values of 0 stand at its lower end. */
class LogScale {
  constructor(values, start, end) {
    const positive = values.filter((value) => value > 0);
    const [least, most] = positive.length ? [Math.min(...positive), Math.max(...positive)] : [0.1, 1];
    const room = Math.max(0.06 * Math.log(most / least), 0.12);
    this.low = Math.log(least) - room;
    this.high = Math.log(most) + room;
    Object.assign(this, { start, end });
  }

  place(value) {
    const share = value > 0 ? (Math.log(value) - this.low) / (this.high - this.low) : 0;
    return this.start + (this.end - this.start) * Math.min(Math.max(share, 0), 1);
  }

  /** 1, 2 and 5 of every decade where labels that need this room have it, else decades, of which every second, third ... where they are many. */
  ticks(room) {
    const decade = (Math.LN10 * Math.abs(this.end - this.start)) / (this.high - this.low);
    const digits = Math.log10(2) * decade >= room ? [1, 2, 5] : [1];
    const step = Math.ceil(room / decade);
    const list = [];
    for (let power = step * Math.floor(this.low / Math.LN10 / step); power <= this.high / Math.LN10; power += step)
      for (const digit of digits) {
        const value = digit * 10 ** power;
        if (Math.log(value) >= this.low && Math.log(value) <= this.high) list.push(Number(value.toPrecision(3)));
      }
    return list;
  }
}
