# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Bounded Voronoi cells, against what is seen from a point in many directions."""

import copy
import inspect
import pickle
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


NOTCHED = [(0, 0), (1, 0), (1, 1), (0.5, 0.999), (0, 1)]  # the square, almost, but not convex


@pytest.mark.parametrize("domain", [SQUARE, NOTCHED])
def test_a_point_outside_of_the_domain_has_what_is_left_of_its_cell_or_nothing_by_the_rule(domain):
    dt = DynamicDelaunay([(1.5, 0.5), (9, 9), (1.0, 0.5), (0.1, 0.5)])
    dt.remove([2])
    half_angle = np.arccos(0.5 / 0.7)
    segment = 0.49 * half_angle - 0.5 * np.sqrt(0.24)
    for rule, its_area in (("whole", segment), ("connected", 0), ("visible", 0)):
        cells = dt.bounded_cells([0.7, 0.7, np.nan, 0.05], domain, rule)
        assert cells.areas == pytest.approx([its_area, 0, 0, 0.0025 * np.pi])
        assert np.array_equal(cells.centroids[1], (9, 9)) and cells.polygons()[1] == []
        assert len(cells.polygons()[0]) == (rule == "whole")
        assert np.array_equal(cells.are_inside, [False, False, False, True]) and not cells.are_inside.flags.writeable
    assert DynamicDelaunay([(1, 0.5), (np.nextafter(1, 2), 0.5)]).bounded_cells(1, domain).are_inside.tolist() == [
        True,
        False,
    ]


def test_without_a_domain_all_points_are_inside():
    for dt in (DynamicDelaunay(POINTS), PeriodicDelaunay(POINTS, (1, 1))):
        assert dt.bounded_cells(0.1).are_inside.all()


# Three rooms beside each other, over a corridor, and a pillar in the first one.
ROOMS = np.array(
    [(0, 0), (12, 0), (12, 10), (9, 10), (9, 2), (8, 2), (8, 10), (5, 10), (5, 2), (4, 2), (4, 10), (0, 10)]
)
PILLAR = np.array([(1, 6), (2, 6), (2, 7), (1, 7)])
AREA = 12 * 10 - 2 * 8 - 1
RULES = ("whole", "connected", "visible")


def polygon_area(polygon):
    boundary, holes = polygon
    assert shoelace(boundary) > 0 and all(shoelace(hole) < 0 for hole in holes)
    return shoelace(boundary) + sum(map(shoelace, holes))


class Shown:
    """Has GeoJSON, as polygons of shapely have."""

    def __init__(self, geometry):
        self.__geo_interface__ = geometry


def geojson(*rings):
    closed = tuple(tuple(map(tuple, np.concatenate([ring, ring[:1]]).tolist())) for ring in rings)
    return {"type": "Polygon", "coordinates": closed}


def in_rooms(count, seed=1):
    random = np.random.default_rng(seed)
    points = random.random((4 * count, 2)) * (12, 10)
    x, y = points.T
    is_in_wall = (y > 2) & (((x > 4) & (x < 5)) | ((x > 8) & (x < 9)))
    is_in_pillar = (x > 1) & (x < 2) & (y > 6) & (y < 7)
    return points[~is_in_wall & ~is_in_pillar][:count]


@pytest.mark.parametrize(
    "domain",
    [
        [ROOMS, PILLAR],
        (ROOMS[::-1].tolist(), PILLAR[::-1].tolist()),
        [np.concatenate([ROOMS, ROOMS[:1]]), PILLAR],
        Shown(geojson(ROOMS, PILLAR)),
        geojson(np.column_stack([ROOMS, np.ones(12)]), np.column_stack([PILLAR, np.ones(4)])),
        geojson(ROOMS, PILLAR),
        Shown({"type": "Feature", "properties": {}, "geometry": geojson(ROOMS, PILLAR)}),
        {"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": geojson(ROOMS, PILLAR)}]},
    ],
)
def test_a_domain_is_any_simple_polygon_with_holes(domain):
    points = in_rooms(100)
    whole, connected, visible = (DynamicDelaunay(points).bounded_cells(domain=domain, rule=rule) for rule in RULES)
    assert whole.areas.sum() == pytest.approx(AREA)
    assert whole.wall_lengths.sum() == pytest.approx(4 + np.hypot(*(ROOMS - np.roll(ROOMS, 1, axis=0)).T).sum())
    assert (connected.areas <= whole.areas * (1 + 1e-12)).all()
    assert (visible.areas <= connected.areas * (1 + 1e-12)).all()
    assert visible.areas.sum() < connected.areas.sum() < whole.areas.sum()
    assert whole.are_inside.all()
    for cells in (whole, connected, visible):
        for row, polygons in enumerate(cells.polygons()):
            assert sum(map(polygon_area, polygons)) == pytest.approx(cells.areas[row])
            assert cells is whole or len(polygons) == 1


