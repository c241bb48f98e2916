// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The motion of a scenario, as `./dev run` simulates it, with hands in it.
//
//   const motion = await Motion.open(scenario, 1008);   an object as in a scenario file, and the number of points
//   motion.setField(0, -0.0005);                        acceleration; of Brownian points a drift, in spacings a step
//   motion.hold(7, x, y);                               draws point 7 to this place in the next step
//   motion.add(x, y); motion.remove(7);                 numbers of points stay
//   motion.putBack(7, x, y);                            one that was removed
//   motion.advance(edges);                              a step; edges: two numbers of points for each
//   motion.points()                                     Float64Array, a copy
//   motion.close();

import { read } from "./read.mjs";

let loaded;

async function load() {
  const module = await WebAssembly.compile(await read(new URL("motion.wasm", import.meta.url)));
  // What the standard library would ask of a system: there is none.
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = () => 52; // "not supported"
  }
  const { exports } = await WebAssembly.instantiate(module, imports);
  exports._initialize();
  return exports;
}

export class Motion {
  static async open(scenario, numberOfPoints) {
    loaded ??= load();
    return new Motion(await loaded, JSON.stringify(scenario), numberOfPoints);
  }

  constructor(wasm, text, numberOfPoints) {
    const bytes = new TextEncoder().encode(text);
    this.wasm = wasm;
    const place = wasm.motion_text(bytes.length) >>> 0; // integers have a sign here, addresses have none
    new Uint8Array(wasm.memory.buffer, place, bytes.length).set(bytes);
    this.player = wasm.motion_open(numberOfPoints);
    if (this.player === 0) {
      throw new RangeError(textAt(wasm, wasm.motion_error() >>> 0));
    }
    this.factor = wasm.motion_factor(this.player);
    this.spacing = wasm.motion_spacing(this.player);
  }

  get numberOfPoints() { return this.wasm.motion_number_of_points(this.player); }

  points() {
    return new Float64Array(this.wasm.memory.buffer, this.wasm.motion_points(this.player) >>> 0,
                            2 * this.numberOfPoints).slice();
  }

  setField(x, y) { this.wasm.motion_set_field(this.player, x, y); }
  hold(point, x, y) { this.wasm.motion_hold(this.player, this.checked(point), x, y); }
  add(x, y) { this.wasm.motion_add(this.player, x, y); }
  putBack(point, x, y) { this.wasm.motion_put_back(this.player, this.checked(point), x, y); }
  remove(point) { this.wasm.motion_remove(this.player, this.checked(point)); }

  advance(edges) {
    const place = this.wasm.motion_neighbors(this.player, edges.length / 2) >>> 0;
    new Uint32Array(this.wasm.memory.buffer, place, edges.length).set(edges);
    this.wasm.motion_advance(this.player);
  }

  close() {
    this.wasm.motion_close(this.player);
    this.player = 0;
  }

  checked(point) {
    if (!(Number.isInteger(point) && point >= 0 && point < this.numberOfPoints)) {
      throw new RangeError(`there is no point ${point}`);
    }
    return point;
  }
}

function textAt(wasm, place) {
  const bytes = new Uint8Array(wasm.memory.buffer, place);
  return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}
