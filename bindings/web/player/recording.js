// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run that scenario_runner/Run_recording.cpp has written, frame by frame, as scenes that geometry.js describes. Nothing
// here decides what is an edge: all edges, triangles and sets are those of the run.
//
// The text is a JSON object with
//   name, method    what ran, and what kept the triangulation
//   numbers         how many points there were in all; each has a number
//   names           null, or what users call the points, by their ids
//   low, high       the bounds of all that is drawn
//   quantum         position = low + quantum * whole numbers
//   speedScale      the speed that has the last color
//   cells           null, or the cell of each frame, null where it is that of the frame before
//   columns         arrays with a value for each frame
//   positions, changes   bytes in base64: whole numbers of seven bits a byte, the lowest first; the sign of one with a
//                   sign is its lowest bit
// `positions` has for each frame and each point that is there, by ascending number, how far it has moved along x and y; a
// new one from low. `changes` has for each frame the points that go (a list), how many come, and their ids; the edges that
// go (a list of places in the ascending list of edges) and those that come; the edges that are not Delaunay (a list of
// places); the triangles that go and come, in the same way; the points whose set changes (a list), and their new sets. A
// list is its length and the differences of ascending numbers.

export class Bytes {
  constructor(text) {
    const letters = atob(text);
    this.values = Uint8Array.from(letters, letter => letter.charCodeAt(0));
    this.at = 0;
  }

  // Beyond 32 bits as well.
  next() {
    let value = 0, unit = 1, byte;
    do {
      byte = this.values[this.at++];
      value += (byte & 127) * unit;
      unit *= 128;
    } while (byte & 128);
    return value;
  }

  nextSigned() {
    const value = this.next();
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }

  nextList() {
    const list = new Uint32Array(this.next());
    let value = 0;
    for (let i = 0; i !== list.length; ++i) {
      value += this.next();
      list[i] = value;
    }
    return list;
  }
}

// Tuples of numbers, so many in each, in ascending order; the first `corners` of a tuple are points.
class Tuples {
  constructor(values, size, corners) {
    this.values = values;
    this.size = size;
    this.corners = corners;
  }

  get length() { return this.values.length / this.size; }

  nextAdded(bytes) {
    const { size, corners } = this;
    const added = new Int32Array(size * bytes.next());
    let first = 0;
    for (let i = 0; i !== added.length; i += size) {
      first += bytes.next();
      added[i] = first;
      for (let k = 1; k !== size; ++k) {
        added[i + k] = bytes.nextSigned() + (k < corners ? first : 0);
      }
    }
    return new Tuples(added, size, corners);
  }

  at(places) {
    const chosen = new Int32Array(this.size * places.length);
    places.forEach((place, i) => chosen.set(this.values.subarray(this.size * place, this.size * (place + 1)), this.size * i));
    return new Tuples(chosen, this.size, this.corners);
  }

  isBefore(i, other, j) {
    for (let k = 0; k !== this.size; ++k) {
      const difference = this.values[i * this.size + k] - other.values[j * this.size + k];
      if (difference !== 0) {
        return difference < 0;
      }
    }
    return false;
  }

  // Without those at these places, and with these.
  changed(removed, added) {
    const { size } = this;
    const values = new Int32Array(this.values.length + added.values.length - size * removed.length);
    let from = 0, gone = 0, come = 0;
    for (let to = 0; to !== values.length; to += size) {
      while (gone !== removed.length && removed[gone] === from) {
        ++gone;
        ++from;
      }
      const isOld = come === added.length || (from !== this.length && this.isBefore(from, added, come));
      const source = isOld ? this : added, place = isOld ? from++ : come++;
      for (let k = 0; k !== size; ++k) {
        values[to + k] = source.values[place * size + k];
      }
    }
    return new Tuples(values, size, this.corners);
  }

  // The numbers from `first` to before `beyond` of each.
  part(first, beyond) {
    const width = beyond - first;
    const part = new Int32Array(width * this.length);
    for (let i = 0, to = 0; i !== this.values.length; i += this.size) {
      for (let k = first; k !== beyond; ++k) {
        part[to++] = this.values[i + k];
      }
    }
    return part;
  }

  get points() { return this.part(0, this.corners); }

  get shifts() { return this.size === this.corners ? undefined : this.part(this.corners, this.size); }
}