def test_a_cell_has_the_rooms_that_its_rule_gives_it():
    dt = DynamicDelaunay([(6.5, 9), (6.5, 1)])
    whole, connected, visible = (dt.bounded_cells(domain=ROOMS, rule=rule) for rule in RULES)
    assert whole.areas == pytest.approx([4 * 5 + 15 + 15, 12 * 5 - 2 * 3]) and len(whole.polygons()[0]) == 3
    assert connected.areas == pytest.approx([15, 12 * 5 - 2 * 3]) and len(connected.polygons()[0]) == 1
    assert visible.areas[0] == pytest.approx(15) and visible.areas[1] < connected.areas[1]
    assert np.array_equal(whole.neighbor_list().point_indices, [1, 1, 1, 0, 0, 0])
    assert visible.free_lengths[1] > 1 and visible.polygons()[1][0][1] == []


def test_a_cell_goes_around_a_pillar():
    cells = DynamicDelaunay([(1.5, 7.5)]).bounded_cells(domain=[ROOMS, PILLAR], rule="connected")
    ((boundary, (hole,)),) = cells.polygons()[0]
    assert shoelace(boundary) + shoelace(hole) == pytest.approx(AREA) == pytest.approx(cells.areas[0])
    assert hole[np.lexsort(hole.round(6).T)] == pytest.approx(PILLAR[np.lexsort(PILLAR.T)])
    walls = cells.pieces.others[cells.pieces.sides == Side.WALL]
    assert sorted(walls.tolist()) == list(range(16))


def test_points_in_rooms_have_radii_and_ids_and_share_cells():
    points = in_rooms(60)
    radii = np.random.default_rng(2).uniform(0.2, 3, 60)
    twice = np.concatenate([points, points[:1]])
    population = Population(np.arange(61) * 5, twice, threads=2)
    cells = population.bounded_cells(np.append(radii, radii[0]), [ROOMS, PILLAR], "visible")
    alone = DynamicDelaunay(points).bounded_cells(radii, [ROOMS, PILLAR], "visible")
    areas = alone.areas.copy()
    areas[0] /= 2
    assert cells.areas == pytest.approx(np.append(areas, areas[0]))
    assert (cells.areas <= np.pi * cells.radii**2 * (1 + 1e-12)).all() and cells.free_lengths.sum() > 1
    for polygons, area in zip(alone.polygons(tolerance=1e-9), alone.areas):
        assert sum(map(polygon_area, polygons)) == pytest.approx(area, rel=1e-6)


def test_polygons_are_made_for_shapely():
    geometry = pytest.importorskip("shapely.geometry")
    room = geometry.Polygon(ROOMS, [PILLAR])
    points = in_rooms(40)
    cells = DynamicDelaunay(points).bounded_cells(2, room)
    for row, polygons in enumerate(cells.polygons(tolerance=1e-9)):
        cell = geometry.MultiPolygon(polygons)
        assert cell.is_valid and cell.area == pytest.approx(cells.areas[row], rel=1e-6)
        assert cell.difference(room).area < 1e-9
    assert DynamicDelaunay(points).bounded_cells(domain=geometry.box(0, 0, 12, 10)).areas.sum() == pytest.approx(120)


def test_walls_are_numbered_as_they_are_given_whichever_way_they_turn():
    dt = DynamicDelaunay([(0.5, 0.5)])
    for ring in (PENTAGON, PENTAGON[::-1], ROOMS, ROOMS[::-1]):
        pieces = dt.bounded_cells(domain=ring).pieces
        walls = pieces.sides == Side.WALL
        assert walls.sum() == len(ring)
        for wall, ends in zip(pieces.others[walls], np.stack([pieces.starts, pieces.ends], axis=1)[walls]):
            its_ends = np.array([ring[wall], ring[(wall + 1) % len(ring)]])
            assert ends == pytest.approx(its_ends) or ends == pytest.approx(its_ends[::-1])


