// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What mouse and fingers do to the points of a picture, by the tool that is chosen. What no tool takes moves the view.
//
//   const hand = new Hand(picture, tell);   tell({ name: "grab" | "drag" | "release" | "add" | "remove" | "move" | "wall", ... })
//   hand.tool = "drag";                     or "add", "remove", "view"
//   hand.holdsPendulum = true;              then the pointer moves the hand that holds it instead of dragging points

import { navigate } from "../drawing/view.js";

const reach = 24;          // pixels round a point
const distanceOfAdded = 14; // pixels between points that one stroke adds

export class Hand {
  constructor(picture, tell) {
    this.picture = picture;
    this.tell = tell;
    this.tool = "drag";
    this.holdsPendulum = false;
    this.pointer = null; // that does something to points, or to the wall
    this.wallEnd = -1;   // that it holds: 0 below, 1 above
    this.pressed = [0, 0];
    navigate(picture.canvas, picture.view, { onChange: () => picture.requestDraw(), mayPan: event => !this.takes(event) });
    const listen = (type, listener) => picture.canvas.addEventListener(type, listener);
    listen("pointerdown", event => this.press(event));
    listen("pointermove", event => this.move(event));
    listen("pointerup", event => this.lift(event));
    listen("pointercancel", event => this.lift(event));
  }

  // A point.
  get isHolding() { return this.pointer !== null && this.tool === "drag" && this.wallEnd < 0; }

  place(event) {
    const box = this.picture.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  world(event) {
    const [x, y] = this.picture.view.toWorld(...this.place(event));
    return { x, y };
  }

  nearest(event) { return this.picture.nearestPoint(...this.place(event), reach); }

  // The end of the wall that is there, or -1.
  wallEndAt(event) {
    const { layers, scene, view } = this.picture;
    const [x, y] = this.place(event);
    return layers.cells && scene.wall
      ? scene.wall.findIndex(([endX, endY]) => Math.hypot(view.x(endX) - x, view.y(endY) - y) < reach) : -1;
  }

  takes(event) {
    return this.pointer !== null || this.tool === "add" || this.tool === "remove" ||
      (this.tool === "drag" && (this.holdsPendulum || this.wallEndAt(event) >= 0 || this.nearest(event) >= 0));
  }

  press(event) {
    if (this.pointer !== null || event.button !== 0 || this.tool === "view" || !this.takes(event)) {
      return;
    }
    this.pointer = event.pointerId;
    try {
      this.picture.canvas.setPointerCapture(event.pointerId);
    } catch { // a synthetic event has no pointer that could be captured
    }
    this.wallEnd = this.tool === "drag" ? this.wallEndAt(event) : -1;
    if (this.wallEnd >= 0) {
      return;
    }
    if (this.tool === "drag" && !this.holdsPendulum) {
      this.tell({ name: "grab", ...this.world(event), id: this.nearest(event) });
    } else {
      this.stroke(event);
    }
  }

  move(event) {
    if (this.wallEnd >= 0) {
      if (event.pointerId === this.pointer) {
        this.tell({ name: "wall", ...this.world(event), end: this.wallEnd });
      }
    } else if (this.holdsPendulum && this.tool === "drag") {
      this.tell({ name: "move", ...this.world(event) });
    } else if (event.pointerId !== this.pointer) {
      return;
    } else if (this.tool === "drag") {
      this.tell({ name: "drag", ...this.world(event) });
    } else {
      const [x, y] = this.place(event);
      if (Math.hypot(x - this.pressed[0], y - this.pressed[1]) >= distanceOfAdded) {
        this.stroke(event);
      }
    }
  }

  stroke(event) {
    this.pressed = this.place(event);
    if (this.tool === "add") {
      this.tell({ name: "add", ...this.world(event) });
    } else if (this.tool === "remove") {
      const id = this.nearest(event);
      if (id >= 0) {
        this.tell({ name: "remove", id });
      }
    } else {
      this.tell({ name: "move", ...this.world(event) });
    }
  }

  lift(event) {
    if (event.pointerId === this.pointer) {
      this.pointer = null;
      this.wallEnd = -1;
      this.tell({ name: "release" });
    }
  }
}
