// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the worker of the playground does, without a browser: node --test with the folder of the built page in SITE_FOLDER.
// Hands, wind and gravity do what they will; the triangulation has to be the one that is triangulated anew.

import assert from "node:assert/strict";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

// Modules of a browser are .js, which Node takes for modules where a package.json says so.
const folder = mkdtempSync(join(tmpdir(), "playground-"));
process.on("exit", () => rmSync(folder, { recursive: true }));
cpSync(process.env.SITE_FOLDER, folder, { recursive: true });
writeFileSync(join(folder, "package.json"), JSON.stringify({ type: "module" }));
const load = file => import(new URL(file, pathToFileURL(folder + "/")));
const { buffersOf, Simulation } = await load("playground/simulation.js");
const { linkOf, settingsOfLink, usualSettings } = await load("playground/settings.js");
const { scenarios, spaces } = await load("playground/scenarios.js");

// The same numbers in every run (Park and Miller), in [0, 1).
function randomSource(seed) {
  let state = seed;
  return () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
}

// Each edge once from each end, with the shift that leads there.
function edgesOf(triangulation) {
  const { ids, shifts } = triangulation.edgesWithShifts();
  const edges = [];
  for (let e = 0; e !== ids.length; e += 2) {
    const [a, b, x, y] = [ids[e], ids[e + 1], shifts[e] ?? 0, shifts[e + 1] ?? 0];
    edges.push(`${a} ${b} ${x} ${y}`, `${b} ${a} ${-x || 0} ${-y || 0}`);
  }
  return edges.sort();
}

function expectAsAnew(simulation, text) {
  assert.ok(simulation.triangulation.isCertified, `${text}: certified`);
  simulation.static.update(simulation.positions);
  assert.deepEqual(edgesOf(simulation.triangulation), edgesOf(simulation.static), text);
}

// One of the things that a person may do.
function play(simulation, random) {
  const { positions, motion } = simulation;
  const id = Math.floor(random() * positions.length / 2);
  const [x, y] = simulation.removed.has(id) ? simulation.at(simulation.anyPresent()) : simulation.at(id);
  const away = () => 8 * motion.spacing * (random() - 0.5);
  const actions = [
    () => simulation.removed.has(id) || simulation.grab(x, y, id), () => simulation.drag(x + away(), y + away()),
    () => simulation.release(), () => simulation.add(x + away(), y + away()), () => simulation.remove(id),
    () => simulation.setField(4 * random() - 2, 4 * random() - 2), () => simulation.moveTo(x),
  ];
  actions[Math.floor(random() * actions.length)]();
}

for (const scenario of Object.keys(scenarios)) {
  for (const space of Object.keys(spaces)) {
    test(`${scenario} in a ${space}, with hands in it, is as if it were triangulated anew`, async () => {
      const random = randomSource(17);
      const settings = { ...usualSettings(scenario), points: 200, space };
      const simulation = await Simulation.open(settings);
      for (let frame = 0; frame !== 60; ++frame) {
        play(simulation, random);
        simulation.advance(settings.steps);
        const { scene, state } = simulation.frame({ triangles: frame % 2 === 0 });
        assert.equal(state.points, simulation.positions.length / 2 - simulation.removed.size);
        assert.equal(state.points, scene.positions.filter(x => x === x).length / 2);
        if (frame % 10 === 0) {
          expectAsAnew(simulation, `frame ${frame}`);
        }
      }
      simulation.close();
    });
  }
}

