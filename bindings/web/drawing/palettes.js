// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The colors of pictures and curves, on a light and on a dark ground. Sets have the colors of figure 4.1 of the thesis
// (Classified red, Padded green, Border cyan), speeds those of its figure 5.1 (cyan at rest, blue, pink when fast).
//
// A palette is an object of CSS colors "#rrggbb" by these names:
//   ground, text, dimText       the background, letters, letters that matter less (contrast at least 4.5 to the ground)
//   edge, point, outline        the triangulation, a point in no set, the walls or the cell
//   border, padded, classified  sets, by the numbers 1, 2, 3 of `setNames`
//   changed, removed, wrong     edges that are new, edges that are gone, edges that are not Delaunay
//   voronoi, circumcircle       the dual, the circumcircles
//   curves                      an array of colors for lines of a chart
//   speeds                      `speedSteps` colors from rest to fast

export const setNames = ["none", "border", "padded", "classified"];
export const speedSteps = 32;

function channels(color) {
  return [1, 3, 5].map(at => parseInt(color.slice(at, at + 2), 16));
}

// Red, green and blue between 0 and 1.
export function colorChannels(color) {
  return channels(color).map(value => value / 255);
}

function between(from, to, share) {
  const b = channels(to);
  return "#" + channels(from).map((value, i) =>
    Math.round(value + share * (b[i] - value)).toString(16).padStart(2, "0")).join("");
}

function ramp(colors) {
  return Array.from({ length: speedSteps }, (_, i) => {
    const at = i / (speedSteps - 1) * (colors.length - 1);
    const k = Math.min(Math.floor(at), colors.length - 2);
    return between(colors[k], colors[k + 1], at - k);
  });
}

export const palettes = {
  light: {
    ground: "#ffffff", text: "#1b2430", dimText: "#56616f",
    edge: "#9aa4b0", point: "#3c4653", outline: "#1b2430",
    border: "#00a9c9", padded: "#1d9a3c", classified: "#e02020",
    changed: "#e07b00", removed: "#7a5cc4", wrong: "#d1006c",
    voronoi: "#3f6fd0", circumcircle: "#a08a5a",
    curves: ["#2563c9", "#c2410c", "#15803d", "#a21caf", "#0e7490"],
    speeds: ramp(["#00b4d0", "#2346d8", "#f0389a"]),
  },
  dark: {
    ground: "#12161c", text: "#eef2f7", dimText: "#a7b2c0",
    edge: "#566373", point: "#c3ccd8", outline: "#eef2f7",
    border: "#2bd4f0", padded: "#3fcf63", classified: "#ff5a52",
    changed: "#ffb020", removed: "#a78bfa", wrong: "#ff4fb0",
    voronoi: "#6f9bff", circumcircle: "#b8a26c",
    curves: ["#6ea8ff", "#ff9a5c", "#5ad07f", "#e58cf0", "#4fd3e6"],
    speeds: ramp(["#2be0f5", "#5a78ff", "#ff5cb5"]),
  },
};

// By number of the set.
export function setColor(palette, set) {
  return set === 0 ? palette.point : palette[setNames[set]];
}

// "light" or "dark", as the person's system asks for.
export function preferredTheme() {
  return globalThis.matchMedia?.("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}
