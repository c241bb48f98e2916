# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What triangulations by SciPy have to say about ours."""

import numpy as np
from scipy.spatial import Delaunay


def edge_set(edges):
    return {(int(min(e)), int(max(e))) for e in edges}


def edges_by_scipy(points):
    triangles = Delaunay(points).simplices
    return edge_set(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]))


def assert_is_delaunay(triangulation, points):
    assert triangulation.is_certified
    assert triangulation.is_valid()
    assert edge_set(triangulation.edges) == edges_by_scipy(points)
