# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Points in space, against SciPy and against determinants of integers."""

import copy
import itertools
import pickle
import subprocess
import sys
import threading
from fractions import Fraction

import numpy as np
import pytest
from scipy.spatial import Delaunay
from space_agreement import (
    assert_fits_together,
    assert_is_delaunay,
    cells,
    cloud,
    moved,
    sides_of_spheres,
    six_volumes,
)

from dynamic_delaunay import DynamicDelaunay, DynamicDelaunay3D, Population3D, UpdateReport3D, errors, track


def test_determinants_tell_what_is_in_a_sphere():
    corners = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4)]
    points = np.array([*corners, (4, 4, 4), (2, 2, 2), (3, 4, 4), (5, 4, 4), (-1, 0, 0)])
    signs = np.sign(sides_of_spheres(points, np.array([(0, 1, 2, 3)])))
    assert signs.tolist() == [[0, 0, 0, 0, 0, -1, -1, 1, 1]]


def assert_has_empty_spheres(dt):
    """Of points whose coordinates are small integers, many of them on one sphere."""
    assert dt.is_certified and dt.is_valid()
    assert_fits_together(dt)
    present = dt.ids
    points = dt.points[present].astype(np.int64)
    simplices, hull = np.searchsorted(present, dt.simplices), np.searchsorted(present, dt.convex_hull)
    volumes = six_volumes(points, simplices)
    assert (volumes > 0).all() and (sides_of_spheres(points, simplices) >= 0).all()
    if len(points) > 0 and np.linalg.matrix_rank(points - points[0]) == 3:
        assert volumes.sum() == six_volumes(points, np.column_stack([np.zeros(len(hull), int), hull])).sum() > 0
        assert set(simplices.ravel()) | set(np.searchsorted(present, dt.duplicates[:, 0])) == set(range(len(points)))
    else:
        assert len(simplices) == 0


def test_becomes_what_its_points_are():
    points = cloud(100)
    for given in (points, points.tolist(), points.astype(np.float32), np.empty((0, 3))):
        assert type(DynamicDelaunay(given)) is type(DynamicDelaunay(points=given)) is DynamicDelaunay3D
    for given in (points[:, :2], [], np.empty((0, 2)), None):
        assert type(DynamicDelaunay(given)) is DynamicDelaunay
    assert type(DynamicDelaunay(points, threads=2)) is DynamicDelaunay3D

    class Derived(DynamicDelaunay):
        pass

    for refused in (Derived, lambda points: DynamicDelaunay().insert(points)):
        with pytest.raises(errors.InputValueError, match=r"\(100, 3\): it must be \(n, 2\)"):
            refused(points)
    with pytest.raises(TypeError, match="DynamicDelaunay3D.*'classifier'"):
        DynamicDelaunay(points, classifier="circumcircle")


def test_triangulates_what_it_is_given():
    points = cloud(500)
    dt = DynamicDelaunay(points)
    assert_is_delaunay(dt, points)
    assert len(dt) == dt.number_of_points == dt.number_of_ids == dt.number_of_vertices == dt.npoints == 500
    assert dt.dimension == 3
    assert np.array_equal(dt.points, points) and np.array_equal(dt.ids, np.arange(500))
    assert dt.duplicates.shape == (0, 2)
    assert repr(dt) == "<DynamicDelaunay3D of 500 points, certified>"
    assert (six_volumes(points, dt.simplices) > 0).all()


def test_has_the_hull_and_the_lists_of_scipy():
    points = cloud(300)
    dt, theirs = DynamicDelaunay(points), Delaunay(points)
    assert cells(dt.convex_hull) == cells(theirs.convex_hull)
    middle = np.vstack([points, points.mean(axis=0)])
    assert (six_volumes(middle, np.column_stack([np.full(len(dt.convex_hull), 300), dt.convex_hull])) > 0).all()
    assert (six_volumes(middle, np.column_stack([dt.convex_hull, np.full(len(dt.convex_hull), 300)])) < 0).all()
    indptr, indices = theirs.vertex_neighbor_vertices
    assert dt.indptr.dtype == dt.indices.dtype == np.int32
    for i in range(300):
        assert dt.neighbors_of(i).tolist() == sorted(indices[indptr[i] : indptr[i + 1]])
    assert dt.vertex_neighbor_vertices == dt.neighbor_lists() == (dt.indptr, dt.indices)
    with pytest.raises(IndexError, match="there is no row 300"):
        dt.neighbors_of(300)


