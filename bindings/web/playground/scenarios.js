// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What can be played: the scenarios that `./dev run` runs as well, and the pendulum. A person may
// put any of them into the open plane, a slab or a periodic cell.

import { read } from "../motion/read.mjs";

export const scenarios = {
  dam_break: { text: "Dam break", points: 1008 },
  explosion: { text: "Explosion", points: 968 },
  spinning: { text: "Spinning", points: 800 },
  brownian: { text: "Brownian motion", points: 2000 },
  static: { text: "Static", points: 1024 },
  pendulum: { text: "Inverted pendulum", points: 684, folder: "./" },
};

export const spaces = {
  plane: "Open plane",
  channel: "Slab: left is right",
  periodic: "Periodic cell",
};

// Where the rod of the pendulum is held, and where it ends above: in the lengths of its file.
export const pendulum = { pivot: [45, 16.5], top: [45, 39.5] };

// Gravity where a file has none, when a person turns it on; of Brownian points a drift, in mean spacings a step.
const usualGravity = { particles: 0.0005, brownian: 0.02 };

export async function loadScenario(name) {
  const address = new URL((scenarios[name].folder ?? "../scenarios/") + name + ".json", import.meta.url);
  return JSON.parse(new TextDecoder().decode(await read(address)));
}

export function usualGravityOf({ gravity }) {
  return gravity ? 1 : 0;
}

// Acceleration of `strength` 1, before the scenario is scaled.
export function gravityOf({ kind, gravity }) {
  return gravity || usualGravity[kind];
}

// Of a body, in the lengths of the file.
function sizeOf({ diameter }, { rows, columns }) {
  return [diameter * columns, diameter * rows];
}

// Round the bodies, half as wide again and as high as wide: they meet in its middle.
function inBox(scenario) {
  if (scenario.box) {
    return scenario;
  }
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (const body of scenario.bodies) {
    const size = sizeOf(scenario, body);
    for (const axis of [0, 1]) {
      low[axis] = Math.min(low[axis], body.position[axis]);
      high[axis] = Math.max(high[axis], body.position[axis] + size[axis]);
    }
  }
  const side = 1.5 * Math.max(high[0] - low[0], high[1] - low[1]);
  const moved = ([x, y]) => [x + (side - low[0] - high[0]) / 2, y + (side - low[1] - high[1]) / 2];
  return { ...scenario, box: [side, side],
           bodies: scenario.bodies.map(body => ({ ...body, position: moved(body.position) })) };
}

// The description of a scenario as a person wants it.
export function described(scenario, { space, seed }) {
  const cell = space === "plane" ? "closed" : space;
  return { ...(space === "plane" ? scenario : inBox(scenario)), cell, seed };
}
