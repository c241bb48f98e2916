// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a picture draws beyond the points, from a scene: segments of edges, the Voronoi diagram, circumcircles. Nothing
// here decides what is a neighbor of what: that is the triangulation's, and comes in as edges and triangles.
//
// A scene is an object with
//   positions     Float64Array or Float32Array: x, y of each point. A point whose x is NaN is not there.
//   edges         Uint32Array: two points for each edge
//   triangles     Uint32Array: three points for each triangle, counterclockwise (for the Voronoi diagram and circles)
//   sets          Uint8Array: 0 none, 1 Border, 2 Padded, 3 Classified, of each point
//   speeds        Float32Array, of each point; and speedScale, the speed that has the last color
//   changed, removed, wrong   Uint32Array: two points for each edge that is new, that is gone, that is not Delaunay
//   marks         array of [x, y]: places that a ring shows
//   outline       array of [x, y]: walls or another polygon to draw
//   wall          array of two [x, y]: a wall of bounded cells, and where it is held
//   cellContacts, cellBorders   Float64Array: x0, y0, x1, y1 of each segment of the boundaries of bounded cells, between
//                 two cells and elsewhere; boundedSegments() makes them
//   cell          { corner: [x, y], sides: [[x, y], [x, y]], isPeriodic: [bool, bool] }: space repeats along these sides
//   edgeShifts, changedShifts, removedShifts, wrongShifts   only with a cell: Int32Array, two numbers for each edge: how
//                 often its second point is shifted by each side
//   triangleShifts  only with a cell: Int32Array, six numbers for each triangle, two for each corner
// All but the positions may be missing. Points need not lie in the cell: wrapped() brings them there.

// Floats that are appended to; the memory stays for the next picture.
export class Floats {
  constructor() {
    this.data = new Float32Array(1024);
    this.size = 0;
  }
  clear() { this.size = 0; }
  reserve(more) {
    if (this.size + more > this.data.length) {
      const larger = new Float32Array(Math.max(2 * this.data.length, this.size + more));
      larger.set(this.data.subarray(0, this.size));
      this.data = larger;
    }
  }
  push(a, b) {
    this.reserve(2);
    this.data[this.size++] = a;
    this.data[this.size++] = b;
  }
  push3(a, b, c) {
    this.reserve(3);
    this.data[this.size++] = a;
    this.data[this.size++] = b;
    this.data[this.size++] = c;
  }
  push4(a, b, c, d) {
    this.reserve(4);
    this.data[this.size++] = a;
    this.data[this.size++] = b;
    this.data[this.size++] = c;
    this.data[this.size++] = d;
  }
  get values() { return this.data.subarray(0, this.size); }
}

// By how many sides of the cell each point lies outside of it: Int32Array, two numbers a point.
export function shiftsOutOfCell(positions, cell) {
  const [a, b] = cellSides(cell);
  const area = a[0] * b[1] - a[1] * b[0];
  const shifts = new Int32Array(positions.length);
  for (let i = 0; i !== positions.length; i += 2) {
    const x = positions[i] - cell.corner[0], y = positions[i + 1] - cell.corner[1];
    shifts[i] = cell.isPeriodic[0] ? Math.floor((x * b[1] - y * b[0]) / area) : 0;
    shifts[i + 1] = cell.isPeriodic[1] ? Math.floor((a[0] * y - a[1] * x) / area) : 0;
  }
  return shifts;
}

// A slab may be flat across: then any side across does.
function cellSides({ sides: [a, b], isPeriodic }) {
  if (a[0] * b[1] - a[1] * b[0] !== 0) {
    return [a, b];
  }
  return isPeriodic[0] ? [a, [-a[1], a[0]]] : [[b[1], -b[0]], b];
}

function shiftedEdges(edges, shifts, outside) {
  if (!edges) {
    return undefined;
  }
  const result = new Int32Array(edges.length);
  for (let e = 0; e !== edges.length; e += 2) {
    for (let k = 0; k !== 2; ++k) {
      result[e + k] = (shifts ? shifts[e + k] : 0) + outside[2 * edges[e + 1] + k] - outside[2 * edges[e] + k];
    }
  }
  return result;
}

