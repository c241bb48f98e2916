// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

declare global {
  interface SymbolConstructor { // as newer versions of TypeScript have it, for `using`
    readonly dispose: unique symbol;
  }
}

/** Points: flat, two coordinates for each, which is the fast way; or rows [x, y]. */
export type Points = ArrayLike<number> | ArrayLike<ArrayLike<number>>;

/** One id, or several. */
export type Ids = number | ArrayLike<number> | Iterable<number>;

/** The address of a WebAssembly module of this package, its bytes, or the compiled module. In Node.js an address without a
    protocol is a path. */
export type Wasm = string | URL | ArrayBuffer | ArrayBufferView | (WebAssembly.Module & object);

/** A parallelogram that repeats itself. Without `b` a slab: periodic along `a`, open across. */
export interface Cell {
  a: [number, number];
  b?: [number, number];
}

export interface Options {
  /** Makes the space periodic. */
  cell?: Cell;
  /** As `./dev run --classifier` has it: "circumcircle" (exact, the usual one), "point_distance:0.7", ... */
  classifier?: string;
  /** "hold_and_flip", ...; by default the one that fits the classifier. */
  repair?: string;
  /** "always_dynamic" (the usual one), "hybrid", "always_static", "key_frames:10", ... */
  policy?: string;
  /** Rings of neighbors around classified vertices that a splice triangulates anew. */
  padding?: number;
  /** Of the classifiers that use random numbers. */
  seed?: number;
  /** Where the WebAssembly module is, if a bundler has not put it beside the bundle: the one for these options, or that
      of all. */
  wasm?: Wasm;
}

/** Counts of the last change, as in `CGAL::Update_report_2`. */
export interface Report {
  classified: number;
  padded: number;
  border: number;
  flips: number;
  splices: number;
  spliced: number;
  enlargements: number;
  relocated: number;
  inserted: number;
  removed: number;
  merged: number;
  parted: number;
  /** Why the frame was triangulated anew: "policy", "too_much_broken", ...; empty if it was not. */
  rebuildReason: string;
  certified: boolean;
}

/** In a periodic triangulation edges lead to images: the second point plus shift[0] times `a` plus shift[1] times `b`. */
export interface ShiftedEdges {
  ids: Int32Array;
  shifts: Int32Array;
}

/** Of points that coincide, one has the edges: the list of each other one is that one alone, and its list ends with the
    others. The list of a removed id is empty. */
export interface NeighborLists {
  /** The neighbors of id i are neighbors[begins[i]] to before neighbors[begins[i + 1]]. */
  begins: Int32Array;
  neighbors: Int32Array;
  /** Two for each neighbor; empty in the plane. */
  shifts: Int32Array;
}

export interface ChangedEdges {
  created: Int32Array;
  removed: Int32Array;
  createdShifts: Int32Array;
  removedShifts: Int32Array;
}

/** By id. Cells that are not bounded have infinite areas and perimeters. */
export interface Cells {
  areas: Float64Array;
  perimeters: Float64Array;
  centroids: Float64Array;
  /** Perimeter by the square root of the area. */
  shapeIndices: Float64Array;
}

/** Voronoi cells that end at a radius, in a convex domain, or at both, as in `CGAL::Bounded_voronoi_cells_2`. The pieces
    of the boundary of cell i are begins[i] to before begins[i + 1], counterclockwise: segments, and arcs at the radius. */
export interface BoundedCells {
  /** By id. */
  radii: Float64Array;
  areas: Float64Array;
  perimeters: Float64Array;
  centroids: Float64Array;
  /** Of what touches no other cell and no wall. */
  freeLengths: Float64Array;
  wallLengths: Float64Array;
  begins: Int32Array;
  /** What is beyond each piece: 0 a neighbor's cell, 1 the outside of the domain, 2 nothing. */
  sides: Int32Array;
  /** The neighbor; of a wall its number, from that after the first corner; else the id of the cell. */
  others: Int32Array;
  /** Two for each piece, of the neighbor; zero in the plane. */
  shifts: Int32Array;
  starts: Float64Array;
  ends: Float64Array;
  lengths: Float64Array;
  /** Of arcs around their points, in radians; 0 of segments. */
  angles: Float64Array;
}

