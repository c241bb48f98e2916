// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of the player: what is clicked, typed and dragged, and what is said about the frame that is shown.

import { Curves, shortNumber } from "../drawing/curves.js";
import { palettes, preferredTheme, setNames } from "../drawing/palettes.js";
import { layerNames, Picture, showLegend } from "../drawing/picture.js";
import { navigate } from "../drawing/view.js";
import { Recording } from "./recording.js";

const element = id => document.getElementById(id);
const numbersOf = column => Float64Array.from(column, value => value ?? NaN);

// A reader of all frames' columns as curves; times of a frame that was not timed leave a gap.
function chartsOf({ columns, cells }) {
  const line = (name, column, color) => ({ name, color, values: numbersOf(columns[column]) });
  return [
    { title: "Time of an update", unit: "ns a point", isLogarithmic: true,
      lines: [line("kept", "dynamic"), line(cells.length ? "anew" : "fastest anew", "staticFastest"),
              line("CGAL's insert", "staticInsert")] },
    { title: "Points of the sets", low: 0, lines: [line("Classified", "classified", "classified"),
                                                   line("Padded", "padded", "padded"),
                                                   line("Border", "border", "border")] },
    { title: "Repairs", low: 0, lines: [line("flips", "flips"), line("splices", "splices")] },
    { title: "Validity", low: Math.min(0.999, ...columns.validity), high: 1, format: value => value.toFixed(4),
      lines: [line("agreement", "validity")] },
  ];
}

class Player {
  constructor(recording) {
    this.recording = recording;
    this.place = 0;
    this.theme = preferredTheme();
    this.picture = new Picture(element("picture"));
    this.picture.layers.removed = false;
    this.curves = new Curves(element("curves"), chartsOf(recording));
    this.playedSince = null; // { time, place } where playing began
    element("name").textContent = recording.name;
    element("method").textContent = recording.method;
    element("slider").max = recording.length - 1;
    this.makeLayers();
    this.listen();
    this.useTheme();
    this.picture.fit(recording.bounds);
    this.show(0);
  }

  makeLayers() {
    for (const [name, text] of Object.entries(layerNames)) {
      const label = document.createElement("label"), box = document.createElement("input");
      box.type = "checkbox";
      box.id = "layer-" + name;
      box.checked = this.picture.layers[name];
      box.addEventListener("change", () => {
        this.picture.layers[name] = box.checked;
        this.redraw();
      });
      label.append(box, text);
      element("layers").append(label);
    }
  }

  listen() {
    const { picture } = this;
    const zoom = factor => {
      picture.view.zoomAt(picture.view.width / 2, picture.view.height / 2, factor);
      picture.requestDraw();
    };
    element("slider").addEventListener("input", () => this.go(Number(element("slider").value)));
    element("back").addEventListener("click", () => this.go(this.place - 1));
    element("next").addEventListener("click", () => this.go(this.place + 1));
    element("play").addEventListener("click", () => this.togglePlay());
    element("speed").addEventListener("change", () => this.isPlaying && this.play());
    element("closer").addEventListener("click", () => zoom(1.5));
    element("farther").addEventListener("click", () => zoom(1 / 1.5));
    element("fit").addEventListener("click", () => {
      picture.view.reset();
      picture.requestDraw();
    });
    element("theme").addEventListener("click", () => {
      this.theme = this.theme === "dark" ? "light" : "dark";
      this.useTheme();
    });
    navigate(picture.canvas, picture.view, { onChange: () => picture.requestDraw() });
    picture.canvas.addEventListener("pointermove", event => this.tellPoint(event.offsetX, event.offsetY));
    picture.canvas.addEventListener("pointerleave", () => { element("told").hidden = true; });
    this.curves.onPick = place => this.go(place);
    new ResizeObserver(() => picture.draw()).observe(picture.canvas);
    document.addEventListener("keydown", event => this.typed(event));
  }

