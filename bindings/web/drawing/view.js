// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which part of the plane a picture shows, and how mouse, fingers and keys move it. In the plane y goes up, on the screen
// down. Lengths on the screen are CSS pixels.
//
//   view.resize(width, height)             of the picture, in pixels
//   view.fit({ low: [x, y], high: [x, y] })   shows all of these bounds
//   view.x(worldX), view.y(worldY)         a point of the plane on the screen
//   view.toWorld(pixelX, pixelY)           [x, y] of the plane
//   view.zoomAt(pixelX, pixelY, factor)    what is under this pixel stays there
//   view.pan(dx, dy)                       by pixels
//   navigate(element, view, options)       listens to pointers, wheel and keys of an element

export class View {
  constructor() {
    this.width = this.height = 1;
    this.centerX = this.centerY = 0;
    this.scale = 1; // pixels for a unit of length
    this.fitted = { low: [0, 0], high: [1, 1] };
    this.fittedScale = 1;
    this.isFitted = true;
    this.largestZoom = 1000; // times the scale that shows everything
  }

  resize(width, height) {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.updateFittedScale();
    if (this.isFitted) {
      this.reset();
    }
  }

  fit(bounds) {
    this.fitted = bounds;
    this.updateFittedScale();
    this.reset();
  }

  // Everything again.
  reset() {
    const { low, high } = this.fitted;
    this.scale = this.fittedScale;
    this.centerX = low[0] / 2 + high[0] / 2;
    this.centerY = low[1] / 2 + high[1] / 2;
    this.isFitted = true;
  }

  updateFittedScale() {
    const { low, high } = this.fitted;
    const margin = Math.min(24, 0.04 * Math.min(this.width, this.height));
    const along = (room, length) => length > 0 ? Math.max(1, room - 2 * margin) / length : Infinity;
    const scale = Math.min(along(this.width, high[0] - low[0]), along(this.height, high[1] - low[1]));
    this.fittedScale = Number.isFinite(scale) && scale > 0 ? scale : 1;
  }

  x(worldX) { return (worldX - this.centerX) * this.scale + this.width / 2; }
  y(worldY) { return (this.centerY - worldY) * this.scale + this.height / 2; }

  toWorld(pixelX, pixelY) {
    return [(pixelX - this.width / 2) / this.scale + this.centerX,
            this.centerY - (pixelY - this.height / 2) / this.scale];
  }

  zoomAt(pixelX, pixelY, factor) {
    const [x, y] = this.toWorld(pixelX, pixelY);
    const least = this.fittedScale / 4;
    this.scale = Math.min(Math.max(this.scale * factor, least), this.fittedScale * this.largestZoom);
    this.centerX = x - (pixelX - this.width / 2) / this.scale;
    this.centerY = y + (pixelY - this.height / 2) / this.scale;
    this.isFitted = false;
  }

  pan(dx, dy) {
    this.centerX -= dx / this.scale;
    this.centerY += dy / this.scale;
    this.isFitted = false;
  }
}

const wheelLine = 16; // pixels, where a wheel counts lines

// Drag or one finger pans, wheel or two fingers zoom, a double click or "0" shows everything, "+" and "-" zoom.
// options.onChange() is called after each change; options.mayPan(event), if given, says whether a pointer that goes
// down pans (else it is somebody else's, as one that drags a point). Returns a function that ends it.
export function navigate(element, view, { onChange, mayPan = () => true }) {
  const pointers = new Map();
  const position = event => {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, distance: Math.hypot(a[0] - b[0], a[1] - b[1]) };
  };
  const middle = () => pointers.size === 2 ? spread() : null;

  const listeners = {
    pointerdown(event) {
      if (pointers.size === 2 || event.button !== 0 || !mayPan(event)) {
        return;
      }
      pointers.set(event.pointerId, position(event));
      try {
        element.setPointerCapture(event.pointerId);
      } catch { // a synthetic event has no pointer that could be captured
      }
    },
    pointermove(event) {
      const before = pointers.get(event.pointerId);
      if (!before) {
        return;
      }
      const old = middle();
      const now = position(event);
      pointers.set(event.pointerId, now);
      if (old) {
        const { x, y, distance } = middle();
        view.pan(x - old.x, y - old.y);
        view.zoomAt(x, y, distance / Math.max(old.distance, 1));
      } else {
        view.pan(now[0] - before[0], now[1] - before[1]);
      }
      onChange();
    },
    pointerup(event) { pointers.delete(event.pointerId); },
    pointercancel(event) { pointers.delete(event.pointerId); },
    wheel(event) {
      event.preventDefault();
      const pixels = event.deltaMode === 0 ? event.deltaY : event.deltaY * wheelLine;
      view.zoomAt(...position(event), Math.exp(-0.0015 * pixels));
      onChange();
    },
    dblclick(event) {
      event.preventDefault();
      view.reset();
      onChange();
    },
    keydown(event) {
      if (event.ctrlKey || event.altKey || event.metaKey) {
        return;
      }
      const zoom = factor => view.zoomAt(view.width / 2, view.height / 2, factor);
      const actions = { "+": () => zoom(1.25), "=": () => zoom(1.25), "-": () => zoom(0.8), 0: () => view.reset() };
      if (Object.hasOwn(actions, event.key)) {
        event.preventDefault();
        actions[event.key]();
        onChange();
      }
    },
  };
  element.style.touchAction = "none";
  for (const [name, listener] of Object.entries(listeners)) {
    element.addEventListener(name, listener, { passive: false });
  }
  return () => {
    for (const [name, listener] of Object.entries(listeners)) {
      element.removeEventListener(name, listener);
    }
  };
}
