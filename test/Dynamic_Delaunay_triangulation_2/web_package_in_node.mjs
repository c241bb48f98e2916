// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The package for web developers in Node: node --test with the folder of the built package in PACKAGE_FOLDER.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";

const folder = pathToFileURL(process.env.PACKAGE_FOLDER + "/");
const { DynamicDelaunayError, Triangulation } = await import(new URL("dynamic_delaunay.mjs", folder));

// The same numbers in every run (Park and Miller).
function randomIntegers(seed) {
  let state = seed;
  return beyond => {
    state = (state * 48271) % 2147483647;
    return Math.floor((state / 2147483647) * beyond);
  };
}

function rows(numbers, size) {
  return Array.from({ length: numbers.length / size }, (_, i) => Array.from(numbers.subarray(size * i, size * (i + 1))));
}

// Whether two large arrays have the same bytes.
function areSame(...arrays) {
  const [a, b] = arrays.map(({ buffer, byteOffset, byteLength }) => Buffer.from(buffer, byteOffset, byteLength));
  return a.equals(b);
}

// SIGNS BY INTEGERS OF ANY SIZE, for points with integer coordinates

function integers([x, y]) {
  return [BigInt(x), BigInt(y)];
}

// Positive if a, b, c turn left.
function orientation(...points) {
  const [[ax, ay], [bx, by], [cx, cy]] = points.map(integers);
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

// Positive if d is inside of the circle through a, b, c, which turn left (the determinant of Guibas and Stolfi 1985).
function sideOfCircle(a, b, c, d) {
  const [dx, dy] = integers(d);
  const [u, v, w] = [a, b, c].map(integers).map(([x, y]) => [x - dx, y - dy]);
  const square = ([x, y]) => x * x + y * y, cross = (p, q) => p[0] * q[1] - p[1] * q[0];
  return square(u) * cross(v, w) + square(v) * cross(w, u) + square(w) * cross(u, v);
}

// THE ORACLE: a triangulation of a convex polygon is Delaunay if each of its edges is.

function expectDelaunay(triangulation, points) {
  const apexes = new Map(), triangles = rows(triangulation.triangles(), 3);
  for (const [i, j, k] of triangles) {
    assert.ok(orientation(points[i], points[j], points[k]) > 0n, "a triangle is counterclockwise");
    for (const [from, to, apex] of [[i, j, k], [j, k, i], [k, i, j]]) {
      assert.ok(!apexes.has(`${from} ${to}`), "a halfedge is in one triangle");
      apexes.set(`${from} ${to}`, apex);
    }
  }
  const borders = [];
  for (const [halfedge, apex] of apexes) {
    const [from, to] = halfedge.split(" ").map(Number), other = apexes.get(`${to} ${from}`);
    if (other === undefined) {
      borders.push([from, to]);
    } else if (from < to) {
      assert.ok(sideOfCircle(points[from], points[to], points[apex], points[other]) <= 0n, "an edge is Delaunay");
    }
  }
  for (const [from, to] of borders) {
    assert.ok(points.every(p => p === null || orientation(points[from], points[to], p) >= 0n), "the border is convex");
  }
  const used = new Set(triangles.flat());
  triangulation.duplicates().filter((_, i) => i % 2 === 0).forEach(id => used.add(id));
  assert.equal(used.size, points.filter(p => p !== null).length, "no point is lost");
  assert.equal(triangulation.edges().length / 2, (apexes.size + borders.length) / 2);
}

function integerPoints(random, size, width) {
  return Array.from({ length: size }, () => [random(width), random(width)]);
}

function edgeKeys(pairs) {
  return rows(pairs, 2).map(([i, j]) => (i < j ? `${i} ${j}` : `${j} ${i}`)).sort();
}

for (const [name, width] of [["few ties", 1 << 20], ["many points on circles, and coinciding ones", 24]]) {
  test(`every frame is Delaunay by integers of any size: ${name}`, async () => {
    const random = randomIntegers(11);
    let points = integerPoints(random, 200, width);
    const triangulation = await Triangulation.create(points.flat());
    for (let frame = 0; frame < 40; ++frame) {
      expectDelaunay(triangulation, points);
      assert.ok(triangulation.isCertified);
      const jumps = frame % 5 === 0 ? 5 : 1000;
      const step = Math.max(2, width >> 7);
      points = points.map(([x, y]) => random(1000) < jumps && jumps < 1000
        ? [random(width), random(width)] : [x + random(2 * step) - step, y + random(2 * step) - step]);
      const report = triangulation.update(new Float64Array(points.flat()));
      assert.ok(report.certified);
    }
  });
}

test("cells end at a radius and in a convex domain", async () => {
  const alone = (await Triangulation.create([2, 3])).boundedCells({ radius: 0.5 });
  assert.ok(Math.abs(alone.areas[0] - Math.PI / 4) < 1e-15 && Math.abs(alone.freeLengths[0] - Math.PI) < 1e-15);
  assert.deepEqual([[...alone.begins], [...alone.sides], [...alone.angles]], [[0, 1], [2], [2 * Math.PI]]);

  const random = randomIntegers(21);
  const triangulation = await Triangulation.create(integerPoints(random, 100, 1000).flat());
  triangulation.remove([3]);
  const domain = [0, 0, 700, 0, 900, 1000, 0, 1000]; // some points are outside
  const sum = numbers => numbers.reduce((total, number) => total + number, 0);
  const cells = triangulation.boundedCells({ domain });
  assert.ok(Math.abs(sum(cells.areas) - 800000) < 1e-6);
  assert.ok(Math.abs(sum(cells.wallLengths) - 2600 - Math.hypot(200, 1000)) < 1e-9);
  assert.equal(cells.areas[3] + cells.begins[4] - cells.begins[3], 0);
  assert.equal(cells.begins[100], cells.sides.length);
  for (let k = 0; k !== cells.sides.length; ++k) {
    const length = Math.hypot(cells.ends[2 * k] - cells.starts[2 * k], cells.ends[2 * k + 1] - cells.starts[2 * k + 1]);
    assert.ok(Math.abs(length - cells.lengths[k]) < 1e-9 && cells.angles[k] === 0);
  }
  assert.deepEqual(triangulation.boundedCells({ domain: [[0, 0], [700, 0], [900, 1000], [0, 1000]] }), cells);
  const small = triangulation.boundedCells({ radius: 50, domain });
  assert.ok(small.areas.every((area, id) => area <= Math.min(cells.areas[id] * (1 + 1e-9), 2500 * Math.PI)));
  assert.ok(sum(small.freeLengths) > 0);

  const cell = { a: [1000, 0], b: [0, 1000] };
  const periodic = await Triangulation.create(integerPoints(random, 100, 1000).flat(), { cell });
  assert.ok(Math.abs(sum(periodic.boundedCells({ radius: 1e4 }).areas) - 1e6) < 1e-6);
  const refused = [[{}, "ParameterError"], [{ radius: -1 }, "ParameterError"], [{ radius: "1" }, "InputTypeError"],
                   [{ domain: [0, 0, 0, 1, 1, 1] }, "DomainError"], [{ domain: [0, 0, 1] }, "InputValueError"],
                   [{ domain: [0, 0, 1, 0] }, "DomainError"], [{ domain: [0, 0, NaN, 0, 1, 1] }, "DomainError"],
                   [{ Radius: 3 }, "InputValueError"], [3, "InputTypeError"], [null, "InputTypeError"]];
  for (const [bounds, name] of refused) {
    assert.throws(() => triangulation.boundedCells(bounds), { name });
  }
  assert.throws(() => periodic.boundedCells({ radius: 1, domain }), { name: "DomainError" });
});

test("points come and go, and ids stay", async () => {
  const random = randomIntegers(12);
  const points = integerPoints(random, 50, 1000);
  const triangulation = await Triangulation.create(points.flat());
  assert.deepEqual(Array.from(triangulation.insert([1, 2, 3, 500])), [50, 51]);
  points.push([1, 2], [3, 500]);
  triangulation.remove([7, 50]);
  points[7] = points[50] = null;
  assert.equal(triangulation.numberOfPoints, 50);
  assert.equal(triangulation.numberOfIds, 52);
  assert.ok(!triangulation.has(7) && triangulation.has(8) && !triangulation.has(1.5) && !triangulation.has(-1));
  assert.ok(Number.isNaN(triangulation.points()[14]));
  expectDelaunay(triangulation, points);
  triangulation.move([51, 3], [400, 400, 10, 990]);
  points[51] = [400, 400];
  points[3] = [10, 990];
  expectDelaunay(triangulation, points);
  points.forEach((p, i) => { if (p) points[i] = [p[0] + 1, p[1]]; });
  triangulation.update(points.flatMap(p => p ?? [NaN, NaN]));
  expectDelaunay(triangulation, points);
  assert.deepEqual(Array.from(triangulation.insert([7, 7, 8, 8, 9, 9])), [7, 50, 52], "the smallest free ids come first");
});

test("points may be rows, and ids one, an array or a set", async () => {
  const points = [[0, 0], [4, 0], [0, 4], [5, 5], [2, 2]];
  const triangulation = await Triangulation.create(points);
  assert.deepEqual(triangulation.points(), new Float64Array(points.flat()));
  triangulation.update(points.map(([x, y]) => Float32Array.of(x + 1, y)));
  assert.equal(triangulation.points()[8], 3);
  assert.deepEqual(Array.from(triangulation.insert([[7, 7]])), [5]);
  assert.equal(triangulation.move(4, [[1, 1]]).relocated + triangulation.move(4, [2, 1]).relocated >= 0, true);
  assert.deepEqual(Array.from(triangulation.points().slice(8, 10)), [2, 1]);
  assert.equal(triangulation.remove(4).removed, 1);
  assert.equal(triangulation.remove(new Set([5, 0])).removed, 2);
  assert.equal(triangulation.remove([]).removed, 0);
  assert.deepEqual([0, 1, 2, 3, 4, 5].filter(id => triangulation.has(id)), [1, 2, 3]);
  for (const array of [Float32Array, Int32Array, Uint8Array]) {
    assert.equal((await Triangulation.create(array.of(0, 0, 4, 0, 0, 4))).numberOfPoints, 3);
  }
});

test("what is no list of points or ids is refused, and changes nothing", async () => {
  const triangulation = await Triangulation.create([0, 0, 4, 0, 0, 4]);
  const wrongPoints = ["0011", 5, null, () => 0, {}, new Map(), new DataView(new ArrayBuffer(16)), new ArrayBuffer(16),
                       Buffer.alloc(16), BigInt64Array.of(0n, 1n), ["0", "1"], [0, "1"], [0, null], [true, false],
                       [, 1], [[0, 0], 1], [[0, 0], [1]], [[0, 0, 0]], [["0", "0"]], [{ x: 0, y: 0 }], [[0, 0], null],
                       ["ab", "cd"], { length: 2 }, { length: 1.5 }, { length: -2 }, [0, 0, 1, [1]], [0, 1, 2]];
  for (const points of wrongPoints) {
    const isWrong = error => error instanceof DynamicDelaunayError && /Input(Type|Value)Error/.test(error.name);
    assert.throws(() => triangulation.insert(points), isWrong);
    assert.throws(() => triangulation.update(points), isWrong);
    assert.throws(() => triangulation.boundedCells({ domain: points }), isWrong);
    await assert.rejects(Triangulation.create(points), isWrong);
  }
  for (const [ids, name] of [["1", "InputTypeError"], [undefined, "InputTypeError"], [null, "InputTypeError"],
                             [{}, "InputTypeError"], [["1"], "InputTypeError"], [[1n], "InputTypeError"],
                             [new Map([[0, 1]]), "InputTypeError"], [NaN, "InputValueError"], [[0.5], "InputValueError"],
                             [-1, "UnknownIdError"], [3, "UnknownIdError"], [new Set([7]), "UnknownIdError"]]) {
    assert.throws(() => triangulation.remove(ids), { name });
    assert.throws(() => triangulation.move(ids, [1, 1]), { name });
  }
  assert.throws(() => triangulation.move([0, 1], [1, 1]), { name: "PointCountError", details: { expected: 2, given: 1 } });
  assert.deepEqual(Array.from(triangulation.points()), [0, 0, 4, 0, 0, 4]);
  assert.ok(triangulation.isCertified);
});

test("a triangulation begins with no points, and with points on a line", async () => {
  const empty = await Triangulation.create();
  assert.equal(empty.numberOfPoints, 0);
  assert.equal(empty.edges().length, 0);
  empty.insert([0, 0, 1, 1, 2, 2]);
  assert.deepEqual(edgeKeys(empty.edges()), ["0 1", "1 2"]);
  assert.equal(empty.triangles().length, 0);
  empty.update([0, 0, 1, 0, 2, 2]);
  assert.equal(empty.triangles().length, 3);
});

test("changed edges lead from one frame to the next", async () => {
  const random = randomIntegers(13);
  let points = integerPoints(random, 300, 100000);
  const triangulation = await Triangulation.create(points.flat());
  const known = new Set(edgeKeys(triangulation.edges()));
  let changes = 0;
  for (let frame = 0; frame < 20; ++frame) {
    points = points.map(([x, y]) => [x + random(2001) - 1000, y + random(2001) - 1000]);
    triangulation.update(points.flat());
    const { created, removed } = triangulation.changedEdges();
    edgeKeys(removed).forEach(key => assert.ok(known.delete(key)));
    edgeKeys(created).forEach(key => { assert.ok(!known.has(key)); known.add(key); });
    assert.deepEqual([...known].sort(), edgeKeys(triangulation.edges()));
    changes += created.length;
  }
  assert.ok(changes > 100);
});

test("neighbors of triangles are those across from each corner", async () => {
  const random = randomIntegers(22);
  const triangulation = await Triangulation.create(integerPoints(random, 100, 10000).flat());
  const triangles = rows(triangulation.triangles(), 3), neighbors = rows(triangulation.neighbors(), 3);
  assert.equal(neighbors.length, triangles.length);
  let border = 0;
  triangles.forEach((corners, t) => corners.forEach((corner, k) => {
    const beyond = neighbors[t][k];
    border += beyond === -1;
    if (beyond !== -1) {
      const shared = corners.filter(id => id !== corner);
      assert.ok(shared.every(id => triangles[beyond].includes(id)) && !triangles[beyond].includes(corner));
      assert.ok(neighbors[beyond].includes(t));
    }
  }));
  assert.equal(3 * triangles.length + border, triangulation.edges().length); // each edge is a side of two, or of one
  const periodic = await Triangulation.create([0, 0], { cell: { a: [1, 0], b: [0, 1] } });
  assert.throws(() => periodic.neighbors(), { name: "UseError" });
});

test("of points that coincide one has the edges, and its list ends with the others", async () => {
  for (const cell of [undefined, { a: [10, 0], b: [0, 10] }]) {
    const triangulation = await Triangulation.create([0, 0, 4, 0, 0, 4, 0, 0, 4, 4, 0, 0], cell && { cell });
    triangulation.remove(4);
    const { begins, neighbors, shifts } = triangulation.neighborLists();
    const listOf = id => Array.from(neighbors.subarray(begins[id], begins[id + 1]));
    assert.deepEqual(rows(triangulation.duplicates(), 2), [[3, 0], [5, 0]]);
    assert.deepEqual([listOf(0).slice(-2), listOf(3), listOf(4), listOf(5)], [[3, 5], [0], [], [0]]);
    assert.equal(neighbors.length, triangulation.edges().length + 4);
    assert.equal(shifts.length, cell ? 2 * neighbors.length : 0);
  }
});

test("neighbor lists are the edges from both ends", async () => {
  const random = randomIntegers(14);
  const triangulation = await Triangulation.create(integerPoints(random, 100, 10000).flat());
  const { begins, neighbors } = triangulation.neighborLists();
  const pairs = [];
  for (let i = 0; i < 100; ++i) {
    neighbors.subarray(begins[i], begins[i + 1]).forEach(j => { if (i < j) pairs.push(i, j); });
  }
  assert.equal(neighbors.length, triangulation.edges().length);
  assert.deepEqual(edgeKeys(Int32Array.from(pairs)), edgeKeys(triangulation.edges()));
});

test("cells cut by a box fill it, and corners are those of the cell", async () => {
  const triangulation = await Triangulation.create([0, 0, 4, 0, 0, 4, 4, 4, 2, 2]);
  const { areas, centroids } = triangulation.cells([0, 0, 4, 4]);
  assert.ok(Math.abs(areas.reduce((sum, area) => sum + area) - 16) < 1e-12);
  assert.ok(Math.abs(areas[4] - 8) < 1e-12);
  centroids.slice(8).forEach(x => assert.ok(Math.abs(x - 2) < 1e-12));
  assert.deepEqual(rows(triangulation.cellCorners(4), 2).sort().toString(), "0,2,2,0,2,4,4,2");
  assert.equal(triangulation.cellCorners(0).length, 0);
  assert.equal(triangulation.cells().areas[0], Infinity);
  const { pairs, lengths } = triangulation.voronoiEdges();
  assert.equal(pairs.length, 2 * lengths.length);
});

test("periodic space has two triangles a point, and wrapping changes nothing", async () => {
  const random = randomIntegers(15), size = 60, width = 1000;
  let points = integerPoints(random, size, width);
  const triangulation = await Triangulation.create(points.flat(), { cell: { a: [width, 0], b: [0, width] } });
  assert.ok(triangulation.isPeriodic);
  for (let frame = 0; frame < 20; ++frame) {
    points = points.map(([x, y]) => [x + random(41) - 20, y + random(41) - 20]);
    assert.ok(triangulation.update(points.flat()).certified);
    const { ids, shifts } = triangulation.trianglesWithShifts();
    assert.equal(ids.length, 6 * (size - triangulation.duplicates().length / 2));
    const corners = Array.from(ids, (id, k) => [points[id][0] + width * shifts[2 * k],
                                                points[id][1] + width * shifts[2 * k + 1]]);
    let area = 0n;
    for (let k = 0; k < corners.length; k += 3) {
      const triangle = corners.slice(k, k + 3), doubled = orientation(...triangle);
      assert.ok(doubled > 0n);
      area += doubled;
      for (const [x, y] of points) {
        for (let s = -2; s <= 2; ++s) {
          for (let t = -2; t <= 2; ++t) {
            assert.ok(sideOfCircle(...triangle, [x + s * width, y + t * width]) <= 0n);
          }
        }
      }
    }
    assert.equal(area, 2n * BigInt(width * width));
  }
  assert.equal(triangulation.edgesWithShifts().shifts.length, triangulation.edges().length);
  triangulation.update(points.flat(), { a: [2 * width, 0], b: [0, width] });
  const { areas } = triangulation.cells();
  assert.ok(Math.abs(areas.reduce((sum, area) => sum + area) / (2 * width * width) - 1) < 1e-12);
});

test("a slab is periodic along its side and open across", async () => {
  const triangulation = await Triangulation.create([0, 0, 5, 1, 2, 8], { cell: { a: [10, 0] } });
  assert.ok(triangulation.isPeriodic && triangulation.isCertified);
  assert.ok(triangulation.edges().length > 0);
});

test("a heuristic leaves broken edges, which are named, and mends them when it is told to", async () => {
  const random = randomIntegers(16);
  let points = integerPoints(random, 300, 100000), worst = 0;
  const triangulation = await Triangulation.create(points.flat(), { classifier: "random:0.01" });
  for (let frame = 0; frame < 10; ++frame) {
    points = points.map(([x, y]) => [x + random(3001) - 1500, y + random(3001) - 1500]);
    triangulation.update(points.flat());
    const { ids } = triangulation.brokenEdges();
    assert.equal(ids.length === 0, triangulation.certify());
    const known = new Set(edgeKeys(triangulation.edges()));
    edgeKeys(ids).forEach(key => assert.ok(known.has(key)));
    worst = Math.max(worst, ids.length / 2);
  }
  assert.ok(worst > 0);
  assert.ok(triangulation.mend().certified);
  expectDelaunay(triangulation, points);
  assert.equal(triangulation.brokenEdges().ids.length, 0);
});

test("sets name what the last update looked at", async () => {
  const random = randomIntegers(17);
  const points = integerPoints(random, 400, 1 << 20);
  const triangulation = await Triangulation.create(points.flat(), { classifier: "point_distance:0.7", repair: "splice" });
  const moved = points.map(([x, y], i) => (i === 5 ? [(x + 60000) % (1 << 20), y] : [x, y]));
  const report = triangulation.update(moved.flat());
  const counts = [0, 0, 0, 0];
  triangulation.sets().forEach(set => ++counts[set]);
  assert.ok(report.rebuildReason !== "" || (report.classified > 0 && counts[3] === report.classified));
});

test("choices can all be made", async () => {
  const { classifiers, repairs, policies } = await Triangulation.choices();
  assert.ok(classifiers.length >= 9 && repairs.length >= 4 && policies.includes("hybrid"));
  assert.equal(classifiers.find(({ name }) => name === "point_distance").parameter.usual, 0.7);
  for (const { name } of classifiers.filter(({ name }) => name !== "refined")) {
    for (const repair of repairs) {
      const triangulation = await Triangulation.create([0, 0, 1, 0, 0, 1, 1, 1.5], { classifier: name, repair });
      triangulation.update([0, 0, 1, 0, 0, 1, 1, 1]);
      assert.ok(triangulation.mend().certified);
      triangulation.dispose();
    }
  }
});

test("errors say what is wrong, with its numbers, and change nothing", async () => {
  const triangulation = await Triangulation.create([0, 0, 1, 0, 0, 1]);
  const isError = (name, details) => error => {
    assert.ok(error instanceof DynamicDelaunayError);
    assert.equal(error.name, name);
    assert.deepEqual(error.details, details);
    return true;
  };
  assert.throws(() => triangulation.update([0, 0, 1, 0]), isError("PointCountError", { expected: 3, given: 2 }));
  assert.throws(() => triangulation.update([0, 0, 1, NaN, 0, 1]),
                isError("NonFiniteCoordinateError", { id: 1, x: 1, y: NaN }));
  assert.throws(() => triangulation.remove([8]), isError("UnknownIdError", { id: 8, number_of_ids: 3 }));
  assert.throws(() => triangulation.update([0, 0, 1]), isError("InputValueError", { length: 3 }));
  assert.throws(() => triangulation.move([0], [1]), isError("InputValueError", { length: 1 }));
  assert.throws(() => triangulation.remove([0.5]), isError("InputValueError", { id: 0.5 }));
  const options = [[{ classifier: "none" }, "InputValueError", {}], [{ colour: 1 }, "InputValueError", { key: "colour" }],
                   [{ toString: 1 }, "InputValueError", { key: "toString" }], [{ classifier: 3 }, "InputTypeError", {}],
                   [{ classifier: "circumcircle\0none" }, "InputTypeError", {}], [{ padding: -1 }, "InputValueError", { value: -1 }],
                   [{ padding: "1" }, "InputTypeError", {}], [{ seed: 0.5 }, "InputValueError", { value: 0.5 }],
                   [{ wasm: 7 }, "InputTypeError", {}], [{ cell: null }, "InputTypeError", {}], [{ cell: 4 }, "InputTypeError", {}],
                   [{ cell: { a: [1], b: [0, 1] } }, "InputValueError", {}], [{ cell: { a: [1, 0], B: [0, 1] } }, "InputValueError", { key: "B" }],
                   [{ cell: { a: ["1", 0] } }, "InputTypeError", {}],
                   [{ cell: { a: [1, 1], b: [2, 2] } }, "PeriodicCellError", { ax: 1, ay: 1, bx: 2, by: 2 }],
                   [{ cell: { a: [NaN, 1] } }, "PeriodicCellError", { ax: NaN, ay: 1, bx: 0, by: 0 }],
                   [{ classifier: "point_distance:7" }, "InputValueError", {}],
                   ["periodic", "InputTypeError", {}], [null, "InputTypeError", {}], [[], "InputTypeError", {}]];
  for (const [choice, name, details] of options) {
    await assert.rejects(Triangulation.create([], choice), isError(name, details));
  }
  await assert.rejects(Triangulation.create([], { classifier: "none" }), /there is no classifier 'none'/);
  await assert.rejects(Triangulation.create([], { colour: 1 }), /there is no 'colour' in options: allowed are classifier, /);
  await assert.rejects(Triangulation.choices({ classifier: 1 }), isError("InputValueError", { key: "classifier" }));
  const ids = [2 ** 40, 2 ** 32, 2 ** 32 - 1, -1, 2 ** 32 - 2, 8]; // of 32 bits some of them would be 0
  ids.forEach(id => {
    assert.throws(() => triangulation.remove(id), isError("UnknownIdError", { id, number_of_ids: 3 }));
    assert.throws(() => triangulation.cellCorners(id), isError("UnknownIdError", { id, number_of_ids: 3 }));
  });
  assert.ok(ids.every(id => !triangulation.has(id)));
  assert.throws(() => triangulation.remove([1, 1]), isError("RepeatedIdError", { id: 1 }));
  assert.throws(() => triangulation.update([0, 0, 1, 0, 0, 1], { a: [1, 0] }), isError("UseError", {}));
  assert.throws(() => triangulation.cells([0, 0]), isError("InputValueError", {}));
  assert.throws(() => triangulation.cells(["0", "0", "1", "1"]), isError("InputTypeError", {}));
  assert.throws(() => triangulation.cells([5, 5, 0, 0]), error => error.name === "ParameterError");
  assert.throws(() => new Triangulation(), isError("UseError", {}));
  assert.throws(() => triangulation.insert({ length: 2 ** 30 }), RangeError);
  assert.throws(() => triangulation.insert({ length: 2 ** 33 }), RangeError);
  const periodic = await Triangulation.create([0, 0], { cell: { a: [1, 0], b: [0, 1] } });
  const isThin = isError("PeriodicCellError", { ax: 1, ay: 0, bx: 1e12, by: 1 });
  assert.throws(() => periodic.update([0, 0], { a: [1, 0], b: [1e12, 1] }), isThin);
  assert.throws(() => periodic.cells([0, 0, 1, 1]), isError("InputValueError", {}));
  assert.throws(() => periodic.update([0, 0], null), isError("InputTypeError", {}));
  assert.deepEqual(Array.from(triangulation.points()), [0, 0, 1, 0, 0, 1]);
  assert.ok(triangulation.isCertified);
  triangulation.dispose();
  triangulation.dispose();
  for (const call of [t => t.edges(), t => t.update([]), t => t.report, t => t.numberOfIds, t => t.has(0), t => t.mend()]) {
    assert.throws(() => call(triangulation), isError("UseError", {}));
  }
});

test("a block with `using` disposes of its triangulation", { skip: !Symbol.dispose }, async () => {
  const triangulation = await Triangulation.create([0, 0]);
  triangulation[Symbol.dispose]();
  assert.throws(() => triangulation.edges(), /disposed/);
});

test("a WebAssembly module is taken as an address, a path, bytes or compiled, if it is the right one", async () => {
  const address = name => new URL(name, folder), bytes = readFileSync(address("dynamic_delaunay.wasm"));
  const given = [address("dynamic_delaunay.wasm"), address("dynamic_delaunay.wasm").href, fileURLToPath(address("dynamic_delaunay.wasm")),
                 `data:application/wasm;base64,${bytes.toString("base64")}`, bytes, new Uint8Array(bytes).buffer,
                 await WebAssembly.compile(bytes), address("dynamic_delaunay_all.wasm")];
  for (const wasm of given) {
    for (let time = 0; time < 2; ++time) {
      assert.equal((await Triangulation.create([0, 0, 1, 0, 0, 1], { wasm })).triangles().length, 3);
    }
  }
  const all = address("dynamic_delaunay_all.wasm"), cell = { a: [1, 0], b: [0, 1] };
  assert.ok((await Triangulation.create([0, 0], { wasm: all, cell, classifier: "random:0.5" })).isPeriodic);
  assert.ok((await Triangulation.choices({ wasm: all })).repairs.length > 0);
  const refused = (promise, message) => assert.rejects(promise, error => {
    assert.ok(error instanceof DynamicDelaunayError && error.name === "ModuleError");
    assert.match(error.message, message);
    return true;
  });
  await refused(Triangulation.create([], { wasm: bytes, cell }), /is the module for 'plane', and this needs the one for 'periodic'/);
  await refused(Triangulation.choices({ wasm: bytes }), /this needs the one for 'all'/);
  await refused(Triangulation.create([], { wasm: address("dynamic_delaunay_periodic.wasm") }), /needs the one for 'plane'/);
  await refused(Triangulation.create([], { wasm: address("README.md") }), /README.md is no WebAssembly/);
  await refused(Triangulation.create([], { wasm: address("nothing.wasm") }), /nothing.wasm cannot be loaded as WebAssembly: ENOENT/);
  await refused(Triangulation.create([], { wasm: "http://127.0.0.1:1/a.wasm" }), /a.wasm cannot be loaded as WebAssembly: /);
  await refused(Triangulation.create([], { wasm: bytes.subarray(0, 1000) }), /cannot be loaded/);
  await refused(Triangulation.create([], { wasm: new Uint8Array(3) }), /is no WebAssembly/);
  await refused(Triangulation.create([], { wasm: Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0) }), /no module of this package/);
});

