# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Queries of many places in periodic space, against brute force over images."""

import itertools

import numpy as np
import pytest

from dynamic_delaunay import (
    PeriodicDelaunay,
    PeriodicDelaunay3D,
    PeriodicPopulation,
    PeriodicPopulation3D,
    errors,
)

RANDOM = np.random.default_rng(49)
CELL = np.array([(1.0, 0.1, 0.0), (0.3, 0.9, 0.1), (-0.2, 0.1, 1.1)])
SHEARED = np.array([(1.0, 0.0, 0.0), (2.4, 1.0, 0.0), (-1.3, 3.6, 0.8)])
POINTS = RANDOM.random((60, 3)) @ CELL
PLACES = np.concatenate([RANDOM.random((40, 3)) @ CELL, RANDOM.uniform(-9, 9, (40, 3))])
IDS = RANDOM.choice(10**15, 60, replace=False) - 5 * 10**14
LATTICE = np.array(list(itertools.product(range(4), repeat=3)), float)


def images(points, cell, places, radius):
    """Of each place and point the shifts of all images that may be within the radius, ascending, and the squares of
    their distances."""
    thickness = 1 / np.linalg.norm(np.linalg.inv(cell), axis=0).max()
    reach = int(np.ceil(radius / thickness + 0.5))
    steps = np.array(list(itertools.product(range(-reach, reach + 1), repeat=3)))
    next_to_it = np.rint((places[:, np.newaxis] - points) @ np.linalg.inv(cell))
    shifts = next_to_it[:, :, np.newaxis] + steps
    ways = points[:, np.newaxis] + shifts @ cell - places[:, np.newaxis, np.newaxis]
    return shifts.astype(int), (ways**2).sum(axis=3)


def basis_of(cell):
    """Shorter vectors of the same lattice, so that few images have to be tried, and the cell's by them."""
    basis = np.array(cell, dtype=float)
    by_basis = np.eye(3, dtype=int)
    for _ in range(20):
        for i, j in itertools.permutations(range(3), 2):
            times = int(np.rint(basis[i] @ basis[j] / (basis[j] @ basis[j])))
            basis[i] -= times * basis[j]
            by_basis[:, j] += times * by_basis[:, i]
    return basis, by_basis


def in_vectors_of(cell, shifts):
    """Shifts by vectors of the basis as those by vectors of the cell."""
    _, by_basis = basis_of(cell)
    return np.rint(shifts @ np.linalg.inv(by_basis)).astype(int)


def expected_nearest(points, cell, places):
    basis, _ = basis_of(cell)
    shifts, squares = images(points, basis, places, 0.8 if len(points) > 9 else 1.5)
    place = np.arange(len(places))
    best = squares.reshape(len(places), -1).argmin(axis=1)
    row, step = np.unravel_index(best, squares.shape[1:])
    return row, in_vectors_of(cell, shifts[place, row, step]), np.sqrt(squares[place, row, step])


def expected_within(points, cell, places, radius):
    """Of each place the sorted list of rows and shifts."""
    basis, _ = basis_of(cell)
    shifts, squares = images(points, basis, places, radius)
    shifts = in_vectors_of(cell, shifts)
    found = []
    for its_shifts, its_squares in zip(shifts, squares):
        row, step = np.nonzero(its_squares <= radius * radius)
        found.append(sorted((i, *shift) for i, shift in zip(row.tolist(), its_shifts[row, step].tolist())))
    return found


def listed(found):
    pairs = [(i, *shift) for i, shift in zip(found.indices.tolist(), found.shifts.tolist())]
    return [pairs[begin:end] for begin, end in zip(found.indptr, found.indptr[1:])]


def assert_finds_images(dt):
    points, cell = dt.points, dt.cell
    found = dt.nearest(PLACES)
    rows, shifts, distances = expected_nearest(points, cell, PLACES)
    assert np.array_equal(found.rows, rows) and np.array_equal(found.shifts, shifts)
    assert found.distances == pytest.approx(distances, abs=1e-12)
    assert [array.dtype.name for array in found] == ["int32", "float64", "int32"]
    for radius in (0, 0.2, 0.9):
        found = dt.within(PLACES, radius)
        assert listed(found) == expected_within(points, cell, PLACES, radius)
        assert [array.dtype.name for array in found[:4]] == ["int32", "int32", "float64", "int32"]
        assert found.shape == (len(PLACES), len(points)) and found.shifts.shape == (len(found.indices), 3)
        first = np.repeat(np.arange(len(PLACES)), np.diff(found.indptr))
        ways = points[found.indices] + found.shifts @ cell - PLACES[first]
        assert found.distances == pytest.approx(np.linalg.norm(ways, axis=1), abs=1e-12)
        assert (found.distances <= radius + 1e-12).all()


