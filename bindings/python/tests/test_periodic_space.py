# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

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
    UpdateReport3D,
    errors,
    read_recording,
    track,
)

CELL = np.array([(1.0, 0.1, 0.0), (0.3, 0.9, 0.1), (-0.2, 0.1, 1.1)])
SHIFTS = np.array(sorted(itertools.product((-1, 0, 1), repeat=3), key=lambda shift: shift != (0, 0, 0)))


def cloud(n, cell=CELL, seed=1):
    return np.random.default_rng(seed).random((n, 3)) @ cell


def wrapped(points, cell):
    """In the cell, and the shifts by which they were moved there."""
    shifts = -np.floor(points @ np.linalg.inv(cell)).astype(int)
    return points + shifts @ cell, shifts


def images_by_scipy(points, cell):
    """Edges as (i, j, shift) of the middle one of 27 copies, of points that are in the cell."""
    copies = np.concatenate([points + shift @ cell for shift in SHIFTS])
    indptr, indices = Delaunay(copies).vertex_neighbor_vertices
    n = len(points)
    return {(i, j % n, tuple(SHIFTS[j // n].tolist())) for i in range(n) for j in indices[indptr[i] : indptr[i + 1]]}


def images(triangulation):
    edges = set()
    for (i, j), shift in zip(triangulation.edges.tolist(), triangulation.edge_shifts.tolist()):
        edges |= {(i, j, tuple(shift)), (j, i, tuple(-number for number in shift))}
    return edges


def listed(lists):
    first = np.repeat(np.arange(len(lists.indptr) - 1), np.diff(lists.indptr))
    return {(i, j, tuple(s)) for i, j, s in zip(first.tolist(), lists.indices.tolist(), lists.shifts.tolist())}


def assert_fits_together(dt):
    """Whether simplices fill the cell, and edges, lists and Voronoi cells are those of the simplices."""
    cell, points = dt.cell, dt.points
    corners = points[dt.simplices] + dt.simplex_shifts @ cell
    a, b, c, d = corners.transpose(1, 0, 2)
    volumes = np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) / 6
    assert (volumes > -1e-12).all() and volumes.sum() == pytest.approx(abs(np.linalg.det(cell)))
    assert dt.volumes() == pytest.approx(volumes, abs=1e-12)
    assert not dt.simplex_shifts[:, 0].any()
    lists = dt.neighbor_lists()
    assert len(dt.edges) == dt.number_of_vertices + len(dt.simplices)
    if not len(dt.duplicates):
        assert listed(lists) == images(dt)
    first = np.repeat(np.arange(len(points)), np.diff(lists.indptr))
    assert lists.vectors == pytest.approx(points[lists.indices] + lists.shifts @ cell - points[first], abs=1e-12)
    assert np.array_equal(lists.indices, dt.indices) and np.array_equal(lists.shifts, dt.neighbor_shifts)
    assert np.array_equal(lists.vectors, dt.neighbor_vectors)
    cells = dt.voronoi_cells()
    assert cells.volumes.sum() == pytest.approx(abs(np.linalg.det(cell)))
    first = np.repeat(np.arange(len(points)), np.diff(cells.indptr))
    assert cells.vectors == pytest.approx(points[cells.neighbors] + cells.shifts @ cell - points[first], abs=1e-12)
    # a cell consists of a pyramid for each facet
    pyramids = np.bincount(first, cells.facet_areas * np.linalg.norm(cells.vectors, axis=1) / 6, len(points))
    if not len(dt.duplicates):
        assert pyramids == pytest.approx(cells.volumes)
        assert np.bincount(first, cells.facet_areas, len(points)) == pytest.approx(cells.surface_areas)
    assert dt.is_valid() and dt.is_certified


def test_agrees_with_scipys_of_27_copies():
    random = np.random.default_rng(1)
    cell = CELL
    points = cloud(80)
    dt = PeriodicDelaunay(points, cell)
    assert type(dt) is PeriodicDelaunay3D
    for frame in range(8):
        inside, shifts = wrapped(points, cell)
        expected = images_by_scipy(inside, cell)
        # an edge of points as they were given is one of points in the cell, with another shift
        found = {(i, j, tuple((np.array(s) - shifts[j] + shifts[i]).tolist())) for i, j, s in images(dt)}
        assert found == expected
        assert_fits_together(dt)
        cell = cell + (0, 0.01, 0.02)
        if frame == 4:  # other vectors of the same lattice
            cell = np.array([cell[0], cell[1] + cell[0], cell[2] - cell[1]])
        points = points + random.normal(0, 0.02, points.shape)
        report = dt.update(points, cell)
        assert isinstance(report, UpdateReport3D) and report.certified
    assert np.array_equal(dt.cell, cell) and np.array_equal(dt.points, points)
    assert repr(dt) == "<PeriodicDelaunay3D of 80 points, certified>"


def test_has_the_voronoi_cells_of_copies():
    points = cloud(40)
    copies = np.concatenate([points + shift @ CELL for shift in SHIFTS])
    voronoi = Voronoi(copies)
    cells = PeriodicDelaunay(points, CELL).voronoi_cells()
    hulls = [ConvexHull(voronoi.vertices[voronoi.regions[region]]) for region in voronoi.point_region[:40]]
    assert cells.volumes == pytest.approx([hull.volume for hull in hulls])
    assert cells.surface_areas == pytest.approx([hull.area for hull in hulls])


def test_has_neighbors_as_freud_has_them():
    points = cloud(50)
    dt = PeriodicDelaunay(points, CELL)
    pairs, cells = dt.neighbor_list(), dt.voronoi_cells()
    assert len(pairs) == len(cells.neighbors)
    assert np.array_equal(pairs.point_indices, cells.neighbors)
    assert np.array_equal(pairs.neighbor_counts, np.diff(cells.indptr)) and pairs.segments[3] == cells.indptr[3]
    assert pairs.vectors.sum(axis=0) == pytest.approx(0)
    assert pairs.distances == pytest.approx(np.linalg.norm(pairs.vectors, axis=1))
    assert np.bincount(pairs.query_point_indices, pairs.weights) == pytest.approx(cells.surface_areas)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 9])
def test_takes_few_points(n):
    dt = PeriodicDelaunay(cloud(n), CELL)
    assert_fits_together(dt)
    dt.update(cloud(n, seed=2), 2 * CELL)
    assert_fits_together(dt)


def test_is_chosen_by_shapes():
    points = cloud(10)
    for triangulation in (
        PeriodicDelaunay(points),
        PeriodicDelaunay(points, (1, 2, 3)),
        PeriodicDelaunay(points=points.tolist(), cell=CELL.tolist()),
        PeriodicDelaunay(cell=CELL),
        PeriodicDelaunay(None, (1, 2, 3)),
    ):
        assert type(triangulation) is PeriodicDelaunay3D
    for population in (
        PeriodicPopulation(range(10), points),
        PeriodicPopulation(range(10), points, CELL),
        PeriodicPopulation(points=points, ids=range(10)),
        PeriodicPopulation(cell=(1, 1, 1)),
    ):
        assert type(population) is PeriodicPopulation3D
    assert np.array_equal(PeriodicDelaunay(points).cell, np.eye(3))
    assert np.array_equal(PeriodicDelaunay(points, (1, 2, 3)).cell, np.diag([1, 2, 3]))
    assert PeriodicDelaunay(points[:, :2], (1, 1)).points.shape == (10, 2)
    assert len(PeriodicDelaunay(cell=CELL)) == 0 and len(PeriodicDelaunay(cell=CELL).simplices) == 0


@pytest.mark.parametrize("cell", [(1, 1), (1, 1, 1, 1), 1.0, np.eye(2), np.eye(4), np.ones((3, 2)), np.ones((3, 3)),
                                  (1, 1, 0), (1, np.nan, 1), (1, np.inf, 1), (1e200, 1, 1e-200)])
def test_refuses_other_cells(cell):
    points = cloud(10)
    with pytest.raises(errors.PeriodicCellError):
        PeriodicDelaunay(points, cell)
    dt = PeriodicDelaunay(points, CELL)
    with pytest.raises(errors.PeriodicCellError):
        dt.update(points * 2, cell)
    assert np.array_equal(dt.cell, CELL) and np.array_equal(dt.points, points)


def test_refuses_what_is_wrong_and_changes_nothing():
    points = cloud(10)
    dt = PeriodicDelaunay(points, CELL)
    for wrong, kind in (
        (points[:9], errors.PointCountError),
        (points[:, :2], errors.InputValueError),
        (np.where(np.arange(30).reshape(10, 3) == 7, np.nan, points), errors.NonFiniteCoordinateError),
        (points + (0, 2e6, 0), errors.PeriodicRangeError),
    ):
        with pytest.raises(kind):
            dt.update(wrong)
    with pytest.raises(errors.InputValueError):
        PeriodicDelaunay(points[:, :2], CELL)
    with pytest.raises(errors.NonFiniteCoordinateError) as refused:
        dt.insert([np.inf, 0, 0])
    assert refused.value.id == 10
    with pytest.raises(errors.PeriodicRangeError) as refused:
        dt.move([3, 4], [points[3], points[4] + 2e7])
    assert refused.value.id == 4
    for ids, kind in (([10], errors.UnknownIdError), ([-1], errors.UnknownIdError), ([1, 1], errors.RepeatedIdError)):
        with pytest.raises(kind):
            dt.remove(ids)
    with pytest.raises(TypeError):
        PeriodicDelaunay(points, CELL, classifier="circumcircle")
    with pytest.raises(errors.InputValueError):
        PeriodicDelaunay(points, CELL, threads=-1)
    assert np.array_equal(dt.points, points) and np.array_equal(dt.cell, CELL) and dt.is_valid()


def test_points_come_move_and_go():
    dt = PeriodicDelaunay(cloud(30), CELL)
    assert dt.insert(cloud(5, seed=2)).tolist() == [30, 31, 32, 33, 34]
    dt.remove([3, 31])
    assert len(dt) == 33 and dt.number_of_ids == 35 and 3 not in dt and 30 in dt
    assert np.isnan(dt.points[3]).all() and dt.ids.tolist() == [i for i in range(35) if i not in (3, 31)]
    assert dt.voronoi_cells().volumes[3] == 0
    assert dt.voronoi_cells().volumes.sum() == pytest.approx(np.linalg.det(CELL))
    assert dt.voronoi_volumes() == pytest.approx(dt.voronoi_cells().volumes)
    assert len(dt.neighbors_of(3)) == 0 and len(dt.neighbors_of(4)) > 3
    report = dt.move(7, dt.points[7] + 0.3)
    assert report.certified and dt.last_report.relocated == report.relocated
    assert dt.insert((0.1, 0.1, 0.1)).tolist() == [3]
    points = dt.points
    points = np.where(np.isnan(points), 5.0, points) + 0.01
    dt.update(points)
    dt.remove(dt.ids[1:])
    assert len(dt) == 1 and len(dt.simplices) == 6 and dt.is_valid()
    dt.remove(0)
    assert len(dt) == 0 and len(dt.edges) == 0 and dt.indptr.tolist() == [0] * 36


def test_points_coincide_with_images():
    points = cloud(20)
    points[7] = points[3] = (0.25, 0.5, 0.75)
    points[9] = points[3] + (2, -1, 4)
    dt = PeriodicDelaunay(points)
    assert dt.duplicates.tolist() == [[7, 3], [9, 3]] and dt.number_of_vertices == 18
    lists = dt.neighbor_lists()
    assert dt.neighbors_of(9).tolist() == [3] and lists.shifts[lists.indptr[9]].tolist() == [2, -1, 4]
    assert dt.neighbors_of(3)[-2:].tolist() == [7, 9] and lists.shifts[lists.indptr[4] - 1].tolist() == [-2, 1, -4]
    assert set(dt.edges.ravel().tolist()).isdisjoint({7, 9})
    assert_fits_together(dt)
    volumes = dt.voronoi_cells().volumes
    assert volumes[3] == volumes[7] == volumes[9]


def test_crystals_have_their_neighbors():
    lattice = np.array(list(itertools.product(range(4), repeat=3)), dtype=float)
    cells = PeriodicDelaunay(lattice, (4, 4, 4)).voronoi_cells()
    assert (np.diff(cells.indptr) == 6).all() and np.allclose(cells.facet_areas, 1) and np.allclose(cells.volumes, 1)
    random = PeriodicDelaunay(lattice + np.random.default_rng(1).normal(0, 1e-3, lattice.shape), (4, 4, 4))
    random.update(lattice + (0, 0, 17))
    assert (random.neighbor_list().neighbor_counts == 6).all()


def test_population_follows_ids():
    random = np.random.default_rng(1)
    cell = CELL
    population = PeriodicPopulation(cell=cell)
    places = cloud(60)
    for frame in range(12):
        ids = random.permutation(60)[: (60, 50, 55, 3, 60, 1, 0, 20, 60, 60, 58, 59)[frame]]
        cell = cell + (0.01, 0, 0.01)
        places = places + random.normal(0, 0.01, places.shape)
        report = population.update(ids + 10**12, places[ids], cell)
        assert report.certified and sorted(population.ids - 10**12) == sorted(ids)
        assert np.array_equal(population.points, places[population.ids - 10**12])
        fresh = PeriodicDelaunay(population.points, cell)
        assert images(population) == images(fresh)
        if len(ids):
            assert_fits_together(population)
            assert population.voronoi_cells().volumes == pytest.approx(fresh.voronoi_cells().volumes)


def test_population_changes_some():
    population = PeriodicPopulation([5, -3, 8], cloud(3), CELL)
    population.insert([1, 2], cloud(2, seed=3))
    population.insert(4, (0.1, 0.2, 0.3))
    assert population.move([5, 2], cloud(2, seed=4)).certified
    assert population.remove(-3).removed == 1 and sorted(population.ids) == [1, 2, 4, 5, 8]
    assert -3 not in population and 4 in population
    assert_fits_together(population)


def test_population_refuses_and_changes_nothing():
    points = cloud(6)
    population = PeriodicPopulation(range(6), points, CELL)
    for change, kind, id in (
        (lambda: population.update([1, 2, 1], points[:3]), errors.RepeatedIdError, 1),
        (lambda: population.update([1, 2, 77], [*points[:2], [0, np.nan, 0]]), errors.NonFiniteCoordinateError, 2),
        (lambda: population.update([7, 4, 5, 2, 3], [*points[:4], [9e9, 0, 0]]), errors.PeriodicRangeError, 4),
        (lambda: population.update([7, 4, 5, 2, 3], [[9e9, 0, 0], *points[:4]]), errors.PeriodicRangeError, 0),
        (lambda: population.insert([9, 5], points[:2]), errors.RepeatedIdError, 5),
        (lambda: population.insert([9, 10], [points[0], [0, 9e9, 0]]), errors.PeriodicRangeError, 1),
        (lambda: population.move([5, 4], [points[0], [0, 9e9, 0]]), errors.PeriodicRangeError, 1),
        (lambda: population.move([5, 9], points[:2]), errors.UnknownIdError, 9),
        (lambda: population.move([5, 5], points[:2]), errors.RepeatedIdError, 5),
        (lambda: population.remove([1, 9]), errors.UnknownIdError, 9),
        (lambda: population.remove([1, 1]), errors.RepeatedIdError, 1),
    ):
        with pytest.raises(kind) as refused:
            change()
        assert refused.value.id == id
    with pytest.raises(errors.PeriodicCellError):
        population.update([1, 9], points[:2], (1, 1))
    with pytest.raises(errors.PeriodicCellError):
        population.update([1, 9], points[:2], (1, 1, 0))
    with pytest.raises(errors.InputTypeError):
        PeriodicPopulation(points=points)
    assert population.ids.tolist() == list(range(6)) and np.array_equal(population.points, points)
    assert population.is_valid()


def test_is_copied_pickled_and_saved(tmp_path):
    points = cloud(20)
    for dt in (PeriodicDelaunay(points, CELL), PeriodicPopulation(range(20), points, CELL)):
        for twin in (copy.copy(dt), copy.deepcopy(dt)):
            assert type(twin) is type(dt) and np.array_equal(twin.simplices, dt.simplices)
            twin.remove(3)
            assert 3 in dt and 3 not in twin and np.array_equal(twin.cell, dt.cell)
        dt.move(3, dt.points[3] + (7, 0.1, -4))
        twin = pickle.loads(pickle.dumps(dt))
        assert type(twin) is type(dt) and np.array_equal(twin.simplices, dt.simplices) and twin.is_valid()
        assert np.array_equal(twin.cell, CELL) and np.array_equal(twin.points, dt.points)
        dt.save(tmp_path / "checkpoint")
        loaded = type(dt)()
        loaded.load(tmp_path / "checkpoint")
        assert np.array_equal(loaded.simplex_shifts, dt.simplex_shifts) and np.array_equal(loaded.cell, CELL)
        with pytest.raises(errors.CheckpointError):
            loaded.restore(dt.checkpoint()[:-9])
        assert len(loaded) == 20
        with pytest.raises(errors.UseError):
            dt.__init__(*([points] if isinstance(dt, PeriodicDelaunay3D) else [range(20), points]))
    with pytest.raises(errors.UseError):
        PeriodicDelaunay3D.__new__(PeriodicDelaunay3D).points


def test_arrays_are_of_their_moment():
    dt = PeriodicDelaunay(cloud(20), CELL)
    edges = dt.edges
    assert dt.edges is edges and dt.is_current(edges) and not edges.flags.writeable
    dt.move(3, dt.points[3] + 0.1)
    assert not dt.is_current(edges) and dt.edges is not edges


def test_threads_change_nothing():
    one, two = (PeriodicDelaunay(cloud(300), CELL, threads=threads) for threads in (1, 0))
    for _ in range(3):
        points = one.points + 0.01 * np.random.default_rng(1).random((300, 3))
        one.update(points)
        two.update(points)
    assert np.array_equal(one.simplices, two.simplices)


def test_tracks_arrays_and_pairs():
    trajectory = [cloud(30) + 0.01 * frame for frame in range(4)]
    for frames in (trajectory, np.array(trajectory)):
        seen = [(frame.number, frame.triangulation.voronoi_cells().volumes.sum()) for frame in track(frames, CELL)]
        assert [number for number, _ in seen] == [0, 1, 2, 3]
        assert [volume for _, volume in seen] == pytest.approx([np.linalg.det(CELL)] * 4)
    pairs = [(np.arange(30 - frame), points[frame:]) for frame, points in enumerate(trajectory)]
    sizes = [len(frame.ids) for frame in track(iter(pairs), CELL, threads=2)]
    assert sizes == [30, 29, 28, 27] and type(next(track(pairs, CELL)).triangulation) is PeriodicPopulation3D
    with pytest.raises(errors.PeriodicCellError, match=r"^frame 0: a cell of points in space has the shape \(2,\)"):
        list(track(trajectory, (1, 1)))
    trajectory[2] = trajectory[2] + (0, 0, 3e7)
    with pytest.raises(errors.PeriodicRangeError, match="^frame 2: "):
        list(track(trajectory, CELL))
    pairs[3] = (np.arange(27), np.full((27, 3), 1e9))
    with pytest.raises(errors.PeriodicRangeError, match="^frame 3, id 0: "):
        list(track(pairs, CELL))


def dump_of(step, cell, points, columns="x y z"):
    """As LAMMPS writes it; the cell is lower triangular."""
    (lx, _, _), (xy, ly, _), (xz, yz, lz) = cell
    rows = "".join(f"{id} 1 {x!r} {y!r} {z!r}\n" for id, (x, y, z) in enumerate(points.tolist(), 1))
    return (f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(points)}\nITEM: BOX BOUNDS xy xz yz pp pp pp\n"
            f"{min(0, xy, xz, xy + xz)!r} {lx + max(0, xy, xz, xy + xz)!r} {xy!r}\n"
            f"{min(0, yz)!r} {ly + max(0, yz)!r} {xz!r}\n0 {lz!r} {yz!r}\nITEM: ATOMS id type {columns}\n{rows}")


