# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What updates from Python cost: beside the same updates in C++, and beside SciPy's Delaunay of the same frames.

    python.py [--frames N] [--space] [NAME ...]

Python and C++ follow 20 frames in turn, in one process, and read the same arrays; SciPy, which takes long, triangulates
20 of all frames. Times are medians over the frames, a point. Last come the fixed cost of a call, at 10 points, the
costs of arrays at 10,000 points, and points in space beside SciPy, to which --space is limited.
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
FRAMES, LARGE_FRAMES = 1000, 300
BLOCK = 20  # frames
SCIPY_FRAMES = 20
SPACE_FRAMES, SPACE_SCIPY_FRAMES, SPACE_STEPS = 30, 3, (1e-4, 1e-3, 0.01)


def nanoseconds(work):
    begin = time.perf_counter_ns()
    work()
    return time.perf_counter_ns() - begin


def each(follow, arguments):
    """Nanoseconds of each call. Read in place: a function around it would take as long as a small frame."""
    clock, times = time.perf_counter_ns, []
    for argument in arguments:
        begin = clock()
        follow(*argument)
        times.append(clock() - begin)
    return times


class Fixed:
    def __init__(self, ids, points):
        self.python, self.cpp = DynamicDelaunay(points), reference.Reference(points)

    def follow_by_python(self, frames):
        return each(self.python.update, [(points,) for _, points in frames])

    def follow_by_cpp(self, frames):
        return self.cpp.follow([points for _, points in frames])


class Changing:
    def __init__(self, ids, points):
        self.python, self.cpp = Population(ids, points), reference.PopulationReference()
        self.cpp.follow([(ids, points)])

    def follow_by_python(self, frames):
        return each(self.python.update, frames)

    def follow_by_cpp(self, frames):
        return self.cpp.follow(frames)


def blocks(motion, frames):
    block = []
    for _ in range(frames):
        if not motion.advance():
            break
        block.append((motion.ids, motion.points))
        if len(block) == BLOCK:
            yield block
            block = []
    if block:
        yield block


def follow(path, points, frames):
    motion = reference.Motion(path, points)
    if motion.is_periodic:
        return
    kind = Fixed if motion.has_fixed_population else Changing
    followed = kind(motion.ids, motion.points)
    python, cpp, theirs, sizes = [], [], [], []
    for number, block in enumerate(blocks(motion, frames)):
        assert all(np.isfinite(positions).all() for _, positions in block)  # and they are in the cache for both
        first, second = (python, followed.follow_by_python), (cpp, followed.follow_by_cpp)
        for times, follow_by in (first, second) if number % 2 else (second, first):
            times += follow_by(block)
        sizes += [max(len(positions), 1) for _, positions in block]
        positions = block[-1][1]
        if number % max(frames // BLOCK // SCIPY_FRAMES, 1) == 0 and len(positions) > 3:
            theirs.append(nanoseconds(lambda: Delaunay(positions)) / len(positions))
    python, cpp = (np.array(times) / sizes for times in (python, cpp))
    assert followed.python.is_certified and followed.python.is_valid()
    size, ours, plain, scipy_time = (np.median(values) for values in (sizes, python, cpp, theirs))
    print(
        f"{motion.name:28}{size:10.0f}{len(python):10}{plain:10.1f}{ours:10.1f}{(ours / plain - 1) * 100:10.1f}"
        f"{(ours - plain) * size / 1000:10.2f}{scipy_time:10.0f}{scipy_time / ours:10.0f}",
        flush=True,
    )


def in_space(number, step):
    """Random points in a cube, whose steps are in mean spacings."""
    random = np.random.default_rng(1)
    points = random.random((number, 3))
    dt = DynamicDelaunay(points)
    ours, theirs = [], []
    for frame in range(SPACE_FRAMES):
        points = points + random.normal(0, step * number ** (-1 / 3) / 3**0.5, points.shape)
        ours.append(nanoseconds(lambda: dt.update(points)) / number)
        if frame % (SPACE_FRAMES // SPACE_SCIPY_FRAMES) == 0:
            theirs.append(nanoseconds(lambda: Delaunay(points)) / number)
    assert dt.is_certified and dt.is_valid()
    ours, theirs = np.median(ours[1:]), np.median(theirs)  # the first frame makes room for former positions
    print(f"{number:10}{step:10g}{ours:10.1f}{theirs:10.0f}{theirs / ours:10.0f}", flush=True)
    return dt


def points_in_space():
    heads = ("points", "step", "Python", "SciPy", "ratio")
    print("\npoints in space, ns a point:\n" + "".join(f"{head:>10}" for head in heads))
    for number in (10_000, 100_000):
        for step in SPACE_STEPS:
            dt = in_space(number, step)
        print("    arrays: ", end="")
        for name in ("points", "simplices", "indices", "edges", "convex_hull"):
            print(f"{name} {array_cost(dt, lambda: getattr(dt, name)):.0f}", end=", ")
        print(f"volumes() {array_cost(dt, dt.volumes):.0f}", flush=True)


def array_cost(dt, make, repetitions=15):
    """Nanoseconds a point, after a change that leaves no array current."""
    times = []
    for _ in range(repetitions):
        dt.move(0, dt.points[0])
        times.append(nanoseconds(make))
    return np.median(times) / len(dt)


def fixed_costs():
    points = np.random.default_rng(1).random((10, 2))
    dt, plain = DynamicDelaunay(points), reference.Reference(points)
    python, cpp = [], []
    for _ in range(100):
        python += each(dt.update, [(points,)] * 200)
        cpp += plain.follow([points] * 200)
    print(f"\na call of update() at 10 points costs {(np.median(python) - np.median(cpp)) / 1000:.2f} us more than in C++")
    points = np.random.default_rng(1).random((10_000, 2))
    dt = DynamicDelaunay(points)
    print("\narrays of 10,000 points, ns a point:")
    for name in ("edges", "triangles", "indices", "areas", "ridges", "points"):
        print(f"  {name:12} {array_cost(dt, lambda: getattr(dt, name), 30):8.1f}")


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    frames = f"of each motion, at most (default: {FRAMES}, {LARGE_FRAMES} of scenarios that are made larger)"
    options.add_argument("--frames", type=int, help=frames)
    options.add_argument("--space", action="store_true", help="points in space alone")
    options.add_argument("names", nargs="*", help="scenarios or files; all scenarios and recordings if there is none")
    options = options.parse_args()
    if options.space:
        points_in_space()
        return
    cases = [(name, None) for name in options.names]
    if not cases:
        cases = SCENARIOS + LARGE + [(path, None) for path in reference.recordings()]
    print(f"SciPy {scipy.__version__}, NumPy {np.__version__}; {dynamic_delaunay.__doc__.splitlines()[0]}\n")
    heads = [("", "points"), ("", "frames"), ("C++,", "ns/point"), ("Python,", "ns/point"), ("over C++,", "%")]
    heads += [("over C++,", "us/call"), ("SciPy,", "ns/point"), ("SciPy /", "Python")]
    for line, first in enumerate(("", "motion")):
        print(f"{first:28}" + "".join(f"{head[line]:>10}" for head in heads))
    for path, points in cases:
        follow(path, points, options.frames or (LARGE_FRAMES if points else FRAMES))
    fixed_costs()
    points_in_space()


if __name__ == "__main__":
    main()