// The same scene with all points in the cell. A scene without a cell is returned as it is.
export function wrapped(scene) {
  if (!scene.cell) {
    return scene;
  }
  const { cell, triangles } = scene;
  const [a, b] = cell.sides;
  const outside = shiftsOutOfCell(scene.positions, cell);
  if (!triangles && outside.every(shift => shift === 0)) {
    return scene;
  }
  const positions = new Float64Array(scene.positions.length);
  for (let i = 0; i !== positions.length; i += 2) {
    positions[i] = scene.positions[i] - outside[i] * a[0] - outside[i + 1] * b[0];
    positions[i + 1] = scene.positions[i + 1] - outside[i] * a[1] - outside[i + 1] * b[1];
  }
  const result = { ...scene, positions };
  for (const name of ["edge", "changed", "removed", "wrong"]) {
    const edges = name === "edge" ? scene.edges : scene[name];
    result[name + "Shifts"] = shiftedEdges(edges, scene[name + "Shifts"], outside);
  }
  if (triangles) {
    const shifts = new Int32Array(2 * triangles.length);
    for (let c = 0; c !== triangles.length; ++c) {
      const first = c - c % 3; // the triangle's first corner lies in the cell
      for (let k = 0; k !== 2; ++k) {
        const of = at => (scene.triangleShifts ? scene.triangleShifts[2 * at + k] : 0) + outside[2 * triangles[at] + k];
        shifts[2 * c + k] = of(c) - of(first);
      }
    }
    result.triangleShifts = shifts;
  }
  return result;
}

// Of the cell or of all points, with the outline: { low: [x, y], high: [x, y] }.
export function boundsOf(scene) {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  const take = (x, y) => {
    if (Number.isFinite(x) && Number.isFinite(y)) {
      low[0] = Math.min(low[0], x);
      low[1] = Math.min(low[1], y);
      high[0] = Math.max(high[0], x);
      high[1] = Math.max(high[1], y);
    }
  };
  const { positions } = wrapped(scene);
  for (let i = 0; i !== positions.length; i += 2) {
    take(positions[i], positions[i + 1]);
  }
  outlineOf(scene).forEach(([x, y]) => take(x, y));
  return low[0] <= high[0] ? { low, high } : { low: [0, 0], high: [1, 1] };
}

// Of walls, or the cell.
export function outlineOf({ cell, outline }) {
  if (!cell) {
    return outline ?? [];
  }
  const { corner: [x, y], sides: [a, b] } = cell;
  return [[x, y], [x + a[0], y + a[1]], [x + a[0] + b[0], y + a[1] + b[1]], [x + b[0], y + b[1]]];
}

// Appends x0, y0, x1, y1 on the screen for each edge. An edge that leaves the cell is drawn as two halves, one at each
// end.
export function edgeSegments(out, view, positions, edges, shifts, cell) {
  out.clear();
  out.reserve((shifts ? 4 : 2) * edges.length);
  for (let e = 0; e !== edges.length; e += 2) {
    const i = 2 * edges[e], j = 2 * edges[e + 1];
    const x0 = view.x(positions[i]), y0 = view.y(positions[i + 1]);
    const x1 = view.x(positions[j]), y1 = view.y(positions[j + 1]);
    if (!shifts || (shifts[e] === 0 && shifts[e + 1] === 0)) {
      out.push4(x0, y0, x1, y1);
    } else {
      const dx = (shifts[e] * cell.sides[0][0] + shifts[e + 1] * cell.sides[1][0]) * view.scale;
      const dy = -(shifts[e] * cell.sides[0][1] + shifts[e + 1] * cell.sides[1][1]) * view.scale;
      out.push4(x0, y0, (x0 + x1 + dx) / 2, (y0 + y1 + dy) / 2);
      out.push4(x1, y1, (x1 + x0 - dx) / 2, (y1 + y0 - dy) / 2);
    }
  }
  return out;
}

