// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulates frames with delaunator, for Delaunator_peer.h, until its input ends.
//
// It says first, in a line, which versions it has. Of each frame it reads the number of coordinates
// (a double) and these (doubles), and answers with the nanoseconds that update() took and the number
// of corners (doubles), and these (32-bit integers); all in the machine's own byte order.

import { readFileSync, readSync, writeSync } from "node:fs";

const INPUT = 0;
const OUTPUT = 1;

// False where the input ends.
function read(numbers) {
  const bytes = new Uint8Array(numbers.buffer);
  for (let done = 0; done < bytes.length;) {
    const count = readSync(INPUT, bytes, done, bytes.length - done);
    if (count === 0) {
      return false;
    }
    done += count;
  }
  return true;
}

function write(numbers) {
  const bytes = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
  for (let done = 0; done < bytes.length;) {
    done += writeSync(OUTPUT, bytes, done, bytes.length - done);
  }
}

async function load() {
  try {
    return (await import("delaunator")).default;
  } catch {
    process.exit(1); // the package is not installed
  }
}

const Delaunator = await load();
const folder = new URL("node_modules/delaunator/package.json", import.meta.url);
const version = JSON.parse(readFileSync(folder, "utf8")).version;
writeSync(OUTPUT, `delaunator ${version}; node ${process.version}\n`);

const size = new Float64Array(1);
let coordinates = new Float64Array(0);
let triangulation = null;

while (read(size)) {
  if (coordinates.length !== size[0]) {
    coordinates = new Float64Array(size[0]);
    triangulation = null;
  }
  read(coordinates);
  triangulation ??= new Delaunator(coordinates);
  const start = process.hrtime.bigint();
  triangulation.update();
  const end = process.hrtime.bigint();
  write(new Float64Array([Number(end - start), triangulation.triangles.length]));
  write(triangulation.triangles);
}
