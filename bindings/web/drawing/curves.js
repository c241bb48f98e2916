// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small line charts, one below or beside the other, over the same numbers of frames, in step with a picture: a line
// stands at the frame that is shown, and the captions say the values there, or under the pointer.
//
//   const curves = new Curves(element, [
//     { title: "time of an update", unit: "ns a point", isLogarithmic: true,
//       lines: [{ name: "dynamic", values: Float64Array }, { name: "static", values: Float64Array }] }, ...]);
//   curves.show(frame)                   puts the line there
//   curves.setValues(chart, line, values)  live: other or longer values; then curves.draw()
//   curves.palette = palettes.dark; curves.draw()
//   curves.onPick = frame => ...         a click or a drag on a chart
//
// A line may have a `color`, the name of a color of the palette or the number of one of its curves. Values that are NaN
// leave a gap. `first`: the number of the frame of the first value (0). `format`: a function from a value to text. `low`,
// `high`: ends of the scale, else those of the values. A chart with more values than pixels draws the least and the largest
// value of each pixel, so that no peak is lost.

import { palettes, preferredTheme } from "./palettes.js";

const margin = { left: 54, right: 8, top: 6, bottom: 4 };

export function shortNumber(value) {
  if (!Number.isFinite(value)) {
    return "–";
  }
  const size = Math.abs(value);
  if (size >= 1e6 || (size !== 0 && size < 1e-3)) {
    return value.toExponential(1).replace("e+", "e");
  }
  const digits = size >= 100 || Number.isInteger(value) ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
  return value.toLocaleString("en-US", { maximumFractionDigits: digits });
}

export class Curves {
  constructor(element, charts, { first = 0 } = {}) {
    this.element = element;
    this.first = first;
    this.frame = first;
    this.hovered = null;
    this.palette = palettes[preferredTheme()];
    this.onPick = null;
    this.charts = charts.map(chart => this.build(chart));
    element.classList.add("curves");
    element.replaceChildren(...this.charts.map(chart => chart.figure));
    this.requested = null;
    new ResizeObserver(() => this.requestDraw()).observe(element);
  }

