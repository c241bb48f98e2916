// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plays a scenario beside the page, which tells it { name, ... } of what is below, one after the other, and is told
// { name: "frame", ... }, { name: "choices", ... } or { name: "refused", message } .

import { Triangulation } from "../package/dynamic_delaunay.mjs";
import { buffersOf, Simulation } from "./simulation.js";

let simulation = null;
let isFirst = false; // of this scenario

const told = {
  async choices() {
    postMessage({ name: "choices", choices: await Triangulation.choices() });
  },
  async open({ settings }) {
    const next = await Simulation.open(settings);
    simulation?.close();
    simulation = next;
    isFirst = true;
    postMessage({ name: "accepted", settings });
  },
  async use({ settings }) {
    await simulation?.use(settings);
    postMessage({ name: "accepted", settings });
  },
  cells: settings => simulation?.setCells(settings),
  field: ({ gravity, wind }) => simulation?.setField(gravity, wind),
  grab: ({ x, y, id }) => simulation?.grab(x, y, id),
  drag: ({ x, y }) => simulation?.drag(x, y),
  release: () => simulation?.release(),
  add: ({ x, y }) => simulation?.add(x, y),
  remove: ({ id }) => simulation?.remove(id),
  move: ({ x }) => simulation?.moveTo(x),
  frame({ steps, wanted }) {
    simulation?.advance(steps);
    if (!simulation) {
      postMessage({ name: "frame" });
      return;
    }
    const frame = simulation.frame(wanted);
    postMessage({ name: "frame", isFirst, ...frame }, buffersOf(frame));
    isFirst = false;
  },
};

let last = Promise.resolve();
onmessage = ({ data }) => {
  last = last.then(() => told[data.name](data)).catch(error => {
    postMessage({ name: "refused", of: data.name, message: error.message });
  });
};