// Of each triangle: x, y of the center, and the radius; NaN where the corners lie on a line. Corners are where the
// scene has them, with their shifts.
export function circumcircles({ positions, triangles, triangleShifts, cell }) {
  const circles = new Float64Array(triangles.length);
  const corner = [0, 0, 0, 0, 0, 0];
  for (let t = 0; t !== triangles.length; t += 3) {
    for (let k = 0; k !== 3; ++k) {
      const i = 2 * triangles[t + k];
      const at = 2 * (t + k);
      for (let axis = 0; axis !== 2; ++axis) {
        corner[2 * k + axis] = positions[i + axis] + (!triangleShifts ? 0
          : triangleShifts[at] * cell.sides[0][axis] + triangleShifts[at + 1] * cell.sides[1][axis]);
      }
    }
    const bx = corner[2] - corner[0], by = corner[3] - corner[1];
    const cx = corner[4] - corner[0], cy = corner[5] - corner[1];
    const twice = 2 * (bx * cy - by * cx);
    const b = bx * bx + by * by, c = cx * cx + cy * cy;
    const x = (cy * b - by * c) / twice, y = (bx * c - cx * b) / twice;
    circles[t] = corner[0] + x;
    circles[t + 1] = corner[1] + y;
    circles[t + 2] = Math.hypot(x, y);
  }
  return circles;
}

// Calls visit(c, d) for each side that two triangles share, and visit(c, -1) for one that is of a single triangle. c and
// d are the places in `triangles` of the corners opposite to the side. In a cell the same image of a side is meant.
function forEachSide({ positions, triangles, triangleShifts: shifts }, visit) {
  const corners = triangles.length;
  const first = c => c - c % 3 + (c + 1) % 3, second = c => c - c % 3 + (c + 2) % 3;
  const key = new Uint32Array(corners), other = new Uint32Array(corners);
  const shiftX = shifts ? new Int32Array(corners) : null, shiftY = shifts ? new Int32Array(corners) : null;
  const starts = new Uint32Array(positions.length / 2 + 1);
  for (let c = 0; c !== corners; ++c) {
    let from = first(c), to = second(c);
    const dx = shifts ? shifts[2 * to] - shifts[2 * from] : 0;
    const dy = shifts ? shifts[2 * to + 1] - shifts[2 * from + 1] : 0;
    const a = triangles[from], b = triangles[to];
    const isReversed = a > b || (a === b && (dx < 0 || (dx === 0 && dy < 0)));
    key[c] = isReversed ? b : a;
    other[c] = isReversed ? a : b;
    if (shifts) {
      shiftX[c] = isReversed ? -dx : dx;
      shiftY[c] = isReversed ? -dy : dy;
    }
    ++starts[key[c] + 1];
  }
  for (let i = 1; i !== starts.length; ++i) {
    starts[i] += starts[i - 1];
  }
  const sides = new Uint32Array(corners), ends = starts.slice();
  for (let c = 0; c !== corners; ++c) {
    sides[ends[key[c]]++] = c;
  }
  const isDone = new Uint8Array(corners);
  for (let i = 0; i + 1 !== starts.length; ++i) {
    for (let p = starts[i]; p !== starts[i + 1]; ++p) {
      const c = sides[p];
      if (isDone[c]) {
        continue;
      }
      let twin = -1;
      for (let q = p + 1; q !== starts[i + 1] && twin < 0; ++q) {
        const d = sides[q];
        if (!isDone[d] && other[c] === other[d] && (!shifts || (shiftX[c] === shiftX[d] && shiftY[c] === shiftY[d]))) {
          twin = d;
          isDone[d] = 1;
        }
      }
      visit(c, twin);
    }
  }
}

