# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What updates from Python cost: beside the same updates in C++, and beside SciPy's Delaunay of the same frames.

    python.py [--frames N] [NAME ...]

In each frame the three take turns, in one process; SciPy, which takes long, in 20 of the frames. Times are medians a
point. Last come the fixed costs of calls, at 10 points, and those of arrays at 10,000 points.
"""

import argparse
import time

import numpy as np
import reference
import scipy
from scipy.spatial import Delaunay

import dynamic_delaunay
from dynamic_delaunay import DynamicDelaunay, Population

SCENARIOS = [("dam_break", None), ("spinning", None), ("explosion", None), ("static", None)]
LARGE = [("dam_break", 10_000), ("spinning", 10_000), ("explosion", 10_000), ("static", 10_000), ("brownian", 10_000)]
SCIPY_FRAMES = 20


def nanoseconds(work):
    begin = time.perf_counter_ns()
    work()
    return time.perf_counter_ns() - begin


class Fixed:
    def __init__(self, motion):
        self.python, self.cpp = DynamicDelaunay(motion.points), reference.Reference(motion.points)

    def times(self, ids, points, python_first):
        if python_first:
            python = nanoseconds(lambda: self.python.update(points))
            return python, self.cpp.update(points)
        cpp = self.cpp.update(points)
        return nanoseconds(lambda: self.python.update(points)), cpp


class Changing:
    def __init__(self, motion):
        self.python, self.cpp = Population(motion.ids, motion.points), reference.PopulationReference()
        self.cpp.update(motion.ids, motion.points)

    def times(self, ids, points, python_first):
        if python_first:
            python = nanoseconds(lambda: self.python.update(ids, points))
            return python, self.cpp.update(ids, points)
        cpp = self.cpp.update(ids, points)
        return nanoseconds(lambda: self.python.update(ids, points)), cpp


def follow(path, points, frames):
    motion = reference.Motion(path, points)
    if motion.is_periodic:
        return
    followed = Fixed(motion) if motion.has_fixed_population else Changing(motion)
    python, cpp, theirs, sizes = [], [], [], []
    for frame in range(frames):
        if not motion.advance():
            break
        ids, positions = motion.ids, motion.points
        times = followed.times(ids, positions, frame % 2 == 0)
        size = max(len(positions), 1)
        python.append(times[0] / size)
        cpp.append(times[1] / size)
        sizes.append(size)
        if frame % max(frames // SCIPY_FRAMES, 1) == 0 and len(positions) > 3:
            theirs.append(nanoseconds(lambda: Delaunay(positions)) / size)
    assert followed.python.is_certified and followed.python.is_valid()
    size, ours, plain, scipy_time = (np.median(values) for values in (sizes, python, cpp, theirs))
    print(
        f"{motion.name:28}{size:10.0f}{len(python):10}{plain:10.1f}{ours:10.1f}{(ours / plain - 1) * 100:10.1f}"
        f"{(ours - plain) * size / 1000:10.2f}{scipy_time:10.0f}{scipy_time / ours:10.0f}",
        flush=True,
    )


def fixed_costs():
    points = np.random.default_rng(1).random((10, 2))
    dt, plain = DynamicDelaunay(points), reference.Reference(points)
    python = np.median([nanoseconds(lambda: dt.update(points)) for _ in range(20_000)])
    cpp = np.median([plain.update(points) for _ in range(20_000)])
    nothing = np.median([nanoseconds(lambda: None) for _ in range(20_000)])
    print(f"\na call of update() at 10 points costs {(python - cpp - nothing) / 1000:.2f} us more than in C++")
    points = np.random.default_rng(1).random((10_000, 2))
    dt = DynamicDelaunay(points)
    print("\narrays of 10,000 points, ns a point:")
    for name in ("edges", "triangles", "indices", "areas", "ridges", "points"):
        times = []
        for _ in range(30):
            dt.move(0, points[0])  # after which no array is current
            times.append(nanoseconds(lambda: getattr(dt, name)))
        print(f"  {name:12} {np.median(times) / 10_000:8.1f}")


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--frames", type=int, default=1000, help="of each motion, at most (default: 1000)")
    options.add_argument("names", nargs="*", help="scenarios or files; all scenarios and recordings if there is none")
    options = options.parse_args()
    cases = [(name, None) for name in options.names]
    if not cases:
        cases = SCENARIOS + LARGE + [(path, None) for path in reference.recordings()]
    print(f"SciPy {scipy.__version__}, NumPy {np.__version__}; {dynamic_delaunay.__doc__.splitlines()[0]}\n")
    heads = [("", "points"), ("", "frames"), ("C++,", "ns/point"), ("Python,", "ns/point"), ("over C++,", "%")]
    heads += [("over C++,", "us/call"), ("SciPy,", "ns/point"), ("SciPy /", "Python")]
    for line, first in enumerate(("", "motion")):
        print(f"{first:28}" + "".join(f"{head[line]:>10}" for head in heads))
    for path, points in cases:
        follow(path, points, options.frames)
    fixed_costs()


if __name__ == "__main__":
    main()
