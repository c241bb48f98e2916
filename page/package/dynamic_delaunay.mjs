// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Delaunay triangulations of moving points: dynamic_delaunay.d.ts says what there is. Runs in browsers, workers and
// Node. The module in C++ (page/wasm) is one of three, loaded when it is needed: the plane or periodic space with the
// usual method, or both with all classifiers, repairs and policies.

const isNode = typeof process !== "undefined" && process.versions?.node !== undefined;

// All that the modules need of a system. C++ ends only where CGAL finds a defect of its own.
function systemOf(name) {
  const proc_exit = code => {
    throw new Error(`${name} has ended with code ${code}`);
  };
  return { env: { emscripten_notify_memory_growth() {} }, wasi_snapshot_preview1: { proc_exit } };
}

async function instantiate(name) {
  const url = new URL(name, import.meta.url);
  if (isNode) {
    const { readFile } = await import("node:fs/promises");
    return WebAssembly.instantiate(await readFile(url), systemOf(name));
  }
  const response = await fetch(url);
  if (!response.ok) {
    throw new Error(`${url} cannot be loaded: ${response.status} ${response.statusText}`);
  }
  return WebAssembly.instantiate(await response.arrayBuffer(), systemOf(name));
}

// A module in C++: its functions, and its memory as arrays of numbers, which are views until it grows.
class Core {
  static #loading = new Map();

  static load(name) {
    if (!Core.#loading.has(name)) {
      const loading = instantiate(name).then(({ instance }) => new Core(instance.exports));
      loading.catch(() => Core.#loading.delete(name)); // the network may be back next time
      Core.#loading.set(name, loading);
    }
    return Core.#loading.get(name);
  }

  constructor(functions) {
    this.functions = functions;
    functions._initialize();
  }

  numbers(Type, address, length) {
    return new Type(this.functions.memory.buffer, address, length);
  }

  text(address) {
    const bytes = new Uint8Array(this.functions.memory.buffer);
    return new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address)));
  }

  // Calls f with the addresses of texts.
  withTexts(texts, f) {
    const encoder = new TextEncoder();
    const addresses = texts.map(text => {
      const bytes = encoder.encode(text + "\0");
      const address = this.functions.malloc(bytes.length);
      this.numbers(Uint8Array, address, bytes.length).set(bytes);
      return address;
    });
    try {
      return f(...addresses);
    } finally {
      addresses.forEach(address => this.functions.free(address));
    }
  }

  // Calls f with the address of the numbers of a cell, which is null if there is none, and whether it is a slab.
  withCell(cell, f) {
    if (!cell) {
      return f(0, false);
    }
    const address = this.functions.malloc(4 * 8);
    this.numbers(Float64Array, address, 4).set([...cell.a, ...(cell.b ?? [0, 0])]);
    try {
      return f(address, !cell.b);
    } finally {
      this.functions.free(address);
    }
  }

  // What a function has returned, or the error that it kept.
  checked(result) {
    if (result) {
      return result;
    }
    const { dd_error_name, dd_error_message, dd_error_fields } = this.functions;
    const name = this.text(dd_error_name()), message = this.text(dd_error_message());
    if (name === "RangeError" || name === "TypeError") {
      throw new (name === "RangeError" ? RangeError : TypeError)(message);
    }
    const fields = this.text(dd_error_fields()).split("\n").filter(line => line !== "").map(line => line.split(" "));
    throw new DynamicDelaunayError(name, message,
                                   Object.fromEntries(fields.map(([key, value]) => [key, Number(value)])));
  }
}

export class DynamicDelaunayError extends Error {
  constructor(name, message, details) {
    super(message);
    this.name = name;
    this.details = details;
  }
}

const usual = { classifier: "circumcircle", repair: "", policy: "always_dynamic", padding: 1, seed: 1 };

function loadFor(options) {
  const isUsual = Object.keys(usual).every(key => options[key] === usual[key]);
  return Core.load(!isUsual ? "dynamic_delaunay_all.wasm" : options.cell ? "dynamic_delaunay_periodic.wasm"
                                                                        : "dynamic_delaunay.wasm");
}

const groups = { points: 1, duplicates: 2, edges: 3, triangles: 4, neighborLists: 5, cells: 6, voronoiEdges: 7,
                 changedEdges: 8, sets: 9, brokenEdges: 10 }; // as in bindings/Subject.h

const counts = ["classified", "padded", "border", "flips", "splices", "spliced", "enlargements", "relocated",
                "inserted", "removed", "merged", "parted"]; // as in bindings/Report_fields.h

// INPUT, which is checked here as far as C++ would not see what is wrong with it

const largestId = 2 ** 32 - 2;

