# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Voronoi cells in a square hall with square pillars, as one does it in Python: SciPy's Voronoi and Shapely.

    shapely_cells.py POINTS PILLARS

Writes the sum of the areas, and the seconds that the cells took. The hall is that of cells.cpp: PILLARS in each row and
column.
"""

import sys
import time

import numpy as np
from scipy.spatial import Voronoi
from shapely.geometry import Polygon


def box(x, y, size):
    return [(x, y), (x + size, y), (x + size, y + size), (x, y + size)]


def main():
    number, pillars = int(sys.argv[1]), int(sys.argv[2])
    side = number**0.5
    spacing = side / pillars
    holes = [
        box((i + 0.375) * spacing, (j + 0.375) * spacing, spacing / 4) for i in range(pillars) for j in range(pillars)
    ]
    hall = Polygon(box(0, 0, side), holes)
    random = np.random.default_rng(1)
    points = random.random((3 * number, 2)) * side
    in_cell = np.abs(points / spacing % 1 - 0.5)
    points = points[in_cell.max(axis=1) > 0.125][:number]
    around = np.array([(-5, 0.5), (6, 0.5), (0.5, -5), (0.5, 6)]) * side  # so that all other cells are bounded

    begin = time.perf_counter()
    voronoi = Voronoi(np.concatenate([points, around]))
    areas = [
        Polygon(voronoi.vertices[voronoi.regions[region]]).intersection(hall).area
        for region in voronoi.point_region[:number]
    ]
    seconds = time.perf_counter() - begin
    print(repr(float(sum(areas))), seconds)


main()
