// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What draws: WebGL 2, a canvas's 2D context, or text of an SVG file. All three draw the same four things, so that one
// description of a picture (picture.js) serves all of them. Everything is in CSS pixels.
//
//   pen.begin(width, height, ground)                    a new picture on a ground of this color
//   pen.segments(values, { color, width, alpha })       Float32Array x0, y0, x1, y1 of each segment
//   pen.discs(values, { color, radius, alpha })         Float32Array x, y of each disc
//   pen.rings(values, { color, width, alpha })          Float32Array x, y, radius of each circle
//   pen.end()                                           the picture is complete; an SvgPen returns its text
//
// openPen(canvas) takes WebGL where hardware does it, else the 2D context: WebGL by the processor alone takes many times
// as long as that. { preferred: "webgl2" } or "2d" takes this one.

import { colorChannels } from "./palettes.js";

export function openPen(canvas, { preferred = hardwareDrawsWebgl() ? "webgl2" : "2d" } = {}) {
  const gl = preferred === "2d" ? null : canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false });
  return gl ? new WebglPen(canvas, gl) : new CanvasPen(canvas);
}

// Browsers that have only the processor should refuse, but some say it in the name alone. Asked of another canvas: one
// that has once been WebGL's is nothing else any more.
function hardwareDrawsWebgl() {
  const gl = document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat: true });
  if (!gl) {
    return false;
  }
  const debug = gl.getExtension("WEBGL_debug_renderer_info");
  const name = gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return !/swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

function resizeCanvas(canvas, width, height) {
  const ratio = globalThis.devicePixelRatio || 1;
  const [w, h] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
  if (canvas.width !== w || canvas.height !== h) {
    canvas.width = w;
    canvas.height = h;
  }
  return ratio;
}

export class CanvasPen {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d", { alpha: false });
    this.kind = "2d";
  }

  begin(width, height, ground) {
    const ratio = resizeCanvas(this.canvas, width, height);
    const c = this.context;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.globalAlpha = 1;
    c.fillStyle = ground;
    c.fillRect(0, 0, width, height);
    c.lineCap = "round";
    this.width = width;
    this.height = height;
  }

  segments(values, { color, width, alpha = 1 }) {
    const c = this.context;
    c.strokeStyle = color;
    c.lineWidth = width;
    c.globalAlpha = alpha;
    // One path of everything takes longer to fill than several short ones.
    const inPath = 4 * 512;
    for (let start = 0; start < values.length; start += inPath) {
      const end = Math.min(start + inPath, values.length);
      c.beginPath();
      for (let i = start; i !== end; i += 4) {
        if (this.isSeen(values[i], values[i + 1], values[i + 2], values[i + 3], width)) {
          c.moveTo(values[i], values[i + 1]);
          c.lineTo(values[i + 2], values[i + 3]);
        }
      }
      c.stroke();
    }
  }

  discs(values, { color, radius, alpha = 1 }) {
    const c = this.context;
    c.fillStyle = color;
    c.globalAlpha = alpha;
    const isSmall = radius < 1.25;
    c.beginPath();
    for (let i = 0; i !== values.length; i += 2) {
      const x = values[i], y = values[i + 1];
      if (!this.isSeen(x, y, x, y, radius)) {
        continue;
      }
      if (isSmall) {
        c.rect(x - radius, y - radius, 2 * radius, 2 * radius);
      } else {
        c.moveTo(x + radius, y);
        c.arc(x, y, radius, 0, 2 * Math.PI);
      }
    }
    c.fill();
  }

  rings(values, { color, width, alpha = 1 }) {
    const c = this.context;
    c.strokeStyle = color;
    c.lineWidth = width;
    c.globalAlpha = alpha;
    c.beginPath();
    for (let i = 0; i !== values.length; i += 3) {
      const x = values[i], y = values[i + 1], radius = values[i + 2];
      if (this.isSeen(x, y, x, y, radius + width)) {
        c.moveTo(x + radius, y);
        c.arc(x, y, radius, 0, 2 * Math.PI);
      }
    }
    c.stroke();
  }

  isSeen(x0, y0, x1, y1, more) {
    return Math.max(x0, x1) >= -more && Math.min(x0, x1) <= this.width + more &&
      Math.max(y0, y1) >= -more && Math.min(y0, y1) <= this.height + more;
  }

  end() {}
}