function checkPairs(points) {
  if (typeof points?.length !== "number") {
    throw new TypeError("points are an array of two coordinates for each of them");
  }
  if (points.length % 2 !== 0) {
    throw new TypeError(`there are ${points.length} coordinates: give two for each point`);
  }
}

function isId(id) {
  return Number.isInteger(id) && id >= 0 && id <= largestId;
}

function checkIds(ids) {
  for (let i = 0; i < ids.length; ++i) {
    if (!isId(ids[i])) {
      throw new TypeError(`${ids[i]} is no id: ids are integers from 0 to ${largestId}`);
    }
  }
}

function checkInteger(name, value, largest) {
  if (!Number.isInteger(value) || value < 0 || value > largest) {
    throw new TypeError(`${name} is ${value}: it must be an integer from 0 to ${largest}`);
  }
}

function checkCell({ a, b = [0, 0] }) {
  for (const [name, vector] of [["a", a], ["b", b]]) {
    if (!(vector?.length === 2 && [0, 1].every(i => typeof vector[i] === "number"))) {
      throw new TypeError(`cell.${name} must be two numbers`);
    }
  }
}

function checkOptions(options) {
  const unknown = Object.keys(options).find(key => key !== "cell" && !(key in usual));
  if (unknown !== undefined) {
    throw new TypeError(`there is no option '${unknown}'; there are ${[...Object.keys(usual), "cell"].join(", ")}`);
  }
}

// Gives the memory of triangulations back that were collected as garbage.
const forgotten = new FinalizationRegistry(({ core, address }) => core.functions.dd_destroy(address));

export class Triangulation {
  #core;
  #address;
  #isPeriodic;

  static async create(points = [], options = {}) {
    checkPairs(points);
    checkOptions(options);
    const all = { ...usual };
    Object.keys(options).filter(key => options[key] !== undefined).forEach(key => { all[key] = options[key]; });
    checkInteger("padding", all.padding, 100);
    checkInteger("seed", all.seed, Number.MAX_SAFE_INTEGER);
    if (all.cell) {
      checkCell(all.cell);
    }
    const triangulation = new Triangulation(await loadFor(all), all);
    triangulation.insert(points);
    return triangulation;
  }

  static async choices() {
    const core = await Core.load("dynamic_delaunay_all.wasm");
    const choices = { classifiers: [], repairs: [], policies: "" };
    for (const line of core.text(core.functions.dd_choices()).split("\n")) {
      const [kind, name, ...rest] = line.split(" ");
      if (kind === "classifier") {
        const classifier = { name, isExact: rest[0] === "exact" };
        if (rest.length > 1) {
          classifier.parameter = { name: rest[1], usual: Number(rest[2]) };
        }
        choices.classifiers.push(classifier);
      } else if (kind === "repair") {
        choices.repairs.push(name);
      } else if (kind === "policies") {
        choices.policies = line.slice(kind.length + 1);
      }
    }
    return choices;
  }