@pytest.mark.parametrize("cell", [CELL, SHEARED, -CELL, np.diag([0.9, 1.3, 0.7])])
def test_agree_with_brute_force_while_points_move(cell):
    points = POINTS
    dt, population = PeriodicDelaunay(points, cell), PeriodicPopulation(IDS, points, cell)
    for frame in range(3):
        assert_finds_images(dt)
        assert_finds_images(population)
        points = points + RANDOM.normal(0, 0.02, points.shape) + RANDOM.integers(-2, 3, points.shape) @ cell
        cell = cell + (0, 0.01, 0.02)
        if frame == 1:  # other vectors of the same lattice
            cell = np.array([cell[0], cell[1] + cell[0], cell[2] - cell[1]])
        dt.update(points, cell)
        population.update(IDS[frame:], points[frame:], cell)


@pytest.mark.parametrize("n", [1, 2, 3, 5])
def test_of_few_points_several_images_are_found(n):
    assert_finds_images(PeriodicDelaunay(POINTS[:n], CELL))
    one = PeriodicDelaunay([(0.25, 0.5, 0.75)])
    vectors = np.array(list(itertools.product(range(-10, 11), repeat=3)))
    within = vectors[(vectors**2).sum(axis=1) <= 100]
    found = one.within((0.25, 0.5, 3.75), 10)
    assert np.array_equal(found.shifts, within + (0, 0, 3)) and not found.indices.any()
    assert found.distances == pytest.approx(np.linalg.norm(within, axis=1))
    assert len(one.within((0.25, 0.5, 3.75), np.nextafter(10, 0)).indices) == len(within) - 30


@pytest.mark.parametrize("cell", [np.diag([4.0, 4.0, 4.0]), np.array([(4.0, 0, 0), (1, 4, 0), (2, -1, 4)])])
def test_of_equally_near_images_the_smallest_is_nearest(cell):
    """By arithmetic that rounds nothing."""
    places = np.concatenate([LATTICE[::5] + 0.5, LATTICE[::7] + (0.5, 0, 0), LATTICE[::9] * 3 - (7, 7.5, 0.5),
                             LATTICE[::6] * -2])
    for dt in (PeriodicDelaunay(LATTICE, cell), PeriodicPopulation(np.arange(64)[::-1] * 7, LATTICE, cell)):
        assert dt.number_of_vertices == 64
        points = dt.points
        found = dt.nearest(places)
        shifts, squares = images(points, cell, places, 1.5)
        for place in range(len(places)):
            row, step = np.nonzero(squares[place] == squares[place].min())
            expected = min((i, *shift) for i, shift in zip(row.tolist(), shifts[place, row, step].tolist()))
            assert (found.rows[place], *found.shifts[place]) == expected
            assert found.distances[place] == np.sqrt(squares[place].min())
        for square in (0, 0.25, 0.5, 0.75, 1, 2.25):
            found = listed(dt.within(places, np.sqrt(square)))
            for place in range(len(places)):
                row, step = np.nonzero(squares[place] <= square)
                assert found[place] == sorted(
                    (i, *shift) for i, shift in zip(row.tolist(), shifts[place, row, step].tolist()))


