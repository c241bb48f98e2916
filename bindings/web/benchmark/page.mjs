// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What updates cost in WebAssembly, in Node.js and in Chromium, beside the same updates by the native program, and
// beside delaunator's update() of the same frames; how large the modules are; and trials of ./dev bench robustness in
// WebAssembly.
//
//     page.mjs --package FOLDER --native PROGRAM --robustness MODULE [--chromium PROGRAM] [--delaunator FOLDER]
//              [--frames N] [--operations N] [--seed N]
//
// Points make normal steps of 0.003 spacings, on each axis. All contestants follow the same frames, in Node.js in blocks
// of 20 in turn. Times are medians over the frames, a point, with the slowest frame; `edges` of all contestants are
// compared at the end. An update includes the copy of the points into WebAssembly's memory. "+ triangles" is an update and
// triangles(), which copies them out of there; delaunator leaves its triangles where a program reads them.

import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { cpus, tmpdir } from "node:os";
import { basename, join } from "node:path";
import { parseArgs } from "node:util";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";

import { measure, packageContestant, quantile } from "./moving_points.mjs";

const STEP = 0.003; // spacings
const BLOCK = 20;
const SIZES = [1000, 10_000, 100_000];

const { values: options } = parseArgs({
  options: {
    package: { type: "string" },
    native: { type: "string" },
    robustness: { type: "string" },
    chromium: { type: "string" },
    delaunator: { type: "string" },
    frames: { type: "string", default: "400" },
    operations: { type: "string", default: "0" },
    seed: { type: "string", default: "1" },
  },
});

function numberOf(name) {
  const value = Number(options[name]);
  if (!Number.isInteger(value) || value < 0) {
    throw new RangeError(`--${name} is '${options[name]}', allowed are integers from 0`);
  }
  return value;
}

// THE NATIVE PROGRAM

class Native {
  constructor(program) {
    this.child = spawn(program, { stdio: ["pipe", "pipe", "inherit"] });
    this.answers = this.child.stdout[Symbol.asyncIterator]();
    this.read = Buffer.alloc(0);
    this.edges = 0;
  }

  async follow(points) {
    const frame = new Float64Array(points.length + 1);
    frame[0] = points.length;
    frame.set(points, 1);
    this.child.stdin.write(Buffer.from(frame.buffer));
    while (this.read.length < 16) {
      const { value, done } = await this.answers.next();
      if (done) {
        throw new Error("the native program has ended");
      }
      this.read = Buffer.concat([this.read, value]);
    }
    const nanoseconds = this.read.readDoubleLE(0);
    this.edges = this.read.readDoubleLE(8);
    this.read = this.read.subarray(16);
    return nanoseconds / 1e6;
  }

  end() {
    this.child.stdin.end();
  }
}

// CHROMIUM, which loads a page from here, and sends back what it has measured

const types = { ".mjs": "text/javascript", ".html": "text/html", ".wasm": "application/wasm" };

function serve(folders) {
  let receive;
  const result = new Promise(done => { receive = done; });
  const server = createServer((request, response) => {
    if (request.method === "POST") {
      const parts = [];
      request.on("data", part => parts.push(part)).on("end", () => {
        receive(JSON.parse(Buffer.concat(parts)));
        response.end();
      });
      return;
    }
    const name = basename(new URL(request.url, "http://localhost").pathname);
    const folder = folders.find(folder => readdirSync(folder).includes(name));
    if (!folder) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { // an isolated page has a fine clock
      "Content-Type": types[name.slice(name.lastIndexOf("."))] ?? "text/plain",
      "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp",
    });
    response.end(readFileSync(join(folder, name)));
  });
  return new Promise(done => server.listen(0, "127.0.0.1", () => done({ server, result, port: server.address().port })));
}

