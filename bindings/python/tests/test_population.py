# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

import pickle

import numpy as np
import pytest
from agreement import edge_set, edges_by_scipy
from scipy.spatial import Delaunay

from dynamic_delaunay import PeriodicPopulation, Population, errors


def edges_of_ids(population):
    return edge_set(population.ids[population.edges])


def expected_edges(ids, points):
    return edge_set([(ids[i], ids[j]) for i, j in edges_by_scipy(points)])


def test_follows_points_that_come_and_go():
    random = np.random.default_rng(1)
    ids = random.choice(10**15, 300, replace=False) - 5 * 10**14
    points = random.random((300, 2))
    population = Population()
    for frame in range(30):
        there = random.random(300) < 0.9
        order = random.permutation(np.flatnonzero(there))
        points = points + random.normal(0, 0.002, points.shape)
        report = population.update(ids[order], points[order])
        assert report.certified and len(population) == there.sum()
        assert edges_of_ids(population) == expected_edges(ids[order], points[order])
        place = {id: k for k, id in enumerate(ids)}
        rows = [place[id] for id in population.ids]
        assert np.array_equal(population.points, points[rows])
        theirs = Delaunay(population.points)
        expected = {frozenset(t) for t in theirs.simplices.tolist()}
        assert {frozenset(t) for t in population.triangles.tolist()} == expected
        indptr, indices = theirs.vertex_neighbor_vertices
        assert len(population.indptr) == len(population) + 1
        for row in range(len(population)):
            assert set(population.neighbors_of(row)) == set(indices[indptr[row] : indptr[row + 1]])
        assert len(population.areas) == len(population.centroids) == len(population)
        assert population.clipped_cells((0, 0, 1, 1)).areas.sum() == pytest.approx(1)
    assert report.inserted > 0 and report.removed > 0 and population.is_valid()


def test_inserts_removes_and_moves_by_the_users_ids():
    population = Population([10, -20, 30], [(0, 0), (1, 0), (0, 1)])
    population.insert(2**40, (1, 1))
    assert 2**40 in population and 11 not in population
    population.move([10, 30], [(0.1, 0.1), (0, 2)])
    population.remove(-20)
    assert dict(zip(population.ids.tolist(), population.points.tolist())) == {
        10: [0.1, 0.1],
        30: [0, 2],
        2**40: [1, 1],
    }
    with pytest.raises(errors.UnknownIdError) as refused:
        population.remove(-20)
    assert refused.value.id == -20
    with pytest.raises(errors.RepeatedIdError) as refused:
        population.insert(10, (5, 5))
    assert refused.value.id == 10
    assert len(population.voronoi_cell(10)) == 0
    with pytest.raises(errors.UnknownIdError):
        population.voronoi_cell(11)


def test_inserts_and_removes_one_point_at_a_time():
    population = Population([1, 2, 3], [(0, 0), (1, 0), (0, 1)])
    with pytest.raises(ValueError, match="one point at a time"):
        population.insert([4, 5], [(1, 1), (2, 2)])
    for ids in ([], [1, 2]):
        with pytest.raises(ValueError, match="one point at a time"):
            population.remove(np.array(ids, int))
    assert len(population) == 3


def test_changes_nothing_if_a_frame_is_refused():
    population = Population([1, 2, 3], [(0, 0), (1, 0), (0, 1)])
    with pytest.raises(errors.RepeatedIdError):
        population.update([1, 2, 2], [(5, 5), (6, 6), (7, 7)])
    with pytest.raises(errors.NonFiniteCoordinateError):
        population.update([1, 2, 4], [(5, 5), (6, 6), (np.nan, 7)])
    assert population.ids.tolist() == [1, 2, 3]
    assert population.points.tolist() == [[0, 0], [1, 0], [0, 1]]


def test_takes_classifiers_and_pickles():
    random = np.random.default_rng(1)
    points = random.random((200, 2))
    population = Population(np.arange(100, 300), points, classifier="point_distance:0.5")
    population.update(np.arange(101, 301), points)
    population.mend()
    twin = pickle.loads(pickle.dumps(population))
    assert isinstance(twin, Population)
    assert np.array_equal(twin.ids, population.ids) and np.array_equal(twin.triangles, population.triangles)


def test_periodic_population():
    random = np.random.default_rng(1)
    points = random.random((100, 2))
    population = PeriodicPopulation(np.arange(100) * 7, points, (1, 1))
    assert len(population.edges) == 300 and len(population.triangles) == 200
    population.update(np.arange(50) * 7, points[:50] * 2, (2, 2))
    assert len(population.edges) == 150 and population.is_valid()
    assert population.areas.sum() == pytest.approx(4)
    assert population.ids[population.edges].max() == 49 * 7
    assert np.array_equal(population.cell, [(2, 0), (0, 2)])