@pytest.mark.parametrize("size", [1, 2.0**-300, 2.0**240])
def test_measures_simplices(size):
    points = np.ldexp(np.concatenate([cloud(200), np.ldexp(cloud(50, seed=2), -40)]), int(np.log2(size)))
    dt = DynamicDelaunay(points)
    volumes = dt.volumes()
    assert len(volumes) == len(dt.simplices) > 1000 and (volumes >= 0).all()
    for simplex, volume in zip(dt.simplices.tolist(), volumes.tolist()):
        a, b, c, d = ([Fraction(x) / Fraction(size) for x in points[corner].tolist()] for corner in simplex)
        u, v, w = ([x - y for x, y in zip(corner, a)] for corner in (b, c, d))
        exact = (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2])
                 + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6
        longest = max(sum((x - y) ** 2 for x, y in zip(p, q)) for p, q in itertools.combinations((a, b, c, d), 2))
        error = abs(Fraction(volume) / Fraction(size) ** 3 - exact)
        assert exact > 0 and error <= 1e-15 * float(longest) ** 1.5 + (0 if size >= 1 else 2.0**-170)


def test_measures_voronoi_cells_in_a_box():
    points = cloud(500)
    points[7] = points[3]
    dt = DynamicDelaunay(points)
    for frame in range(3):
        cells = dt.voronoi_cells((0, 0, 0, 1, 1, 1))
        assert cells.volumes.sum() == pytest.approx(1, abs=1e-12) and (cells.volumes > 0).all()
        assert cells.volumes[3] == cells.volumes[7]
        assert cells.centroids.shape == (500, 3) and (cells.volumes @ cells.centroids) == pytest.approx(0.5, abs=1e-12)
        shared = np.diff(cells.indptr)[[3, 7]]
        assert shared.min() == 0 and shared.max() > 3 and cells.neighbors.dtype == np.int32
        rows = np.repeat(np.arange(500), np.diff(cells.indptr))
        areas = dict(zip(zip(rows.tolist(), cells.neighbors.tolist()), cells.facet_areas.tolist()))
        assert all(areas[j, i] == area for (i, j), area in areas.items())
        points += np.random.default_rng(frame).normal(0, 1e-3, points.shape)
        points[7] = points[3]
        dt.update(np.clip(points, 0, 1, out=points))


def test_measures_whole_voronoi_cells():
    lattice = np.array(list(itertools.product(range(5), repeat=3)), float)
    dt = DynamicDelaunay(lattice)
    cells = dt.voronoi_cells()
    inner = ((lattice > 0) & (lattice < 4)).all(axis=1)
    assert cells.volumes[inner] == pytest.approx(1, abs=1e-14) and np.isinf(cells.volumes[~inner]).all()
    assert cells.surface_areas[inner] == pytest.approx(6, abs=1e-13)
    assert cells.centroids[inner] == pytest.approx(lattice[inner], abs=1e-14)
    assert (cells.centroids[~inner] == lattice[~inner]).all()
    assert (np.diff(cells.indptr)[inner] == 6).all()
    assert len(DynamicDelaunay3D().voronoi_cells().volumes) == 0


def test_measures_volumes_of_voronoi_cells_alone():
    dt = DynamicDelaunay(np.concatenate([cloud(300), cloud(5)]))  # five of them coincide
    dt.remove([7, 31])
    volumes, expected = dt.voronoi_volumes(), dt.voronoi_cells().volumes
    assert volumes.shape == (305,) and volumes[7] == 0
    assert np.array_equal(np.isinf(volumes), np.isinf(expected))
    bounded = np.isfinite(volumes)
    assert volumes[bounded] == pytest.approx(expected[bounded], rel=1e-9)
    population = Population3D(np.arange(300) * 7, cloud(300))
    population.remove([14])
    assert population.voronoi_volumes().shape == (299,)
    assert len(DynamicDelaunay3D().voronoi_volumes()) == 0


def test_refuses_boxes_that_are_none():
    dt = DynamicDelaunay(cloud(20))
    for box in [(0, 0, 0, 1, 1), (0, 0, 0, 1, 1, 0), (0, 0, 0, 1, 1, np.nan), (0, 0, 0, 1, 1, 1e101), "box", [[0] * 6]]:
        with pytest.raises(errors.InputValueError, match="box"):
            dt.voronoi_cells(box)