async function measureInChromium(frames) {
  const { server, result, port } = await serve([options.package, import.meta.dirname ?? new URL(".", import.meta.url).pathname]);
  const profile = mkdtempSync(join(tmpdir(), "page-"));
  const child = spawn(options.chromium, ["--headless", "--no-sandbox", "--disable-gpu", `--user-data-dir=${profile}`,
    `http://127.0.0.1:${port}/in_browser.html?frames=${frames}&step=${STEP}&block=${BLOCK}&sizes=${SIZES}`],
    { stdio: "ignore" });
  const ended = new Promise(done => child.on("exit", done));
  try {
    return await Promise.race([result, ended.then(code => {
      throw new Error(`Chromium has ended with code ${code}`);
    })]);
  } finally {
    child.kill();
    await ended;
    server.close();
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

// CONTESTANTS IN NODE

async function loadDelaunator() {
  if (options.delaunator) {
    try {
      return (await import(pathToFileURL(join(options.delaunator, "node_modules/delaunator/index.js")))).default;
    } catch {
      console.log("delaunator is not installed, and left out");
    }
  }
  return null;
}

function delaunatorContestant(Delaunator) {
  let triangulation = null;
  return {
    share: 0.25,
    follow: points => {
      if (!triangulation) {
        triangulation = new Delaunator(points.slice());
        return;
      }
      triangulation.coords.set(points);
      const begin = performance.now();
      triangulation.update();
      return performance.now() - begin;
    },
    edges: () => (triangulation.halfedges.length + triangulation.hull.length) / 2,
  };
}

async function measureInNode(size, frames, Delaunator) {
  const { Triangulation } = await import(pathToFileURL(join(options.package, "dynamic_delaunay.mjs")));
  const native = new Native(options.native);
  const contestants = [
    { name: "native", follow: points => native.follow(points), edges: () => native.edges, end: () => native.end() },
    { name: "node", ...await packageContestant(Triangulation) },
    { name: "node + triangles", ...await packageContestant(Triangulation, triangulation => triangulation.triangles()) },
  ];
  if (Delaunator) {
    contestants.push({ name: "delaunator", ...delaunatorContestant(Delaunator) });
  }
  const times = await measure({ size, step: STEP, frames, block: BLOCK }, contestants);
  const edges = contestants.map(({ edges }) => edges());
  contestants.forEach(({ end }) => end?.());
  if (edges.some(number => number !== edges[0])) {
    throw new Error(`the contestants differ: ${edges} edges`);
  }
  return Object.fromEntries(contestants.map(({ name }, k) => [name, times[k]]));
}

// OUTPUT

function cell(size, times) {
  const text = share => ((quantile(times, share) * 1e6) / size).toFixed(1);
  return `${text(0.5)} (${text(1)})`;
}

function writeTable(rows) {
  const widths = rows[0].map((_, k) => Math.max(...rows.map(row => row[k].length)));
  for (const row of rows) {
    console.log(row.map((text, k) => text.padStart(widths[k])).join("   "));
  }
}

async function writeTimes(frames) {
  const Delaunator = await loadDelaunator();
  const inChromium = options.chromium ? await measureInChromium(frames) : null;
  const names = ["native", "node", "node + triangles", ...(inChromium ? ["chromium", "chromium + triangles"] : []),
                 ...(Delaunator ? ["delaunator"] : [])];
  const ratios = [["node", "native"], ...(Delaunator ? [["delaunator", "node"], ["delaunator", "node + triangles"]] : [])];
  const rows = [["points", ...names, "ms in node", ...(inChromium ? ["ms in chromium"] : []),
                 ...ratios.map(([a, b]) => (b.includes("+") ? `${a}/(${b})` : `${a}/${b}`))]];
  for (const size of SIZES) {
    const times = { ...(await measureInNode(size, frames, Delaunator)), ...inChromium?.times[size] };
    const median = name => quantile(times[name], 0.5);
    rows.push([String(size), ...names.map(name => cell(size, times[name])), median("node").toFixed(3),
               ...(inChromium ? [median("chromium").toFixed(3)] : []),
               ...ratios.map(([a, b]) => (median(a) / median(b)).toFixed(b === "native" ? 2 : 1))]);
  }
  console.log(`Node.js ${process.version}${inChromium ? `, ${inChromium.browser}` : ""}; ${cpus()[0].model}`);
  console.log(`Nanoseconds a point: the median of ${frames} frames, and the slowest one\n`);
  writeTable(rows);
}

function writeSizes() {
  console.log("\nSizes of the modules, in bytes\n");
  const modules = readdirSync(options.package).filter(name => name.endsWith(".wasm")).sort();
  writeTable([["module", "as it is", "gzipped"], ...modules.map(name => {
    const bytes = readFileSync(join(options.package, name));
    return [name, String(bytes.length), String(gzipSync(bytes, { level: 9 }).length)];
  })]);
}

async function writeRobustness(operations, seed) {
  const unavailable = () => 8; // as of a file that is not open
  const imports = { env: { emscripten_notify_memory_growth() {} }, wasi_snapshot_preview1: new Proxy({}, {
    get: (_, name) => (name === "proc_exit" ? code => { throw new Error(`it has ended with code ${code}`); }
                                            : unavailable),
  }) };
  const { instance: { exports: core } } = await WebAssembly.instantiate(readFileSync(options.robustness), imports);
  core._initialize();
  const begin = performance.now();
  for (let trial = 0; core.count(0) < operations; ++trial) {
    core.run_trial(seed, trial);
  }
  const [done, wrong, lost, crashed] = [0, 1, 2, 3].map(core.count);
  console.log(`\n${done} operations in WebAssembly, ${wrong} wrong, ${lost} lost, ${crashed} crashed; seed ${seed}, ` +
              `${((performance.now() - begin) / 1000).toFixed(1)} s`);
  const bytes = new Uint8Array(core.memory.buffer), address = core.findings() >>> 0;
  process.stdout.write(new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address))));
  if (wrong + lost + crashed > 0) {
    process.exitCode = 1;
  }
}

if (numberOf("frames") > 0) {
  await writeTimes(Math.ceil(numberOf("frames") / BLOCK) * BLOCK);
  writeSizes();
}
if (numberOf("operations") > 0) {
  await writeRobustness(numberOf("operations"), numberOf("seed"));
}
