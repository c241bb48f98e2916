# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Bounded Voronoi cells, against what is seen from a point in many directions."""

import threading

import numpy as np
import pytest

import dynamic_delaunay
from dynamic_delaunay import DynamicDelaunay, PeriodicDelaunay, PeriodicPopulation, Population, Side, errors

SQUARE = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
PENTAGON = np.array([(-0.1, 0.2), (0.6, -0.1), (1.1, 0.3), (0.8, 1.2), (0.1, 0.9)])
POINTS = np.random.default_rng(1).random((60, 2))


def shoelace(ring):
    x, y = ring.T
    return (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2


def seen_area(point, others, radius, domain=()):
    """That of what is nearer to a point than to all others, and no farther away than the radius."""
    directions = (np.arange(20000) + 0.5) * 2 * np.pi / 20000
    ways = np.column_stack([np.cos(directions), np.sin(directions)])
    distances = np.full(len(directions), radius)
    for other in others:
        way = other - point
        along = ways @ way
        distances = np.minimum(distances, np.where(along > 0, way @ way / 2 / np.where(along > 0, along, 1), np.inf))
    for corner, next_corner in zip(domain, np.roll(domain, -1, axis=0) if len(domain) else ()):
        normal = np.array([next_corner[1] - corner[1], corner[0] - next_corner[0]])
        along = ways @ normal
        reach = (corner - point) @ normal
        distances = np.minimum(distances, np.where(along > 0, reach / np.where(along > 0, along, 1), np.inf))
    return (distances**2).sum() * np.pi / len(directions)


def test_a_point_alone_has_a_disc():
    cells = DynamicDelaunay([(2, 3)]).bounded_cells(0.5)
    assert cells.areas == pytest.approx([np.pi / 4])
    assert cells.perimeters == pytest.approx([np.pi]) and np.array_equal(cells.free_lengths, cells.perimeters)
    assert cells.centroids == pytest.approx(np.array([(2, 3)])) and np.array_equal(cells.radii, [0.5])
    assert np.array_equal(cells.pieces.sides, [Side.FREE]) and cells.pieces.angles == pytest.approx([2 * np.pi])
    assert len(cells.neighbor_list()) == 0 and np.array_equal(cells.neighbor_list().neighbor_counts, [0])


def test_two_discs_share_a_chord():
    cells = DynamicDelaunay([(0, 0), (1, 0)]).bounded_cells(1)
    half_angle = np.arccos(0.5)
    assert cells.areas == pytest.approx([np.pi - half_angle + np.sin(half_angle) / 2] * 2)
    contacts = cells.neighbor_list()
    assert np.array_equal(contacts.query_point_indices, [0, 1]) and np.array_equal(contacts.point_indices, [1, 0])
    assert contacts.weights == pytest.approx([np.sqrt(3)] * 2)
    assert np.array_equal(contacts.vectors, [(1, 0), (-1, 0)]) and np.array_equal(contacts.neighbor_counts, [1, 1])
    assert cells.free_lengths == pytest.approx(cells.perimeters - np.sqrt(3))


@pytest.mark.parametrize("domain", [None, SQUARE, PENTAGON])
@pytest.mark.parametrize("radius", [0.2, np.random.default_rng(2).uniform(0.02, 0.3, 60)])
def test_cells_are_what_is_seen_from_their_points(radius, domain):
    dt = DynamicDelaunay(POINTS * 0.7 + 0.15)
    cells = dt.bounded_cells(radius, domain)
    for row, point in enumerate(dt.points):
        its_radius = cells.radii[row]
        expected = seen_area(point, np.delete(dt.points, row, axis=0), its_radius, () if domain is None else domain)
        assert cells.areas[row] == pytest.approx(expected, rel=1e-4)
    of_rows = np.repeat(np.arange(60), np.diff(cells.pieces.indptr))
    for side, lengths in ((Side.FREE, cells.free_lengths), (Side.WALL, cells.wall_lengths)):
        chosen = cells.pieces.sides == side
        assert lengths == pytest.approx(np.bincount(of_rows[chosen], cells.pieces.lengths[chosen], 60))
    assert (cells.wall_lengths.sum() > 0) == (domain is not None)


@pytest.mark.parametrize("domain", [SQUARE, PENTAGON])
def test_cells_fill_their_domain(domain):
    cells = DynamicDelaunay(POINTS).bounded_cells(domain=domain)
    assert cells.areas.sum() == pytest.approx(shoelace(domain))
    assert cells.wall_lengths.sum() == pytest.approx(np.hypot(*(domain - np.roll(domain, 1, axis=0)).T).sum())
    assert not cells.free_lengths.any() and np.isinf(cells.radii).all()
    assert (cells.areas[:, np.newaxis] * cells.centroids).sum(axis=0) / shoelace(domain) == pytest.approx(
        centroid(domain)
    )


def centroid(ring):
    x, y = ring.T
    next_x, next_y = np.roll(ring, -1, axis=0).T
    cross = x * next_y - next_x * y
    return np.array([((x + next_x) * cross).sum(), ((y + next_y) * cross).sum()]) / 6 / shoelace(ring)


def test_a_domain_may_have_its_first_corner_again_at_its_end():
    dt = DynamicDelaunay(POINTS)
    closed = dt.bounded_cells(0.1, np.concatenate([PENTAGON, PENTAGON[:1]]))
    assert np.array_equal(closed.areas, dt.bounded_cells(0.1, PENTAGON).areas)


def test_a_point_outside_of_the_domain_has_what_is_left_of_its_cell():
    cells = DynamicDelaunay([(1.5, 0.5), (9, 9)]).bounded_cells(0.7, SQUARE)
    half_angle = np.arccos(0.5 / 0.7)
    assert cells.areas == pytest.approx([0.49 * half_angle - 0.5 * np.sqrt(0.24), 0])
    assert np.array_equal(cells.centroids[1], (9, 9)) and len(cells.rings()[1]) == 0


def test_a_population_has_a_row_for_each_point():
    ids = np.arange(60) * 7 - 100
    population = Population(ids, POINTS)
    population.remove(ids[10])
    left = np.delete(POINTS, 10, axis=0)
    radii = np.random.default_rng(2).uniform(0.05, 0.3, 59)
    ours, others = population.bounded_cells(radii, SQUARE), DynamicDelaunay(left).bounded_cells(radii, SQUARE)
    assert np.array_equal(population.ids, np.delete(ids, 10)) and np.array_equal(ours.points, left)
    for name in ("radii", "areas", "perimeters", "centroids", "free_lengths", "wall_lengths"):
        assert getattr(ours, name) == pytest.approx(getattr(others, name)), name
    assert pairs(ours) == pairs(others)
    assert np.array_equal(ours.pieces.others[ours.pieces.angles > 0], others.pieces.others[others.pieces.angles > 0])


def pairs(cells):
    contacts = cells.neighbor_list()
    return set(zip(contacts.query_point_indices.tolist(), contacts.point_indices.tolist()))


def test_rows_of_removed_ids_have_nothing_and_their_radii_mean_nothing():
    dt = DynamicDelaunay(POINTS)
    dt.remove([3, 5])
    radii = np.full(60, 0.1)
    radii[[3, 5]] = np.nan, -1
    cells = dt.bounded_cells(radii)
    assert not cells.areas[[3, 5]].any() and not np.diff(cells.pieces.indptr)[[3, 5]].any()
    left = np.delete(np.arange(60), [3, 5])
    assert cells.areas[left] == pytest.approx(DynamicDelaunay(POINTS[left]).bounded_cells(0.1).areas)


def test_points_that_coincide_share_a_cell():
    cells = DynamicDelaunay([(0, 0), (0, 0), (0, 0), (5, 0)]).bounded_cells(1)
    assert cells.areas == pytest.approx([np.pi / 3] * 3 + [np.pi])
    assert cells.perimeters == pytest.approx([2 * np.pi] * 4)
    assert sorted(map(len, cells.rings())) == [0, 0, 64, 64]


def test_nothing_has_no_cells():
    for cells in (DynamicDelaunay().bounded_cells(1), Population().bounded_cells(1, SQUARE)):
        assert cells.areas.shape == (0,) and cells.centroids.shape == cells.points.shape == (0, 2)
        assert cells.rings() == [] and cells.surface_lines() == [] and len(cells.neighbor_list()) == 0
        assert np.array_equal(cells.pieces.indptr, [0]) and np.array_equal(cells.surface.indptr, [0])


def test_cells_fill_a_torus():
    points = np.random.default_rng(3).random((50, 2)) * (2, 3)
    dt = PeriodicDelaunay(points, (2, 3))
    assert dt.bounded_cells(10).areas.sum() == pytest.approx(6)
    cells = dt.bounded_cells(0.25)
    shifts = np.array([(2 * i, 3 * j) for i in (-1, 0, 1) for j in (-1, 0, 1)])
    for row, point in enumerate(points):
        images = (points[:, np.newaxis] + shifts).reshape(-1, 2)
        images = images[np.hypot(*(images - point).T) > 0]
        assert cells.areas[row] == pytest.approx(seen_area(point, images, 0.25), rel=1e-4)
    contacts = cells.neighbor_list()
    assert (contacts.distances < 0.5).all() and (contacts.weights <= 0.5).all() and len(contacts) > 100
    population = PeriodicPopulation(np.arange(50) + 7, points, (2, 3))
    assert population.bounded_cells(0.25).areas == pytest.approx(cells.areas)


def test_a_point_touches_its_own_images():
    contacts = PeriodicDelaunay([(0.5, 0.5)], (1, 1)).bounded_cells(0.6).neighbor_list()
    assert sorted(map(tuple, contacts.vectors.tolist())) == [(-1, 0), (0, -1), (0, 1), (1, 0)]
    assert contacts.weights == pytest.approx([2 * np.sqrt(0.36 - 0.25)] * 4)


def energy_and_gradients(cells):
    areas, perimeters, free = cells.areas - 0.02, cells.perimeters - 0.6, cells.free_lengths
    energy = (areas**2 + 0.1 * perimeters**2 + 0.01 * free).sum()
    lengths = np.repeat(0.2 * perimeters, np.diff(cells.pieces.indptr))
    return energy, cells.gradients(2 * areas, lengths + 0.01 * (cells.pieces.sides == Side.FREE))


@pytest.mark.parametrize("kind, domain", [("plane", None), ("plane", SQUARE), ("population", SQUARE), ("torus", None)])
def test_gradients_are_differences_of_the_energy(kind, domain):
    make = {
        "plane": DynamicDelaunay,
        "population": lambda points: Population(np.arange(60)[::-1], points),
        "torus": lambda points: PeriodicDelaunay(points, (1.0, 1.1)),
    }[kind]
    radii = np.random.default_rng(5).uniform(0.05, 0.15, 60)

    def cells_of(points, radii):
        return make(points).bounded_cells(radii, domain)

    _, gradients = energy_and_gradients(cells_of(POINTS, radii))
    step = 1e-6
    for row in range(0, 60, 7):
        for axis in (0, 1):
            way = np.zeros((60, 2))
            way[row, axis] = step
            after, before = (energy_and_gradients(cells_of(POINTS + s * way, radii))[0] for s in (1, -1))
            assert gradients.by_positions[row, axis] == pytest.approx((after - before) / 2 / step, rel=1e-4, abs=1e-7)
        way = np.where(np.arange(60) == row, step, 0)
        after, before = (energy_and_gradients(cells_of(POINTS, radii + s * way))[0] for s in (1, -1))
        assert gradients.by_radii[row] == pytest.approx((after - before) / 2 / step, rel=1e-4, abs=1e-7)


def test_gradients_need_the_points_as_they_are():
    dt = DynamicDelaunay(POINTS)
    cells = dt.bounded_cells(0.1)
    cells.gradients(np.ones(60), np.ones(len(cells.pieces.sides)))
    with pytest.raises(errors.InputValueError, match="there are 3 weights of areas and 60 rows"):
        cells.gradients(np.ones(3), np.ones(len(cells.pieces.sides)))
    with pytest.raises(errors.InputValueError, match=r"weights of lengths .*shape \(\): it must be \(n,\)"):
        cells.gradients(np.ones(60), 1)
    with pytest.raises(errors.InputValueError, match="there are 60 weights of lengths and [0-9]+ pieces"):
        cells.gradients(np.ones(60), np.ones(60))
    dt.update(POINTS)
    with pytest.raises(errors.UseError, match="has changed"):
        cells.gradients(np.ones(60), np.ones(len(cells.pieces.sides)))


def test_rings_come_as_near_to_arcs_as_they_are_told_to():
    cells = DynamicDelaunay(POINTS).bounded_cells(np.linspace(0.05, 0.1, 60), PENTAGON)
    errors_of = []
    for segments in (16, 64, 256):
        areas = np.array([shoelace(ring) for ring in cells.rings(segments=segments)])
        assert (areas <= cells.areas * (1 + 1e-12)).all()
        errors_of.append(np.abs(areas - cells.areas).max())
    assert errors_of[1] < errors_of[0] / 10 and errors_of[2] < errors_of[1] / 10
    for tolerance in (1e-3, 1e-6):
        for row, ring in enumerate(cells.rings(tolerance=tolerance)):
            distances = np.hypot(*(ring - POINTS[row]).T)
            assert (distances <= cells.radii[row] * (1 + 1e-12)).all()
            missed = cells.areas[row] - shoelace(ring)
            assert 0 <= missed + 1e-15 and missed <= tolerance * cells.free_lengths[row] + 1e-15
    coarse, fine = (sum(map(len, cells.rings(tolerance=tolerance))) for tolerance in (1e-3, 1e-7))
    assert 20 * coarse < fine


def test_the_corners_of_an_arc_are_no_farther_from_it_than_the_tolerance():
    cells = DynamicDelaunay([(1e3, -1e3)]).bounded_cells(7)
    for tolerance in (100, 1, 1e-2, 1e-6):
        ring = cells.rings(tolerance=tolerance)[0]
        middles = (ring + np.roll(ring, -1, axis=0)) / 2 - (1e3, -1e3)
        missed = 7 - np.hypot(*middles.T).min()
        assert len(ring) >= 3 and missed <= max(tolerance, 3.6) * (1 + 1e-6)
        assert len(ring) == 3 or missed <= tolerance * (1 + 1e-6)


@pytest.mark.parametrize(
    "settings, error",
    [
        ({"segments": 2}, errors.InputValueError),
        ({"segments": 1_000_001}, errors.InputValueError),
        ({"segments": 3.5}, errors.InputTypeError),
        ({"tolerance": 0}, errors.InputValueError),
        ({"tolerance": np.nan}, errors.InputValueError),
        ({"tolerance": 1e-14}, errors.InputValueError),
        ({"tolerance": "fine"}, errors.InputTypeError),
    ],
)
def test_rings_refuse_what_makes_no_polygon(settings, error):
    cells = DynamicDelaunay(POINTS).bounded_cells(0.1)
    for make in (cells.rings, cells.surface_lines):
        with pytest.raises(error, match="must be|more than"):
            make(**settings)


def test_the_surface_surrounds_cells_and_holes():
    angles = np.arange(12) * np.pi / 6
    ring_of_points = 3 * np.column_stack([np.cos(angles), np.sin(angles)])
    cells = DynamicDelaunay(np.concatenate([ring_of_points, [(20, 0)]])).bounded_cells(1)
    surface = cells.surface
    assert surface.are_closed.all() and not surface.windings.any()
    assert surface.areas.sum() == pytest.approx(cells.areas.sum())
    hole, alone, outside = np.argsort(surface.areas)
    assert surface.areas[hole] < 0 and surface.areas[alone] == pytest.approx(np.pi)
    assert np.array_equal(surface.rows[surface.indptr[alone] : surface.indptr[alone + 1]], [12])
    assert np.array_equal(np.sort(surface.rows[surface.indptr[outside] : surface.indptr[outside + 1]]), np.arange(12))
    for line, area in zip(cells.surface_lines(segments=2000), surface.areas):
        assert shoelace(line) == pytest.approx(area, rel=1e-4)
        assert line[0] == pytest.approx(line[-1])
    inner = cells.surface_lines()[hole]
    assert (np.hypot(*inner.T) < 3).all()


def test_the_surface_goes_from_wall_to_wall():
    cells = DynamicDelaunay([(0.5, 0.0)]).bounded_cells(0.3, SQUARE)
    assert np.array_equal(cells.surface.are_closed, [0]) and np.isnan(cells.surface.areas).all()
    (line,) = cells.surface_lines()
    assert line[0] == pytest.approx((0.8, 0)) and line[-1] == pytest.approx((0.2, 0))


def test_the_surface_winds_around_a_torus():
    points = np.column_stack([np.arange(8) / 8 + 1 / 16, np.full(8, 0.5)])
    cells = PeriodicDelaunay(points, (1, 1)).bounded_cells(0.1)
    assert sorted(map(tuple, cells.surface.windings.tolist())) == [(-1, 0), (1, 0)]
    for line, winding in zip(cells.surface_lines(), cells.surface.windings):
        assert line[-1] - line[0] == pytest.approx(winding)
        assert np.hypot(*np.diff(line, axis=0).T).max() < 0.03


def test_cells_stay_as_they_are():
    dt = DynamicDelaunay(POINTS)
    cells = dt.bounded_cells(0.1)
    areas, rings = cells.areas.copy(), cells.rings()
    dt.update(POINTS[::-1] * 2)
    again = dynamic_delaunay.DynamicDelaunay(POINTS).bounded_cells(0.1)
    assert np.array_equal(cells.areas, areas) and cells.areas is cells.areas
    assert np.array_equal(cells.points, POINTS)
    assert all(np.array_equal(ring, other) for ring, other in zip(rings, again.rings()))
    for array in (cells.areas, cells.points, *cells.pieces, *cells.surface):
        assert not array.flags.writeable


@pytest.mark.parametrize(
    "corners, corner, match",
    [
        (SQUARE[::-1], 0, "left turn"),
        (SQUARE[[0, 1, 3, 2]], 2, "left turn"),
        (np.insert(SQUARE, 1, (0.5, 0), axis=0), 1, "left turn"),
        (SQUARE[:2], 2, "at least three"),
        (np.zeros((0, 2)), 0, "at least three"),
        (SQUARE + np.inf, 0, "not finite"),
    ],
)
def test_a_domain_must_be_convex(corners, corner, match):
    with pytest.raises(errors.DomainError, match=match) as refused:
        DynamicDelaunay(POINTS).bounded_cells(1, corners)
    assert refused.value.corner == corner and isinstance(refused.value, ValueError)


def test_what_cannot_be_a_radius_or_a_domain_is_refused():
    dt = DynamicDelaunay(POINTS)
    masked = np.ma.masked_array(np.ones(60), np.arange(60) == 3)
    with pytest.raises(errors.InputTypeError, match="radii are a masked array"):
        dt.bounded_cells(masked)
    for radius in (0, -1, np.nan, np.inf, 1e200):
        with pytest.raises(errors.ParameterError, match="the radius is") as refused:
            dt.bounded_cells(radius)
        assert np.array_equal(refused.value.value, radius, equal_nan=True)
    with pytest.raises(errors.ParameterError):
        dt.bounded_cells()
    with pytest.raises(errors.ParameterError):
        dt.bounded_cells(np.where(np.arange(60) == 7, -1, 1))
    with pytest.raises(errors.InputValueError, match="there are 59 radii and 60 rows: there must be as many"):
        dt.bounded_cells(np.ones(59))
    with pytest.raises(errors.InputValueError, match=r"radii have the shape \(60, 1\)"):
        dt.bounded_cells(np.ones((60, 1)))
    with pytest.raises(errors.InputValueError):
        dt.bounded_cells("large")
    with pytest.raises(errors.InputValueError, match=r"corners of a domain have the shape \(4,\)"):
        dt.bounded_cells(1, (0, 0, 1, 1))
    with pytest.raises(errors.DomainError, match="periodic"):
        PeriodicDelaunay(POINTS).bounded_cells(1, SQUARE)


def test_cells_need_an_exact_triangulation():
    dt = DynamicDelaunay(POINTS, classifier="random:0")
    dt.update(POINTS[::-1])
    with pytest.raises(errors.UncertifiedTriangulationError):
        dt.bounded_cells(0.1)
    dt.mend()
    assert dt.bounded_cells(0.1).areas.shape == (60,)


@pytest.mark.parametrize("factor", [1e-100, 1e100])
def test_cells_may_be_tiny_and_huge(factor):
    cells = DynamicDelaunay(POINTS * factor).bounded_cells(0.1 * factor, SQUARE * factor)
    expected = DynamicDelaunay(POINTS).bounded_cells(0.1, SQUARE)
    assert cells.areas / factor**2 == pytest.approx(expected.areas)
    assert cells.free_lengths / factor == pytest.approx(expected.free_lengths, abs=1e-12)
    assert [len(ring) for ring in cells.rings()] == [len(ring) for ring in expected.rings()]


def test_cells_are_of_one_moment_while_another_thread_moves_the_points():
    dt = DynamicDelaunay(POINTS, threads=2)
    is_over = threading.Event()

    def move():
        scale = 1.0
        while not is_over.is_set():
            scale = 1.1 if scale == 1.0 else 1.0
            dt.update((POINTS - 0.5) * 0.8 * scale + 0.5)

    mover = threading.Thread(target=move)
    mover.start()
    try:
        for _ in range(200):
            cells = dt.bounded_cells(domain=SQUARE)
            assert cells.areas.sum() == pytest.approx(1)
            assert len({len(cells.areas), len(cells.points), len(cells.pieces.indptr) - 1}) == 1
    finally:
        is_over.set()
        mover.join()