test("arrays stay when memory grows", async () => {
  const random = randomIntegers(18);
  const first = await Triangulation.create([0, 0, 1, 0, 0, 1]);
  const edges = first.edges();
  const copy = Array.from(edges);
  const large = await Triangulation.create(integerPoints(random, 200000, 1 << 30).flat());
  assert.equal(large.numberOfPoints, 200000);
  assert.deepEqual(Array.from(edges), copy);
  assert.equal(first.update([0, 0, 2, 0, 0, 1]).certified, true);
});

test("memory beyond 2 GiB is read where it is, and the end of it is an error that others survive", async () => {
  const size = 800_000, random = randomIntegers(23), triangulations = [];
  const wasm = readFileSync(new URL("dynamic_delaunay.wasm", folder)); // with a memory of its own
  const points = Float64Array.from({ length: 2 * size }, () => random(1 << 30));
  const expected = await Triangulation.create(points);
  const [edges, triangles] = [expected.edges(), expected.triangles()];
  for (let number = 0; number < 10; ++number) {
    triangulations.push(await Triangulation.create(points, { wasm }));
  }
  for (const triangulation of triangulations) { // older ones as well
    assert.ok(areSame(triangulation.edges(), edges));
  }
  const last = triangulations.at(-1);
  assert.ok(areSame(last.points(), points));
  assert.ok(areSame(last.triangles(), triangles));
  assert.equal(last.update(points).certified, true);
  assert.throws(() => last.remove(size), { name: "UnknownIdError", details: { id: size, number_of_ids: size } });
  await assert.rejects(async () => {
    while (triangulations.length < 40) {
      triangulations.push(await Triangulation.create(points, { wasm }));
    }
  }, { name: "RangeError", message: /not enough memory/ });
  assert.ok(triangulations.length > 13);
  assert.ok(areSame(last.edges(), edges));
  triangulations.splice(0, 2).forEach(triangulation => triangulation.dispose());
  triangulations.push(await Triangulation.create(points, { wasm })); // in the memory of those
  assert.ok(areSame(triangulations.at(-1).triangles(), triangles));
  triangulations.forEach(triangulation => triangulation.dispose());
});

test("the code of the README runs", async () => {
  const readme = readFileSync(new URL("README.md", folder), "utf8");
  const [, code] = readme.match(/^```js\n(.*?)^```$/ms);
  const runnable = code.replace('"dynamic-delaunay"', `"${new URL("dynamic_delaunay.mjs", folder)}"`);
  const { triangulation } = await import(`data:text/javascript,${encodeURIComponent(`${runnable}\nexport { triangulation };`)}`);
  assert.ok(triangulation.isCertified);
  assert.equal(triangulation.points()[3], 1);
});

test("a module is at most 200 kB when it is compressed", () => {
  for (const module of ["dynamic_delaunay.wasm", "dynamic_delaunay_periodic.wasm"]) {
    const size = gzipSync(readFileSync(new URL(module, folder)), { level: 9 }).length;
    assert.ok(size <= 200_000, `${module} has ${size} bytes`);
  }
});
