# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Queries of many places and alpha shapes, against SciPy and brute force."""

import itertools

import numpy as np
import pytest
from scipy.interpolate import LinearNDInterpolator
from scipy.sparse import csr_array
from scipy.spatial import cKDTree

from dynamic_delaunay import AlphaClass, DynamicDelaunay, PeriodicDelaunay, PeriodicPopulation, Population, errors

RANDOM = np.random.default_rng(49)
POINTS = RANDOM.random((300, 2))
PLACES = RANDOM.uniform(-0.2, 1.2, (200, 2))
TILTED = np.array([(1.0, 0.1), (0.4, 0.9)])
SLAB = np.array([(1.0, 0.0)])
CELLS = [None, (1.0, 1.0), TILTED, SLAB]


def triangulation_in(cell, points=POINTS):
    return DynamicDelaunay(points) if cell is None else PeriodicDelaunay(points, cell)


def images(triangulation, reach=3):
    """Rows, shifts and positions of all images near the cell."""
    points = triangulation.points
    if isinstance(triangulation, (DynamicDelaunay, Population)):
        return np.arange(len(points)), np.zeros((len(points), 2), int), points
    cell = triangulation.cell
    second = range(-reach, reach + 1) if len(cell) == 2 else [0]
    shifts = np.array(list(itertools.product(range(-reach, reach + 1), second)))
    vectors = shifts[:, : len(cell)] @ cell
    rows = np.tile(np.arange(len(points)), len(shifts))
    return rows, np.repeat(shifts, len(points), axis=0), (points + vectors[:, np.newaxis]).reshape(-1, 2)


@pytest.mark.parametrize("cell", CELLS)
def test_nearest_agrees_with_a_tree(cell):
    triangulation = triangulation_in(cell)
    rows, shifts, positions = images(triangulation)
    found = triangulation.nearest(PLACES)
    distances, places = cKDTree(positions).query(PLACES)
    assert np.array_equal(found.rows, rows[places]) and np.array_equal(found.shifts, shifts[places])
    assert np.allclose(found.distances, distances, rtol=1e-12)
    assert [array.dtype.name for array in found] == ["int32", "float64", "int32"]


@pytest.mark.parametrize("cell", CELLS)
def test_within_agrees_with_brute_force(cell):
    triangulation = triangulation_in(cell)
    rows, shifts, positions = images(triangulation)
    for radius in (0, 0.03, 0.4):
        found = triangulation.within(PLACES, radius)
        assert found.indptr[0] == 0 and found.indptr[-1] == len(found.indices)
        for i, place in enumerate(PLACES):
            distances = np.hypot(*(positions - place).T)
            expected = {(rows[k], *shifts[k]) for k in np.flatnonzero(distances <= radius)}
            part = slice(found.indptr[i], found.indptr[i + 1])
            assert {(row, *shift) for row, shift in zip(found.indices[part], found.shifts[part])} == expected
            assert (np.diff(found.indices[part]) >= 0).all()
            assert (found.distances[part] <= radius * (1 + 1e-15)).all()


def test_lists_within_a_radius_are_a_sparse_matrix():
    found = DynamicDelaunay(POINTS).within(POINTS, 0.1)
    matrix = csr_array((found.distances, found.indices, found.indptr), found.shape).toarray()
    expected = np.hypot(*(POINTS[:, np.newaxis] - POINTS).transpose(2, 0, 1))
    assert np.allclose(matrix, np.where(expected <= 0.1, expected, 0))
    assert (found.indices[found.distances == 0] == np.arange(300)).all()  # each finds itself


def test_points_on_the_circle_are_within_the_radius():
    for radius in (*RANDOM.random(500), 0.1, 0.3, 1e-170, 5e-324, 1e100):
        assert len(DynamicDelaunay([(radius, 0.0)]).within((0, 0), radius).indices) == 1, radius
        assert len(DynamicDelaunay([(radius, 0.0)]).within((0, 0), radius * (1 - 1e-15)).indices) <= (radius < 1e-160)


def test_all_points_are_within_an_infinite_radius_of_the_plane():
    assert np.array_equal(DynamicDelaunay(POINTS).within(PLACES[:2], np.inf).indices, [*range(300)] * 2)


@pytest.mark.parametrize("cell", [(1.0, 1.0), SLAB])
def test_a_radius_with_too_many_images_is_refused_before_they_are_found(cell):
    for radius in (1e12, 1e300, np.inf):
        with pytest.raises(errors.InputValueError, match="the radius is so large, compared to the cell"):
            triangulation_in(cell).within((0, 0), radius)


