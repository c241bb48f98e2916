# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Queries of many places in space, against SciPy and brute force."""

import copy
import itertools
import threading

import numpy as np
import pytest
from scipy.sparse import csr_array
from scipy.spatial import cKDTree
from space_agreement import cloud, moved

from dynamic_delaunay import DynamicDelaunay, DynamicDelaunay3D, Population, Population3D, errors

RANDOM = np.random.default_rng(49)
POINTS = cloud(400)
PLACES = RANDOM.uniform(-0.2, 1.2, (300, 3))
IDS = RANDOM.choice(10**15, 400, replace=False) - 5 * 10**14


def in_spheres(points, places, radius):
    """Rows of the points within a radius of each place, by distances as SciPy has them."""
    return [sorted(rows) for rows in cKDTree(points).query_ball_point(places, radius)]


def listed(found):
    return [found.indices[begin:end].tolist() for begin, end in zip(found.indptr, found.indptr[1:])]


@pytest.mark.parametrize("make", [DynamicDelaunay, lambda points: Population(IDS, points)])
def test_agree_with_a_tree_while_points_move(make):
    points = POINTS
    dt = make(points)
    for frame in range(4):
        found = dt.nearest(PLACES)
        distances, rows = cKDTree(dt.points).query(PLACES)
        assert np.array_equal(found.rows, rows) and np.allclose(found.distances, distances, rtol=1e-12)
        assert [array.dtype.name for array in found] == ["int32", "float64", "int32"]
        assert found.shifts.shape == (300, 3) and not found.shifts.any()
        for radius in (0, 0.05, 0.3):
            found = dt.within(PLACES, radius)
            assert listed(found) == in_spheres(dt.points, PLACES, radius)
            assert found.shape == (300, 400) and found.shifts.shape == (len(found.indices), 3)
            assert [array.dtype.name for array in found[:4]] == ["int32", "int32", "float64", "int32"]
            assert (found.distances <= radius * (1 + 1e-15)).all() and not found.shifts.any()
        points = moved(points, 0.01, frame)
        if isinstance(dt, Population3D):
            dt.update(IDS[frame:], points[frame:])
            dt.insert(IDS[:frame], points[:frame])
        else:
            dt.update(points)


def test_lists_within_a_radius_are_a_sparse_matrix():
    found = DynamicDelaunay(POINTS).within(POINTS, 0.15)
    matrix = csr_array((found.distances, found.indices, found.indptr), found.shape).toarray()
    expected = np.linalg.norm(POINTS[:, np.newaxis] - POINTS, axis=2)
    assert np.allclose(matrix, np.where(expected <= 0.15, expected, 0))
    assert (found.indices[found.distances == 0] == np.arange(400)).all()  # each finds itself


def test_points_on_the_sphere_are_within_the_radius():
    for radius in (*RANDOM.random(300), 0.1, 0.3, 1e-170, 5e-324, 1e70):
        for axis in np.eye(3):
            dt = DynamicDelaunay([radius * axis])
            assert len(dt.within((0, 0, 0), radius).indices) == 1, radius
            assert len(dt.within((0, 0, 0), radius * (1 - 1e-15)).indices) <= (radius < 1e-160)


def test_all_points_are_within_an_infinite_radius():
    assert np.array_equal(DynamicDelaunay(POINTS).within(PLACES[:2], np.inf).indices, [*range(400)] * 2)


def test_of_equally_near_points_the_smallest_row_is_nearest():
    lattice = np.array(list(itertools.product(range(4), repeat=3)), float)
    for dt in (DynamicDelaunay(lattice), Population(np.arange(64)[::-1] * 7, lattice)):
        middles = lattice[lattice.max(axis=1) < 3] + 0.5
        for places in (middles, middles * (1, 1, 0), middles - (0, 0.5, 0.5), lattice):
            squares = ((dt.points - places[:, np.newaxis]) ** 2).sum(axis=2)
            assert dt.nearest(places).rows.tolist() == squares.argmin(axis=1).tolist()
            for square in (0.25, 0.5, 0.75):
                expected = [np.flatnonzero(row <= square).tolist() for row in squares]
                assert listed(dt.within(places, np.sqrt(square))) == expected
    sphere = np.array(list(itertools.product(range(-9, 10), repeat=3)), float)
    sphere = RANDOM.permutation(sphere[(sphere**2).sum(axis=1) == 81])
    found = DynamicDelaunay(sphere)
    assert found.nearest((0, 0, 0)).rows.tolist() == [0]
    assert len(found.within((0, 0, 0), 9).indices) == len(sphere) > 100
    assert len(found.within((0, 0, 0), np.nextafter(9, 0)).indices) == 0