// Each thing is a quad with room for its soft edge; the fragment shader asks how far away the line or the rim is.
const segmentShader = `#version 300 es
in vec2 corner;
in vec4 ends;
uniform vec2 size;
uniform float halfWidth;
out vec2 at;
flat out float reach;
void main() {
  vec2 along = ends.zw - ends.xy;
  float span = length(along);
  vec2 u = span > 0.0 ? along / span : vec2(1.0, 0.0);
  float room = halfWidth + 1.0;
  at = vec2(mix(-room, span + room, corner.x * 0.5 + 0.5), corner.y * room);
  reach = span;
  vec2 p = ends.xy + u * at.x + vec2(-u.y, u.x) * at.y;
  gl_Position = vec4(p.x / size.x * 2.0 - 1.0, 1.0 - p.y / size.y * 2.0, 0.0, 1.0);
}`;
const segmentInk = `#version 300 es
precision highp float;
in vec2 at;
flat in float reach;
uniform float halfWidth;
uniform float soft;
uniform vec4 color;
out vec4 ink;
void main() {
  float away = length(vec2(max(max(-at.x, at.x - reach), 0.0), at.y));
  ink = color * clamp((halfWidth - away) / soft + 0.5, 0.0, 1.0);
}`;
const roundShader = `#version 300 es
in vec2 corner;
in vec3 circle;
uniform vec2 size;
uniform float halfWidth;
uniform float discRadius;
out vec2 at;
flat out float radius;
void main() {
  radius = circle.z + discRadius; // one of them is 0
  at = corner * (radius + halfWidth + 1.0);
  vec2 p = circle.xy + at;
  gl_Position = vec4(p.x / size.x * 2.0 - 1.0, 1.0 - p.y / size.y * 2.0, 0.0, 1.0);
}`;
const discInk = `#version 300 es
precision highp float;
in vec2 at;
flat in float radius;
uniform float soft;
uniform vec4 color;
out vec4 ink;
void main() {
  ink = color * clamp((radius - length(at)) / soft + 0.5, 0.0, 1.0);
}`;
const ringInk = `#version 300 es
precision highp float;
in vec2 at;
flat in float radius;
uniform float halfWidth;
uniform float soft;
uniform vec4 color;
out vec4 ink;
void main() {
  ink = color * clamp((halfWidth - abs(length(at) - radius)) / soft + 0.5, 0.0, 1.0);
}`;

export class WebglPen {
  constructor(canvas, gl) {
    this.canvas = canvas;
    this.gl = gl;
    this.kind = "webgl2";
    this.prepare();
    canvas.addEventListener("webglcontextlost", event => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => this.prepare());
  }