// The frame before, from which the next one is read, is never written to.
function readFrame(bytes, before, numbers) {
  const { positions, changes } = bytes;
  positions.at = before.positionsAt;
  changes.at = before.changesAt;
  const isThere = before.isThere.slice(), sets = before.sets.slice(), steps = before.steps.slice();
  for (const number of changes.nextList()) {
    isThere[number] = 0;
    sets[number] = 0;
  }
  const ids = before.ids.slice(), isNew = new Uint8Array(numbers);
  for (let come = changes.next(); come !== 0; --come) {
    isThere[ids.length] = isNew[ids.length] = 1;
    ids.push(changes.nextSigned());
  }
  const removedEdges = changes.nextList(), changed = before.edges.nextAdded(changes);
  const edges = before.edges.changed(removedEdges, changed);
  const wrong = edges.at(changes.nextList());
  const removedTriangles = changes.nextList();
  const triangles = before.triangles.changed(removedTriangles, before.triangles.nextAdded(changes));
  for (const number of changes.nextList()) {
    sets[number] = 255; // those whose set follows
  }
  for (let number = 0; number !== numbers; ++number) {
    if (sets[number] === 255) {
      sets[number] = changes.next();
    }
    if (isThere[number]) {
      steps[2 * number] += positions.nextSigned();
      steps[2 * number + 1] += positions.nextSigned();
    }
  }
  return { isThere, isNew, sets, steps, stepsBefore: before.steps, ids, edges, changed, removed: before.edges.at(removedEdges), wrong, triangles,
           positionsAt: positions.at, changesAt: changes.at };
}

const frameEveryKept = 16;

export class Recording {
  constructor(json) {
    Object.assign(this, { name: json.name, method: json.method, columns: json.columns, speedScale: json.speedScale });
    this.low = json.low;
    this.bounds = { low: json.low, high: json.high };
    this.quantum = json.quantum;
    this.numbers = json.numbers;
    this.names = json.names;
    this.length = json.columns.frame.length;
    this.bytes = { positions: new Bytes(json.positions), changes: new Bytes(json.changes) };
    this.cells = [];
    for (const cell of json.cells ?? []) {
      this.cells.push(cell ?? this.cells[this.cells.length - 1]);
    }
    const isPeriodic = this.cells.length !== 0;
    this.kept = new Map([[-1, {
      isThere: new Uint8Array(this.numbers), sets: new Uint8Array(this.numbers), steps: new Float64Array(2 * this.numbers),
      ids: [], edges: new Tuples(new Int32Array(0), isPeriodic ? 4 : 2, 2),
      triangles: new Tuples(new Int32Array(0), isPeriodic ? 7 : 3, 3), positionsAt: 0, changesAt: 0,
    }]]);
    this.last = { place: -1, frame: this.kept.get(-1) };
  }

  // Some frames are kept, so that going back does not read everything again.
  frame(place) {
    let { place: at, frame } = this.last;
    const kept = Math.max(-1, ...[...this.kept.keys()].filter(k => k <= place));
    if (at > place || kept > at) {
      at = kept;
      frame = this.kept.get(kept);
    }
    while (at !== place) {
      frame = readFrame(this.bytes, frame, this.numbers);
      ++at;
      if (at % frameEveryKept === 0) {
        this.kept.set(at, frame);
      }
    }
    this.last = { place, frame };
    return frame;
  }

  // What users call a point that is there in this frame.
  nameOf(place, number) {
    const id = this.frame(place).ids[number];
    return this.names ? this.names[id] : `${id}`;
  }

  // By the distance to the frame before, in the unit of the motion; 0 where a point is new.
  speeds(place, { isThere, isNew, steps, stepsBefore }) {
    const speeds = new Float32Array(this.numbers);
    const time = this.columns.time[place] - this.columns.time[place - 1];
    for (let i = 0; i !== this.numbers; ++i) {
      if (isThere[i] && !isNew[i]) {
        const moved = Math.hypot(steps[2 * i] - stepsBefore[2 * i], steps[2 * i + 1] - stepsBefore[2 * i + 1]);
        speeds[i] = moved * this.quantum / (time > 0 ? time : 1);
      }
    }
    return speeds;
  }

  scene(place) {
    const frame = this.frame(place);
    const { isThere, steps, sets, edges, changed, removed, wrong, triangles } = frame;
    const positions = new Float64Array(2 * this.numbers);
    for (let i = 0; i !== positions.length; ++i) {
      positions[i] = isThere[i >> 1] ? this.low[i % 2] + this.quantum * steps[i] : NaN;
    }
    const scene = {
      positions, sets, speeds: this.speeds(place, frame), speedScale: this.speedScale || 1, cell: this.cells[place],
      edges: edges.points, edgeShifts: edges.shifts, wrong: wrong.points, wrongShifts: wrong.shifts,
      triangles: triangles.points, triangleShifts: undefined, changed: new Int32Array(0), removed: new Int32Array(0),
    };
    if (place !== 0) { // of which all edges are new
      Object.assign(scene, { changed: changed.points, changedShifts: changed.shifts,
                             removed: removed.points, removedShifts: removed.shifts });
    }
    if (scene.cell) {
      const shifts = triangles.shifts; // of the second and the third corner
      scene.triangleShifts = Int32Array.from({ length: 6 * triangles.length }, (_, i) =>
        i % 6 < 2 ? 0 : shifts[4 * Math.floor(i / 6) + i % 6 - 2]);
    }
    return scene;
  }
}
