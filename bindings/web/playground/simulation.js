// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scenario that is played: its motion, the triangulation that follows it, and hands in it. Knows no page; a worker of
// the page owns it.
//
//   const simulation = await Simulation.open(settings);    settings.js
//   simulation.setField(gravity, wind);                    gravity in that of the scenario
//   simulation.grab(x, y, id); simulation.drag(x, y); simulation.release();
//   simulation.add(x, y); simulation.remove(id);
//   simulation.moveTo(x);                                  the hand of the pendulum
//   simulation.setCells({ cellRadius, wallBelow, wallAbove });   where bounded cells end: in spacings; the ends of the wall
//   simulation.advance(2);                                 steps; the triangulation follows each of them
//   simulation.frame({ triangles: true, cells: true })     { scene, state }: what is shown, and what is said of it
//   await simulation.use(settings);                        another classifier, repair, ... from now on

import { boundedSegments } from "../drawing/geometry.js";
import { Motion } from "../motion/motion.mjs";
import { Triangulation } from "../package/dynamic_delaunay.mjs";
import { delaunator } from "./opponents.js";
import { described, gravityOf, loadScenario, pendulum, usualGravityOf } from "./scenarios.js";

const updatesOfMean = { kept: 16, anew: 4 };
const stepsBetweenComparisons = 16; // triangulating anew takes many times as long
const reachOfHand = 2.5;       // in spacings, round the point that is grabbed

// The mean of the middle half of the last values: clocks of browsers are too coarse for one update, and sometimes a
// computer does something else in between.
class RecentMean {
  constructor(length) {
    this.values = new Float64Array(length);
    this.number = 0;
  }
  add(value) { this.values[this.number++ % this.values.length] = value; }
  get mean() {
    const sorted = this.values.slice(0, Math.min(this.number, this.values.length)).sort();
    const quarter = Math.floor(sorted.length / 4);
    const middle = sorted.subarray(quarter, sorted.length - quarter);
    return middle.reduce((sum, value) => sum + value, 0) / middle.length;
  }
}

// It leaves its class in the global object, as it is no module.
async function loadOpponents() {
  if (delaunator !== null && !globalThis.Delaunator) {
    await import(delaunator);
  }
}

// What the package is told; what is "" is left to it.
function optionsOf({ classifier, parameter, padding, repair, policy, seed }, cell) {
  const options = { classifier: parameter === "" ? classifier : `${classifier}:${parameter}`, padding, policy, seed, cell };
  if (repair !== "") {
    options.repair = repair;
  }
  return options;
}

export class Simulation {
  static async open(settings) {
    const scenario = await loadScenario(settings.scenario);
    const description = described(scenario, settings);
    const motion = await Motion.open(description, settings.points);
    const simulation = new Simulation(settings, scenario, description, motion);
    try {
      await loadOpponents();
      await simulation.use(settings);
    } catch (error) {
      simulation.close();
      throw error;
    }
    simulation.setCells(settings);
    simulation.setField(settings.gravity === "" ? usualGravityOf(scenario) : settings.gravity, settings.wind);
    return simulation;
  }

  constructor(settings, scenario, description, motion) {
    this.scenario = scenario;
    this.motion = motion;
    this.box = description.box?.map(side => side * motion.factor);
    this.periods = settings.space === "plane" ? [0, 0] : [this.box[0], settings.space === "periodic" ? this.box[1] : 0];
    this.cell = this.periods[0] === 0 ? undefined
      : { a: [this.box[0], 0], ...(this.periods[1] === 0 ? {} : { b: [0, this.box[1]] }) };
    this.removed = new Set();
    this.positions = motion.points();
    this.speeds = new Float32Array(this.positions.length / 2);
    this.speedScale = 0;
    this.held = new Map(); // ids, and where they are seen from the hand
    this.hand = [0, 0];
    this.step = 0;
    this.report = null;
    if (settings.scenario === "pendulum") {
      this.makePendulum();
    }
  }

  close() {
    this.triangulation?.dispose();
    this.static?.dispose();
    this.motion.close();
  }

  // Coincident points are allowed, and so a removed one can be anywhere until it is removed again.
  async use(settings) {
    const points = this.positions.slice();
    const present = this.anyPresent();
    for (const id of this.removed) {
      points.copyWithin(2 * id, 2 * present, 2 * present + 2);
    }
    const triangulations = [
      await Triangulation.create(points, optionsOf(settings, this.cell)),
      await Triangulation.create(points, { policy: "always_static", cell: this.cell })];
    if (this.removed.size !== 0) {
      triangulations.forEach(triangulation => triangulation.remove([...this.removed]));
    }
    this.triangulation?.dispose();
    this.static?.dispose();
    [this.triangulation, this.static] = triangulations;
    this.time = new RecentMean(updatesOfMean.kept);
    this.staticTime = new RecentMean(updatesOfMean.anew);
    this.delaunatorTime = new RecentMean(updatesOfMean.anew);
    this.report = null;
    this.edges = null;
  }

