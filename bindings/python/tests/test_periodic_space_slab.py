# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Slabs in space, periodic along two vectors and open across them, against SciPy's triangulation of copies."""

import copy
import itertools
import pickle

import numpy as np
import pytest
from scipy.spatial import ConvexHull, Delaunay, Voronoi

from dynamic_delaunay import (
    PeriodicDelaunay,
    PeriodicDelaunay3D,
    PeriodicPopulation,
    PeriodicPopulation3D,
    errors,
    read_recording,
    track,
)

CELL = np.array([(1.0, 0.1, 0.0), (0.3, 0.9, 0.0)])
LEANING = np.array([(1.0, 0.1, 0.2), (0.3, 0.9, -0.4)])
SHIFTS = np.array(sorted(itertools.product((-2, -1, 0, 1, 2), (-2, -1, 0, 1, 2), (0,)), key=lambda s: s != (0, 0, 0)))


def upright(cell):
    """The vectors of the slab, and a third one across them."""
    return np.vstack([cell, np.cross(*cell)])


def cloud(n, cell=CELL, seed=1):
    return np.random.default_rng(seed).random((n, 3)) @ upright(cell)


def between_walls(seed=1):
    """30 points on either wall, and 60 between them."""
    points = cloud(120, seed=seed)
    points[:30, 2], points[30:60, 2] = 0, 1
    return points


def copies(points, cell=CELL):
    return np.concatenate([points + shift @ upright(cell) for shift in SHIFTS])


