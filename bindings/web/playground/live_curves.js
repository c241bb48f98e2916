// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves of the last frames, in step with the picture.

import { Curves } from "../drawing/curves.js";
import { delaunator } from "./opponents.js";

const shownFrames = 240;

const percent = value => Number.isFinite(value) ? (100 * value).toFixed(value < 0.1 ? 2 : 1) + " %" : "–";

// Of a time, what the opponents take; if there is no delaunator, it has no line.
const opponentLines = of => [
  { name: "anew", color: 1, of: state => of(state, state.staticTime) },
  ...(delaunator === null ? [] : [{ name: "delaunator", color: 2, of: state => of(state, state.delaunatorTime) }]),
];

// Of each line: what it shows of a frame's state.
const charts = [
  { title: "Time of an update", unit: "ns a point", isLogarithmic: true,
    lines: [{ name: "kept", of: state => state.time }, ...opponentLines((state, time) => time)] },
  { title: "Speedup over", format: value => Number.isFinite(value) ? value.toFixed(1) : "–", low: 0,
    lines: opponentLines((state, time) => time / state.time) },
  { title: "Right edges", high: 1, format: value => Number.isFinite(value) ? value.toFixed(4) : "–",
    lines: [{ of: state => 1 - state.wrong / Math.max(1, state.edges) }] },
  { title: "Share of the points", low: 0, format: percent,
    lines: ["classified", "padded", "border"].map(set =>
      ({ name: set[0].toUpperCase() + set.slice(1), color: set, of: ({ report, points }) => report[set] / points })) },
];

export class LiveCurves {
  constructor(element) {
    this.curves = new Curves(element, charts.map(chart => ({
      ...chart, lines: chart.lines.map(({ name, color }) => ({ name, color, values: new Float64Array(0) })) })));
    this.clear();
  }

  set palette(palette) {
    this.curves.palette = palette;
    this.curves.requestDraw();
  }

  clear() {
    this.values = charts.map(chart => chart.lines.map(() => []));
    this.frames = 0;
  }

  add(state) {
    ++this.frames;
    charts.forEach((chart, c) => chart.lines.forEach((line, l) => {
      const values = this.values[c][l];
      values.push(line.of(state));
      if (values.length > shownFrames) {
        values.shift();
      }
    }));
  }

  draw() {
    this.values.forEach((lines, c) => lines.forEach((values, l) => this.curves.setValues(c, l, Float64Array.from(values))));
    this.curves.charts[2].low = Math.min(0.999, ...this.values[2][0]);
    this.curves.first = this.frames - this.values[0][0].length;
    this.curves.show(this.frames - 1);
  }
}