  /** @private */
  constructor(core, { classifier, repair, policy, padding, seed, cell }) {
    this.#core = core;
    this.#isPeriodic = Boolean(cell);
    this.#address = core.withTexts([classifier, repair, policy], (...texts) =>
      core.withCell(cell, (...itsCell) =>
        core.checked(core.functions.dd_create(...texts, padding, seed, ...itsCell))));
    forgotten.register(this, { core, address: this.#address }, this);
  }

  update(points, cell) {
    if (cell) {
      if (!this.#isPeriodic) {
        throw new TypeError("a triangulation of the plane has no cell");
      }
      checkCell(cell);
    }
    this.#give(points);
    return this.#changed(this.#core.withCell(cell, (...itsCell) =>
      this.#f.dd_update(this.#address, points.length / 2, ...itsCell)));
  }

  move(ids, points) {
    if (points.length !== 2 * ids.length) {
      throw new TypeError(`there are ${ids.length} ids and ${points.length} coordinates: give two for each id`);
    }
    this.#giveIds(ids);
    this.#give(points);
    return this.#changed(this.#f.dd_move(this.#address, ids.length));
  }

  insert(points) {
    this.#give(points);
    this.#changed(this.#f.dd_insert(this.#address, points.length / 2));
    const size = points.length / 2;
    return Int32Array.from(this.#core.numbers(BigInt64Array, this.#f.dd_ids(this.#address, size), size), Number);
  }

  remove(ids) {
    this.#giveIds(ids);
    return this.#changed(this.#f.dd_remove(this.#address, ids.length));
  }

  mend() {
    return this.#changed(this.#f.dd_mend(this.#address));
  }

  certify() {
    return this.#f.dd_certify(this.#address) !== 0;
  }

  get isCertified() {
    return this.#f.dd_is_certified(this.#address) !== 0;
  }
  get isPeriodic() {
    return this.#isPeriodic;
  }
  get report() {
    const numbers = this.#core.numbers(Float64Array, this.#f.dd_counts(this.#address), counts.length);
    const reason = this.#f.dd_rebuild_reason(this.#address);
    return { ...Object.fromEntries(counts.map((name, i) => [name, numbers[i]])),
             rebuildReason: reason === 0 ? "" : this.#core.text(reason), certified: this.isCertified };
  }
  get numberOfPoints() {
    return this.#f.dd_number_of_points(this.#address);
  }
  get numberOfIds() {
    return this.#f.dd_number_of_ids(this.#address);
  }
  get numberOfVertices() {
    return this.#f.dd_number_of_vertices(this.#address);
  }
  has(id) {
    return isId(id) && this.#f.dd_has_id(this.#address, id) !== 0;
  }

  points() {
    return this.#read("points")[0];
  }
  duplicates() {
    return this.#read("duplicates")[0];
  }
  edges() {
    return this.#read("edges")[0];
  }
  triangles() {
    return this.#read("triangles")[0];
  }
  edgesWithShifts() {
    const [ids, shifts = new Int32Array()] = this.#read("edges");
    return { ids, shifts };
  }
  trianglesWithShifts() {
    const [ids, shifts] = this.#read("triangles"); // in the plane the second ones are neighbors
    return { ids, shifts: this.#isPeriodic ? shifts : new Int32Array() };
  }
  neighborLists() {
    const [begins, neighbors, shifts = new Int32Array()] = this.#read("neighborLists");
    return { begins, neighbors, shifts };
  }
  cells(box) {
    if (box) {
      if (box.length !== 4) {
        throw new TypeError("a box has four numbers: xmin, ymin, xmax, ymax");
      }
      this.#core.checked(this.#f.dd_read_clipped_cells(this.#address, ...box));
    } else {
      this.#compute("cells");
    }
    const [areas, perimeters, centroids, shapeIndices] = [0, 1, 2, 3].map(i => this.#array(i));
    return { areas, perimeters, centroids, shapeIndices };
  }
  boundedCells({ radius = Infinity, domain = [] } = {}) {
    if (typeof radius !== "number") {
      throw new TypeError("radius must be a number");
    }
    this.#give(domain);
    this.#core.checked(this.#f.dd_read_bounded_cells(this.#address, radius, domain.length / 2));
    const names = ["radii", "areas", "perimeters", "centroids", "freeLengths", "wallLengths", "begins", "sides", "others",
                   "shifts", "starts", "ends", "lengths", "angles"];
    return Object.fromEntries(names.map((name, i) => [name, this.#array(i)]));
  }
  cellCorners(id) {
    checkIds([id]);
    this.#core.checked(this.#f.dd_read_cell_corners(this.#address, id));
    return this.#array(0);
  }
  voronoiEdges() {
    const [pairs, lengths, shifts] = this.#read("voronoiEdges");
    return { pairs, lengths, shifts };
  }
  changedEdges() {
    const [created, removed, createdShifts, removedShifts] = this.#read("changedEdges");
    return { created, removed, createdShifts, removedShifts };
  }
  sets() {
    return this.#read("sets")[0];
  }
  brokenEdges() {
    const [ids, shifts] = this.#read("brokenEdges");
    return { ids, shifts };
  }

  dispose() {
    forgotten.unregister(this);
    this.#f.dd_destroy(this.#address);
    this.#address = 0;
  }

  get #f() {
    if (this.#address === 0) {
      throw new TypeError("this triangulation was disposed of");
    }
    return this.#core.functions;
  }

  #give(points) {
    checkPairs(points);
    const address = this.#core.checked(this.#f.dd_points(this.#address, points.length / 2));
    this.#core.numbers(Float64Array, address, points.length).set(points);
  }

  #giveIds(ids) {
    checkIds(ids);
    const address = this.#core.checked(this.#f.dd_ids(this.#address, ids.length));
    const buffer = this.#core.numbers(BigInt64Array, address, ids.length);
    for (let i = 0; i < ids.length; ++i) {
      buffer[i] = BigInt(ids[i]);
    }
  }

  #changed(succeeded) {
    this.#core.checked(succeeded);
    return this.report;
  }

  #compute(group) {
    return this.#core.checked(this.#f.dd_read(this.#address, groups[group]));
  }

  #read(group) {
    return Array.from({ length: this.#compute(group) }, (_, i) => this.#array(i));
  }

  // A copy, since C++ reuses its memory.
  #array(i) {
    const Type = [Int32Array, BigInt64Array, Float64Array][this.#f.dd_array_type(this.#address, i)];
    const length = this.#f.dd_array_length(this.#address, i);
    return this.#core.numbers(Type, this.#f.dd_array(this.#address, i), length).slice();
  }
}
