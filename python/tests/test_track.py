# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

import numpy as np
import pytest
from agreement import assert_is_delaunay, edge_set, edges_by_scipy

from dynamic_delaunay import track

RANDOM = np.random.default_rng(1)
TRAJECTORY = RANDOM.random((100, 2)) + np.cumsum(RANDOM.normal(0, 0.003, (20, 100, 2)), axis=0)


def test_follows_an_array():
    numbers = []
    for number, triangulation, report in track(TRAJECTORY, classifier="safe_region"):
        assert report.certified
        assert_is_delaunay(triangulation, TRAJECTORY[number])
        numbers.append(number)
    assert numbers == list(range(20))


def test_follows_a_generator_in_a_periodic_cell():
    for frame in track((points for points in TRAJECTORY), cell=(1, 1)):
        assert len(frame.triangulation.edges) == 300 and frame.report.certified


@pytest.mark.parametrize("cell", [None, (1, 1)])
def test_follows_pairs_of_ids_and_points(cell):
    pairs = ((np.arange(n, 100), points[n:]) for n, points in enumerate(TRAJECTORY))
    for frame in track(pairs, cell=cell):
        assert len(frame.triangulation) == 100 - frame.number == len(frame.triangulation.ids)


def test_follows_a_table():
    pandas = pytest.importorskip("pandas")
    rows = [(10 * f, 7 * i, *TRAJECTORY[f, i]) for f in range(20) for i in range(100) if (f + i) % 9]
    table = pandas.DataFrame(rows, columns=["frame", "id", "x", "y"]).sample(frac=1, random_state=1)
    numbers = []
    for frame in track(table, progress=True):
        numbers.append(frame.number)
        population = frame.triangulation
        points = TRAJECTORY[frame.number // 10, population.ids // 7]
        assert np.array_equal(population.points, points)
        assert edge_set(population.edges) == edges_by_scipy(points)
    assert numbers == list(range(0, 200, 10))
    with pytest.raises(ValueError, match="no column id, x"):
        next(track(table[["frame", "y"]]))


def test_follows_a_table_with_integers_of_pandas():
    pandas = pytest.importorskip("pandas")
    rows = [(f, i, *TRAJECTORY[f, i]) for f in range(3) for i in range(100)]
    table = pandas.DataFrame(rows, columns=["frame", "id", "x", "y"])
    for frame in track(table.astype({"id": "Int64"}), changes=True):
        assert frame.triangulation.ids.tolist() == list(range(100))
    with pytest.raises(TypeError, match="ids have the type float64: integers are needed"):
        next(track(table.astype({"id": float})))


def test_says_nothing_of_an_empty_trajectory():
    assert list(track([])) == []
