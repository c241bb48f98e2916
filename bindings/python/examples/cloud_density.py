# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Densities in a cloud of particles that falls together: 4 over the volume of the tetrahedra around a particle.

    cloud_density.py [--points N] [--frames N]

Each tetrahedron counts for its four corners (this is the DTFE, the Delaunay tessellation field estimator). Prints the
mean number of neighbors, and the density in the inner half of the cloud over that of the first frame, every 20 frames.
"""

import argparse

import numpy as np

from dynamic_delaunay import track


def fall(frames, points, seed=1):
    """Positions of particles that fall to the middle of a ball of radius 1, and are shaken."""
    random = np.random.default_rng(seed)
    positions = random.normal(size=(points, 3))
    positions *= (random.random((points, 1)) ** (1 / 3)) / np.linalg.norm(positions, axis=1, keepdims=True)
    for _ in range(frames):
        yield positions
        positions = 0.997 * positions + random.normal(0, 1e-4, positions.shape)


def densities(cloud):
    """Particles per unit of volume, at each particle."""
    around = np.bincount(cloud.simplices.ravel(), np.repeat(cloud.volumes(), 4), minlength=len(cloud.points))
    return 4 / around


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--points", type=int, default=2000)
    options.add_argument("--frames", type=int, default=101)
    options = options.parse_args()
    first = None
    for number, cloud, report in track(fall(options.frames, options.points)):
        assert report.certified
        if number % 20 == 0:
            from_middle = np.linalg.norm(cloud.points, axis=1)
            inner = np.median(densities(cloud)[from_middle < np.median(from_middle)])
            first = first or inner
            neighbors = np.diff(cloud.indptr).mean()
            print(f"frame {number:3d}: {neighbors:.2f} neighbors, density {inner / first:.2f}, {report.flips} flips")


if __name__ == "__main__":
    main()