  typed(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) {
      return;
    }
    const keyOf = { " ": () => this.togglePlay(), ArrowLeft: () => this.go(this.place - 1),
                    ArrowRight: () => this.go(this.place + 1), PageUp: () => this.go(this.place - 10),
                    PageDown: () => this.go(this.place + 10), Home: () => this.go(0),
                    End: () => this.go(this.recording.length - 1) };
    const isControl = event.target.matches("select") || (event.key === " " && event.target.matches("button, input, summary"));
    if (Object.hasOwn(keyOf, event.key) && !isControl) {
      event.preventDefault();
      keyOf[event.key]();
    } else if (/^[1-9]$/.test(event.key) && !isControl) {
      element("layers").querySelectorAll("input")[event.key - 1]?.click();
    }
  }

  useTheme() {
    document.documentElement.dataset.theme = this.theme;
    element("theme").textContent = this.theme === "dark" ? "Light" : "Dark";
    this.picture.palette = this.curves.palette = palettes[this.theme];
    this.curves.requestDraw();
    this.redraw();
  }

  get isPlaying() { return this.playedSince !== null; }

  togglePlay() {
    this.isPlaying ? this.pause() : this.play();
  }

  // From the first frame again if the last one is shown.
  play() {
    if (this.place === this.recording.length - 1) {
      this.show(0);
    }
    this.playedSince = { time: performance.now(), place: this.place };
    element("play").textContent = "Pause";
    const since = this.playedSince;
    const step = now => {
      if (this.playedSince !== since) {
        return; // paused, or begun anew
      }
      const passed = Math.floor(Math.max(0, now - since.time) / 1000 * Number(element("speed").value));
      const place = Math.min(since.place + passed, this.recording.length - 1);
      if (place !== this.place) {
        this.show(place);
      }
      place === this.recording.length - 1 ? this.pause() : requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  pause() {
    this.playedSince = null;
    element("play").textContent = "Play";
  }

  go(place) {
    this.pause();
    this.show(place);
  }

  show(place) {
    const { recording, picture } = this;
    this.place = Math.min(Math.max(place, 0), recording.length - 1);
    picture.scene = recording.scene(this.place);
    const { frame, time } = recording.columns;
    element("slider").value = this.place;
    element("shown").textContent = `frame ${frame[this.place]} of ${frame[recording.length - 1]}`;
    element("slider").setAttribute("aria-valuetext", element("shown").textContent);
    this.tellState(shortNumber(time[this.place]));
    this.curves.show(this.place);
    this.redraw();
  }

  tellState(time) {
    const { columns } = this.recording;
    const { edges, changed, wrong } = this.picture.scene;
    const parts = [`time ${time}`, `${columns.points[this.place]} points`, `${edges.length / 2} edges`,
                   `${changed.length / 2} new`];
    if (columns.rebuild[this.place]) {
      parts.push(`triangulated anew (${columns.rebuild[this.place]})`);
    }
    if (columns.certified[this.place]) {
      parts.push("certified Delaunay");
    }
    element("state").textContent = parts.join(" · ");
    if (wrong.length !== 0) {
      const alarm = document.createElement("b");
      alarm.textContent = `${wrong.length / 2} wrong`;
      element("state").append(" · ", alarm);
    }
  }

  tellPoint(x, y) {
    const { picture, recording } = this;
    const number = picture.nearestPoint(x, y);
    element("told").hidden = number < 0;
    if (number >= 0) {
      const { positions, sets, speeds } = picture.scene;
      const set = setNames[sets[number]];
      element("told").textContent = `point ${recording.nameOf(this.place, number)} at ` +
        `(${shortNumber(positions[2 * number])}, ${shortNumber(positions[2 * number + 1])}), ` +
        `speed ${shortNumber(speeds[number])}` + (set === "none" ? "" : `, ${set}`);
    }
  }

  redraw() {
    this.picture.requestDraw();
    showLegend(element("legend"), this.picture.legend());
  }
}

new Player(new Recording(JSON.parse(element("recording").textContent)));