def test_tracks_recordings(tmp_path):
    random = np.random.default_rng(1)
    fractions, cells, text, scaled, xyz = random.random((50, 3)), [], "", "", ""
    for step in range(5):
        cell = np.array([(4, 0, 0), (0.5, 3, 0), (1.5 * step % 4 - 2, -0.3, 5 - 0.1 * step)])
        cells.append(cell)
        points = fractions @ cell
        text += dump_of(100 * step, cell.tolist(), points)
        scaled += dump_of(100 * step, cell.tolist(), fractions, "xsu ysu zsu")
        xyz += f'50\nLattice="{" ".join(map(repr, cell.ravel().tolist()))}"\n'
        xyz += "".join(f"Ar {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist())
        fractions = fractions + random.normal(0.02, 0.01, (50, 3))
    found = {}
    for name, content in (("a.dump", text), ("b.dump", scaled), ("c.xyz", xyz)):
        path = tmp_path / name
        path.write_text(content)
        frames = read_recording(path)
        assert [frame.cell == pytest.approx(cell) for frame, cell in zip(frames, cells)] == [True] * 5
        found[name] = []
        for frame, cell in zip(track(frames), cells):
            dt = frame.triangulation
            assert type(dt) is PeriodicPopulation3D and dt.cell == pytest.approx(cell) and frame.report.certified
            volumes = dt.voronoi_cells().volumes
            assert volumes.sum() == pytest.approx(np.linalg.det(cell))
            found[name].append(volumes)
        assert np.array(found[name]) == pytest.approx(np.array(found["a.dump"]))
        assert read_recording(path, dimension=2)[0].cell.shape == (2, 2)
    assert len(list(track(read_recording(tmp_path / "a.dump"), cell=(9, 9, 9)))) == 5


def test_an_update_rebuilds_nothing():
    points = cloud(500)
    dt = PeriodicDelaunay(points, CELL)
    report = dt.update(points + np.random.default_rng(1).normal(0, 1e-3, points.shape))
    assert 0 < report.flips < 500 and not report.rebuilt and report.inserted == 0
