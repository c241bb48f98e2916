# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

import numpy as np
import pytest
from agreement import assert_is_delaunay, edge_set, edges_by_scipy

from dynamic_delaunay import errors, track

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
    with pytest.raises(ValueError, match="'id' and 'x' are missing"):
        next(track(table[["frame", "y"]]))


def test_follows_a_table_with_integers_of_pandas():
    pandas = pytest.importorskip("pandas")
    rows = [(f, i, *TRAJECTORY[f, i]) for f in range(3) for i in range(100)]
    table = pandas.DataFrame(rows, columns=["frame", "id", "x", "y"])
    for frame in track(table.astype({"id": "Int64"}), changes=True):
        assert frame.triangulation.ids.tolist() == list(range(100))
    for frame in track(table.astype({"id": float})):
        assert frame.ids.tolist() == list(range(100))


@pytest.mark.parametrize("cell", [None, (1, 1)])
def test_errors_name_the_frame_and_the_id(cell):
    trajectory = TRAJECTORY.copy()
    trajectory[7, 3, 1] = np.nan
    with pytest.raises(errors.NonFiniteCoordinateError, match=r"^frame 7: point 3 has the coordinates") as refused:
        list(track(trajectory, cell))
    assert refused.value.id == 3
    with pytest.raises(errors.NonFiniteCoordinateError, match=r"^frame 7, id 1003: point 3 has"):
        list(track(((np.arange(1000, 1100), points) for points in trajectory), cell))
    pandas = pytest.importorskip("pandas")
    rows = [(10 * f, 7 * i, *trajectory[f, i]) for f in range(20) for i in range(100)]
    table = pandas.DataFrame(rows, columns=["frame", "id", "x", "y"]).sample(frac=1, random_state=1)
    with pytest.raises(errors.NonFiniteCoordinateError, match=r"^frame 70, id 21: "):
        list(track(table, cell))
    with pytest.raises(errors.NonFiniteCoordinateError, match=r"^frame 0: "):
        list(track(trajectory[7:], cell))
    with pytest.raises(errors.PointCountError, match=r"^frame 1: "):
        list(track([TRAJECTORY[0], TRAJECTORY[1, :50]], cell))
    with pytest.raises(errors.RepeatedIdError, match=r"^frame 0: "):
        list(track([([1, 1], TRAJECTORY[0, :2])], cell))


def test_ids_may_be_text():
    pairs = [(["b", "a"], TRAJECTORY[0, :2]), (np.array(["c", "b"], dtype=object), TRAJECTORY[1, :2])]
    frames = [(frame.ids.tolist(), frame.triangulation.points.tolist()) for frame in track(pairs)]
    assert [dict(zip(ids, points))["b"] for ids, points in frames] == [list(TRAJECTORY[0, 0]), list(TRAJECTORY[1, 1])]
    assert [sorted(ids) for ids, _ in frames] == [["a", "b"], ["b", "c"]]
    with pytest.raises(errors.InputTypeError, match="^frame 1: the ids are numbers, and those of the first frame text"):
        list(track([pairs[0], ([1, 2], TRAJECTORY[0, :2])]))
    with pytest.raises(errors.InputTypeError, match="^frame 1: the ids are text, and those of the first frame numbers"):
        list(track([([1, 2], TRAJECTORY[0, :2]), pairs[0]]))
    with pytest.raises(errors.InputTypeError, match="^frame 0: ids have the type object"):
        list(track([(["a", None], TRAJECTORY[0, :2])]))


def test_says_nothing_of_an_empty_trajectory():
    assert list(track([])) == []
