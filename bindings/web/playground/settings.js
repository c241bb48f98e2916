// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All that a person sets, and a link that has it: "#scenario=explosion&points=5000". What a link does not say is as usual;
// what it says and does not exist is left out.

import { usualLayers } from "../drawing/picture.js";
import { scenarios, spaces } from "./scenarios.js";

export const largestNumberOfPoints = 50000;
export const stepsPerFrame = [1, 2, 4, 8];
export const tools = ["drag", "add", "remove", "view"];
export const leastWall = 0.05; // of the width of the box

const word = allowed => text => allowed.includes(text) ? text : undefined;
const number = (low, high) => text => {
  const value = Number(text);
  return text.trim() !== "" && value >= low && value <= high ? value : undefined;
};
const integer = (low, high) => text => {
  const value = number(low, high)(text);
  return Number.isInteger(value) ? value : undefined;
};
const identifier = text => /^[a-z_]+$/.test(text) ? text : undefined;
const layerList = text => {
  const names = text.split(" ");
  return Object.fromEntries(Object.keys(usualLayers()).map(name => [name, names.includes(name)]));
};

// Of each setting: what reads it from text. "" stands for the usual one of the package or the scenario.
const readers = {
  scenario: word(Object.keys(scenarios)),
  points: integer(1, largestNumberOfPoints),
  space: word(Object.keys(spaces)),
  seed: integer(0, 2 ** 31),
  steps: text => word(stepsPerFrame.map(String))(text) && Number(text),
  classifier: identifier,
  parameter: number(-1e6, 1e6),
  padding: integer(0, 20),
  repair: identifier,
  policy: text => /^[a-z_]+(:\d+)?$/.test(text) ? text : undefined,
  gravity: number(-3, 3),
  wind: number(-3, 3),
  cells: text => word(["true", "false"])(text) && text === "true",
  cellRadius: number(0.25, 5),
  wallBelow: number(leastWall, 1),
  wallAbove: number(leastWall, 1),
  tool: word(tools),
  layers: layerList,
};

const usualSteps = { brownian: 1, pendulum: 4 };

export function usualSettings(scenario = "dam_break") {
  return { scenario, points: scenarios[scenario].points, space: "plane", seed: 1, steps: usualSteps[scenario] ?? 2,
           classifier: "circumcircle", parameter: "", padding: 1, repair: "", policy: "hybrid", gravity: "", wind: 0,
           cells: false, cellRadius: 1, wallBelow: 0.9, wallAbove: 0.9, tool: "drag", layers: usualLayers() };
}

function textOf(value) {
  return typeof value === "object" ? Object.keys(value).filter(name => value[name]).join(" ") : String(value);
}

export function settingsOfLink(hash) {
  const given = new URLSearchParams(hash.replace(/^#/, ""));
  const settings = usualSettings(readers.scenario(given.get("scenario") ?? "") ?? "dam_break");
  for (const [name, read] of Object.entries(readers)) {
    const value = given.has(name) ? read(given.get(name)) : undefined;
    if (value !== undefined) {
      settings[name] = value;
    }
  }
  return settings;
}

export function linkOf(settings) {
  const usual = usualSettings(settings.scenario);
  const link = new URLSearchParams({ scenario: settings.scenario });
  for (const name of Object.keys(readers)) {
    if (textOf(settings[name]) !== textOf(usual[name])) {
      link.set(name, textOf(settings[name]));
    }
  }
  return "#" + link;
}