def test_follows_points_that_move_and_reports_what_it_did():
    points = cloud(500)
    dt = DynamicDelaunay(points)
    for frame in range(20):
        points = moved(points, 0.002, frame)
        report = dt.update(points)
        assert isinstance(report, UpdateReport3D)
        assert report.certified and not report.rebuilt and report.rebuild_reason is None
        assert_is_delaunay(dt, points)
    assert report.flips > 0 and report.unproved > 0
    assert f"UpdateReport3D(flips={report.flips}, unproved={report.unproved}, held=" in repr(report)
    assert dt.last_report == report == pickle.loads(pickle.dumps(report))
    report = dt.update(cloud(500, seed=3))
    assert report.rebuilt and report.rebuild_reason == "too_much_broken"
    assert report != dt.update(points)


def test_inserts_removes_and_moves():
    dt = DynamicDelaunay(cloud(200))
    assert list(dt.insert([(0.5, 0.5, 0.1), (0.25, 0.75, 0.2)])) == [200, 201]
    assert list(dt.insert((0.1, 0.2, 0.3))) == [202] and dt.insert((0.1, 0.2, 0.4)).dtype == np.int64
    assert dt.remove([3, 200]).removed == 2
    assert 3 not in dt and 4 in dt and -1 not in dt and "4" not in dt and 2**70 not in dt
    assert np.isnan(dt.points[3]).all() and len(dt.neighbors_of(3)) == 0
    assert list(dt.insert((0.9, 0.9, 0.8))) == [3]
    dt.move(4, (0.3, 0.3, 0.3))
    report = dt.move([5, 6, 7], [(0.31, 0.3, 0.2), (0.3, 0.31, 0.3), (0.7, 0.1, 0.9)])
    assert report.certified and dt.last_report == report
    assert np.array_equal(dt.points[[4, 6]], [(0.3, 0.3, 0.3), (0.3, 0.31, 0.3)])
    assert 200 not in dt.ids and len(dt.ids) == len(dt) == 203
    dt.remove(201)
    dt.insert([(0.7, 0.1, 0.1), (0.7, 0.2, 0.1)])
    assert_is_delaunay(dt, dt.points)


@pytest.mark.parametrize("n", [2, 4, 6])
def test_triangulates_lattices(n):
    lattice = np.array(list(itertools.product(range(n), repeat=3)), dtype=float)
    dt = DynamicDelaunay(lattice)
    assert_has_empty_spheres(dt)
    assert dt.volumes().sum() == pytest.approx((n - 1) ** 3, rel=1e-14)
    for frame in range(3):
        assert dt.update(moved(lattice, 0.01, frame)).certified
        assert_fits_together(dt)
        dt.update(lattice)
        assert_has_empty_spheres(dt)


def test_triangulates_points_on_a_sphere():
    points = np.array(list(itertools.product(range(-9, 10), repeat=3)))
    points = points[(points**2).sum(axis=1) == 81]
    assert len(points) > 100
    assert_has_empty_spheres(DynamicDelaunay(points))
    assert_has_empty_spheres(DynamicDelaunay(np.vstack([points, (0, 0, 0)])))


@pytest.mark.parametrize("points, dimension, edges", [
    (np.empty((0, 3)), -1, 0),
    ([(1, 2, 3)], 0, 0),
    ([(1, 2, 3)] * 3, 0, 0),
    ([(0, 0, 0), (1, 1, 1)], 1, 1),
    ([(0, 0, 0), (2, 2, 2), (1, 1, 1)], 1, 2),
    ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], 2, 3),
    ([(0, 0, 5), (1, 0, 5), (0, 1, 5), (1, 1.5, 5)], 2, 5),
])
def test_has_no_simplices_without_an_extent(points, dimension, edges):
    dt = DynamicDelaunay(points)
    assert dt.is_valid() and dt.is_certified and dt.dimension == dimension
    assert dt.simplices.shape == dt.neighbors.shape == (0, 4)
    assert dt.convex_hull.shape == (0, 3) and dt.volumes().shape == (0,)
    assert dt.edges.shape == (edges, 2)
    assert dt.points.shape == (len(points), 3)
    assert_fits_together(dt)
    dt.insert([(0.2, 0.3, 9), (8, 0.1, 7), (0.3, 7, 0.7), (-1, -2, -2)])
    assert dt.dimension == 3
    assert_fits_together(dt)


