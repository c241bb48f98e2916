// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Delaunay triangulations of moving points: dynamic_delaunay.d.ts says what there is. Runs in browsers, workers and
// Node. The module in C++ (wasm) is one of three, loaded when it is needed: the plane or periodic space with the
// usual method, or both with all classifiers, repairs and policies.

export class DynamicDelaunayError extends Error {
  constructor(name, message, details = {}, options = {}) {
    super(message, options);
    this.name = name;
    this.details = details;
  }
}

function refuse(name, message, details, options) {
  throw new DynamicDelaunayError(name, message, details, options);
}

// THE MODULES. Bundlers find each file by such an expression alone, written out.

const addresses = {
  plane: () => new URL("./dynamic_delaunay.wasm", import.meta.url),
  periodic: () => new URL("./dynamic_delaunay_periodic.wasm", import.meta.url),
  all: () => new URL("./dynamic_delaunay_all.wasm", import.meta.url),
};

const isNode = typeof process !== "undefined" && process.versions?.node !== undefined;
const nodeFiles = ["node:fs", "promises"].join("/"); // bundlers for browsers would stop at this name

// All that the modules need of a system. C++ ends only where CGAL finds a defect of its own.
const system = {
  env: { emscripten_notify_memory_growth() {} },
  wasi_snapshot_preview1: { proc_exit(code) { throw new Error(`the WebAssembly module has ended with code ${code}`); } },
};

// In Node.js an address without a protocol is a path.
async function read(address) {
  const text = String(address);
  if (isNode && !/^(?!file:)[a-z][a-z\d+.-]+:/i.test(text)) {
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ nodeFiles);
    return readFile(/^file:/i.test(text) ? new URL(text) : text);
  }
  const response = await fetch(address);
  if (!response.ok) {
    refuse("ModuleError", `${text} cannot be loaded: ${response.status} ${response.statusText}`, { status: response.status });
  }
  return response.arrayBuffer();
}

function isBytes(wasm) {
  return wasm instanceof ArrayBuffer || ArrayBuffer.isView(wasm);
}

// A server may answer with a page where there is no such file, as those of bundlers do.
function checkMagic(address, bytes) {
  const begin = new Uint8Array(bytes.buffer ?? bytes, bytes.byteOffset ?? 0, Math.min(4, bytes.byteLength));
  if (String.fromCharCode(...begin) !== "\0asm") {
    refuse("ModuleError", `${address} is no WebAssembly: see that your bundler copies this file, or give the option wasm`);
  }
}

// The development server of Vite 7 moves the JavaScript of a package away from its other files.
function usualAddress(kind) {
  try {
    return new URL(addresses[kind]().href.replace("/.vite/deps/", "/dynamic-delaunay/"));
  } catch (cause) { // in a bundle that is no ES module
    return refuse("ModuleError", "a bundle without import.meta.url does not know where the WebAssembly module is: " +
                  "give the option wasm", {}, { cause });
  }
}

async function compile(wasm) {
  if (wasm instanceof WebAssembly.Module) {
    return wasm;
  }
  const bytes = isBytes(wasm) ? wasm : await read(wasm);
  checkMagic(isBytes(wasm) ? "the option wasm" : wasm, bytes);
  return WebAssembly.compile(bytes);
}

async function instantiate(wasm) {
  try {
    return new Core((await WebAssembly.instantiate(await compile(wasm), system)).exports);
  } catch (cause) {
    if (cause instanceof DynamicDelaunayError) {
      throw cause;
    }
    const where = addressOf(wasm) ?? "the option wasm";
    return refuse("ModuleError", `${where} cannot be loaded as WebAssembly: ${cause.message}`, {}, { cause });
  }
}

// The text of an address, also of a URL of another realm; undefined if it is none.
function addressOf(wasm) {
  return typeof wasm === "string" ? wasm : typeof wasm?.href === "string" ? wasm.href : undefined;
}

function checkWasm(wasm) {
  if (!(addressOf(wasm) !== undefined || isBytes(wasm) || wasm instanceof WebAssembly.Module)) {
    refuse("InputTypeError", "wasm must be an address, bytes, or a WebAssembly.Module");
  }
}

// A module in C++: its functions, and its memory as arrays of numbers, which are views until it grows.
class Core {
  static #loadedFrom = new Map(); // addresses of users
  static #loaded = new WeakMap(); // what else they give, and functions that tell the usual addresses