@pytest.mark.parametrize("flatten", [(1, 1, 0), (1, 0, 0), (0, 0, 0)])
def test_points_without_an_extent_are_found(flatten):
    dt = DynamicDelaunay(POINTS * flatten + (0, 0, 0.5))
    assert dt.dimension == sum(flatten) and len(dt.simplices) == 0
    assert np.allclose(dt.nearest(PLACES).distances, cKDTree(dt.points).query(PLACES)[0], rtol=1e-12)
    assert listed(dt.within(PLACES, 0.5)) == in_spheres(dt.points, PLACES, 0.5)


def test_rows_are_those_of_arrays_where_ids_are_free_and_points_coincide():
    dt = DynamicDelaunay([*POINTS[:10], POINTS[3]])
    dt.remove([0, 5])
    assert dt.nearest(POINTS[3]).rows.tolist() == [3]
    assert dt.within(POINTS[3], 0).indices.tolist() == [3, 10]
    assert not {0, 5} & set(dt.nearest(PLACES).rows) and dt.within(PLACES, 1).shape == (300, 11)
    population = Population([5, -7, 5000, 6], [(0.1, 0.1, 0), (0.5, 0.5, 0), (0.9, 0.9, 0), (0.1, 0.1, 0)])
    found = population.within([(0.1, 0.1, 0), (0.9, 0.8, 0)], 0.2)
    assert [population.ids[rows].tolist() for rows in listed(found)] == [[5, 6], [5000]]
    population.remove(5)
    assert population.ids[population.nearest((0, 0, 0)).rows].tolist() == [6]
    assert population.within((0, 0, 0), 9).shape == (1, 3)
    together = DynamicDelaunay(np.repeat(POINTS[:20], 3, axis=0))
    assert (together.nearest(POINTS[:20]).rows == np.arange(0, 60, 3)).all()
    assert listed(together.within(POINTS[:20], 1e-9)) == [[3 * i, 3 * i + 1, 3 * i + 2] for i in range(20)]


@pytest.mark.parametrize("kind", [DynamicDelaunay3D, Population3D])
def test_no_points_and_no_places(kind):
    empty = kind()
    found = empty.nearest(PLACES[:3])
    assert found.rows.tolist() == [-1] * 3 and np.isinf(found.distances).all() and not found.shifts.any()
    assert empty.within(PLACES[:3], 1).indptr.tolist() == [0] * 4
    for dt in (empty, DynamicDelaunay(POINTS)):
        for places in ([], np.empty((0, 3))):
            assert [array.shape for array in dt.nearest(places)] == [(0,), (0,), (0, 3)]
            assert dt.within(places, 1).indptr.tolist() == [0]
    assert DynamicDelaunay([(1, 2, 3)]).nearest((1, 2, 5)).distances.tolist() == [2]


@pytest.mark.parametrize("arranged", [
    np.asfortranarray,
    lambda places: np.ascontiguousarray(places[::-1, ::-1])[::-1, ::-1],
    lambda places: places.astype(">f8"),
    lambda places: places.tolist(),
    lambda places: np.broadcast_to(places, places.shape),
])
def test_places_are_read_wherever_they_are(arranged):
    dt = DynamicDelaunay(POINTS)
    assert np.array_equal(dt.nearest(arranged(PLACES)).rows, dt.nearest(PLACES).rows)
    assert np.array_equal(dt.within(arranged(PLACES), 0.2).indices, dt.within(PLACES, 0.2).indices)