def test_knows_points_that_coincide():
    dt = DynamicDelaunay([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
    assert list(dt.insert([(1, 0, 0), (1, 0, 0)])) == [4, 5]
    assert dt.number_of_points == 6 and dt.number_of_vertices == 4
    assert dt.duplicates.tolist() == [[4, 1], [5, 1]]
    assert dt.neighbors_of(4).tolist() == [1] and dt.neighbors_of(1).tolist() == [0, 2, 3, 4, 5]
    assert sorted(dt.simplices[0]) == [0, 1, 2, 3]
    points = dt.points.copy()
    points[5] = (2, 3, 4)
    assert dt.update(points).parted == 1
    assert dt.duplicates.tolist() == [[4, 1]]
    assert_fits_together(dt)
    points[5] = points[3]
    dt.update(points)
    assert dt.duplicates.tolist() in ([[4, 1], [5, 3]], [[3, 5], [4, 1]])
    assert_fits_together(dt)
    together = DynamicDelaunay(np.repeat(cloud(20), 3, axis=0))
    assert together.number_of_vertices == 20 and len(together.duplicates) == 40
    assert np.array_equal(*together.points[together.duplicates.T])
    assert_fits_together(together)


def unaligned(points):
    data = bytearray(1) + points.tobytes()
    return np.frombuffer(data, dtype=np.uint8)[1:].view(np.float64).reshape(points.shape)


@pytest.mark.parametrize("arranged", [
    np.asfortranarray,
    lambda points: np.repeat(points, 3, axis=0)[::3],
    lambda points: np.ascontiguousarray(points[::-1, ::-1])[::-1, ::-1],
    lambda points: np.repeat(points, 2, axis=1)[:, ::2],
    unaligned,
    lambda points: points.astype(">f8"),
    lambda points: points.astype(np.longdouble),
    lambda points: points.tolist(),
    lambda points: np.broadcast_to(points, points.shape),  # read-only
])
def test_reads_numbers_wherever_they_are(arranged):
    points, others = cloud(60), cloud(60, seed=3)
    dt = DynamicDelaunay(arranged(points))
    assert np.array_equal(dt.points, points)
    dt.update(arranged(others))
    assert np.array_equal(dt.points, others)
    dt.move(np.arange(5), arranged(points[:5]))
    assert np.array_equal(dt.points, np.vstack([points[:5], others[5:]]))
    assert_is_delaunay(dt, dt.points)


@pytest.mark.parametrize("type", [np.float32, np.float16, np.int32, np.uint8])
def test_converts_other_numbers(type):
    points = (cloud(50) * 200).astype(type)
    assert np.array_equal(DynamicDelaunay(points).points, points.astype(float))


def test_refuses_wrong_input_before_anything_changes():
    points = cloud(20)
    dt = DynamicDelaunay(points)
    dt.remove(7)
    expected, simplices = dt.points.copy(), dt.simplices
    nan, infinite = points.copy(), points.copy()
    nan[4, 2], infinite[5, 0] = np.nan, np.inf
    for call, kind, text in (
        (lambda: dt.update(points[:, :2]), errors.InputValueError, r"\(20, 2\): it must be \(n, 3\), a row of x, y"),
        (lambda: dt.update(points[0]), errors.InputValueError, r"\(3,\): it must be \(n, 3\)"),
        (lambda: dt.update(points[:19]), errors.PointCountError, "20"),
        (lambda: dt.update(nan), errors.NonFiniteCoordinateError, "point 4 has the coordinates"),
        (lambda: dt.update(infinite), errors.NonFiniteCoordinateError, "point 5 has the coordinates"),
        (lambda: dt.insert((0, 0, np.nan)), errors.NonFiniteCoordinateError, "point 7 has"),
        (lambda: dt.insert((0, 0)), errors.InputValueError, r"\(2,\): it must be \(n, 3\)"),
        (lambda: dt.move(7, (0, 0, 0)), errors.UnknownIdError, "no point with id 7"),
        (lambda: dt.move(-1, (0, 0, 0)), errors.UnknownIdError, "ids are not negative"),
        (lambda: dt.move([1, 2, 1], points[:3]), errors.RepeatedIdError, "1"),
        (lambda: dt.move([1, 2, 4], nan[[1, 2, 4]]), errors.NonFiniteCoordinateError, "point 4 has"),
        (lambda: dt.move([1, 2], points[:3]), errors.InputValueError, "2 ids and 3 points"),
        (lambda: dt.remove([1, 20]), errors.UnknownIdError, "no point with id 20"),
        (lambda: dt.remove(-3), errors.UnknownIdError, "ids are not negative"),
        (lambda: dt.remove([1, 1]), errors.RepeatedIdError, "1"),
        (lambda: dt.remove(1.5), errors.InputTypeError, "integers are needed"),
        (lambda: dt.update(points.astype(complex)), errors.InputTypeError, "real numbers are needed"),
        (lambda: dt.update(np.ma.masked_array(points, points > 0.5)), errors.InputTypeError, "mask would be lost"),
        (lambda: dt.neighbors_of("a"), errors.InputTypeError, "must be an integer"),
        (lambda: dt.__init__(points), errors.UseError, "initialized once"),
        (lambda: DynamicDelaunay3D(points, threads=-1), errors.InputValueError, "threads is -1"),
        (lambda: DynamicDelaunay3D(points, threads=5000), errors.InputValueError, "number of threads is 5000"),
        (lambda: DynamicDelaunay3D(points, threads=1.5), errors.InputTypeError, "must be an integer"),
    ):
        with pytest.raises(kind, match=text):
            call()
    with pytest.raises(errors.NonFiniteCoordinateError) as refused:
        dt.update(nan)
    assert refused.value.id == 4 and np.isnan(refused.value.z)
    assert (refused.value.x, refused.value.y) == tuple(nan[4, :2])
    assert np.array_equal(dt.points, expected, equal_nan=True) and np.array_equal(dt.simplices, simplices)
    assert dt.is_certified and dt.is_valid()
    nan[4], nan[7] = points[4], np.nan  # of an id that is removed
    assert dt.update(nan).certified


def test_says_that_it_is_not_initialized():
    class Unprepared(DynamicDelaunay3D):
        def __init__(self):
            pass

    ways = (len, copy.copy, copy.deepcopy, pickle.dumps, DynamicDelaunay3D.mend)
    for use in (*ways, lambda dt: dt.edges, lambda dt: dt.update(cloud(5))):
        with pytest.raises(errors.UseError, match="was not called"):
            use(Unprepared())


def test_arrays_stay_as_they_were():
    points = cloud(100)
    dt = DynamicDelaunay(points)
    for name in ("points", "ids", "duplicates", "edges", "simplices", "neighbors", "indptr", "indices"):
        array = getattr(dt, name)
        assert array is getattr(dt, name) and dt.is_current(array)
        assert not array.flags.writeable and not dt.is_current(array.copy())
        kept = array.copy()
        dt.update(moved(dt.points, 0.03))
        assert not dt.is_current(array) and np.array_equal(array, kept)
    assert not dt.volumes().flags.writeable
    before = dt.simplices
    assert not dt.mend().rebuilt and np.array_equal(dt.simplices, before)


class Labeled(DynamicDelaunay3D):
    label = None


def pickled(dt):
    return pickle.loads(pickle.dumps(dt))


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy, pickled])
def test_copies_go_on_alike(duplicate):
    points = cloud(300)
    dt = Labeled(points, threads=2)
    dt.label = ["label"]
    dt.remove([7, 9])
    twin = duplicate(dt)
    assert type(twin) is Labeled and twin.label == ["label"]
    assert (twin.label is dt.label) == (duplicate is copy.copy)
    assert duplicate is pickled or twin.last_report == dt.last_report
    for frame in range(5):
        points = moved(points, 0.003, frame)
        assert dt.update(points) == twin.update(points)
        assert np.array_equal(dt.simplices, twin.simplices) and np.array_equal(dt.neighbors, twin.neighbors)
    assert twin.insert((0.5, 0.5, 0.5)) == dt.insert((0.5, 0.5, 0.5)) == 7
    twin.remove(3)
    assert 3 in dt and dt.is_valid() and twin.is_valid()