// Appends x0, y0, x1, y1 on the screen for each edge of the Voronoi diagram. One of a hull edge goes on to beyond the
// screen.
export function voronoiSegments(out, view, scene, circles) {
  out.clear();
  const { positions, triangles, triangleShifts: shifts, cell } = scene;
  const reach = 2 * (view.width + view.height);
  forEachSide(scene, (c, d) => {
    const t = c - c % 3;
    const x = view.x(circles[t]), y = view.y(circles[t + 1]);
    if (!(Math.abs(x) < 1e7 && Math.abs(y) < 1e7)) {
      return; // of points on a line
    }
    const from = t + (c + 1) % 3, to = t + (c + 2) % 3;
    if (d < 0) {
      let dx = positions[2 * triangles[to]] - positions[2 * triangles[from]];
      let dy = positions[2 * triangles[to] + 1] - positions[2 * triangles[from] + 1];
      if (shifts) {
        const along = axis => (shifts[2 * to] - shifts[2 * from]) * cell.sides[0][axis] +
          (shifts[2 * to + 1] - shifts[2 * from + 1]) * cell.sides[1][axis];
        dx += along(0);
        dy += along(1);
      }
      const length = Math.hypot(dx, dy) || 1;
      out.push4(x, y, x + dy / length * reach, y + dx / length * reach); // outwards; on the screen y goes down
      return;
    }
    const u = d - d % 3;
    let cx = circles[u], cy = circles[u + 1];
    if (shifts) {
      // the side's first point, as each of the triangles has it
      const mate = triangles[from] === triangles[u + (d + 2) % 3] ? u + (d + 2) % 3 : u + (d + 1) % 3;
      const by = [0, 1].map(k => shifts[2 * from + k] - shifts[2 * mate + k]);
      cx += by[0] * cell.sides[0][0] + by[1] * cell.sides[1][0];
      cy += by[0] * cell.sides[0][1] + by[1] * cell.sides[1][1];
    }
    if (Math.abs(view.x(cx)) < 1e7 && Math.abs(view.y(cy)) < 1e7) {
      out.push4(x, y, view.x(cx), view.y(cy));
    }
  });
  return out;
}

const angleOfChord = Math.PI / 16; // that stands for an arc

// Of cells as Triangulation.boundedCells() has them: { cellContacts, cellBorders }, with each cell around its point as
// wrapped() has it.
export function boundedSegments({ begins, sides, starts, ends, angles }, positions, cell) {
  const contacts = [], borders = [];
  const outside = cell && shiftsOutOfCell(positions, cell);
  for (let i = 0; i + 1 < begins.length; ++i) {
    const [dx, dy] = cell ? [0, 1].map(axis => -outside[2 * i] * cell.sides[0][axis] -
                                               outside[2 * i + 1] * cell.sides[1][axis]) : [0, 0];
    for (let k = begins[i]; k !== begins[i + 1]; ++k) {
      const x = positions[2 * i], y = positions[2 * i + 1];
      const fromX = starts[2 * k] - x, fromY = starts[2 * k + 1] - y;
      const chords = Math.max(1, Math.ceil(angles[k] / angleOfChord));
      let lastX = starts[2 * k] + dx, lastY = starts[2 * k + 1] + dy;
      for (let c = 1; c <= chords; ++c) {
        const turn = angles[k] * c / chords, cosine = Math.cos(turn), sine = Math.sin(turn);
        const nextX = (c === chords ? ends[2 * k] : x + cosine * fromX - sine * fromY) + dx;
        const nextY = (c === chords ? ends[2 * k + 1] : y + sine * fromX + cosine * fromY) + dy;
        (sides[k] === 0 ? contacts : borders).push(lastX, lastY, nextX, nextY);
        [lastX, lastY] = [nextX, nextY];
      }
    }
  }
  return { cellContacts: Float64Array.from(contacts), cellBorders: Float64Array.from(borders) };
}

// The point of the scene that is seen nearest to a pixel, within `reach` pixels; -1 if none is.
export function nearestPoint(scene, view, pixelX, pixelY, reach) {
  const { positions } = wrapped(scene);
  let nearest = -1, least = reach * reach;
  for (let i = 0; i !== positions.length; i += 2) {
    const dx = view.x(positions[i]) - pixelX, dy = view.y(positions[i + 1]) - pixelY;
    const squared = dx * dx + dy * dy;
    if (squared <= least) {
      least = squared;
      nearest = i / 2;
    }
  }
  return nearest;
}
