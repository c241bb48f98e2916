// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the five steps of a frame from a small triangulation that is really updated: by a border splice, so that all sets
// are there, each time that some points are moved.

import { palettes, preferredTheme } from "../drawing/palettes.js";
import { Picture } from "../drawing/picture.js";
import { Triangulation } from "../package/dynamic_delaunay.mjs";

const element = id => document.getElementById(id);
const side = 14;        // points along each side of the square
const numberMoved = 2; // points; the others stay

const none = new Int32Array(0);
const hidden = { edges: true, points: true, sets: true, speeds: false, voronoi: false, circumcircles: false,
                 changed: false, removed: false, wrong: false };

const tooMuch = "Here so much was broken that it was cheaper to triangulate everything anew.";

// Of each step: what it shows of an update, and what it says.
const steps = {
  classify: { scene: update => ({ ...old(update), removed: update.removed, sets: setsFrom(update, 3) }),
              layers: { ...hidden, removed: true },
              told: ({ report, removed }) => `Here ${report.classified} points are Classified, and ` +
                `${removed.length / 2} edges will be gone.` },
  pad: { scene: update => ({ ...old(update), sets: setsFrom(update, 2) }), layers: hidden,
         told: ({ report }) => report.rebuildReason ? tooMuch : `Here they are ${report.padded}.` },
  border: { scene: update => ({ ...old(update), sets: setsFrom(update, 1) }), layers: hidden,
            told: ({ report, positions }) => report.rebuildReason ? tooMuch : `Here they are ${report.border}; ` +
              `${positions.length / 2 - report.classified - report.padded - report.border} points are in none of the sets.` },
  repair: { scene: update => ({ ...anew(update), changed: update.created, sets: setsFrom(update, 1) }),
            layers: { ...hidden, changed: true },
            told: ({ report, created }) => `Here ${created.length / 2} edges are new, by ` + (report.rebuildReason
              ? "triangulating everything." : [[report.splices, "splice"], [report.flips, "flip"]]
                .filter(([number]) => number !== 0)
                .map(([number, name]) => `${number} ${name}${number === 1 ? "" : "s"}`).join(" and ") + ".") },
  prove: { scene: update => ({ ...anew(update), triangles: mended(update), sets: setsFrom(update, 4) }),
           layers: { ...hidden, circumcircles: true },
           told: ({ isCertified, edges }) => `Here ${edges.length / 2} edges: ${isCertified ? "certified Delaunay" : "not certified"}.` },
};

const old = ({ positions, edgesBefore }) => ({ positions, edges: edgesBefore });
const anew = ({ positions, edges }) => ({ positions, edges });
// All circles would hide everything: those of triangles at Classified points, and of all if there are no sets.
function mended({ triangles, sets, report }) {
  const isMended = t => report.rebuildReason || [0, 1, 2].some(k => sets[triangles[t + k]] === 3);
  return triangles.filter((_, c) => isMended(c - c % 3));
}
const setsFrom = ({ sets }, least) => sets.map(set => set >= least ? set : 0);

// Uniform in [-1, 1), the same ones each time (mulberry32).
function randomSource(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6D2B79F5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 31 - 1;
  };
}

function shakenGrid(random) {
  return Float64Array.from({ length: 2 * side * side }, (_, i) =>
    ((i % 2 === 0 ? (i / 2) % side : Math.floor(i / 2 / side)) + 0.38 * random()) / (side - 1));
}

class Explanation {
  constructor(triangulation, points, random) {
    Object.assign(this, { triangulation, random, points, update: null });
    this.theme = preferredTheme();
    this.pictures = Object.fromEntries([...document.querySelectorAll("canvas")].map(canvas => {
      const picture = new Picture(canvas, { preferred: "2d" });
      picture.layers = steps[canvas.dataset.step].layers;
      new ResizeObserver(() => picture.draw()).observe(canvas);
      return [canvas.dataset.step, picture];
    }));
    element("move").addEventListener("click", () => this.move());
    element("amount").addEventListener("change", () => this.move());
    element("theme").addEventListener("click", () => {
      this.theme = this.theme === "dark" ? "light" : "dark";
      this.useTheme();
    });
    this.useTheme();
    this.move();
  }

  useTheme() {
    document.documentElement.dataset.theme = this.theme;
    element("theme").textContent = this.theme === "dark" ? "Light" : "Dark";
    for (const picture of Object.values(this.pictures)) {
      picture.palette = palettes[this.theme];
      picture.requestDraw();
    }
  }

  // Some points, from where they began: they do not wander away.
  move() {
    const { triangulation, points, random } = this;
    triangulation.update(points);
    const edgesBefore = triangulation.edges();
    const amount = Number(element("amount").value);
    const positions = points.slice();
    for (let k = 0; k !== numberMoved; ++k) {
      const i = 2 * Math.floor((random() + 1) / 2 * side * side);
      positions[i] += amount * random();
      positions[i + 1] += amount * random();
    }
    const report = triangulation.update(positions);
    const { created, removed } = triangulation.changedEdges();
    this.show({ positions, edgesBefore, report, created, removed, sets: triangulation.sets(),
                edges: triangulation.edges(), triangles: triangulation.triangles(), isCertified: triangulation.isCertified });
  }

  show(update) {
    this.update = update;
    for (const [name, picture] of Object.entries(this.pictures)) {
      picture.scene = { changed: none, wrong: none, ...steps[name].scene(update) };
      picture.fit({ low: [-0.08, -0.08], high: [1.08, 1.08] });
      picture.draw();
      document.querySelector(`[data-told="${name}"]`).textContent = steps[name].told(update);
    }
  }
}

try {
  const random = randomSource(3);
  const points = shakenGrid(random);
  const triangulation = await Triangulation.create(points, { repair: "splice", policy: "always_dynamic" });
  globalThis.explanation = new Explanation(triangulation, points, random);
} catch (error) {
  element("refused").textContent = error.message;
  element("refused").hidden = false;
}