def test_saves_and_loads(tmp_path):
    dt = DynamicDelaunay3D(np.concatenate([cloud(50), cloud(3)]))
    dt.remove(7)
    dt.save(tmp_path / "checkpoint")
    other = DynamicDelaunay3D(cloud(9, seed=5))
    other.load(tmp_path / "checkpoint")
    assert other.is_certified and other.is_valid() and other.last_report.certified
    for name in ("points", "ids", "duplicates", "simplices", "neighbors", "indices"):
        assert np.array_equal(getattr(dt, name), getattr(other, name), equal_nan=name == "points")
    checkpoint = dt.checkpoint()
    assert type(checkpoint) is bytes and checkpoint == (tmp_path / "checkpoint").read_bytes() == other.checkpoint()
    damaged = checkpoint.replace(b"0", b"1", 1)
    planar = DynamicDelaunay(cloud(20)[:, :2])
    for wrong in (damaged, checkpoint[:-9], b"", planar.checkpoint(), Population3D([1], cloud(1)).checkpoint()):
        with pytest.raises(errors.CheckpointError) as refused:
            other.restore(wrong)
        assert refused.value.line >= 0
    with pytest.raises(errors.CheckpointError):
        planar.restore(checkpoint)
    with pytest.raises(errors.InputTypeError, match="a checkpoint is no str"):
        other.restore(checkpoint.decode())
    with pytest.raises(errors.InputTypeError, match=r"load\(\) is called by a triangulation"):
        DynamicDelaunay3D.load(tmp_path / "checkpoint")
    with pytest.raises(FileNotFoundError):
        other.load(tmp_path / "nothing")
    assert np.array_equal(dt.simplices, other.simplices)