  // One that knows this kind of triangulation.
  static async load(kind, wasm = addresses[kind]) {
    const key = addressOf(wasm) ?? wasm;
    const cache = typeof key === "string" ? Core.#loadedFrom : Core.#loaded;
    if (!cache.has(key)) {
      cache.set(key, (async () => instantiate(wasm === addresses[kind] ? usualAddress(kind) : wasm))());
      cache.get(key).catch(() => cache.delete(key)); // the network may be back next time
    }
    const core = await cache.get(key);
    if (core.kind !== kind && core.kind !== "all") {
      refuse("ModuleError", `the option wasm is the module for '${core.kind}', and this needs the one for '${kind}' or 'all'`);
    }
    return core;
  }

  // WebAssembly's integers have a sign, but addresses and sizes have none.
  constructor(functions) {
    this.memory = functions.memory;
    this.functions = {};
    for (const [name, f] of Object.entries(functions)) {
      if (typeof f === "function") {
        this.functions[name] = (...values) => f(...values) >>> 0;
      }
    }
    if (!this.functions.dd_kind) {
      refuse("ModuleError", "the option wasm is WebAssembly, but no module of this package");
    }
    this.functions._initialize();
    this.kind = this.text(this.functions.dd_kind());
  }

  numbers(Type, address, length) {
    return new Type(this.memory.buffer, address, length);
  }

