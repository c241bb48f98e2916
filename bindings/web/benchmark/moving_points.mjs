// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Brownian motion, the same in Node.js and in browsers.

// Uniform in (0, 1) (Park and Miller).
function randomSource(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

// Points that are one spacing apart on average, and move in each frame by normal steps of that many spacings.
export class MovingPoints {
  constructor(size, step, seed = 1) {
    this.step = step;
    this.random = randomSource(seed);
    this.points = Float64Array.from({ length: 2 * size }, () => Math.sqrt(size) * this.random());
  }

  advance() {
    for (let i = 0; i < this.points.length; i += 2) { // Box and Muller
      const radius = this.step * Math.sqrt(-2 * Math.log(this.random())), angle = 2 * Math.PI * this.random();
      this.points[i] += radius * Math.cos(angle);
      this.points[i + 1] += radius * Math.sin(angle);
    }
    return this.points;
  }
}

// Lets each contestant follow the same frames, in turn, block by block; milliseconds of each frame. Those that take long
// follow only some of the last frames of each block. Each has a function `follow(points)`, which may return
// milliseconds that it has measured itself.
export async function measure({ size, step, frames, block }, contestants) {
  const motion = new MovingPoints(size, step), times = contestants.map(() => []);
  for (const contestant of contestants) {
    await contestant.follow(motion.points);
  }
  for (let done = 0; done < frames; done += block) {
    const blockOfFrames = Array.from({ length: block }, () => motion.advance().slice());
    for (const [k, { follow, share = 1 }] of contestants.entries()) {
      for (const points of blockOfFrames.slice(Math.floor(block * (1 - share)))) {
        const begin = performance.now();
        const own = await follow(points);
        times[k].push(own ?? performance.now() - begin);
      }
    }
  }
  return times;
}

// What follows by a triangulation of the package, and reads what it is told to after each update.
export async function packageContestant(Triangulation, read = () => {}) {
  const triangulation = await Triangulation.create();
  return {
    follow: points => {
      if (triangulation.numberOfIds === 0) {
        triangulation.insert(points);
      } else if (!triangulation.update(points).certified) {
        throw new Error("a frame is not certified");
      }
      read(triangulation);
    },
    edges: () => triangulation.edges().length / 2,
    end: () => triangulation.dispose(),
  };
}

export function quantile(times, share) {
  const sorted = Float64Array.from(times).sort();
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}
