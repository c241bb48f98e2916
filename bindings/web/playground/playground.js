// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of the playground: what is set, clicked and typed. A worker moves and triangulates the points; while it makes
// the next frame, the page draws the last one.

import { shortNumber } from "../drawing/curves.js";
import { palettes, preferredTheme, setNames } from "../drawing/palettes.js";
import { boundsOf } from "../drawing/geometry.js";
import { layerNames, Picture, showLegend } from "../drawing/picture.js";
import { Hand } from "./hand.js";
import { LiveCurves } from "./live_curves.js";
import { loadScenario, scenarios, spaces, usualGravityOf } from "./scenarios.js";
import { leastWall, linkOf, settingsOfLink, stepsPerFrame, tools, usualSettings } from "./settings.js";

const element = id => document.getElementById(id);
const toolTexts = { drag: "Drag", add: "Add", remove: "Remove", view: "View" };
const toolKeys = { d: "drag", a: "add", x: "remove", v: "view" };
const pace = { text: 250, curves: 120 }; // milliseconds: nobody reads sixty texts a second
const strides = { field: 0.25, pendulum: 2 }; // of an arrow key: in gravities, in diameters
const framesOfRate = 60;

function fill(select, texts) {
  select.replaceChildren(...Object.entries(texts).map(([value, text]) => new Option(text, value)));
}

const readable = name => name.replaceAll("_", " ");