def images_by_scipy(points, cell):
    """Edges as (i, j, shift) of the middle one of 25 copies, of points that are in the cell."""
    indptr, indices = Delaunay(copies(points, cell)).vertex_neighbor_vertices
    n = len(points)
    return {(i, j % n, tuple(SHIFTS[j // n].tolist())) for i in range(n) for j in indices[indptr[i] : indptr[i + 1]]}


def images(edges, shifts):
    found = set()
    for (i, j), shift in zip(edges.tolist(), shifts.tolist()):
        found |= {(i, j, tuple(shift)), (j, i, tuple(-number for number in shift))}
    return found


def edges_of(dt):
    return images(dt.edges, dt.edge_shifts)


def assert_fits_together(dt):
    """Whether simplices fill the layer of the points, and edges, lists and Voronoi cells are those of the simplices."""
    cell, points = upright(dt.cell), dt.points
    normal = np.cross(*dt.cell)
    heights = points @ normal / np.linalg.norm(normal)
    corners = points[dt.simplices] + dt.simplex_shifts @ cell
    a, b, c, d = corners.transpose(1, 0, 2)
    volumes = np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) / 6
    assert (volumes > -1e-12).all()
    assert volumes.sum() == pytest.approx(np.linalg.norm(normal) * np.ptp(heights), abs=1e-12)
    assert dt.volumes() == pytest.approx(volumes, abs=1e-12)
    lists, cells = dt.neighbor_lists(), dt.voronoi_cells()
    for shifts in (dt.simplex_shifts, dt.edge_shifts, lists.shifts, cells.shifts, dt.neighbor_list().vectors * 0):
        assert not shifts[..., 2].any()
    first = np.repeat(np.arange(len(points)), np.diff(lists.indptr))
    assert lists.vectors == pytest.approx(points[lists.indices] + lists.shifts @ cell - points[first], abs=1e-12)
    found = {(i, j, tuple(s)) for i, j, s in zip(first.tolist(), lists.indices.tolist(), lists.shifts.tolist())}
    assert len(dt.duplicates) or found == edges_of(dt)
    first = np.repeat(np.arange(len(points)), np.diff(cells.indptr))
    assert cells.vectors == pytest.approx(points[cells.neighbors] + cells.shifts @ cell - points[first], abs=1e-12)
    at_hull = np.isclose(heights, heights.max(), atol=1e-12) | np.isclose(heights, heights.min(), atol=1e-12)
    assert np.array_equal(np.isinf(cells.volumes), at_hull) and np.array_equal(np.isinf(cells.surface_areas), at_hull)
    assert np.array_equal(cells.centroids[at_hull], points[at_hull]) and np.isfinite(cells.centroids).all()
    if not len(dt.duplicates):  # a cell consists of a pyramid for each facet
        pyramids = np.bincount(first, cells.facet_areas * np.linalg.norm(cells.vectors, axis=1) / 6, len(points))
        assert pyramids[~at_hull] == pytest.approx(cells.volumes[~at_hull])
    assert dt.is_valid() and dt.is_certified


def test_agrees_with_scipys_of_copies():
    random = np.random.default_rng(1)
    cell, points = CELL, between_walls()
    dt = PeriodicDelaunay(points, cell)
    assert type(dt) is PeriodicDelaunay3D and np.array_equal(dt.cell, CELL)
    for frame in range(8):
        shifts = -np.floor(points @ np.linalg.inv(upright(cell))).astype(int) * (1, 1, 0)
        inside = points + shifts @ upright(cell)
        found = {(i, j, tuple((np.array(s) - shifts[j] + shifts[i]).tolist())) for i, j, s in edges_of(dt)}
        assert found == images_by_scipy(inside, cell)
        assert_fits_together(dt)
        cell = cell + (0.01, 0.02, 0)
        if frame == 4:  # other vectors of the same lattice
            cell = np.array([cell[0], cell[1] - cell[0]])
        points = points + random.normal(0, 0.02, points.shape) * (1, 1, 0)
        points[60:, 2] = np.clip(points[60:, 2] + random.normal(0, 0.02, 60), 0.01, 0.99)
        assert dt.update(points, cell).certified
    assert np.array_equal(dt.cell, cell) and np.array_equal(dt.points, points)


def test_has_the_voronoi_cells_of_copies():
    points = between_walls()
    voronoi = Voronoi(copies(points))
    cells = PeriodicDelaunay(points, CELL).voronoi_cells()
    hulls = [ConvexHull(voronoi.vertices[voronoi.regions[region]]) for region in voronoi.point_region[60:120]]
    assert cells.volumes[60:] == pytest.approx([hull.volume for hull in hulls])
    assert cells.surface_areas[60:] == pytest.approx([hull.area for hull in hulls])
    assert np.isinf(cells.volumes[:60]).all()


def test_may_lean():
    """The slab may be turned to any side, and be given by any vectors."""
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    points = cloud(60)
    dt, turned = PeriodicDelaunay(points, CELL), PeriodicDelaunay(points @ turn, CELL @ turn)
    assert edges_of(turned) == edges_of(dt)
    assert_fits_together(turned)
    assert_fits_together(PeriodicDelaunay(cloud(60, LEANING), LEANING))
    swapped = {(i, j, (b, a, c)) for i, j, (a, b, c) in edges_of(PeriodicDelaunay(points, CELL[::-1]))}
    assert swapped == edges_of(dt)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 9])
def test_takes_few_points(n):
    dt = PeriodicDelaunay(cloud(n), CELL)
    assert_fits_together(dt)
    dt.update(cloud(n, seed=2), 2 * CELL)
    assert_fits_together(dt)


def test_a_layer_has_no_simplices():
    lattice = np.array([(i, j, 3) for i in range(4) for j in range(4)], dtype=float)
    dt = PeriodicDelaunay(lattice, [(4, 0, 0), (0, 4, 0)])
    assert dt.simplices.shape == (0, 4) and len(dt.volumes()) == 0 and len(dt.edges) == 48
    cells = dt.voronoi_cells()
    assert (np.diff(cells.indptr) == 4).all() and np.isinf(cells.volumes).all() and np.isinf(cells.facet_areas).all()
    random = np.random.default_rng(1)
    dt.update(lattice + random.normal(0, 0.1, lattice.shape))
    assert len(dt.simplices)
    assert_fits_together(dt)
    dt.update(lattice)
    assert len(dt.simplices) == 0 and dt.is_valid()


def test_is_chosen_by_shapes():
    points = cloud(10)
    for triangulation in (PeriodicDelaunay(points, CELL), PeriodicDelaunay(points.tolist(), CELL.tolist()),
                          PeriodicDelaunay(cell=CELL), PeriodicDelaunay3D(points, cell=CELL)):
        assert type(triangulation) is PeriodicDelaunay3D and np.array_equal(triangulation.cell, CELL)
    for population in (PeriodicPopulation(range(10), points, CELL), PeriodicPopulation(cell=CELL)):
        assert type(population) is PeriodicPopulation3D and np.array_equal(population.cell, CELL)
    assert len(PeriodicDelaunay(cell=CELL)) == 0 and len(PeriodicDelaunay(cell=CELL).simplices) == 0


@pytest.mark.parametrize("cell", [np.ones((2, 3)), np.zeros((2, 3)), [(1, 0, 0)], np.ones((2, 3, 1)), (1, 1, 1),
                                  [(1, 2, 3), (-2, -4, -6)], [(1, 0, 0), (0, np.nan, 1)], [(1, 0, 0), (0, np.inf, 1)],
                                  np.eye(3)])
def test_a_slab_stays_one(cell):
    points = cloud(10)
    dt, population = PeriodicDelaunay(points, CELL), PeriodicPopulation(range(10), points, CELL)
    with pytest.raises(errors.PeriodicCellError):
        dt.update(points * 2, cell)
    with pytest.raises(errors.PeriodicCellError):
        population.update(range(10), points * 2, cell)
    for unchanged in (dt, population):
        assert np.array_equal(unchanged.cell, CELL) and np.array_equal(unchanged.points, points)
    with pytest.raises(errors.PeriodicCellError):
        PeriodicDelaunay(points, np.eye(3)).update(points, CELL)


def test_messages_name_the_shapes_and_vectors():
    with pytest.raises(errors.PeriodicCellError, match=r"has the shape \(4, 3\): .*, \(2, 3\) for those of a slab, or"):
        PeriodicDelaunay(cloud(10), np.ones((4, 3)))
    with pytest.raises(errors.PeriodicCellError, match=r"slab has the vectors \(1, 2, 3\) and \(2, 4, 6\): .*parallel"):
        PeriodicDelaunay(cloud(10), [(1, 2, 3), (2, 4, 6)])


def test_points_come_move_and_go():
    dt = PeriodicDelaunay(cloud(30), CELL)
    assert dt.insert(cloud(5, seed=2)).tolist() == [30, 31, 32, 33, 34]
    dt.insert([(0, 0, 7), (0, 0, -7)])  # above and below all others
    assert np.flatnonzero(np.isinf(dt.voronoi_cells().volumes)).tolist() == [35, 36]
    dt.remove([3, 31, 35])
    assert dt.move(7, dt.points[7] + (5, 5, 0.3)).certified and dt.is_valid()
    dt.insert((0.1, 0.1, 0.1))
    dt.remove(dt.ids[1:])
    assert len(dt) == 1 and len(dt.simplices) == 0 and len(dt.edges) == 3 and dt.is_valid()
    dt.remove(0)
    assert len(dt) == 0 and len(dt.edges) == 0


def test_points_coincide_with_images():
    points = cloud(20)
    points[3] = (0.25, 0.5, 0.75)
    points[7] = points[3] + (2, -1, 0)
    dt = PeriodicDelaunay(points, [(1, 0, 0), (0, 1, 0)])
    assert dt.duplicates.tolist() == [[7, 3]] and dt.number_of_vertices == 19
    lists = dt.neighbor_lists()
    assert dt.neighbors_of(7).tolist() == [3] and lists.shifts[lists.indptr[7]].tolist() == [2, -1, 0]
    assert_fits_together(dt)
    dt.move(7, points[3] + (2, -1, 1))  # across the slab it is another place
    assert len(dt.duplicates) == 0 and dt.is_valid()


def test_population_follows_ids():
    random = np.random.default_rng(1)
    cell, places = CELL, cloud(60)
    population = PeriodicPopulation(cell=cell)
    for size in (60, 50, 55, 3, 60, 1, 0, 20, 60, 60, 58, 59):
        ids = random.permutation(60)[:size]
        cell = cell + (0.01, 0, 0.01)
        places = places + random.normal(0, 0.01, places.shape)
        assert population.update(ids + 10**12, places[ids], cell).certified
        assert np.array_equal(population.points, places[population.ids - 10**12])
        fresh = PeriodicDelaunay(population.points, cell)
        assert edges_of(population) == edges_of(fresh)
        assert population.voronoi_cells().volumes == pytest.approx(fresh.voronoi_cells().volumes)


def test_is_copied_pickled_and_saved(tmp_path):
    points = cloud(20)
    for dt in (PeriodicDelaunay(points, CELL, changes=True), PeriodicPopulation(range(20), points, CELL)):
        for twin in (copy.copy(dt), copy.deepcopy(dt), pickle.loads(pickle.dumps(dt))):
            assert type(twin) is type(dt) and np.array_equal(twin.simplices, dt.simplices) and twin.is_valid()
            assert np.array_equal(twin.cell, CELL) and np.array_equal(twin.points, dt.points)
            twin.remove(3)
            assert 3 in dt and 3 not in twin
        dt.save(tmp_path / "checkpoint")
        loaded = type(dt)()
        loaded.load(tmp_path / "checkpoint")
        assert np.array_equal(loaded.simplex_shifts, dt.simplex_shifts) and np.array_equal(loaded.cell, CELL)


def test_edges_that_come_and_go_are_told():
    random = np.random.default_rng(2)
    points = cloud(50)
    dt = PeriodicDelaunay(points, CELL, changes=True)
    before, changes = edges_of(dt), 0
    for _ in range(12):
        points = points + random.normal(0, 0.01, points.shape)
        dt.update(points)
        now = edges_of(dt)
        assert images(dt.created_edges, dt.created_edge_shifts) == now - before
        assert images(dt.removed_edges, dt.removed_edge_shifts) == before - now
        changes += len(dt.created_edges)
        before = now
    assert changes > 20


@pytest.mark.parametrize("cell", [CELL, LEANING])
def test_finds_nearest_images_and_those_within_a_radius(cell):
    points, places = cloud(60, cell), np.random.default_rng(5).uniform(-1.5, 1.5, (60, 3))
    steps = np.array(list(itertools.product(range(-7, 8), range(-7, 8), (0,))))
    ways = points[:, np.newaxis] + steps @ upright(cell) - places[:, np.newaxis, np.newaxis]
    distances = np.linalg.norm(ways, axis=3)
    for dt in (PeriodicDelaunay(points, cell), PeriodicPopulation(np.arange(60) * 7, points, cell)):
        found = dt.nearest(places)
        assert found.distances == pytest.approx(distances.min(axis=(1, 2)))
        reached = points[found.rows] + found.shifts @ upright(cell)
        assert np.linalg.norm(reached - places, axis=1) == pytest.approx(found.distances)
        for radius in (0.3, 1.0):
            found = dt.within(places, radius)
            assert np.diff(found.indptr).tolist() == (distances <= radius).sum(axis=(1, 2)).tolist()
            first = np.repeat(np.arange(len(places)), np.diff(found.indptr))
            reached = points[found.indices] + found.shifts @ upright(cell)
            assert np.linalg.norm(reached - places[first], axis=1) == pytest.approx(found.distances)
            assert not found.shifts[:, 2].any()


def test_refuses_a_radius_for_too_many_images():
    dt = PeriodicDelaunay(cloud(60), CELL)
    for radius in (1e12, np.inf):
        with pytest.raises(errors.InputValueError, match="the radius is so large, compared to the cell"):
            dt.within((0, 0, 0), radius)


def test_threads_change_nothing():
    one, two = (PeriodicDelaunay(cloud(300), CELL, threads=threads) for threads in (1, 0))
    for _ in range(3):
        points = one.points + 0.01 * np.random.default_rng(1).random((300, 3))
        one.update(points)
        two.update(points)
    assert np.array_equal(one.simplices, two.simplices)


def test_tracks_arrays_and_pairs():
    trajectory = [cloud(30) + 0.01 * frame for frame in range(4)]
    for frames in (trajectory, [(np.arange(30 - frame), points[frame:]) for frame, points in enumerate(trajectory)]):
        for frame in track(frames, CELL):
            assert np.array_equal(frame.triangulation.cell, CELL) and frame.report.certified
            assert np.isinf(frame.triangulation.voronoi_cells().volumes).sum() == 2


def rows_of(points):
    return "".join(f"{id} 1 {x!r} {y!r} {z!r}\n" for id, (x, y, z) in enumerate(points.tolist(), 1))


def test_tracks_recordings(tmp_path):
    random = np.random.default_rng(1)
    fractions, cells, dump, turned, xyz = random.random((50, 3)), [], "", "", ""
    for step in range(5):
        xy = 1.5 * step % 4 - 2
        cell = np.array([(4, 0, 0), (xy, 3, 0), (0, 0, 2)])
        cells.append(cell[:2])
        points = fractions @ cell
        head = f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n50\nITEM: BOX BOUNDS"
        bounds = f"{min(0, xy)!r} {4 + max(0, xy)!r} {xy!r}\n0 3 0\n0 2 0"
        dump += f"{head} xy xz yz pp pp fs\n{bounds}\nITEM: ATOMS id type x y z\n{rows_of(points)}"
        vectors = f"0 0 2 0\n4 0 0 0\n{xy!r} 3 0 0"
        turned += f"{head} abc origin ff pp pp\n{vectors}\nITEM: ATOMS id type x y z\n{rows_of(points)}"
        lattice = " ".join(map(repr, cell.ravel().tolist()))
        xyz += f'50\nLattice="{lattice}" pbc="T T F" Properties=id:I:1:type:I:1:pos:R:3\n{rows_of(points)}'
        fractions = fractions + random.normal(0.02, 0.01, (50, 3))
    found = []
    for name, content in (("film.dump", dump), ("turned.dump", turned), ("film.xyz", xyz)):
        path = tmp_path / name
        path.write_text(content)
        frames = read_recording(path)
        assert all(np.allclose(frame.cell, cell) and frame.cell.shape == (2, 3) for frame, cell in zip(frames, cells))
        volumes = []
        for frame, cell in zip(track(frames), cells):
            dt = frame.triangulation
            assert type(dt) is PeriodicPopulation3D and dt.cell == pytest.approx(cell) and frame.report.certified
            volumes.append(dt.voronoi_cells().volumes)
        found.append(np.array(volumes))
    assert found[1] == pytest.approx(found[0]) and found[2] == pytest.approx(found[0])
    assert np.isinf(found[0]).sum(axis=1).tolist() == [2] * 5
    (flat, *_) = read_recording(tmp_path / "film.dump", dimension=2)
    assert flat.cell.shape == (2, 2) and flat.points.shape == (50, 2)