def test_of_equally_near_points_the_smallest_row_is_nearest():
    grid = np.array(list(itertools.product(range(6), range(5))), float)
    population = Population(np.arange(30)[::-1] * 7, grid)
    for place in grid[grid.max(axis=1) < 4] + 0.5:
        distances = np.hypot(*(population.points - place).T)
        found = population.nearest(place)
        assert found.rows[0] == np.flatnonzero(distances == distances.min())[0]
        assert len(population.within(place, np.sqrt(0.5)).indices) == 4
    torus = PeriodicDelaunay(grid, (6, 5))
    assert torus.nearest((0.5, 0.5)).rows.tolist() == [0]
    assert torus.nearest((5.5, 4.5)).rows.tolist() == [0]
    assert torus.nearest((5.5, 4.5)).shifts.tolist() == [[1, 1]]


def test_rows_are_those_of_arrays_where_ids_are_free_and_points_coincide():
    dt = DynamicDelaunay([*POINTS[:10], POINTS[3]])
    dt.remove([0, 5])
    assert dt.nearest(POINTS[3]).rows.tolist() == [3]
    assert dt.within(POINTS[3], 0).indices.tolist() == [3, 10]
    assert 5 not in dt.nearest(PLACES).rows
    assert dt.within(PLACES, 1).shape == (200, 11)
    population = PeriodicPopulation([5, -7, 5000], [(0.1, 0.1), (0.5, 0.5), (0.9, 0.9)])
    found = population.nearest([(1.08, 0.1), (0.45, 0.5), (0.05, 0.05)])
    assert population.ids[found.rows].tolist() == [5, -7, 5]
    population.remove(5)
    assert population.interpolation_weights(PLACES).shape == (200, 2)
    assert population.ids[population.nearest((0.1, 0.1)).rows].tolist() == [5000]


@pytest.mark.parametrize("kind", [DynamicDelaunay, PeriodicDelaunay, Population, PeriodicPopulation])
def test_no_points_and_no_places(kind):
    empty = kind()
    found = empty.nearest(PLACES[:3])
    assert found.rows.tolist() == [-1] * 3 and np.isinf(found.distances).all() and not found.shifts.any()
    assert empty.within(PLACES[:3], 1).indptr.tolist() == [0] * 4
    for method in ("natural", "linear"):
        assert empty.interpolation_weights(PLACES[:3], method).indptr.tolist() == [0] * 4
        assert np.isnan(empty.interpolation_weights(PLACES[:3], method).interpolate([])).all()
    assert [array.tolist() for array in empty.alpha_shape(1)] == [[], [], []]
    for places in ([], np.empty((0, 2))):
        assert [len(array) for array in empty.nearest(places)] == [0, 0, 0]
        assert empty.within(places, 1).indptr.tolist() == [0]
        assert empty.interpolation_weights(places).interpolate([]).tolist() == []


def test_linear_weights_agree_with_scipy():
    values = RANDOM.random((300, 3))
    dt = DynamicDelaunay(POINTS)
    weights = dt.interpolation_weights(PLACES, "linear")
    expected = LinearNDInterpolator(POINTS, values)(PLACES)
    assert np.isnan(expected).any() and not np.isnan(expected).all()
    assert np.allclose(weights.interpolate(values), expected, atol=1e-9, equal_nan=True)
    assert np.allclose(weights.interpolate(values[:, 0]), expected[:, 0], atol=1e-9, equal_nan=True)
    matrix = csr_array((weights.weights, weights.indices, weights.indptr), weights.shape)
    inside = dt.find_simplex(PLACES) >= 0
    assert np.allclose((matrix @ values)[inside], expected[inside], atol=1e-9)


def test_natural_weights_are_the_shares_that_a_new_cell_takes():
    dt = DynamicDelaunay(POINTS)
    places = RANDOM.uniform(0.3, 0.7, (20, 2))
    weights = dt.interpolation_weights(places)
    for i, place in enumerate(places):
        part = slice(weights.indptr[i], weights.indptr[i + 1])
        neighbors = weights.indices[part]
        before = dt.areas[neighbors]
        (id,) = dt.insert(place)
        shares = (before - dt.areas[neighbors]) / dt.areas[id]
        dt.remove(id)
        assert np.allclose(weights.weights[part], shares, atol=1e-9) and np.isclose(shares.sum(), 1)


