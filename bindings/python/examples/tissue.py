# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""T1 events of a tissue: cells that exchange neighbors in a periodic Voronoi tissue.

    tissue.py [--steps N] [--shape P0]

A simple model of a tissue: a cell whose shape index, perimeter over the square root of the area, is above a target
draws its point to its centroid, which makes it rounder; and all are shaken. It counts how often two cells part and two
others meet: a T1 event is one created and one removed edge. For forces of an energy see ``voronoi_tissue.cpp``.
"""

import argparse

import numpy as np

from dynamic_delaunay import PeriodicDelaunay


def force_to_centroids(tissue, target):
    """Toward the centroids, which makes cells round, the more so the longer their perimeters are."""
    excess = np.maximum(tissue.shape_indices - target, 0)
    return excess[:, np.newaxis] * (tissue.centroids - tissue.points)


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--steps", type=int, default=300)
    options.add_argument("--shape", type=float, default=3.7, help="target of perimeter / sqrt(area)")
    options = options.parse_args()
    side = 15
    random = np.random.default_rng(1)
    points = random.uniform(0, side, (side * side, 2))
    tissue = PeriodicDelaunay(points, (side, side), changes=True)
    events = []
    for _ in range(options.steps):
        points = points + 0.5 * force_to_centroids(tissue, options.shape) + random.normal(0, 0.02, points.shape)
        tissue.update(points)
        events.append(len(tissue.created_edges))  # one for each T1 event
    assert abs(tissue.areas.sum() - side * side) < 1e-6 * side * side
    half = options.steps // 2
    print(f"shape index {tissue.shape_indices.mean():.3f}")
    print(f"T1 events a cell and step: {np.mean(events[:half]) / len(tissue):.4f} in the first half, "
          f"{np.mean(events[half:]) / len(tissue):.4f} in the second")


if __name__ == "__main__":
    main()