export interface VoronoiEdges {
  /** The two points whose cells meet there. */
  pairs: Int32Array;
  lengths: Float64Array;
  shifts: Int32Array;
}

export interface Choices {
  classifiers: {
    name: string;
    isExact: boolean;
    parameter?: { name: string; usual: number };
  }[];
  repairs: string[];
  policies: string;
}

/** Thrown for bad input and wrong use, before anything changes. `name` is that of the error in Python, or "ModuleError" if
    a WebAssembly module cannot be loaded; `details` is what the message speaks of, such as an id, a coordinate or a key. If
    memory runs out, a RangeError is thrown. */
export class DynamicDelaunayError extends Error {
  private constructor();
  readonly details: Record<string, number | string>;
}

/** The Delaunay triangulation of moving points. A new point gets the smallest id that is free: the first ones 0, 1, ..., and
    later ones first the ids of removed points. */
export class Triangulation {
  private constructor();
  /** Loads the WebAssembly module at the first call. */
  static create(points?: Points, options?: Options): Promise<Triangulation>;
  /** What `classifier`, `repair` and `policy` may be. */
  static choices(options?: { wasm?: Wasm }): Promise<Choices>;

  /** The next frame: a point for each id, those of removed ids being ignored; the cell may change. */
  update(points: Points, cell?: Cell): Report;
  move(ids: Ids, points: Points): Report;
  /** Returns the new ids. */
  insert(points: Points): Int32Array;
  remove(ids: Ids): Report;
  /** Makes a triangulation Delaunay that a heuristic classifier has left. */
  mend(): Report;
  /** Proves by exact predicates that every edge is locally Delaunay, or answers false. */
  certify(): boolean;

  /** Whether the triangulation is proved to be Delaunay. */
  readonly isCertified: boolean;
  readonly isPeriodic: boolean;
  /** Of the last change. */
  readonly report: Report;
  readonly numberOfPoints: number;
  /** One more than the largest id. */
  readonly numberOfIds: number;
  /** Points that coincide have one vertex. */
  readonly numberOfVertices: number;
  has(id: number): boolean;

  /** NaN where an id was removed. */
  points(): Float64Array;
  /** Pairs: a point without a vertex of its own, and the one that has it. */
  duplicates(): Int32Array;
  edges(): Int32Array;
  /** Three ids for each, counterclockwise. */
  triangles(): Int32Array;
  /** Three for each triangle: the number of the triangle across from each corner, -1 on the border. Only in the plane. Takes
      several times as long as `triangles()`. */
  neighbors(): Int32Array;
  /** In the plane all shifts are zero, and the array is empty. */
  edgesWithShifts(): ShiftedEdges;
  trianglesWithShifts(): ShiftedEdges;
  neighborLists(): NeighborLists;
  /** In the plane cells can be cut by a box: xmin, ymin, xmax, ymax. */
  cells(box?: [number, number, number, number]): Cells;
  /** `domain`: the corners of a convex polygon, counterclockwise; only in the plane. A point may be
      outside: its cell is what the domain has of it. Without a domain there must be a radius. */
  boundedCells(bounds?: { radius?: number; domain?: Points }): BoundedCells;
  /** Counterclockwise; none if the cell is not bounded. */
  cellCorners(id: number): Float64Array;
  voronoiEdges(): VoronoiEdges;
  /** Of the last call that changed points. */
  changedEdges(): ChangedEdges;
  /** By id: 3 in the Classified set of the last update, 2 in the Padded set, 1 in the Border set, 0 in none. */
  sets(): Int32Array;
  /** Edges that are not locally Delaunay, after an update by a heuristic classifier. */
  brokenEdges(): ShiftedEdges;

  /** Gives the memory back to the WebAssembly module, for other triangulations. Nothing else may be called afterwards. */
  dispose(): void;
  [Symbol.dispose](): void;
}