test("cells have borders: a radius, the box and the wall", async () => {
  const settings = { ...usualSettings("dam_break"), points: 200, cellRadius: 2, wallBelow: 0.5, wallAbove: 0.8 };
  const simulation = await Simulation.open(settings);
  const [width, height] = simulation.box;
  for (const [below, above] of [[0.5, 0.8], [1, 0.05], [1, 1]]) {
    simulation.setCells({ cellRadius: 2, wallBelow: below, wallAbove: above });
    simulation.advance(20);
    const { scene } = simulation.frame({ cells: true });
    assert.deepEqual(scene.wall, [[below * width, 0], [above * width, height]]);
    assert.ok(scene.cellContacts.length > 400 && scene.cellBorders.length > 100);
    for (const segments of [scene.cellContacts, scene.cellBorders]) {
      for (let i = 0; i !== segments.length; i += 2) {
        const [x, y] = segments.subarray(i, i + 2), wall = width * (below + (above - below) * y / height);
        assert.ok(x > -1e-9 && y > -1e-9 && y < height + 1e-9 && x < wall + 1e-9, `${x}, ${y} is in the domain`);
      }
    }
  }
  assert.equal(simulation.frame({}).scene.wall, undefined);
  simulation.close();
  for (const other of [{ space: "periodic" }, { space: "channel" }, { scenario: "explosion" }]) {
    const without = await Simulation.open({ ...settings, ...other });
    without.advance(2);
    const { scene } = without.frame({ cells: true });
    assert.ok(scene.wall === undefined && scene.cellBorders.length > 0, JSON.stringify(other));
    without.close();
  }
  const heuristic = await Simulation.open({ ...settings, classifier: "random", parameter: 0.001 });
  heuristic.advance(40);
  const { scene, state } = heuristic.frame({ cells: true });
  assert.ok(scene.wall && (state.isCertified || scene.cellContacts === undefined));
  heuristic.close();
});

test("another method has the same points, also where some were removed", async () => {
  const simulation = await Simulation.open({ ...usualSettings("brownian"), points: 100 });
  simulation.remove(0);
  simulation.remove(50);
  simulation.advance(3);
  await simulation.use({ ...usualSettings("brownian"), classifier: "safe_region", repair: "splice" });
  simulation.advance(3);
  assert.equal(simulation.state(true, simulation.frame({}).scene).points, 98);
  expectAsAnew(simulation, "after a change of the method");
  simulation.close();
});

test("a method that is refused leaves the simulation as it was", async () => {
  const simulation = await Simulation.open({ ...usualSettings("brownian"), points: 100 });
  await assert.rejects(simulation.use({ ...usualSettings("brownian"), classifier: "nonsense" }));
  simulation.advance(3);
  expectAsAnew(simulation, "after the refusal");
  simulation.close();
});

test("the arrays of a frame can move to another thread, and the next frame has its own", async () => {
  const simulation = await Simulation.open({ ...usualSettings("brownian"), points: 100, space: "periodic" });
  for (let k = 0; k !== 3; ++k) {
    simulation.advance(1);
    const frame = simulation.frame({ triangles: true });
    const { scene } = structuredClone(frame, { transfer: buffersOf(frame) });
    assert.equal(scene.positions.length, 200);
    assert.equal(frame.scene.positions.length, 0); // it is gone
  }
  expectAsAnew(simulation, "after three frames");
  simulation.close();
});

test("a link has what is not as usual, and leads back to it", () => {
  const settings = { ...usualSettings("spinning"), points: 300, space: "channel", parameter: 0.5, classifier: "point_distance",
                     layers: { ...usualSettings().layers, voronoi: true, points: false }, policy: "key_frames:7" };
  assert.deepEqual(settingsOfLink(linkOf(settings)), settings);
  assert.equal(linkOf(usualSettings("static")), "#scenario=static");
  assert.deepEqual(settingsOfLink("#points=1e99&seed=-1&repair=;&steps=3&gravity=x"), usualSettings());
});

test("the scenarios that are played are those of the repository", () => {
  for (const name of Object.keys(scenarios).filter(name => !scenarios[name].folder)) {
    const { bodies, points } = JSON.parse(readFileSync(join(folder, "scenarios", name + ".json")));
    const number = bodies?.reduce((sum, { rows, columns }) => sum + rows * columns, 0) ?? points;
    assert.ok(name === "brownian" || scenarios[name].points === number, `${name} has ${number} points`);
  }
});
