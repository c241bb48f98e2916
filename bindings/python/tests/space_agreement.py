# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What triangulations in space have to be, alone and by SciPy."""

import itertools

import numpy as np
from agreement import edge_set
from scipy.spatial import Delaunay


def cloud(n, seed=1):
    return np.random.default_rng(seed).random((n, 3))


def moved(points, size, seed=2):
    return points + np.random.default_rng(seed).normal(0, size, points.shape)


def cells(simplices):
    return {tuple(simplex) for simplex in np.sort(simplices).tolist()}


def six_volumes(points, simplices):
    a, b, c, d = np.moveaxis(points[simplices], 1, 0)
    return np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a))


def sides_of_spheres(points, simplices):
    """By exact arithmetic of small integers, for each positive simplex: negative for points in its sphere, 0 on it."""
    rows = []
    for corners in points[simplices]:
        x = corners[:, np.newaxis] - points
        lifted = (x**2).sum(axis=2)
        minors = [np.einsum("ij,ij->i", x[i], np.cross(x[j], x[k]))
                  for i, j, k in ((1, 2, 3), (0, 2, 3), (0, 1, 3), (0, 1, 2))]
        rows.append(-lifted[0] * minors[0] + lifted[1] * minors[1] - lifted[2] * minors[2] + lifted[3] * minors[3])
    return np.array(rows).reshape(len(simplices), len(points))


def edges_of(simplices):
    return edge_set(np.concatenate([simplices[:, pair] for pair in itertools.combinations(range(4), 2)]))


def assert_edges_agree(dt):
    """With SciPy, of points that differ and whose coordinates are small integers: edges of only one of both are between
    points of a sphere on which there are more than four."""
    present = dt.ids if len(dt.ids) < len(dt.points) else np.arange(len(dt.points))
    points, simplices = dt.points[present].astype(np.int64), np.searchsorted(present, dt.simplices)
    spheres = [set(np.flatnonzero(side == 0).tolist()) for side in sides_of_spheres(points, simplices)]
    crowded = [sphere for sphere in spheres if len(sphere) > 4]
    for edge in edges_of(simplices) ^ edges_of(Delaunay(points).simplices):
        assert any(sphere.issuperset(edge) for sphere in crowded)


def assert_fits_together(dt):
    """Whether neighbors share facets, and lists, edges and hull are those of the simplices."""
    simplices, neighbors = dt.simplices, dt.neighbors
    facets = {}
    for number, simplex in enumerate(simplices.tolist()):
        for corner in range(4):
            facets.setdefault(frozenset(simplex) - {simplex[corner]}, []).append((number, corner))
    expected = np.full(simplices.shape, -1)
    for (number, corner), *others in facets.values():
        for other, its_corner in others:
            expected[number, corner], expected[other, its_corner] = other, number
        assert len(others) <= 1
    assert np.array_equal(neighbors, expected)
    assert {frozenset(facet) for facet in dt.convex_hull.tolist()} == \
        {facet for facet, sides in facets.items() if len(sides) == 1}
    if len(simplices):
        assert edge_set(dt.edges) == edges_of(simplices)
    assert len(dt.edges) == len(edge_set(dt.edges))
    indptr, indices = dt.neighbor_lists()
    assert len(indptr) == len(dt.points) + 1
    ends = np.concatenate([dt.edges, dt.duplicates]).reshape(-1, 2)
    listed = {(i, j) for i in range(len(dt.points)) for j in indices[indptr[i] : indptr[i + 1]].tolist()}
    assert listed == {(i, j) for pair in ends.tolist() for i, j in (pair, pair[::-1])}
    assert len(listed) == len(indices)
    rows = np.repeat(np.arange(len(dt.points)), np.diff(indptr))
    assert (np.diff(indices)[np.diff(rows) == 0] > 0).all()


def assert_is_delaunay(dt, points):
    """In general position, where there is one Delaunay triangulation."""
    assert dt.is_certified and dt.is_valid()
    assert cells(dt.simplices) == cells(Delaunay(points).simplices)
    assert_fits_together(dt)