def test_rows_are_those_of_arrays_where_ids_are_free_and_points_coincide_with_images():
    points = POINTS[:12].copy()
    points[3] = points[7] = (0.25, 0.5, 0.75)
    points[9] = points[3] + (2, -1, 4)
    dt = PeriodicDelaunay(points)
    found = dt.within(points[3], 0)
    assert listed(found) == [[(3, 0, 0, 0), (7, 0, 0, 0), (9, -2, 1, -4)]] and not found.distances.any()
    found = dt.nearest(points[9])
    assert (found.rows.tolist(), found.shifts.tolist()) == ([3], [[2, -1, 4]])
    dt.remove([3, 5])
    assert listed(dt.within(points[9], 0)) == [[(7, 2, -1, 4), (9, 0, 0, 0)]]
    assert not {3, 5} & set(dt.nearest(PLACES).rows.tolist()) and dt.within(PLACES, 0.5).shape == (80, 12)
    population = PeriodicPopulation([5, -7, 5000], [(0.1, 0.1, 0.1), (0.5, 0.5, 0.5), (0.9, 0.9, 0.9)])
    found = population.nearest([(1.08, 0.1, 0.1), (0.45, 0.5, 0.5), (0.02, 0.02, 0.02)])
    assert population.ids[found.rows].tolist() == [5, -7, 5]
    assert found.shifts.tolist() == [[1, 0, 0], [0, 0, 0], [0, 0, 0]]
    population.remove(5)
    found = population.nearest((0.02, 0.02, 0.02))
    assert population.ids[found.rows].tolist() == [5000] and found.shifts.tolist() == [[-1, -1, -1]]
    assert population.within((0, 0, 0), 0.3).shape == (1, 2)


def test_places_may_be_far_away():
    dt = PeriodicDelaunay(POINTS, CELL)
    near, far = dt.nearest(PLACES), dt.nearest(PLACES + (1000, -2000, 3000) @ CELL)
    assert np.array_equal(near.rows, far.rows) and np.array_equal(near.shifts + (1000, -2000, 3000), far.shifts)
    assert near.distances == pytest.approx(far.distances, abs=1e-9)


@pytest.mark.parametrize("kind", [PeriodicDelaunay3D, PeriodicPopulation3D])
def test_no_points_and_no_places(kind):
    empty = kind()
    found = empty.nearest(PLACES[:3])
    assert found.rows.tolist() == [-1] * 3 and np.isinf(found.distances).all() and not found.shifts.any()
    assert empty.within(PLACES[:3], 1).indptr.tolist() == [0] * 4
    for dt in (empty, PeriodicDelaunay(POINTS, CELL)):
        for places in ([], np.empty((0, 3))):
            assert [array.shape for array in dt.nearest(places)] == [(0,), (0,), (0, 3)]
            assert dt.within(places, 1).indptr.tolist() == [0]


def test_wrong_questions_are_refused():
    dt = PeriodicDelaunay(POINTS, CELL)
    for wrong, kind, text in (
        (lambda: dt.nearest(PLACES[:, :2]), errors.InputValueError, r"query points have the shape \(80, 2\): .*n, 3"),
        (lambda: dt.nearest("here"), errors.InputTypeError, "real numbers are needed"),
        (lambda: dt.within((0, 0, 0), -1), errors.InputValueError, "must be 0 or more"),
        (lambda: dt.within((0, 0, 0), np.nan), errors.InputValueError, "must be 0 or more"),
        (lambda: dt.within((0, 0), 1), errors.InputValueError, r"\(2,\)"),
        (lambda: dt.within((0, 0, 0), 1e12), errors.InputValueError, "the radius is so large, compared to the cell"),
        (lambda: dt.within((0, 0, 0), np.inf), errors.InputValueError, "the radius is so large, compared to the cell"),
        (lambda: PeriodicDelaunay(POINTS[:1]).within((0, 0, 0), 257), errors.ParameterError, "squared radius"),
    ):
        with pytest.raises(kind, match=text):
            wrong()
    for wrong, kind in ((np.nan, errors.NonFiniteCoordinateError), (2e7, errors.PeriodicRangeError)):
        for ask in (dt.nearest, lambda places: dt.within(places, 0.1)):
            with pytest.raises(kind) as refused:
                ask([(0, 0, 0), (1, 1, 1), (0.5, 0.25, wrong)])
            assert refused.value.id == 2
    assert len(dt.nearest(PLACES).rows) == 80 and dt.is_valid()


def test_threads_change_no_answer():
    points, places = RANDOM.random((2000, 3)) @ CELL, RANDOM.uniform(-3, 3, (5000, 3))
    alone, together = PeriodicDelaunay(points, CELL), PeriodicDelaunay(points, CELL, threads=0)
    for ask in (lambda dt: dt.nearest(places), lambda dt: dt.within(places, 0.1)):
        assert all(np.array_equal(a, b) for a, b in zip(ask(alone), ask(together)))