@pytest.mark.parametrize("cell", CELLS)
@pytest.mark.parametrize("method", ["natural", "linear"])
def test_weights_reproduce_linear_functions(cell, method):
    triangulation = triangulation_in(cell)
    weights = triangulation.interpolation_weights(PLACES, method)
    counts = np.diff(weights.indptr)
    assert (weights.weights >= 0).all()
    owners = np.repeat(np.arange(len(PLACES)), counts)
    sums = np.bincount(owners, weights.weights, len(PLACES))
    assert np.allclose(sums[counts > 0], 1, atol=1e-14)
    positions = triangulation.points[weights.indices]
    if cell is not None:
        vectors = triangulation.cell
        positions = positions + weights.shifts[:, : len(vectors)] @ vectors
    sums = np.column_stack([np.bincount(owners, weights.weights * x, len(PLACES)) for x in positions.T])
    assert np.allclose(sums[counts > 0], PLACES[counts > 0], atol=1e-11)
    assert (counts == 0).any() == (cell is None or cell is SLAB)


def test_interpolation_at_the_points_is_their_values():
    for triangulation in (DynamicDelaunay(POINTS), PeriodicDelaunay(POINTS, TILTED)):
        for method in ("natural", "linear"):
            weights = triangulation.interpolation_weights(triangulation.points, method)
            assert np.array_equal(weights.interpolate(np.arange(300)), np.arange(300))


def circumradii_squared(corners):
    a, b, c = (corners[:, i] - corners[:, j] for i, j in ((0, 1), (1, 2), (2, 0)))
    doubled = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return (a**2).sum(1) * (b**2).sum(1) * (c**2).sum(1) / (4 * doubled**2)


@pytest.mark.parametrize("cell", CELLS)
def test_alpha_shapes_agree_with_brute_force(cell):
    triangulation = triangulation_in(cell)
    triangles, edges = triangulation.triangles, triangulation.edges
    corners = triangulation.points[triangles]
    ends = triangulation.points[edges]
    if cell is not None:
        vectors = triangulation.cell
        corners = corners + triangulation.triangle_shifts[..., : len(vectors)] @ vectors
        ends[:, 1] += triangulation.edge_shifts[:, : len(vectors)] @ vectors
    middles, squares = ends.mean(axis=1), ((ends[:, 1] - ends[:, 0]) ** 2).sum(1) / 4
    nearest = triangulation.nearest(middles).distances ** 2
    for alpha in (0, 0.0005, 0.0012, 0.01, 100):
        shape = triangulation.alpha_shape(alpha)
        are_in = circumradii_squared(corners) <= alpha
        assert np.array_equal(shape.triangles == AlphaClass.INTERIOR, are_in)
        assert np.array_equal(shape.triangles == AlphaClass.EXTERIOR, ~are_in)
        some, all_in = np.zeros(300, bool), np.ones(300, bool)
        some[triangles[are_in]] = True
        all_in[triangles[~are_in]] = False
        if cell is None or cell is SLAB:  # outside there are no triangles
            lengths = dict(zip(map(tuple, triangulation.ridges[0]), triangulation.ridges[1]))
            all_in[[row for pair, length in lengths.items() if np.isinf(length) for row in pair]] = False
        expected = np.where(some, np.where(all_in, AlphaClass.INTERIOR, AlphaClass.REGULAR), AlphaClass.SINGULAR)
        assert np.array_equal(shape.points, expected)
        is_gabriel = nearest >= squares * (1 - 1e-9)
        has_face = np.isin(shape.edges, [AlphaClass.REGULAR, AlphaClass.INTERIOR])
        singular = (shape.edges == AlphaClass.SINGULAR)
        assert np.array_equal(singular, ~has_face & is_gabriel & (squares <= alpha))
        assert some[edges[has_face]].all()
        boundary = edges[shape.edges == AlphaClass.REGULAR]
        assert set(boundary.ravel()) <= set(np.flatnonzero(expected == AlphaClass.REGULAR))


def test_alpha_shapes_of_points_on_a_line_and_of_removed_ids():
    line = DynamicDelaunay([(0, 0), (1, 0), (3, 0), (3.5, 0)])
    for alpha, expected in ((0.25, [1, 0, 1]), (0.2499999, [0, 0, 1]), (1, [1, 1, 1]), (1e308, [1, 1, 1])):
        shape = line.alpha_shape(alpha)
        by_ends = {tuple(sorted(edge)): kind for edge, kind in zip(line.edges.tolist(), shape.edges)}
        assert [by_ends[pair] for pair in ((0, 1), (1, 2), (2, 3))] == expected
        assert shape.points.tolist() == [1] * 4 and shape.triangles.tolist() == []
    line.insert((0, 1))
    line.remove([0, 3])
    shape = line.alpha_shape(1e6)
    assert shape.points.tolist() == [0, AlphaClass.REGULAR, AlphaClass.REGULAR, 0, AlphaClass.REGULAR]
    assert DynamicDelaunay([(0, 0), (0, 0)]).alpha_shape(1).points.tolist() == [1, 1]