class Playground {
  constructor() {
    this.settings = settingsOfLink(location.hash);
    this.accepted = this.settings; // the last that the worker plays
    this.worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    this.worker.onmessage = ({ data }) => this.heard[data.name](data);
    this.worker.onerror = event => this.tellRefused(event.message || "the worker cannot be loaded");
    this.theme = preferredTheme();
    this.picture = new Picture(element("picture"));
    this.curves = new LiveCurves(element("curves"));
    this.hand = new Hand(this.picture, told => told.name === "wall" ? this.moveWall(told) : this.tell(told));
    this.isPlaying = false;
    this.isWaiting = false; // for a frame
    this.stepsWanted = 0;
    this.isStale = false;   // something is to be shown that the last frame does not have
    this.arrived = null;
    this.state = null;
    this.bounds = null; // of what is to be seen
    this.choices = null;
    this.written = { text: 0, curves: 0 };
    this.shownAt = [];
    this.makeControls();
    this.listen();
    this.useTheme();
    this.tell({ name: "choices" });
    this.open();
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.play();
    }
    const tick = now => {
      requestAnimationFrame(tick);
      this.tick(now);
    };
    requestAnimationFrame(tick);
  }

  tell(message) {
    this.worker.postMessage(message);
    if (["add", "remove", "cells"].includes(message.name)) {
      this.isStale = true;
    } else if (message.name === "release") {
      this.settingsChanged(); // a wall may have been moved
    }
  }

  // What the worker says.
  heard = {
    choices: ({ choices }) => {
      this.choices = choices;
      this.fillChoices();
    },
    frame: frame => {
      this.isWaiting = false;
      if (frame.scene) {
        this.arrived = frame;
      }
    },
    accepted: ({ settings }) => {
      this.accepted = settings;
      this.isStale = true;
    },
    refused: ({ of, message }) => {
      this.tellRefused(message);
      if (of === "frame") {
        this.isWaiting = false;
        this.pause();
      } else if (of === "open" || of === "use") {
        const { tool, layers, cells, cellRadius, wallBelow, wallAbove } = this.settings;
        this.settings = { ...this.accepted, tool, layers, cells, cellRadius, wallBelow, wallAbove };
        this.settingsChanged();
        this.showSettings();
      }
    },
  };

  tellRefused(message) {
    element("refused").textContent = message;
    element("refused").hidden = message === "";
  }

  makeControls() {
    fill(element("scenario"), Object.fromEntries(Object.entries(scenarios).map(([name, { text }]) => [name, text])));
    fill(element("space"), spaces);
    fill(element("steps"), Object.fromEntries(stepsPerFrame.map(number => [number, number])));
    for (const [name, text] of Object.entries(layerNames)) {
      element("layers").append(this.choice("checkbox", "layer-" + name, "", text, box => {
        this.settings.layers = { ...this.settings.layers, [name]: box.checked };
        this.useLayers();
        this.settingsChanged();
      }));
    }
    for (const name of tools) {
      const label = this.choice("radio", "tool-" + name, "tool", toolTexts[name], () => this.useTool(name));
      label.title = `${toolTexts[name]} (${Object.keys(toolKeys).find(key => toolKeys[key] === name)})`;
      element("tools").append(label);
    }
  }

  choice(type, id, name, text, changed) {
    const label = document.createElement("label"), box = document.createElement("input");
    Object.assign(box, { type, id, name });
    box.addEventListener("change", () => changed(box));
    label.append(box, text);
    return label;
  }

  fillChoices() {
    const { classifiers, repairs, policies } = this.choices;
    fill(element("classifier"), Object.fromEntries(classifiers.map(({ name, isExact }) =>
      [name, readable(name) + (isExact ? " (exact)" : " (heuristic)")])));
    fill(element("repair"), { "": "usual", ...Object.fromEntries(repairs.map(name => [name, readable(name)])) });
    const names = policies.replace(/\(.*?\)/g, "").split(",").map(name => name.trim().replace(/:.*/, ""));
    fill(element("policy"), Object.fromEntries(names.map(name =>
      name === "key_frames" ? ["key_frames:10", "key frames: each 10th"] : [name, readable(name)])));
    this.showSettings();
  }

  listen() {
    const { picture } = this;
    const changed = (id, act) => element(id).addEventListener("change", () => act(element(id)));
    changed("scenario", ({ value }) => this.useScenario(value));
    changed("points", field => this.setNumber(field, "points", () => this.open()));
    changed("space", ({ value }) => this.set("space", value, () => this.open()));
    changed("steps", ({ value }) => this.set("steps", Number(value), () => {}));
    for (const name of ["gravity", "wind"]) {
      element(name).addEventListener("input", () => this.set(name, Number(element(name).value), () => this.useField()));
    }
    changed("cells", ({ checked }) => this.set("cells", checked, () => {}));
    element("cell-radius").addEventListener("input", () => {
      this.set("cellRadius", Number(element("cell-radius").value), () => this.useCells());
    });
    changed("classifier", ({ value }) => {
      this.settings.parameter = "";
      this.set("classifier", value, () => this.use());
    });
    changed("parameter", field => this.set("parameter", field.value === "" ? "" : Number(field.value), () => this.use()));
    changed("padding", field => this.setNumber(field, "padding", () => this.use()));
    changed("repair", ({ value }) => this.set("repair", value, () => this.use()));
    changed("policy", ({ value }) => this.set("policy", value, () => this.use()));

    const clicked = (id, act) => element(id).addEventListener("click", act);
    clicked("play", () => this.togglePlay());
    clicked("step", () => this.step());
    clicked("reset", () => this.open());
    clicked("link", () => this.copyLink());
    clicked("svg", () => this.save("svg", new Blob([picture.svg(document.title)], { type: "image/svg+xml" })));
    clicked("png", async () => this.save("png", await picture.png()));
    const zoom = factor => {
      picture.view.zoomAt(picture.view.width / 2, picture.view.height / 2, factor);
      picture.requestDraw();
    };
    clicked("closer", () => zoom(1.5));
    clicked("farther", () => zoom(1 / 1.5));
    clicked("fit", () => this.fit());
    clicked("theme", () => this.toggleTheme());
    picture.canvas.addEventListener("pointermove", event => this.tellPoint(event.offsetX, event.offsetY));
    picture.canvas.addEventListener("pointerleave", () => { element("told").hidden = true; });
    new ResizeObserver(() => picture.draw()).observe(picture.canvas);
    document.addEventListener("keydown", event => this.typed(event));
    addEventListener("hashchange", () => this.followLink());
  }

  typed(event) {
    const isControl = event.target.matches?.("select, input:not([type='checkbox']):not([type='radio'])") ||
      (event.key === " " && event.target.matches?.("button, input, summary, a"));
    const isTool = event.target.matches?.("input[type='radio']") && event.key.startsWith("Arrow");
    if (event.ctrlKey || event.altKey || event.metaKey || isControl || isTool) {
      return;
    }
    const isPendulum = this.settings.scenario === "pendulum";
    const push = (name, by) => {
      const value = Math.min(3, Math.max(-3, Number(element(name).value) + by));
      element(name).value = value;
      this.set(name, value, () => this.useField());
    };
    const sideways = by => isPendulum ? this.moveHand(by * strides.pendulum) : push("wind", by * strides.field);
    const actions = {
      " ": () => this.togglePlay(), n: () => this.step(), r: () => this.open(), c: () => this.copyLink(),
      t: () => this.toggleTheme(), b: () => element("cells").click(),
      ArrowLeft: () => sideways(-1), ArrowRight: () => sideways(1),
      ArrowUp: () => push("gravity", strides.field), ArrowDown: () => push("gravity", -strides.field),
    };
    if (Object.hasOwn(actions, event.key)) {
      event.preventDefault();
      actions[event.key]();
    } else if (Object.hasOwn(toolKeys, event.key)) {
      this.useTool(toolKeys[event.key]);
    } else if (/^[1-9]$/.test(event.key)) {
      element("layers").querySelectorAll("input")[event.key - 1]?.click();
    }
  }

  moveHand(by) {
    const [x] = this.picture.scene.marks?.[0] ?? [0];
    this.tell({ name: "move", x: x + by });
  }

  // Not written to the link before it is let go: browsers limit how often that is done.
  moveWall({ end, x }) {
    const width = this.picture.scene.outline[1][0];
    const share = Math.min(1, Math.max(leastWall, Math.round(1000 * x / width) / 1000));
    this.settings = { ...this.settings, [end === 0 ? "wallBelow" : "wallAbove"]: share };
    this.useCells();
  }

  // Settings.

  set(name, value, act) {
    this.settings = { ...this.settings, [name]: value };
    this.tellRefused("");
    this.settingsChanged();
    this.showSettings();
    act();
  }

  // A text that is no number that is allowed is as before.
  setNumber(field, name, act) {
    const settings = settingsOfLink(linkOf({ ...this.settings, [name]: field.value }));
    if (field.value === "" || settings[name] !== Number(field.value)) {
      this.tellRefused(`${name}: allowed are integers from ${field.min} to ${field.max}`);
      this.showSettings();
      return;
    }
    this.set(name, settings[name], act);
  }

  settingsChanged() {
    history.replaceState(null, "", linkOf(this.settings));
  }

  followLink() {
    this.settings = settingsOfLink(location.hash);
    this.showSettings();
    this.open();
  }

  showSettings() {
    const { settings, choices } = this;
    for (const name of ["scenario", "points", "space", "steps", "padding", "wind"]) {
      element(name).value = settings[name];
    }
    element("gravity").value = settings.gravity === "" ? this.usualGravity ?? 0 : settings.gravity;
    element("gravity-value").textContent = Number(element("gravity").value);
    element("wind-value").textContent = settings.wind;
    if (choices) {
      const { parameter } = choices.classifiers.find(({ name }) => name === settings.classifier) ?? {};
      for (const name of ["classifier", "repair", "policy"]) {
        if (![...element(name).options].some(({ value }) => value === settings[name])) {
          element(name).append(new Option(readable(settings[name]), settings[name]));
        }
        element(name).value = settings[name];
      }
      element("parameter-label").hidden = parameter === undefined;
      element("parameter").placeholder = parameter === undefined ? "" : `usual: ${parameter.usual}`;
      element("parameter").value = settings.parameter;
    }
    for (const name of Object.keys(layerNames)) {
      element("layer-" + name).checked = settings.layers[name];
    }
    element("cells").checked = settings.cells;
    element("cell-radius").value = element("cell-radius-value").textContent = settings.cellRadius;
    element("tool-" + settings.tool).checked = true;
    this.hand.tool = element("picture").dataset.tool = settings.tool;
    this.hand.holdsPendulum = settings.scenario === "pendulum";
    this.useLayers();
  }

  useLayers() {
    this.picture.layers = { ...this.settings.layers, cells: this.settings.cells };
    this.isStale = true;
    this.redraw();
  }

  useTool(name) {
    this.set("tool", name, () => {});
  }

  useScenario(name) {
    const { points, steps, gravity, wind } = usualSettings(name);
    this.settings = { ...this.settings, points, steps, gravity, wind };
    this.set("scenario", name, () => this.open());
  }

  useField() {
    this.tell({ name: "field", gravity: Number(element("gravity").value), wind: this.settings.wind });
  }

  useCells() { this.tell({ name: "cells", ...this.settings }); }

  use() { this.tell({ name: "use", settings: this.settings }); }

  async open() {
    const { settings } = this;
    this.tell({ name: "open", settings });
    this.usualGravity = usualGravityOf(await loadScenario(settings.scenario));
    this.showSettings();
  }

  // Playing.

  togglePlay() { this.isPlaying ? this.pause() : this.play(); }

  play() {
    this.isPlaying = true;
    element("play").textContent = "Pause";
  }

  pause() {
    this.isPlaying = false;
    element("play").textContent = "Play";
  }

  step() {
    this.pause();
    ++this.stepsWanted;
  }

  tick(now) {
    const frame = this.arrived;
    this.arrived = null;
    if (!this.isWaiting) {
      this.ask(); // the worker works while the page draws
    }
    if (frame) {
      this.show(frame, now);
    }
  }

  // For the next frame, of which the worker may as well make one that is only drawn anew. Whoever holds a point plays.
  ask() {
    const isMoving = this.isPlaying || this.hand.isHolding;
    const steps = isMoving ? this.settings.steps : this.stepsWanted !== 0 ? 1 : 0;
    if (steps === 0 && !this.isStale) {
      return;
    }
    this.stepsWanted = Math.max(0, this.stepsWanted - 1);
    this.isStale = false;
    this.isWaiting = true;
    const { cells, layers: { voronoi, circumcircles } } = this.settings;
    this.tell({ name: "frame", steps, wanted: { triangles: voronoi || circumcircles, cells } });
  }

  show({ scene, state, isFirst }, now) {
    this.picture.scene = scene;
    this.state = state;
    if (isFirst) {
      this.curves.clear();
      this.shownAt = [];
      this.fit();
    } else if (!hasWalls(scene)) {
      this.follow();
    }
    this.picture.draw();
    this.shownAt.push(now);
    if (this.shownAt.length > framesOfRate) {
      this.shownAt.shift();
    }
    if (state.report) {
      this.curves.add(state);
    }
    if (isFirst || now - this.written.text > pace.text || !this.isPlaying) {
      this.written.text = now;
      this.tellState();
      this.redrawLegend();
    }
    if (isFirst || now - this.written.curves > pace.curves || !this.isPlaying) {
      this.written.curves = now;
      this.curves.draw();
    }
  }

  // The box, or what is there now with room around.
  fit() {
    const { scene } = this.picture;
    this.bounds = hasWalls(scene) ? boundsOf({ ...scene, positions: new Float64Array(0) }) : boundsOfMost(scene, 0.25);
    this.picture.fit(this.bounds);
    this.picture.requestDraw();
  }

  // Points that no box holds fly apart: as long as nobody has moved the view, it widens with most of them.
  follow() {
    if (!this.picture.view.isFitted) {
      return;
    }
    const { low, high } = boundsOfMost(this.picture.scene, 0);
    this.bounds = { low: low.map((value, axis) => Math.min(value, this.bounds.low[axis])),
                    high: high.map((value, axis) => Math.max(value, this.bounds.high[axis])) };
    this.picture.fit(this.bounds);
  }

  // Text.

  tellState() {
    const { step, points, edges, changed, wrong, isCertified, report, rod, held } = this.state;
    const parts = [`step ${step}`, `${points} points`, `${edges} edges`, `${changed} new`];
    if (held) {
      parts.push(`${held} held`);
    }
    const rate = (this.shownAt.length - 1) / (this.shownAt.at(-1) - this.shownAt[0]) * 1000;
    if (this.isPlaying && this.shownAt.length > 10) {
      parts.push(`${Math.round(rate)} frames a second`);
    }
    if (rod) {
      const seconds = steps => (steps / this.settings.steps / 60).toFixed(1);
      parts.push(rod.isUpright ? `upright for ${seconds(rod.steps)} s` : "fallen", `best ${seconds(rod.best)} s`);
    }
    if (report?.rebuildReason) {
      parts.push(`triangulated anew (${readable(report.rebuildReason)})`);
    }
    if (isCertified) {
      parts.push("certified Delaunay");
    }
    element("state").textContent = parts.join(" · ");
    if (!isCertified) {
      const alarm = document.createElement("b");
      alarm.textContent = `not certified: ${wrong} wrong edges`;
      element("state").append(" · ", alarm);
    }
  }

  tellPoint(x, y) {
    const { picture, state } = this;
    const number = picture.nearestPoint(x, y);
    element("told").hidden = number < 0 || !state;
    if (number >= 0 && state) {
      const { positions, sets } = picture.scene;
      const set = setNames[sets[number]];
      element("told").textContent = `point ${number} at (${shortNumber(positions[2 * number])}, ` +
        `${shortNumber(positions[2 * number + 1])})` + (set === "none" ? "" : `, ${set}`);
    }
  }

  redraw() {
    this.picture.requestDraw();
    this.redrawLegend();
  }

  // Only when it has changed: it would not be selectable else.
  redrawLegend() {
    const legend = this.picture.legend();
    const text = JSON.stringify(legend);
    if (text !== this.legendText) {
      this.legendText = text;
      showLegend(element("legend"), legend);
    }
  }

  toggleTheme() {
    this.theme = this.theme === "dark" ? "light" : "dark";
    this.useTheme();
  }

  useTheme() {
    document.documentElement.dataset.theme = this.theme;
    element("theme").textContent = this.theme === "dark" ? "Light" : "Dark";
    this.picture.palette = this.curves.palette = palettes[this.theme];
    this.redraw();
  }

  // Sharing.

  async copyLink() {
    this.settingsChanged();
    const button = element("link");
    try {
      await navigator.clipboard.writeText(location.href);
      button.textContent = "Copied";
    } catch { // not allowed: the address of the page is the link
      button.textContent = "See address";
    }
    setTimeout(() => { button.textContent = "Copy link"; }, 1500);
  }

  save(kind, blob) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = `${this.settings.scenario}_${this.state?.step ?? 0}.${kind}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
}

function hasWalls({ cell, outline }) {
  return cell !== undefined || outline !== undefined;
}

// Two and a half standard deviations round the middle, and as much more as `room` says.
function boundsOfMost({ positions }, room) {
  const sum = [0, 0], squares = [0, 0];
  let number = 0;
  for (let i = 0; i !== positions.length; i += 2) {
    if (positions[i] === positions[i]) { // else the point is not there
      ++number;
      for (const axis of [0, 1]) {
        sum[axis] += positions[i + axis];
        squares[axis] += positions[i + axis] ** 2;
      }
    }
  }
  const middle = sum.map(value => value / number);
  const half = (1 + room) * 2.5 *
    Math.max(...squares.map((value, axis) => Math.sqrt(Math.max(0, value / number - middle[axis] ** 2))), 1e-9);
  return { low: middle.map(value => value - half), high: middle.map(value => value + half) };
}

globalThis.playground = new Playground();