  prepare() {
    const gl = this.gl;
    this.corners = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.corners);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]), gl.STATIC_DRAW);
    this.things = gl.createBuffer();
    this.programs = {
      segments: this.program(segmentShader, segmentInk, "ends", 4),
      discs: this.program(roundShader, discInk, "circle", 2),
      rings: this.program(roundShader, ringInk, "circle", 3),
    };
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA); // inks are multiplied by their alpha
  }

  program(vertexText, fragmentText, attribute, components) {
    const gl = this.gl;
    const program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertexText], [gl.FRAGMENT_SHADER, fragmentText]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error("WebGL: " + gl.getProgramInfoLog(program));
    }
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const corner = gl.getAttribLocation(program, "corner"), thing = gl.getAttribLocation(program, attribute);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.corners);
    gl.enableVertexAttribArray(corner);
    gl.vertexAttribPointer(corner, 2, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.things);
    gl.enableVertexAttribArray(thing);
    gl.vertexAttribPointer(thing, components, gl.FLOAT, false, 0, 0);
    gl.vertexAttribDivisor(thing, 1);
    gl.bindVertexArray(null);
    const uniforms = {};
    for (const name of ["size", "halfWidth", "discRadius", "soft", "color"]) {
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return { program, array, uniforms, components };
  }

  begin(width, height, ground) {
    const gl = this.gl;
    this.ratio = resizeCanvas(this.canvas, width, height);
    this.width = width;
    this.height = height;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(...colorChannels(ground), 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
  }

  draw(kind, values, { color, width = 0, radius = 0, alpha = 1 }) {
    if (values.length === 0) {
      return;
    }
    const gl = this.gl;
    const { program, array, uniforms, components } = this.programs[kind];
    // A line thinner than a pixel of the screen is a pale one of that width.
    const least = 1 / this.ratio;
    const shown = Math.max(width, least);
    const strength = alpha * (kind === "discs" ? 1 : Math.min(1, width / least));
    gl.useProgram(program);
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.things);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STREAM_DRAW);
    gl.uniform2f(uniforms.size, this.width, this.height);
    gl.uniform1f(uniforms.halfWidth, kind === "discs" ? 0 : shown / 2);
    gl.uniform1f(uniforms.discRadius, radius);
    gl.uniform1f(uniforms.soft, least);
    gl.uniform4f(uniforms.color, ...colorChannels(color).map(value => value * strength), strength);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, values.length / components);
    gl.bindVertexArray(null);
  }

  segments(values, style) { this.draw("segments", values, style); }
  discs(values, style) { this.draw("discs", values, style); }
  rings(values, style) { this.draw("rings", values, style); }
  end() {}
}

export class SvgPen {
  constructor({ title = "" } = {}) {
    this.title = title;
    this.kind = "svg";
  }

  begin(width, height, ground) {
    const size = [width, height].map(number);
    this.width = width;
    this.height = height;
    this.parts = [
      `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size[0]} ${size[1]}" width="${size[0]}" ` +
        `height="${size[1]}">\n`,
      this.title ? `<title>${escaped(this.title)}</title>\n` : "",
      `<rect width="100%" height="100%" fill="${ground}"/>\n`];
  }

  segments(values, { color, width, alpha = 1 }) {
    this.path(color, width, alpha, values, 4, i =>
      `M${number(values[i])} ${number(values[i + 1])}L${number(values[i + 2])} ${number(values[i + 3])}`);
  }

  // A line without length and with round ends is a disc.
  discs(values, { color, radius, alpha = 1 }) {
    this.path(color, 2 * radius, alpha, values, 2, i => `M${number(values[i])} ${number(values[i + 1])}h0`);
  }

  rings(values, { color, width, alpha = 1 }) {
    this.path(color, width, alpha, values, 3, i => {
      const r = number(values[i + 2]), d = number(2 * values[i + 2]);
      return `M${number(values[i] - values[i + 2])} ${number(values[i + 1])}a${r} ${r} 0 1 0 ${d} 0a${r} ${r} 0 1 0 -${d} 0`;
    });
  }

  path(color, width, alpha, values, components, text) {
    if (values.length === 0) {
      return;
    }
    const opacity = alpha < 1 ? ` opacity="${number(alpha)}"` : "";
    this.parts.push(`<path fill="none" stroke="${color}" stroke-width="${number(width)}" stroke-linecap="round"${opacity} d="`);
    for (let i = 0; i !== values.length; i += components) {
      this.parts.push(text(i), "\n");
    }
    this.parts.push('"/>\n');
  }

  end() { return this.parts.join("") + "</svg>\n"; }
}

function number(value) {
  return String(Math.round(value * 100) / 100);
}

function escaped(text) {
  return text.replace(/[&<>"]/g, c => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);
}