  anyPresent() {
    for (let id = 0; id !== this.positions.length / 2; ++id) {
      if (!this.removed.has(id)) {
        return id;
      }
    }
    return 0;
  }

  setField(gravity, wind) {
    const unit = gravityOf(this.scenario) / this.motion.factor;
    this.motion.setField(unit * wind, -unit * gravity);
  }

  // In the plane with a box, the right side of its cells' domain is a wall, whose ends are so far to the right: in widths.
  setCells({ cellRadius, wallBelow, wallAbove }) {
    this.cellRadius = cellRadius * this.motion.spacing;
    const [x, y] = this.box ?? [0, 0];
    this.wall = this.cell || !this.box ? null : [[wallBelow * x, 0], [wallAbove * x, y]];
  }

  // From one place to the nearest image of another.
  offset(from, to) {
    return [0, 1].map(axis => {
      const way = to[axis] - from[axis], period = this.periods[axis];
      return period === 0 ? way : way - period * Math.round(way / period);
    });
  }

  at(id) { return [this.positions[2 * id], this.positions[2 * id + 1]]; }

  // This point and those close to it follow the hand.
  grab(x, y, id) {
    this.hand = [x, y];
    this.held.clear();
    const reach = reachOfHand * this.motion.spacing;
    for (let i = 0; i !== this.positions.length / 2; ++i) {
      if (!this.removed.has(i) && (i === id || Math.hypot(...this.offset(this.at(id), this.at(i))) < reach)) {
        this.held.set(i, this.offset(this.hand, this.at(i)));
      }
    }
  }

  drag(x, y) { this.hand = [x, y]; }
  release() { this.held.clear(); }

  hold() {
    const hold = (id, place) => {
      const [dx, dy] = this.offset(this.at(id), place);
      this.motion.hold(id, this.at(id)[0] + dx, this.at(id)[1] + dy);
    };
    for (const [id, [dx, dy]] of this.held) {
      hold(id, [this.hand[0] + dx, this.hand[1] + dy]);
    }
    if (this.rod && !this.removed.has(this.rod.pivot)) {
      hold(this.rod.pivot, this.rod.place);
    }
  }

  // Points outside of walls are none of the motion's.
  add(x, y) {
    const isInside = !this.box || [x, y].every((value, axis) => this.periods[axis] !== 0 ||
                                               (value >= 0 && value <= this.box[axis]));
    if (!isInside) {
      return;
    }
    this.mendForChange();
    const [id] = this.triangulation.insert([x, y]);
    this.static.insert([x, y]);
    if (this.removed.delete(id)) { // ids of removed points are given again
      this.motion.putBack(id, x, y);
    } else {
      this.motion.add(x, y);
      const positions = new Float64Array(this.positions.length + 2), speeds = new Float32Array(this.speeds.length + 1);
      positions.set(this.positions);
      speeds.set(this.speeds);
      Object.assign(this, { positions, speeds });
    }
    this.positions.set([x, y], 2 * id);
    this.speeds[id] = 0;
    this.edges = null;
  }

  remove(id) {
    if (this.removed.has(id) || id >= this.positions.length / 2 || this.removed.size + 1 === this.positions.length / 2) {
      return;
    }
    this.mendForChange();
    this.motion.remove(id);
    this.triangulation.remove([id]);
    this.static.remove([id]);
    this.removed.add(id);
    this.held.delete(id);
    this.positions.fill(NaN, 2 * id, 2 * id + 2);
    this.edges = null;
  }

  // Points come and go in a triangulation that is Delaunay.
  mendForChange() {
    if (!this.triangulation.isCertified) {
      this.triangulation.mend();
    }
  }

  neighbors() {
    this.edges ??= this.triangulation.edgesWithShifts();
    return this.edges.ids;
  }

  advance(steps) {
    for (let k = 0; k !== steps; ++k) {
      this.hold();
      this.motion.advance(this.neighbors());
      this.takePositions();
      const start = performance.now();
      this.report = this.triangulation.update(this.positions);
      this.time.add(performance.now() - start);
      this.edges = null;
      if (this.step % stepsBetweenComparisons === 0) {
        this.compare();
      }
      ++this.step;
      this.rod?.tell();
    }
  }

  takePositions() {
    const before = this.positions;
    this.positions = this.motion.points();
    for (const id of this.removed) {
      this.positions.fill(NaN, 2 * id, 2 * id + 2);
    }
    let sum = 0, squares = 0;
    for (let i = 0; i !== this.speeds.length; ++i) {
      let dx = this.positions[2 * i] - before[2 * i], dy = this.positions[2 * i + 1] - before[2 * i + 1];
      dx -= this.periods[0] && this.periods[0] * Math.round(dx / this.periods[0]);
      dy -= this.periods[1] && this.periods[1] * Math.round(dy / this.periods[1]);
      const squared = (dx * dx + dy * dy) || 0;
      this.speeds[i] = Math.sqrt(squared);
      sum += this.speeds[i];
      squares += squared;
    }
    const mean = sum / this.speeds.length;
    const fast = mean + 2 * Math.sqrt(Math.max(0, squares / this.speeds.length - mean * mean));
    this.speedScale = Math.max(fast, 0.99 * this.speedScale); // no flicker when all slow down
  }