def test_only_cells_without_walls_that_divide_have_one_ring_each_and_a_surface_and_gradients():
    dt = DynamicDelaunay(in_rooms(10))
    square = SQUARE * 12
    for cells in (dt.bounded_cells(1), dt.bounded_cells(1, square), dt.bounded_cells(1, square[::-1])):
        assert [len(cell) for cell in cells.polygons()] == [1] * 10
        assert all(np.array_equal(cell[0][0], ring) for cell, ring in zip(cells.polygons(), cells.rings()))
        assert len(cells.surface.areas) and len(cells.gradients(np.ones(10), np.ones(len(cells.pieces.sides)))[0]) == 10
    for domain, rule in ((ROOMS, "whole"), (square, "visible"), ([square, PILLAR], "whole")):
        cells = dt.bounded_cells(1, domain, rule)
        with pytest.raises(errors.UseError, match="polygons"):
            cells.rings()
        with pytest.raises(errors.UseError, match="no surface"):
            cells.surface
        with pytest.raises(errors.UseError, match="no gradients"):
            cells.gradients(np.ones(10), np.ones(len(cells.pieces.sides)))


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
    assert DynamicDelaunay().bounded_cells(1, ROOMS).polygons() == []
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
        (SQUARE[[0, 1, 3, 2]], 3, "crosses"),
        (SQUARE[[0, 1, 1, 2]], 2, "where corner 1 is"),
        (SQUARE[:2], 0, "at least three"),
        (np.zeros((0, 2)), 0, "at least three"),
        (SQUARE + np.inf, 0, "not finite"),
        ([SQUARE, SQUARE * np.nan], 4, "not finite"),
        ([SQUARE, SQUARE * 0.5 + 0.7], 4, "crosses"),
        ([SQUARE, SQUARE + 3], 4, "inside of the outer boundary"),
        ([SQUARE, np.zeros((0, 2))], 4, "at least three"),
    ],
)
def test_a_domain_must_be_a_simple_polygon_with_holes(corners, corner, match):
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
    for domain in (SQUARE, ROOMS):
        with pytest.raises(errors.DomainError, match="periodic"):
            PeriodicDelaunay(POINTS).bounded_cells(1, domain)
    for domain in (
        {"type": "MultiPolygon", "coordinates": [[SQUARE]]},
        {"type": "Polygon", "coordinates": []},
        {"type": "Polygon", "coordinates": 5},
        {"type": "Feature", "geometry": None},
        {"type": "Feature"},
        {"type": "FeatureCollection", "features": []},
        {"type": "FeatureCollection"},
        {},
    ):
        with pytest.raises(errors.InputValueError, match="must be a 'Polygon'"):
            dt.bounded_cells(1, Shown(domain))
    for places in ([1, 2], [[1, 2]], [[[0, 0], [1, 0], 5]], [[[0, 0], [1, 0], [1]]]):
        with pytest.raises((errors.InputTypeError, errors.InputValueError), match="corners of a domain"):
            dt.bounded_cells(1, {"type": "Polygon", "coordinates": places})
    with pytest.raises(errors.InputValueError, match="rule is 'seen', allowed are whole, connected and visible"):
        dt.bounded_cells(1, SQUARE, "seen")


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


ROOM_WITH_A_PILLAR = [SQUARE, [(0.4, 0.4), (0.6, 0.4), (0.6, 0.6), (0.4, 0.6)]]


@pytest.mark.parametrize(
    "cells",
    [
        DynamicDelaunay(POINTS).bounded_cells(0.1),
        DynamicDelaunay(POINTS).bounded_cells(0.1, PENTAGON),
        DynamicDelaunay(POINTS).bounded_cells(0.3, ROOM_WITH_A_PILLAR),
        DynamicDelaunay(POINTS).bounded_cells(0.3, SQUARE, rule="visible"),
        PeriodicDelaunay(POINTS, (1, 1)).bounded_cells(0.05),
        DynamicDelaunay().bounded_cells(1),
    ],
)
def test_cells_can_be_pickled_and_copied(cells):
    sent = pickle.loads(pickle.dumps(cells))
    sent = pickle.loads(pickle.dumps(sent, protocol=2))
    for name, value in inspect.getmembers(cells, lambda value: isinstance(value, (np.ndarray, tuple))):
        if name.startswith("_"):
            continue
        arrays, expected = (v if isinstance(v, tuple) else (v,) for v in (getattr(sent, name), value))
        for array, original in zip(arrays, expected):
            assert array is None or np.array_equal(array, original, equal_nan=original.dtype.kind == "f"), name
            assert array is None or not array.flags.writeable
    assert np.array_equal(sent.neighbor_list().vectors, cells.neighbor_list().vectors)
    assert all(map(np.array_equal, flattened(sent.polygons()), flattened(cells.polygons())))
    assert hasattr(sent, "surface") == hasattr(cells, "surface")
    if hasattr(cells, "surface"):
        assert all(map(np.array_equal, sent.surface_lines(), cells.surface_lines()))
        assert all(map(np.array_equal, sent.rings(), cells.rings()))
        with pytest.raises(errors.UseError, match="these cells were pickled, without the triangulation"):
            sent.gradients(np.ones(len(sent.areas)), np.ones(len(sent.pieces.sides)))
    for copied in (copy.copy(cells), copy.deepcopy({"cells": cells})["cells"]):
        assert np.array_equal(copied.areas, cells.areas)


def flattened(polygons):
    return [ring for components in polygons for outer, holes in components for ring in (outer, *holes)]


def test_copied_cells_have_gradients():
    dt = DynamicDelaunay(POINTS)
    cells = copy.deepcopy(dt.bounded_cells(0.1))
    assert np.isfinite(cells.gradients(np.ones(60), np.ones(len(cells.pieces.sides))).by_positions).all()


def test_says_what_bounds_cells():
    with pytest.raises(errors.ParameterError, match="cells need an end. Give a radius, .* a domain"):
        DynamicDelaunay(POINTS).bounded_cells()
    with pytest.raises(errors.ParameterError, match="cells need an end. Give a finite radius") as refused:
        PeriodicDelaunay(POINTS, (1, 1)).bounded_cells()
    assert refused.value.value == np.inf