  build(description) {
    const figure = document.createElement("figure");
    figure.className = "curve";
    const caption = document.createElement("figcaption");
    const title = document.createElement("b");
    title.textContent = description.title + (description.unit ? `, ${description.unit}` : "");
    const marks = description.lines.map(() => document.createElement("i"));
    const outputs = description.lines.map(() => document.createElement("output"));
    caption.append(title, ...outputs.map((output, i) => {
      const entry = document.createElement("span");
      marks[i].className = "legend-line";
      entry.className = "curve-value";
      entry.append(marks[i], output);
      return entry;
    }));
    const canvas = document.createElement("canvas");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `${title.textContent} of each frame`);
    figure.append(caption, canvas);
    const chart = { ...description, figure, canvas, marks, outputs, context: canvas.getContext("2d") };
    this.listen(chart);
    return chart;
  }

  listen(chart) {
    const { canvas } = chart;
    const frameAt = event => {
      const share = (event.offsetX - margin.left) / this.plotWidth(chart);
      return this.first + Math.round(Math.min(1, Math.max(0, share)) * Math.max(0, this.length() - 1));
    };
    canvas.addEventListener("pointermove", event => {
      this.hovered = frameAt(event);
      if (event.buttons & 1) {
        this.onPick?.(this.hovered);
      }
      this.requestDraw();
    });
    canvas.addEventListener("pointerdown", event => this.onPick?.(frameAt(event)));
    canvas.addEventListener("pointerleave", () => {
      this.hovered = null;
      this.requestDraw();
    });
  }

  length() {
    return Math.max(0, ...this.charts.flatMap(chart => chart.lines.map(line => line.values.length)));
  }

  plotWidth({ canvas }) {
    return Math.max(1, canvas.clientWidth - margin.left - margin.right);
  }

  setValues(chart, line, values) { this.charts[chart].lines[line].values = values; }

  show(frame) {
    this.frame = frame;
    this.requestDraw();
  }

  requestDraw() {
    this.requested ??= requestAnimationFrame(() => {
      this.requested = null;
      this.draw();
    });
  }

  draw() {
    this.charts.forEach(chart => this.drawChart(chart));
  }

  drawChart(chart) {
    const { canvas, context: c } = chart;
    const width = canvas.clientWidth, height = canvas.clientHeight, ratio = globalThis.devicePixelRatio || 1;
    canvas.width = Math.max(1, Math.round(width * ratio));
    canvas.height = Math.max(1, Math.round(height * ratio));
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    const scale = this.scaleOf(chart, height);
    this.drawAxis(c, chart, scale, width);
    const last = Math.max(1, this.length() - 1);
    const x = k => margin.left + k / last * this.plotWidth(chart);
    chart.lines.forEach((line, i) => {
      c.strokeStyle = this.colorOf(line, i);
      c.lineWidth = 1.4;
      this.drawLine(c, line.values, x, scale);
    });
    this.drawMark(c, x(this.frame - this.first), height, this.palette.text, 0.9);
    if (this.hovered !== null && this.hovered !== this.frame) {
      this.drawMark(c, x(this.hovered - this.first), height, this.palette.dimText, 0.7);
    }
    this.writeValues(chart);
  }

  // From values to pixels.
  scaleOf({ lines, isLogarithmic, low, high }, height) {
    let least = low ?? Infinity, largest = high ?? -Infinity;
    for (const { values } of lines) {
      for (const value of values) {
        if (Number.isFinite(value) && (!isLogarithmic || value > 0)) {
          least = Math.min(least, value);
          largest = Math.max(largest, value);
        }
      }
    }
    if (least > largest) {
      [least, largest] = [isLogarithmic ? 1 : 0, isLogarithmic ? 10 : 1];
    }
    if (least === largest) {
      largest = isLogarithmic ? 2 * least : least + (Math.abs(least) || 1);
    }
    const of = isLogarithmic ? value => Math.log10(Math.max(value, least)) : value => value;
    const room = height - margin.top - margin.bottom;
    return { least, largest, y: value => margin.top + room * (1 - (of(value) - of(least)) / (of(largest) - of(least))) };
  }

  drawAxis(c, { format = shortNumber }, { least, largest, y }, width) {
    c.globalAlpha = 1;
    c.font = "12px system-ui, sans-serif";
    c.textAlign = "right";
    c.fillStyle = this.palette.dimText;
    c.strokeStyle = this.palette.dimText;
    c.lineWidth = 0.5;
    for (const [value, baseline] of [[largest, "top"], [least, "bottom"]]) {
      c.textBaseline = baseline;
      c.fillText(format(value), margin.left - 6, y(value) + (baseline === "top" ? -4 : 4));
      c.globalAlpha = 0.6;
      c.beginPath();
      c.moveTo(margin.left, y(value));
      c.lineTo(width - margin.right, y(value));
      c.stroke();
      c.globalAlpha = 1;
    }
  }

  drawLine(c, values, x, { y }) {
    const perPixel = Math.max(1, Math.floor(values.length / Math.max(1, x(values.length - 1) - x(0))));
    let isDown = false;
    const to = (k, value) => {
      isDown ? c.lineTo(x(k), y(value)) : c.moveTo(x(k), y(value));
      isDown = true;
    };
    c.beginPath();
    for (let start = 0; start < values.length; start += perPixel) {
      let low = Infinity, high = -Infinity;
      for (let k = start; k < Math.min(start + perPixel, values.length); ++k) {
        if (Number.isFinite(values[k])) {
          low = Math.min(low, values[k]);
          high = Math.max(high, values[k]);
        }
      }
      if (low > high) {
        isDown = false;
        continue;
      }
      to(start, low);
      if (high !== low) {
        to(start, high);
      }
    }
    c.stroke();
  }

  drawMark(c, x, height, color, alpha) {
    c.globalAlpha = alpha;
    c.strokeStyle = color;
    c.lineWidth = 1;
    c.beginPath();
    c.moveTo(x, 0);
    c.lineTo(x, height);
    c.stroke();
    c.globalAlpha = 1;
  }

  colorOf({ color }, i) {
    const { curves } = this.palette;
    return typeof color === "string" ? this.palette[color] : curves[(color ?? i) % curves.length];
  }

  writeValues({ lines, marks, outputs, format = shortNumber }) {
    const at = (this.hovered ?? this.frame) - this.first;
    lines.forEach((line, i) => {
      const text = (line.name ? line.name + " " : "") + format(line.values[at] ?? NaN);
      if (outputs[i].textContent !== text) {
        outputs[i].textContent = text;
      }
      marks[i].style.background = this.colorOf(line, i);
    });
  }
}