  compare() {
    const start = performance.now();
    this.static.update(this.positions);
    this.staticTime.add(performance.now() - start);
    if (delaunator !== null && !this.cell) { // it knows the plane alone
      this.compareWithDelaunator();
    }
  }

  // Its update() takes the same number of points as before; and it knows no points that were removed.
  compareWithDelaunator() {
    const positions = this.positions.filter(coordinate => coordinate === coordinate);
    if (this.delaunator?.coords.length !== positions.length) {
      this.delaunator = new globalThis.Delaunator(positions);
      return;
    }
    const start = performance.now();
    this.delaunator.coords.set(positions);
    this.delaunator.update();
    this.delaunatorTime.add(performance.now() - start);
  }

  makePendulum() {
    const nearest = place => {
      const [x, y] = place.map(coordinate => coordinate * this.motion.factor);
      let best = 0, least = Infinity;
      for (let i = 0; i !== this.positions.length / 2; ++i) {
        const distance = Math.hypot(this.positions[2 * i] - x, this.positions[2 * i + 1] - y);
        if (distance < least) {
          [best, least] = [i, distance];
        }
      }
      return best;
    };
    const pivot = nearest(pendulum.pivot);
    const rod = { pivot, top: nearest(pendulum.top), place: this.at(pivot), steps: 0, best: 0 };
    rod.tell = () => {
      const [dx, dy] = this.offset(this.at(rod.pivot), this.at(rod.top));
      rod.isUpright = dy > Math.abs(dx); // within 45 degrees
      rod.steps = rod.isUpright ? rod.steps + 1 : 0;
      rod.best = Math.max(rod.best, rod.steps);
    };
    rod.tell();
    this.rod = rod;
  }

  moveTo(x) {
    if (this.rod) {
      const margin = 2 * this.motion.spacing;
      this.rod.place = [Math.min(Math.max(x, margin), this.box[0] - margin), this.rod.place[1]];
    }
  }

  // wanted: { triangles, cells }, whether these are shown as well. Arrays are new, so they can be sent away.
  frame(wanted) {
    const { triangulation, report } = this;
    this.neighbors();
    const isCertified = triangulation.isCertified;
    const scene = { positions: this.positions.slice(), speeds: this.speeds.slice(), speedScale: this.speedScale || 1,
                    sets: triangulation.sets(), edges: this.edges.ids.slice() };
    const put = (name, { ids, shifts }) => {
      scene[name] = ids;
      if (this.cell) {
        scene[(name === "triangles" ? "triangle" : name) + "Shifts"] = shifts;
      }
    };
    if (this.cell) {
      scene.edgeShifts = this.edges.shifts.slice();
      scene.cell = { corner: [0, 0], sides: [[this.box[0], 0], [0, this.box[1]]],
                     isPeriodic: this.periods.map(period => period !== 0) };
    } else if (this.box) {
      const [x, y] = this.box;
      scene.outline = [[0, 0], [x, 0], [x, y], [0, y]];
    }
    if (wanted.triangles) {
      put("triangles", triangulation.trianglesWithShifts());
    }
    if (wanted.cells) {
      this.putCells(scene, isCertified);
    }
    if (report) {
      const { created, removed, createdShifts, removedShifts } = triangulation.changedEdges();
      put("changed", { ids: created, shifts: createdShifts });
      put("removed", { ids: removed, shifts: removedShifts });
    }
    put("wrong", isCertified ? { ids: new Int32Array(0), shifts: new Int32Array(0) } : triangulation.brokenEdges());
    if (this.rod) {
      scene.marks = [this.rod.place];
    }
    return { scene, state: this.state(isCertified, scene) };
  }

  // A triangulation that is not Delaunay has no cells.
  putCells(scene, isCertified) {
    if (this.wall) {
      scene.wall = this.wall;
    }
    if (isCertified) {
      const domain = this.wall ? [0, 0, ...this.wall.flat(), 0, this.box[1]] : [];
      const cells = this.triangulation.boundedCells({ radius: this.cellRadius, domain });
      Object.assign(scene, boundedSegments(cells, scene.positions, scene.cell));
    }
  }

  state(isCertified, scene) {
    const points = this.triangulation.numberOfPoints;
    const nanoseconds = time => time.mean * 1e6 / points;
    return { step: this.step, points, edges: scene.edges.length / 2, wrong: scene.wrong.length / 2, isCertified,
             changed: (scene.changed?.length ?? 0) / 2, report: this.report, time: nanoseconds(this.time),
             staticTime: nanoseconds(this.staticTime), delaunatorTime: nanoseconds(this.delaunatorTime), held: this.held.size,
             rod: this.rod && { isUpright: this.rod.isUpright, steps: this.rod.steps, best: this.rod.best } };
  }
}

// Of a frame, so that they move to another thread instead of being copied.
export function buffersOf({ scene }) {
  return [...new Set(Object.values(scene).filter(ArrayBuffer.isView).map(array => array.buffer))];
}
