// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture of a scene (geometry.js says what a scene is) on a canvas, and the same picture as SVG or PNG.
//
//   const picture = new Picture(canvas);
//   picture.scene = { positions, edges, ... };
//   picture.fit();                            shows all of it; also after the canvas has another size
//   picture.layers.voronoi = true;            what is drawn: see `layerNames`; also `cells`, if the scene has bounded ones
//   picture.palette = palettes.dark;
//   picture.draw();                           at once; picture.requestDraw() before the next frame of the screen
//   picture.svg("title"), await picture.png()
//   picture.nearestPoint(event.offsetX, event.offsetY)   the number of a point, or -1
//
// Points have the color of their set if `sets` is drawn and they are in one, else that of their speed if `speeds` is
// drawn, else one color. `picture.legend()` lists what the colors mean.

import { boundsOf, circumcircles, edgeSegments, Floats, nearestPoint, outlineOf, voronoiSegments, wrapped }
  from "./geometry.js";
import { palettes, preferredTheme, setColor, setNames, speedSteps } from "./palettes.js";
import { openPen, SvgPen } from "./pens.js";
import { View } from "./view.js";

export const layerNames = {
  edges: "Triangulation",
  points: "Points",
  sets: "Classified, Padded, Border",
  speeds: "Speed",
  voronoi: "Voronoi cells",
  circumcircles: "Circumcircles",
  changed: "New edges",
  removed: "Gone edges",
  wrong: "Wrong edges",
};

export function usualLayers() {
  return { edges: true, points: true, sets: true, speeds: false, voronoi: false, circumcircles: false, changed: true,
           removed: false, wrong: true };
}

const floats = new Floats();

// Draws a scene with any pen. `pointRadius`: in pixels; by default as large as the room between points allows.
export function paint(pen, scene, view, { layers = usualLayers(), palette = palettes.light, pointRadius } = {}) {
  const shown = wrapped(scene);
  const radius = pointRadius ?? usualRadius(scene, view);
  const line = Math.min(1.2, Math.max(0.35, 0.4 * radius));
  pen.begin(view.width, view.height, palette.ground);
  paintOutline(pen, scene, view, palette);
  paintCircles(pen, shown, view, layers, palette, line);
  if (layers.cells) {
    paintCells(pen, scene, view, palette, line);
  }
  const edges = (name, style) => {
    if (layers[name] && shown[name]) {
      const shifts = shown[name === "edges" ? "edgeShifts" : name + "Shifts"];
      pen.segments(edgeSegments(floats, view, shown.positions, shown[name], shifts, shown.cell).values, style);
    }
  };
  edges("edges", { color: palette.edge, width: line });
  edges("removed", { color: palette.removed, width: 1.5 * line + 0.6, alpha: 0.8 });
  edges("changed", { color: palette.changed, width: 2 * line + 0.8 });
  edges("wrong", { color: palette.wrong, width: 2 * line + 2 });
  if (layers.points) {
    paintPoints(pen, shown, view, layers, palette, radius);
  }
  paintMarks(pen, scene, view, palette, radius);
  return pen.end();
}

function paintOutline(pen, scene, view, palette) {
  const corners = outlineOf(scene);
  floats.clear();
  corners.forEach(([x, y], i) => {
    const [nextX, nextY] = corners[(i + 1) % corners.length];
    floats.push4(view.x(x), view.y(y), view.x(nextX), view.y(nextY));
  });
  pen.segments(floats.values, { color: palette.outline, width: 1.25, alpha: 0.7 });
}

function paintCircles(pen, scene, view, layers, palette, line) {
  if (!scene.triangles || !(layers.voronoi || layers.circumcircles)) {
    return;
  }
  const circles = circumcircles(scene);
  if (layers.circumcircles) {
    const largest = 4 * (view.width + view.height);
    floats.clear();
    for (let t = 0; t !== circles.length; t += 3) {
      const radius = circles[t + 2] * view.scale;
      if (radius < largest) { // a larger one is a line for the eye; of points on a line there is none
        floats.push3(view.x(circles[t]), view.y(circles[t + 1]), radius);
      }
    }
    pen.rings(floats.values, { color: palette.circumcircle, width: line, alpha: 0.55 });
  }
  if (layers.voronoi) {
    pen.segments(voronoiSegments(floats, view, scene, circles).values, { color: palette.voronoi, width: 1.2 * line });
  }
}

const ringOfWall = 9; // pixels, where a wall is held

function paintCells(pen, { cellContacts, cellBorders, wall }, view, palette, line) {
  const segments = (values, style) => {
    floats.clear();
    for (let i = 0; i < values.length; i += 4) {
      floats.push4(view.x(values[i]), view.y(values[i + 1]), view.x(values[i + 2]), view.y(values[i + 3]));
    }
    pen.segments(floats.values, style);
  };
  if (cellContacts) {
    segments(cellContacts, { color: palette.voronoi, width: 1.2 * line });
    segments(cellBorders, { color: palette.voronoi, width: 2 * line + 0.6 });
  }
  if (wall) {
    segments(wall.flat(), { color: palette.outline, width: 4 });
    floats.clear();
    wall.forEach(([x, y]) => floats.push3(view.x(x), view.y(y), ringOfWall));
    pen.rings(floats.values, { color: palette.outline, width: 2.5 });
  }
}