def test_wrong_questions_are_refused():
    dt, masked = DynamicDelaunay(POINTS), np.ma.masked_array(PLACES, PLACES > 0.5)
    for wrong, kind, text in (
        (lambda: dt.nearest(PLACES[:, :2]), errors.InputValueError, r"query points have the shape \(300, 2\): .*n, 3"),
        (lambda: dt.nearest((0, 0)), errors.InputValueError, r"\(2,\)"),
        (lambda: dt.nearest(np.zeros((2, 3, 3))), errors.InputValueError, r"\(2, 3, 3\)"),
        (lambda: dt.nearest(0.5), errors.InputValueError, r"\(\)"),
        (lambda: dt.nearest("here"), errors.InputTypeError, "real numbers are needed"),
        (lambda: dt.nearest(None), errors.InputTypeError, "real numbers are needed"),
        (lambda: dt.nearest(PLACES * 1j), errors.InputTypeError, "real numbers are needed"),
        (lambda: dt.nearest(masked), errors.InputTypeError, "mask would be lost"),
        (lambda: dt.nearest([(0, 0, np.nan)]), errors.NonFiniteCoordinateError, "nan"),
        (lambda: dt.within((0, -np.inf, 0), 1), errors.NonFiniteCoordinateError, "inf"),
        (lambda: dt.within((0, 0, 0), -1), errors.InputValueError, "must be 0 or more"),
        (lambda: dt.within((0, 0, 0), np.nan), errors.InputValueError, "must be 0 or more"),
        (lambda: dt.within((0, 0, 0), [1, 2]), errors.InputValueError, "must be one number"),
        (lambda: dt.within((0, 0, 0), "far"), errors.InputValueError, "real numbers"),
        (lambda: dt.within((0, 0, 0), {}), errors.InputTypeError, "real numbers"),
        (lambda: dt.within((0, 0), 1), errors.InputValueError, r"\(2,\)"),
    ):
        with pytest.raises(kind, match=text):
            wrong()
    with pytest.raises(errors.NonFiniteCoordinateError) as refused:
        dt.nearest([(0, 0, 0), (1, 1, 1), (0.5, 0.25, np.nan)])
    assert (refused.value.id, refused.value.x, refused.value.y) == (2, 0.5, 0.25) and np.isnan(refused.value.z)
    assert dt.nearest(PLACES).rows.shape == (300,)


def test_need_an_initialized_triangulation():
    class Unprepared(DynamicDelaunay3D):
        def __init__(self):
            pass

    for use in (lambda dt: dt.nearest(PLACES), lambda dt: dt.within(PLACES, 1), lambda dt: dt.certify(),
                lambda dt: dt.created_edges):
        with pytest.raises(errors.UseError, match="was not called"):
            use(Unprepared())


def test_what_reads_places_may_use_the_triangulation():
    dt = DynamicDelaunay(POINTS)

    class Moving:
        def __array__(self, *_arguments, **_named):
            dt.update(moved(POINTS, 0.01))
            return dt.points

    assert dt.nearest(Moving()).rows.tolist() == list(range(400))
    assert (dt.within(Moving(), 0).distances == 0).all()


def test_certify_proves_again():
    for dt in (DynamicDelaunay(POINTS), Population(IDS, POINTS), DynamicDelaunay3D(), DynamicDelaunay([(1, 2, 3)] * 3),
               DynamicDelaunay(POINTS * (1, 1, 0)), DynamicDelaunay(POINTS, threads=0)):
        simplices = dt.simplices
        assert dt.certify() is True and dt.is_certified and dt.is_current(simplices)


def test_threads_change_no_answer():
    points, places = RANDOM.random((5000, 3)), RANDOM.random((20000, 3))
    alone, together = DynamicDelaunay(points), DynamicDelaunay(points, threads=0)
    for ask in (lambda dt: dt.nearest(places), lambda dt: dt.within(places, 0.05)):
        assert all(np.array_equal(a, b) for a, b in zip(ask(alone), ask(together)))


def test_release_the_interpreter():
    dt = DynamicDelaunay(cloud(20_000))
    turns, is_over = [], threading.Event()

    def count():
        while not is_over.wait(1e-4):
            turns.append(1)

    counter = threading.Thread(target=count)
    counter.start()
    before = len(turns)
    dt.nearest(RANDOM.random((50_000, 3)))  # some tenths of a second
    during = len(turns) - before
    is_over.set()
    counter.join()
    assert during > 5


def test_answers_belong_to_one_moment():
    population = Population(IDS, POINTS)
    failures, is_over = [], threading.Event()

    def change():
        random = np.random.default_rng(1)
        for _ in range(150):
            there = random.permutation(400)[: random.integers(1, 400)]
            population.update(IDS[there], POINTS[there])
        is_over.set()

    def ask():
        try:
            while not is_over.is_set():
                assert (population.nearest(PLACES).rows >= 0).all()
                found = population.within(PLACES, 0.3)
                assert found.indices.max(initial=0) < found.shape[1] and found.indptr[-1] == len(found.indices)
                assert population.certify() and len(copy.copy(population)) > 0
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=work) for work in (change, ask, ask, ask)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures and population.is_valid()
