# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Densities in a crowd at a bottleneck: the inverse areas of Voronoi cells in the room, which end 2 m from a person.

    crowd_density.py [--picture FILE] [--frames N]

People walk through a gap. Each frame has the people who are there, by ids; some come, some leave. Prints the mean
density within 3 m of the gap, people per square meter, and draws the last frame if it is told to.
"""

import argparse

import numpy as np

from dynamic_delaunay import track

ROOM = np.array([(-5.0, 0.0), (5.0, 0.0), (5.0, 10.0), (-5.0, 10.0)])  # m; the gap is in the middle of the lower side
REACH = 2.0  # m
GAP = np.array([0.0, 0.0])
QUEUE_DENSITY = 4.0  # people per square meter


def walk(frames, people=150, seed=1):
    """Frames of ids and positions, in meters, every 0.1 s."""
    random = np.random.default_rng(seed)
    positions = random.uniform((-5, 2), (5, 10), (people, 2))
    ids = np.arange(people)
    for frame in range(frames):
        yield ids, positions
        way = GAP - positions
        distance = np.linalg.norm(way, axis=1)
        place_in_queue = np.argsort(np.argsort(distance))
        nearest_allowed = np.sqrt(2 * place_in_queue / (np.pi * QUEUE_DENSITY))
        step = np.clip(distance - nearest_allowed, 0, 0.12)
        positions = positions + (step / distance)[:, np.newaxis] * way + random.normal(0, 0.01, positions.shape)
        if frame % 5 == 4:  # the first one of the queue walks through, and somebody comes
            first = np.argmin(distance)
            positions[first] = random.uniform((-5, 9), (5, 10))
            ids = np.where(np.arange(people) == first, ids.max() + 1, ids)


def draw(cells, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
    from matplotlib.collections import PolyCollection

    polygons = PolyCollection(cells.rings(), edgecolors="white")
    polygons.set_array(1 / cells.areas)
    polygons.set_clim(0, 2 * QUEUE_DENSITY)
    figure, axes = pyplot.subplots(figsize=(6, 6))
    axes.add_collection(polygons)
    axes.plot(*cells.points.T, "k.", markersize=3)
    axes.set(xlim=(-5, 5), ylim=(0, 10), xlabel="x, m", ylabel="y, m", aspect="equal")
    figure.colorbar(polygons, label="people per square meter")
    figure.savefig(path)


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--picture", help="where to draw the last frame")
    options.add_argument("--frames", type=int, default=201)
    options = options.parse_args()
    came = left = 0
    for frame in track(walk(options.frames)):
        crowd = frame.triangulation
        came += frame.report.inserted
        left += frame.report.removed
        cells = crowd.bounded_cells(REACH, ROOM)
        if frame.number % 50 == 0:
            before_gap = np.linalg.norm(crowd.points - GAP, axis=1) < 3
            density = before_gap.sum() / cells.areas[before_gap].sum()
            print(f"{frame.number / 10:4.0f} s: {density:.1f} people per square meter")
    print(f"{came} came, {left} left")
    if options.picture:
        draw(cells, options.picture)


if __name__ == "__main__":
    main()