// Lists of points that are drawn in one color, later ones over the others.
function paintPoints(pen, scene, view, layers, palette, radius) {
  const { positions, sets, speeds, speedScale = 1 } = scene;
  const number = positions.length / 2;
  const bySet = layers.sets && sets, bySpeed = layers.speeds && speeds;
  const group = new Uint8Array(number);
  for (let i = 0; i !== number; ++i) {
    const set = bySet ? sets[i] : 0;
    group[i] = set !== 0 ? speedSteps + set
      : bySpeed ? Math.round(Math.min(1, Math.max(0, speeds[i] / speedScale || 0)) * (speedSteps - 1)) : speedSteps;
  }
  const starts = new Uint32Array(speedSteps + setNames.length + 1);
  for (const g of group) {
    ++starts[g + 1];
  }
  for (let g = 1; g !== starts.length; ++g) {
    starts[g] += starts[g - 1];
  }
  const order = new Uint32Array(number), ends = starts.slice();
  for (let i = 0; i !== number; ++i) {
    order[ends[group[i]]++] = i;
  }
  for (let g = 0; g + 1 !== starts.length; ++g) {
    floats.clear();
    for (let k = starts[g]; k !== starts[g + 1]; ++k) {
      const x = positions[2 * order[k]], y = positions[2 * order[k] + 1];
      if (x === x) { // else the point is not there
        floats.push(view.x(x), view.y(y));
      }
    }
    if (floats.size !== 0) {
      const set = g - speedSteps;
      pen.discs(floats.values, { color: set < 0 ? palette.speeds[g] : setColor(palette, set),
                                 radius: set > 0 ? 1.25 * radius : radius });
    }
  }
}

function paintMarks(pen, { marks = [] }, view, palette, radius) {
  floats.clear();
  for (const [x, y] of marks) {
    floats.push3(view.x(x), view.y(y), 2 * radius + 6);
  }
  pen.rings(floats.values, { color: palette.text, width: 2.5 });
}

function usualRadius(scene, view) {
  const { low, high } = view.fitted;
  const number = Math.max(1, scene.positions.length / 2);
  const room = Math.sqrt((high[0] - low[0]) * (high[1] - low[1]) / number) * view.scale;
  return Math.min(7, Math.max(0.75, 0.13 * room));
}

export class Picture {
  constructor(canvas, { preferred } = {}) {
    this.canvas = canvas;
    this.pen = openPen(canvas, { preferred });
    this.view = new View();
    this.layers = usualLayers();
    this.palette = palettes[preferredTheme()];
    this.scene = { positions: new Float64Array(0) };
    this.pointRadius = undefined;
    this.requested = null;
    canvas.addEventListener("webglcontextrestored", () => this.draw());
  }

  // Takes the size that the page gives the canvas. True if it is another one than before.
  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === this.view.width && clientHeight === this.view.height) {
      return false;
    }
    this.view.resize(clientWidth, clientHeight);
    return true;
  }

  fit(bounds = boundsOf(this.scene)) {
    this.resize();
    this.view.fit(bounds);
  }

  draw() {
    this.resize();
    paint(this.pen, this.scene, this.view, this);
  }

  requestDraw() {
    this.requested ??= requestAnimationFrame(() => {
      this.requested = null;
      this.draw();
    });
  }

  svg(title) {
    return paint(new SvgPen({ title }), this.scene, this.view, this);
  }

  // A Blob. Drawn in the same task, as WebGL keeps no picture beyond it.
  png() {
    this.draw();
    return new Promise(done => this.canvas.toBlob(done, "image/png"));
  }

  nearestPoint(pixelX, pixelY, reach = 20) {
    return nearestPoint(this.scene, this.view, pixelX, pixelY, reach);
  }

  // What is drawn, as { kind: "disc" | "line" | "ramp", color or colors, text }.
  legend() {
    const { layers, palette, scene } = this;
    const entries = [];
    const add = (isThere, kind, color, text) => isThere && entries.push({ kind, color, text });
    if (layers.points && layers.sets && scene.sets) {
      add(true, "disc", palette.classified, "Classified");
      add(true, "disc", palette.padded, "Padded");
      add(true, "disc", palette.border, "Border");
    }
    if (layers.points && layers.speeds && scene.speeds) {
      entries.push({ kind: "ramp", colors: palette.speeds, text: "at rest to fast" });
    }
    add(layers.changed && scene.changed, "line", palette.changed, "new edge");
    add(layers.removed && scene.removed, "line", palette.removed, "gone edge");
    add(layers.wrong && scene.wrong?.length, "line", palette.wrong, "wrong edge");
    add(layers.voronoi && scene.triangles, "line", palette.voronoi, "Voronoi cell");
    add(layers.cells && scene.cellContacts, "line", palette.voronoi, "cell with borders");
    add(layers.circumcircles && scene.triangles, "line", palette.circumcircle, "circumcircle");
    return entries;
  }
}

// Fills an element with the entries of a legend.
export function showLegend(element, entries) {
  element.replaceChildren(...entries.map(({ kind, color, colors, text }) => {
    const item = document.createElement("span");
    item.className = "legend-entry";
    const mark = document.createElement("i");
    mark.className = "legend-" + kind;
    mark.style.background = colors ? `linear-gradient(to right, ${colors.join(", ")})` : color;
    item.append(mark, text);
    return item;
  }));
}
