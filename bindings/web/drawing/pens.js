// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What draws: WebGL 2, the pixels of a canvas, or text of an SVG file. All three draw the same four things, so that one
// description of a picture (picture.js) serves all of them. Everything is in CSS pixels.
//
//   pen.begin(width, height, ground)                    a new picture on a ground of this color
//   pen.segments(values, { color, width, alpha })       Float32Array x0, y0, x1, y1 of each segment
//   pen.discs(values, { color, radius, alpha })         Float32Array x, y of each disc
//   pen.rings(values, { color, width, alpha })          Float32Array x, y, radius of each circle
//   pen.end()                                           the picture is complete; an SvgPen returns its text
//
// openPen(canvas) takes WebGL where hardware does it, else pixels: WebGL by the processor alone takes many times as long
// as that. { preferred: "webgl2" } or "2d" takes this one.

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

// Sets pixels itself: paths of a 2D context take ten times as long for so many short lines. How much of a pixel is covered
// follows from how far away the line or the rim is, as in the shaders below.
export class CanvasPen {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d", { alpha: false });
    this.kind = "2d";
  }

  begin(width, height, ground) {
    this.ratio = resizeCanvas(this.canvas, width, height);
    const { width: columns, height: rows } = this.canvas;
    if (this.image?.width !== columns || this.image.height !== rows) {
      this.image = this.context.createImageData(columns, rows);
      this.pixels = new Uint32Array(this.image.data.buffer); // red is the lowest byte on all machines that browsers run on
    }
    this.pixels.fill(packed(ground));
  }

  // Of lines that are thinner than a pixel: they are pale ones of that width.
  ink({ color, width = 0, alpha = 1 }) {
    const shown = width * this.ratio;
    return { color: packed(color), half: Math.max(1, shown) / 2, strength: 256 * alpha * Math.min(1, width === 0 ? 1 : shown) };
  }

  // Each is walked along x or y, whichever is longer.
  segments(values, style) {
    const { color, half, strength } = this.ink(style);
    for (let i = 0; i !== values.length; i += 4) {
      const isFlat = Math.abs(values[i + 2] - values[i]) >= Math.abs(values[i + 3] - values[i + 1]);
      const u = isFlat ? 0 : 1, v = 1 - u; // along and across
      const isForward = values[i + u] <= values[i + 2 + u];
      const from = isForward ? i : i + 2, to = isForward ? i + 2 : i;
      if (half === 0.5) {
        this.hairline(values[from + u], values[from + v], values[to + u], values[to + v], isFlat, color, strength);
      } else {
        this.segment(values[from + u], values[from + v], values[to + u], values[to + v], isFlat, color, half, strength);
      }
    }
  }

  // Of a pixel's width: two pixels across share each step along (Wu 1991). The middles of pixels have integer
  // coordinates.
  hairline(fromU, fromV, toU, toV, isFlat, color, strength) {
    const { ratio, pixels } = this;
    const { width: columns, height: rows } = this.image;
    const u0 = fromU * ratio - 0.5, v0 = fromV * ratio - 0.5, u1 = toU * ratio - 0.5;
    const slope = u1 > u0 ? (toV - fromV) / (toU - fromU) : 0;
    const endV = (isFlat ? rows : columns) - 1;
    const stepU = isFlat ? 1 : columns, stepV = isFlat ? columns : 1;
    const last = Math.min((isFlat ? columns : rows) - 1, Math.round(u1));
    for (let u = Math.max(0, Math.round(u0)); u <= last; ++u) {
      const v = v0 + (u - u0) * slope, low = Math.floor(v), share = v - low;
      if (low >= 0 && low < endV) {
        const at = u * stepU + low * stepV;
        blend(pixels, at, color, strength * (1 - share));
        blend(pixels, at + stepV, color, strength * share);
      }
    }
  }

  segment(fromU, fromV, toU, toV, isFlat, color, half, strength) {
    const { ratio, pixels } = this;
    const { width: columns, height: rows } = this.image;
    const u0 = fromU * ratio - 0.5, v0 = fromV * ratio - 0.5, u1 = toU * ratio - 0.5, v1 = toV * ratio - 0.5;
    const endU = isFlat ? columns : rows, endV = isFlat ? rows : columns;
    const stepU = isFlat ? 1 : columns, stepV = isFlat ? columns : 1;
    const length = Math.hypot(u1 - u0, v1 - v0);
    const cosine = length > 0 ? (u1 - u0) / length : 1, sine = length > 0 ? (v1 - v0) / length : 0;
    const room = half + 0.5, across = room / cosine;
    const last = Math.min(endU - 1, Math.floor(u1 + room));
    for (let u = Math.max(0, Math.ceil(u0 - room)); u <= last; ++u) {
      const middle = v0 + (Math.min(Math.max(u, u0), u1) - u0) * sine / cosine;
      const end = Math.min(endV - 1, Math.floor(middle + across));
      for (let v = Math.max(0, Math.ceil(middle - across)); v <= end; ++v) {
        const along = (u - u0) * cosine + (v - v0) * sine;
        const aside = Math.abs((v - v0) * cosine - (u - u0) * sine);
        const beyond = Math.max(-along, along - length);
        const covered = room - (beyond <= 0 ? aside : Math.sqrt(beyond * beyond + aside * aside));
        if (covered > 0) {
          blend(pixels, u * stepU + v * stepV, color, strength * Math.min(1, covered));
        }
      }
    }
  }

  discs(values, { color, radius, alpha = 1 }) {
    const { ratio, pixels } = this;
    const { width: columns, height: rows } = this.image;
    const ink = packed(color), strength = 256 * alpha, room = radius * ratio + 0.5;
    for (let i = 0; i !== values.length; i += 2) {
      const x = values[i] * ratio - 0.5, y = values[i + 1] * ratio - 0.5;
      const right = Math.min(columns - 1, Math.floor(x + room)), low = Math.min(rows - 1, Math.floor(y + room));
      for (let row = Math.max(0, Math.ceil(y - room)); row <= low; ++row) {
        for (let column = Math.max(0, Math.ceil(x - room)); column <= right; ++column) {
          const covered = room - Math.sqrt((column - x) * (column - x) + (row - y) * (row - y));
          if (covered > 0) {
            blend(pixels, row * columns + column, ink, strength * Math.min(1, covered));
          }
        }
      }
    }
  }

  rings(values, style) {
    const { color, half, strength } = this.ink(style);
    for (let i = 0; i !== values.length; i += 3) {
      this.ring(values[i] * this.ratio - 0.5, values[i + 1] * this.ratio - 0.5, values[i + 2] * this.ratio, color, half,
                strength);
    }
  }

  // In each row the pixels between the outer and the inner rim, left and right.
  ring(x, y, radius, color, half, strength) {
    const { width: columns, height: rows } = this.image;
    const room = half + 0.5, outer = radius + room, inner = radius - room;
    const low = Math.min(rows - 1, Math.floor(y + outer));
    for (let row = Math.max(0, Math.ceil(y - outer)); row <= low; ++row) {
      const squared = (row - y) * (row - y);
      const reach = Math.sqrt(outer * outer - squared);
      const gap = inner > 0 && inner * inner > squared ? Math.sqrt(inner * inner - squared) : 0;
      const fill = (from, to) => {
        const end = Math.min(columns - 1, Math.floor(to));
        for (let column = Math.max(0, Math.ceil(from)); column <= end; ++column) {
          const covered = room - Math.abs(Math.sqrt((column - x) * (column - x) + squared) - radius);
          if (covered > 0) {
            blend(this.pixels, row * columns + column, color, strength * Math.min(1, covered));
          }
        }
      };
      if (gap < 1) {
        fill(x - reach, x + reach);
      } else {
        fill(x - reach, x - gap);
        fill(x + gap, x + reach);
      }
    }
  }

  end() { this.context.putImageData(this.image, 0, 0); }
}

function packed(color) {
  const [red, green, blue] = [1, 3, 5].map(at => parseInt(color.slice(at, at + 2), 16));
  return (0xff000000 | (blue << 16) | (green << 8) | red) >>> 0;
}

// Red and blue together, then green: what flows from one into the other is cut off.
function blend(pixels, at, color, strength) {
  const share = strength | 0; // of 256
  const before = pixels[at];
  const redBlue = before & 0xff00ff, green = before & 0x00ff00;
  pixels[at] = 0xff000000 |
    ((redBlue + (Math.imul((color & 0xff00ff) - redBlue, share) >> 8)) & 0xff00ff) |
    ((green + (Math.imul((color & 0x00ff00) - green, share) >> 8)) & 0x00ff00);
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