@pytest.mark.parametrize("points", [np.empty((0, 3)), [(1, 2, 3)], [(0, 0, 0), (1, 1, 1)],
                                    [(0, 0, 5), (1, 0, 5), (0, 1, 5)]])
def test_saves_points_without_an_extent(points):
    twin = pickled(DynamicDelaunay(points))
    assert np.array_equal(twin.points, points) and twin.is_valid()
    twin.insert(cloud(30))
    assert_fits_together(twin)


def test_threads_change_nothing():
    points = cloud(3000)
    followed = [DynamicDelaunay(points, threads=threads) for threads in (1, 2, 0)]
    for frame in range(3):
        points = moved(points, 0.002, frame)
        assert len({repr(dt.update(points)) for dt in followed}) == 1
        assert all(np.array_equal(dt.simplices, followed[0].simplices) for dt in followed)


def test_works_while_other_threads_do():
    points = cloud(20_000)
    dt = DynamicDelaunay(points)
    turns, is_over = [], threading.Event()

    def count():
        while not is_over.wait(1e-4):
            turns.append(1)

    counter = threading.Thread(target=count)
    counter.start()
    before = len(turns)
    dt.insert(cloud(20_000, seed=5))  # half a second without the interpreter's lock
    during = len(turns) - before
    is_over.set()
    counter.join()
    assert during > 5 and dt.is_certified


def test_calls_of_one_object_wait_for_each_other():
    points = cloud(1000)
    dt = DynamicDelaunay(points)
    failures = []

    def use(seed):
        try:
            for frame in range(20):
                dt.update(moved(points, 0.001, 100 * seed + frame))
                simplices, neighbors = dt.simplices, dt.neighbors
                assert simplices.max() == 999 and neighbors.max() <= 10_000
                indptr, indices = dt.neighbor_lists()
                assert indptr[-1] == len(indices) and dt.convex_hull.shape[1] == 3
                assert abs(dt.volumes().sum() - 1) < 0.2 and len(copy.copy(dt)) == 1000
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=use, args=(seed,)) for seed in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures and dt.is_valid()