def test_alpha_shapes_decide_ties_exactly():
    grid = np.array(list(itertools.product(range(5), range(5))), float)
    for triangulation in (DynamicDelaunay(grid), PeriodicDelaunay(grid, (5, 5))):
        assert (triangulation.alpha_shape(0.5).triangles == AlphaClass.INTERIOR).all()
        assert (triangulation.alpha_shape(np.nextafter(0.5, 0)).triangles == AlphaClass.EXTERIOR).all()


@pytest.mark.parametrize(
    "wrong, kind",
    [
        (lambda dt: dt.nearest(np.zeros((3, 3))), errors.InputValueError),
        (lambda dt: dt.nearest("here"), errors.InputTypeError),
        (lambda dt: dt.nearest([(0, np.nan)]), errors.NonFiniteCoordinateError),
        (lambda dt: dt.within((0, 0), -1), errors.InputValueError),
        (lambda dt: dt.within((0, 0), np.nan), errors.InputValueError),
        (lambda dt: dt.within((0, 0), [1, 2]), errors.InputValueError),
        (lambda dt: dt.within((0, 0), "far"), errors.InputValueError),
        (lambda dt: dt.within((np.inf, 0), 1), errors.NonFiniteCoordinateError),
        (lambda dt: dt.interpolation_weights((0, 0), "cubic"), errors.InputValueError),
        (lambda dt: dt.interpolation_weights((0, 0), []), errors.InputValueError),
        (lambda dt: dt.interpolation_weights((0.5, 0.5)).interpolate([1, 2]), errors.InputValueError),
        (lambda dt: dt.interpolation_weights((0.5, 0.5)).interpolate(np.zeros(301)), errors.InputValueError),
        (lambda dt: dt.interpolation_weights((0.5, 0.5)).interpolate(3), errors.InputValueError),
        (lambda dt: dt.alpha_shape(-1), errors.InputValueError),
        (lambda dt: dt.alpha_shape(np.inf), errors.InputValueError),
        (lambda dt: dt.alpha_shape({}), errors.InputTypeError),
    ],
)
@pytest.mark.parametrize("cell", [None, (1.0, 1.0)])
def test_wrong_questions_are_refused(cell, wrong, kind):
    with pytest.raises(kind):
        wrong(triangulation_in(cell))


def test_errors_name_the_place():
    with pytest.raises(errors.NonFiniteCoordinateError) as refused:
        DynamicDelaunay(POINTS).nearest([(0, 0), (1, 1), (np.nan, 0)])
    assert refused.value.id == 2
    with pytest.raises(errors.PeriodicRangeError) as refused:
        PeriodicDelaunay(POINTS, (1, 1)).within([(0, 0), (2e6, 0)], 1)
    assert refused.value.id == 1


@pytest.mark.parametrize("cell", [None, (1.0, 1.0)])
def test_queries_need_a_certified_triangulation(cell):
    kind = DynamicDelaunay if cell is None else PeriodicDelaunay
    heuristic = kind(POINTS, classifier="point_distance:0.1")
    heuristic.update(1.001 * POINTS)
    for ask in (heuristic.nearest, heuristic.interpolation_weights, lambda places: heuristic.within(places, 1)):
        with pytest.raises(errors.UncertifiedTriangulationError):
            ask(PLACES)
    with pytest.raises(errors.UncertifiedTriangulationError):
        heuristic.alpha_shape(1)
    heuristic.mend()
    assert (heuristic.nearest(PLACES).rows >= 0).all()


def test_threads_change_no_answer():
    points, places = RANDOM.random((5000, 2)), RANDOM.random((20000, 2))
    alone, together = DynamicDelaunay(points), DynamicDelaunay(points, threads=0)
    for ask in (
        lambda dt: dt.nearest(places),
        lambda dt: dt.within(places, 0.02),
        lambda dt: dt.interpolation_weights(places),
        lambda dt: dt.alpha_shape(2e-4),
    ):
        assert all(np.array_equal(a, b) for a, b in zip(ask(alone), ask(together)))