  text(address) {
    const bytes = new Uint8Array(this.memory.buffer);
    return new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address)));
  }

  allocate(size) {
    const address = this.functions.malloc(size);
    if (address === 0) {
      throw new RangeError("there is not enough memory");
    }
    return address;
  }

  // Calls f with the addresses of texts.
  withTexts(texts, f) {
    const encoder = new TextEncoder();
    const addresses = texts.map(text => {
      const bytes = encoder.encode(text + "\0");
      const address = this.allocate(bytes.length);
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
    const address = this.allocate(4 * 8);
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
    if (name === "RangeError" || name === "Error") {
      throw new (name === "RangeError" ? RangeError : Error)(message);
    }
    const fields = this.text(dd_error_fields()).split("\n").filter(line => line !== "").map(line => line.split(" "));
    return refuse(name, message, Object.fromEntries(fields.map(([key, value]) => [key, Number(value)])));
  }
}

const usual = { classifier: "circumcircle", repair: "", policy: "always_dynamic", padding: 1, seed: 1 };

function loadFor(options) {
  const isUsual = Object.keys(usual).every(key => options[key] === usual[key]);
  return Core.load(!isUsual ? "all" : options.cell ? "periodic" : "plane", options.wasm);
}

const groups = { points: 1, duplicates: 2, edges: 3, triangles: 4, neighborLists: 5, cells: 6, voronoiEdges: 7,
                 changedEdges: 8, sets: 9, brokenEdges: 10, corners: 11 }; // as in bindings/common/Subject.h

const counts = ["classified", "padded", "border", "flips", "splices", "spliced", "enlargements", "relocated",
                "inserted", "removed", "merged", "parted"]; // as in bindings/common/Report_fields.h

// INPUT, which is checked here as far as C++ would not see what is wrong with it

const largestId = 2 ** 32 - 2;
const mostPairs = 2 ** 28; // they alone would fill the memory of WebAssembly

function checkKeys(what, object, allowed) {
  if (typeof object !== "object" || object === null || typeof object.length === "number") {
    refuse("InputTypeError", `${what} must be an object with some of ${allowed.join(", ")}`);
  }
  const key = Object.keys(object).find(key => !allowed.includes(key));
  if (key !== undefined) {
    refuse("InputValueError", `there is no '${key}' in ${what}: allowed are ${allowed.join(", ")}`, { key });
  }
}

function checkNumber(what, value, details) {
  if (typeof value !== "number") {
    refuse("InputTypeError", `${what} is ${value === null ? "null" : `of type ${typeof value}`}: it must be a number`, details);
  }
  return value;
}

function isList(list) {
  return typeof list === "object" && list !== null && Number.isInteger(list.length) && list.length >= 0;
}

// Whether each is an array of its own, as others have them: [[x, y], ...].
function areRows(pairs) {
  return pairs.length > 0 && typeof pairs[0] === "object" && pairs[0] !== null;
}

function numberOfPairs(what, pairs) {
  if (!isList(pairs) || typeof pairs[0] === "bigint" || globalThis.Buffer?.isBuffer(pairs)) {
    refuse("InputTypeError", `${what} must be an array: of numbers, two for each, or of pairs [x, y]`);
  }
  const size = areRows(pairs) ? pairs.length : pairs.length / 2;
  if (!Number.isInteger(size)) {
    refuse("InputValueError", `${what} have ${pairs.length} coordinates: give two for each`, { length: pairs.length });
  }
  if (size > mostPairs) {
    throw new RangeError(`${size} ${what} are too many for the memory of WebAssembly`);
  }
  return size;
}

function writeRows(what, rows, buffer) {
  for (let i = 0; i < rows.length; ++i) {
    if (!isList(rows[i]) || rows[i].length !== 2) {
      refuse("InputValueError", `place ${i} of ${what} is no pair [x, y]`, { place: i });
    }
    buffer[2 * i] = checkNumber(`place ${i} of ${what}`, rows[i][0], { place: i });
    buffer[2 * i + 1] = checkNumber(`place ${i} of ${what}`, rows[i][1], { place: i });
  }
}

function writePairs(what, pairs, buffer) {
  if (ArrayBuffer.isView(pairs)) {
    buffer.set(pairs);
  } else if (areRows(pairs)) {
    writeRows(what, pairs, buffer);
  } else {
    for (let i = 0; i < pairs.length; ++i) {
      buffer[i] = checkNumber(`coordinate ${i} of ${what}`, pairs[i], { place: i });
    }
  }
}

// Of one id, an array or a set.
function listOfIds(ids) {
  if (typeof ids === "number") {
    return [ids];
  }
  if (isList(ids)) {
    return ids;
  }
  if (typeof ids !== "object" || ids === null || typeof ids[Symbol.iterator] !== "function") {
    refuse("InputTypeError", "ids must be an id, an array or a set");
  }
  return [...ids];
}

function isId(id) {
  return Number.isInteger(id) && id >= 0 && id <= largestId;
}

function checkId(what, id, numberOfIds) {
  checkNumber(what, id);
  if (!Number.isInteger(id)) {
    refuse("InputValueError", `${id} is no id: ids are integers`, { id });
  }
  if (!isId(id)) {
    refuse("UnknownIdError", `there is no point with id ${id}: ids are from 0 to ${largestId}`,
           { id, number_of_ids: numberOfIds });
  }
}

function checkText(name, value) {
  if (typeof value !== "string" || value.includes("\0")) {
    refuse("InputTypeError", `${name} must be a text`);
  }
}

function checkInteger(name, value, largest) {
  checkNumber(name, value);
  if (!Number.isInteger(value) || value < 0 || value > largest) {
    refuse("InputValueError", `${name} is ${value}: it must be an integer from 0 to ${largest}`, { value });
  }
}

function checkCell(cell) {
  checkKeys("cell", cell, ["a", "b"]);
  const { a, b = [0, 0] } = cell;
  for (const [name, vector] of [["a", a], ["b", b]]) {
    if (!isList(vector) || vector.length !== 2) {
      refuse("InputValueError", `cell.${name} must be two numbers`);
    }
    [0, 1].forEach(i => checkNumber(`cell.${name}[${i}]`, vector[i]));
  }
}

// With the usual values of those that are not given.
function completed(options) {
  checkKeys("options", options, [...Object.keys(usual), "cell", "wasm"]);
  const all = { ...usual };
  Object.keys(options).filter(key => options[key] !== undefined).forEach(key => { all[key] = options[key]; });
  ["classifier", "repair", "policy"].forEach(name => checkText(name, all[name]));
  checkInteger("padding", all.padding, 100);
  checkInteger("seed", all.seed, Number.MAX_SAFE_INTEGER);
  if ("cell" in all) {
    checkCell(all.cell);
  }
  if ("wasm" in all) {
    checkWasm(all.wasm);
  }
  return all;
}

const creating = Symbol("creating"); // what the constructor is for

// Gives the memory of triangulations back that were collected as garbage.
const forgotten = new FinalizationRegistry(({ core, address }) => core.functions.dd_destroy(address));

export class Triangulation {
  #core;
  #address;
  #isPeriodic;

  static async create(points = [], options = {}) {
    numberOfPairs("points", points);
    const all = completed(options);
    const triangulation = new Triangulation(creating, await loadFor(all), all);
    try {
      triangulation.insert(points);
    } catch (error) {
      triangulation.dispose(); // at once, as memory may have run out
      throw error;
    }
    return triangulation;
  }

  static async choices(options = {}) {
    checkKeys("options", options, ["wasm"]);
    if (options.wasm !== undefined) {
      checkWasm(options.wasm);
    }
    const core = await Core.load("all", options.wasm);
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

  constructor(purpose, core, options = {}) {
    if (purpose !== creating) {
      refuse("UseError", "a triangulation is made by Triangulation.create(), which waits for WebAssembly");
    }
    const { classifier, repair, policy, padding, seed, cell } = options;
    this.#core = core;
    this.#isPeriodic = Boolean(cell);
    this.#address = core.withTexts([classifier, repair, policy], (...texts) =>
      core.withCell(cell, (...itsCell) =>
        core.checked(core.functions.dd_create(...texts, padding, seed, ...itsCell))));
    forgotten.register(this, { core, address: this.#address }, this);
  }

  update(points, cell) {
    if (cell !== undefined) {
      if (!this.#isPeriodic) {
        refuse("UseError", "a triangulation of the plane has no cell");
      }
      checkCell(cell);
    }
    const size = this.#give("points", points);
    return this.#changed(this.#core.withCell(cell, (...itsCell) => this.#f.dd_update(this.#address, size, ...itsCell)));
  }

  move(ids, points) {
    const list = listOfIds(ids), size = this.#give("points", points);
    if (size !== list.length) {
      refuse("PointCountError", `there are ${list.length} ids and ${size} points: give one for each id`,
             { expected: list.length, given: size });
    }
    this.#giveIds(list);
    return this.#changed(this.#f.dd_move(this.#address, size));
  }

  insert(points) {
    const size = this.#give("points", points);
    this.#changed(this.#f.dd_insert(this.#address, size));
    return Int32Array.from(this.#core.numbers(BigInt64Array, this.#f.dd_ids(this.#address, size), size), Number);
  }

  remove(ids) {
    const list = listOfIds(ids);
    this.#giveIds(list);
    return this.#changed(this.#f.dd_remove(this.#address, list.length));
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
    return this.#read("corners")[0];
  }
  neighbors() {
    if (this.#isPeriodic) {
      refuse("UseError", "the neighbors of triangles are known in the plane alone");
    }
    this.#compute("triangles");
    return this.#array(1);
  }
  edgesWithShifts() {
    const [ids, shifts = new Int32Array()] = this.#read("edges");
    return { ids, shifts };
  }
  trianglesWithShifts() {
    const [ids, shifts] = this.#read("corners");
    return { ids, shifts };
  }
  neighborLists() {
    const [begins, neighbors, shifts] = this.#read("neighborLists");
    return { begins, neighbors, shifts };
  }
  cells(box) {
    if (box !== undefined) {
      if (!isList(box) || box.length !== 4) {
        refuse("InputValueError", "a box has four numbers: xmin, ymin, xmax, ymax");
      }
      [0, 1, 2, 3].forEach(i => checkNumber(`box[${i}]`, box[i]));
      this.#core.checked(this.#f.dd_read_clipped_cells(this.#address, ...box));
    } else {
      this.#compute("cells");
    }
    const [areas, perimeters, centroids, shapeIndices] = [0, 1, 2, 3].map(i => this.#array(i));
    return { areas, perimeters, centroids, shapeIndices };
  }
  boundedCells(bounds = {}) {
    checkKeys("bounds", bounds, ["radius", "domain"]);
    const { radius = Infinity, domain = [] } = bounds;
    checkNumber("radius", radius);
    const corners = this.#give("corners", domain);
    this.#core.checked(this.#f.dd_read_bounded_cells(this.#address, radius, corners));
    const names = ["radii", "areas", "perimeters", "centroids", "freeLengths", "wallLengths", "begins", "sides", "others",
                   "shifts", "starts", "ends", "lengths", "angles"];
    return Object.fromEntries(names.map((name, i) => [name, this.#array(i)]));
  }
  cellCorners(id) {
    checkId("the id", id, this.numberOfIds);
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
    if (this.#address !== 0) {
      forgotten.unregister(this);
      this.#f.dd_destroy(this.#address);
      this.#address = 0;
    }
  }

  get #f() {
    if (this.#address === 0) {
      refuse("UseError", "this triangulation was disposed of");
    }
    return this.#core.functions;
  }

  // Where C++ reads them; the result is their number.
  #give(what, pairs) {
    const size = numberOfPairs(what, pairs);
    const address = this.#core.checked(this.#f.dd_points(this.#address, size));
    writePairs(what, pairs, this.#core.numbers(Float64Array, address, 2 * size));
    return size;
  }

  #giveIds(ids) {
    const numberOfIds = this.numberOfIds;
    for (let i = 0; i < ids.length; ++i) {
      checkId(`place ${i} of ids`, ids[i], numberOfIds);
    }
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

// For `using`, where the language has it.
if (Symbol.dispose) {
  Object.defineProperty(Triangulation.prototype, Symbol.dispose,
                        { value: Triangulation.prototype.dispose, configurable: true, writable: true });
}
