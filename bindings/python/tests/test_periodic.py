# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

import pickle

import numpy as np
import pytest
from scipy.spatial import Delaunay

from dynamic_delaunay import PeriodicDelaunay, PeriodicPopulation, errors


def images_by_scipy(points, cell):
    """Edges as (i, j, shift) of the middle one of 25 copies."""
    shifts = [(i, j) for i in range(-2, 3) for j in range(-2, 3)]
    copies = np.concatenate([points + np.array(shift) @ cell for shift in shifts])
    n, edges = len(points), set()
    for triangle in Delaunay(copies).simplices:
        for a, b in zip(triangle, np.roll(triangle, 1)):
            for p, q in ((a, b), (b, a)):
                if shifts[p // n] == (0, 0):
                    edges.add((p % n, q % n, shifts[q // n]))
    return edges


def images(triangulation):
    edges = set()
    for (i, j), (a, b) in zip(triangulation.edges.tolist(), triangulation.edge_shifts.tolist()):
        edges |= {(i, j, (a, b)), (j, i, (-a, -b))}
    return edges


def test_agrees_with_scipys_of_many_copies():
    random = np.random.default_rng(1)
    cell = np.array([(1.0, 0.1), (0.3, 0.9)])
    points = random.random((80, 2)) @ cell
    dt = PeriodicDelaunay(points, cell)
    for frame in range(10):
        assert images(dt) == images_by_scipy(points, cell)
        assert dt.is_valid() and dt.is_certified
        assert len(dt.edges) == 3 * 80 and len(dt.triangles) == 2 * 80
        cell = cell + (0, 0.01)
        points = points + random.normal(0, 0.01, points.shape)
        report = dt.update(points, cell)
    assert report.certified
    assert np.array_equal(dt.cell, cell)
    assert repr(dt) == "<PeriodicDelaunay of 80 points, certified>"


def test_triangles_and_lists_have_shifts():
    points = np.random.default_rng(1).random((50, 2))
    dt = PeriodicDelaunay(points, (1, 1))
    corners = points[dt.triangles] + dt.triangle_shifts @ dt.cell
    a, b, c = corners.transpose(1, 0, 2)
    areas = np.cross(b - a, c - a) / 2
    assert (areas > 0).all() and areas.sum() == pytest.approx(1)
    first = np.repeat(np.arange(50), np.diff(dt.indptr))
    listed = {(i, j, tuple(s)) for i, j, s in zip(first, dt.indices, dt.neighbor_shifts.tolist())}
    assert listed == images(dt)
    pairs = dt.neighbor_list()
    assert len(pairs) == 300 and np.array_equal(pairs.neighbor_counts, np.diff(dt.indptr))
    assert pairs.vectors.sum(axis=0) == pytest.approx(0)
    assert pairs.distances.max() < 0.6
    assert np.bincount(first, pairs.weights) == pytest.approx(dt.perimeters)
    assert dt.areas.sum() == pytest.approx(1)


def test_lists_the_changed_edges():
    random = np.random.default_rng(1)
    points = random.random((100, 2))
    dt = PeriodicDelaunay(points, (1, 1), changes=True)
    edges = images(dt)
    points = points + random.normal(0, 0.01, points.shape)
    dt.update(points)

    def changed(pairs, shifts):
        both = set()
        for (i, j), (a, b) in zip(pairs.tolist(), shifts.tolist()):
            both |= {(i, j, (a, b)), (j, i, (-a, -b))}
        return both

    created = changed(dt.created_edges, dt.created_edge_shifts)
    removed = changed(dt.removed_edges, dt.removed_edge_shifts)
    assert created and edges - removed | created == images(dt)
    assert len(dt.created_edges) == len(dt.removed_edges)


def test_inserts_removes_and_moves():
    dt = PeriodicDelaunay(cell=(3, 2))
    assert dt.insert(np.random.default_rng(1).random((10, 2))).tolist() == list(range(10))
    dt.remove([2, 3])
    dt.move(4, (10.5, 0))
    assert dt.insert((0.5, 1.5)).tolist() == [2]
    assert len(dt) == 9 and len(dt.edges) == 27 and dt.is_valid()


def test_slab():
    dt = PeriodicDelaunay(np.random.default_rng(1).random((50, 2)), [(1, 0)])
    assert dt.cell.tolist() == [[1, 0]]
    assert not dt.edge_shifts[:, 1].any() and np.isinf(dt.areas).any()


@pytest.mark.parametrize("cell", [(1, 0), [(1, 2), (2, 4)], (1, 2, 3, 4), [(np.nan, 0), (0, 1)], 1.0])
def test_refuses_what_is_no_cell(cell):
    with pytest.raises(errors.PeriodicCellError):
        PeriodicDelaunay([(0, 0)], cell)


@pytest.mark.parametrize("cell", [(1, 1), [(1, 0.2), (0.3, 1)], [(1, 0)]])
def test_pickles_and_goes_on_as_it_would_have(cell):
    random = np.random.default_rng(2)
    points = random.random((60, 2))
    dt = PeriodicDelaunay(points, cell)
    twin = pickle.loads(pickle.dumps(dt))
    assert twin.cell.tolist() == dt.cell.tolist()
    for _ in range(5):
        points = points + random.normal(0, 0.02, points.shape)
        assert dt.update(points).flips == twin.update(points).flips
        assert twin.is_valid()
        assert np.array_equal(dt.edges, twin.edges) and np.array_equal(dt.edge_shifts, twin.edge_shifts)


def test_population_pickles():
    population = PeriodicPopulation([7, -3, 5], [(0.1, 0.2), (0.5, 0.6), (0.9, 0.1)], (1, 1))
    twin = pickle.loads(pickle.dumps(population))
    assert twin.ids.tolist() == population.ids.tolist()
    twin.remove(7)
    assert len(twin) == 2 and len(population) == 3


def test_refuses_points_that_are_too_far():
    with pytest.raises(errors.PeriodicRangeError) as refused:
        PeriodicDelaunay([(0, 0), (1e9, 0)], (1, 1))
    assert refused.value.id == 1