def test_tracks_trajectories():
    trajectory = cloud(100) + np.cumsum(np.random.default_rng(2).normal(0, 0.003, (20, 100, 3)), axis=0)
    for given in (trajectory, (points for points in trajectory), trajectory.tolist()):
        numbers = []
        for frame in track(given, threads=1):
            assert frame.report.certified and type(frame.triangulation) is DynamicDelaunay3D
            assert np.array_equal(frame.triangulation.points, trajectory[frame.number])
            assert frame.ids.tolist() == list(range(100))
            numbers.append(frame.number)
        assert numbers == list(range(20))
    assert_is_delaunay(frame.triangulation, trajectory[-1])
    trajectory[7, 3, 1] = np.nan
    with pytest.raises(errors.NonFiniteCoordinateError, match=r"^frame 7: point 3 has the coordinates"):
        list(track(trajectory))
    with pytest.raises(errors.InputValueError, match=r"^frame 1: .*it must be \(n, 3\)"):
        list(track([trajectory[0], trajectory[0, :, :2]]))
    with pytest.raises(errors.PeriodicCellError, match=r"^frame 0: a cell of points in space has the shape \(2,\)"):
        list(track(trajectory, cell=(1, 1)))
    with pytest.raises(errors.PeriodicCellError, match=r"^frame 0: a cell of points in space has the shape \(2,\)"):
        list(track([(np.arange(100), trajectory[0])], cell=(1, 1)))


def do_something(dt, random, anywhere, shaken):
    """One random call."""
    ids = dt.ids
    kind = random.integers(6)
    if kind == 0:
        dt.insert(anywhere(random.integers(1, 5)))
    elif kind == 1 and len(ids) > 0:
        dt.remove(random.choice(ids, random.integers(min(len(ids), 5)), replace=False))
    elif kind == 2 and len(ids) > 0:
        some = random.choice(ids, random.integers(min(len(ids), 5)), replace=False)
        dt.move(some, anywhere(len(some)))
    else:
        assert dt.update(shaken(np.nan_to_num(dt.points))).certified


@pytest.mark.parametrize("seed", range(4))
def test_random_operations_agree_with_scipy(seed):
    random = np.random.default_rng(seed)
    dt = DynamicDelaunay(random.random((20, 3)))
    for _ in range(300):
        do_something(dt, random, lambda n: random.random((n, 3)),
                     lambda points: points + random.normal(0, 10.0 ** random.integers(-4, 0), points.shape))
        ids = dt.ids
        assert dt.is_valid() and len(ids) == len(dt)
        if len(ids) > 4:
            assert cells(np.searchsorted(ids, dt.simplices)) == cells(Delaunay(dt.points[ids]).simplices)
        assert_fits_together(dt)


@pytest.mark.parametrize("seed", range(4))
def test_random_operations_on_a_grid_have_empty_spheres(seed):
    random = np.random.default_rng(seed)
    extent = (2, 3, 5, 9)[seed]
    dt = DynamicDelaunay(np.empty((0, 3)))
    for _ in range(300):
        extents = (extent, extent, random.integers(1, extent))  # at times a plane
        do_something(dt, random, lambda n: random.integers(extent, size=(n, 3)),
                     lambda points: (points + random.integers(-1, 2, points.shape)) % extents)
        assert_has_empty_spheres(dt)


WITHOUT_MEMORY = """
import resource
import sys
import numpy as np
from dynamic_delaunay import DynamicDelaunay, errors
random = np.random.default_rng(1)
dt = DynamicDelaunay(random.random((1000, 3)))
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
many = random.random((200_000, 3))
unlimited = resource.getrlimit(resource.RLIMIT_AS)
resource.setrlimit(resource.RLIMIT_AS, (used + (int(sys.argv[1]) << 20), unlimited[1]))
try:
    dt.insert(many)
except MemoryError:
    pass
resource.setrlimit(resource.RLIMIT_AS, unlimited)
was_certified = dt.is_certified
if not was_certified:
    for refused in (lambda: dt.simplices, lambda: dt.edges, lambda: dt.indices, lambda: dt.volumes()):
        try:
            refused()
        except errors.UncertifiedTriangulationError as error:
            assert "call mend()" in str(error) and not hasattr(dt, "simplices")
        else:
            raise AssertionError("no cells, but arrays")
    assert len(dt.points) >= 1000
dt.mend()
assert dt.is_certified and dt.is_valid() and len(dt) in (1000, 201_000)
assert len(dt.simplices) > 5000
print(was_certified)
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="memory is limited as Linux does it")
def test_goes_on_after_memory_was_exhausted():
    outcomes = []
    for megabytes in (2, 20, 30, 40, 60):  # at some of these while cells are made
        command = [sys.executable, "-c", WITHOUT_MEMORY, str(megabytes)]
        finished = subprocess.run(command, capture_output=True, text=True, check=False)
        assert finished.returncode == 0, finished.stderr
        outcomes.append(finished.stdout.strip())
    assert "False" in outcomes
