# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Lloyd's relaxation: points move to the centroids of their Voronoi cells until all cells are about alike.

    lloyd.py [--points N] [--steps N]
"""

import argparse

import numpy as np

from dynamic_delaunay import DynamicDelaunay

BOX = (0.0, 0.0, 1.0, 1.0)


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--points", type=int, default=1000)
    options.add_argument("--steps", type=int, default=100)
    options = options.parse_args()
    dt = DynamicDelaunay(np.random.default_rng(1).random((options.points, 2)))
    for step in range(options.steps + 1):
        cells = dt.clipped_cells(BOX)
        if step % max(options.steps // 5, 1) == 0:
            spread = cells.areas.std() / cells.areas.mean()
            print(f"step {step:4d}: areas differ by {spread:.3f} of their mean")
        dt.update(cells.centroids)
    assert dt.is_certified


if __name__ == "__main__":
    main()
