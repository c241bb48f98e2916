# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Points in space that come and go."""

import copy
import pickle

import numpy as np
import pytest
from scipy.spatial import Delaunay
from space_agreement import assert_fits_together, cells, cloud, moved

from dynamic_delaunay import (
    DynamicDelaunay,
    PeriodicPopulation,
    Population,
    Population3D,
    UpdateReport3D,
    errors,
    track,
)

IDS = np.random.default_rng(3).choice(10**15, 300, replace=False) - 5 * 10**14


def assert_is_crowd(population, ids, points):
    """In general position; ids and points in any order."""
    assert population.is_certified and population.is_valid() and len(population) == len(ids)
    assert dict(zip(population.ids.tolist(), population.points.tolist())) == dict(zip(ids.tolist(), points.tolist()))
    assert population.points.shape == (len(ids), 3)
    assert_fits_together(population)
    if len(ids) > 4:
        assert cells(population.simplices) == cells(Delaunay(population.points).simplices)


def test_becomes_what_its_points_are():
    points = cloud(100)
    for population in (Population(IDS[:100], points), Population(ids=IDS[:100], points=points),
                       Population(IDS[:100], points=points.tolist(), threads=2)):
        assert type(population) is Population3D
        assert repr(population) == "<Population3D of 100 points, certified>"
    for population in (Population(), Population(IDS[:100], points[:, :2]), Population([], [])):
        assert type(population) is Population

    class Derived(Population):
        pass

    class DerivedPeriodic(PeriodicPopulation):
        pass

    for refused in (Derived, DerivedPeriodic):
        with pytest.raises(errors.InputValueError, match=r"\(100, 3\): it must be \(n, 2\)"):
            refused(IDS[:100], points)
    with pytest.raises(TypeError, match="Population3D.*'classifier'"):
        Population(IDS[:100], points, classifier="circumcircle")


@pytest.mark.parametrize("seed", range(3))
def test_follows_points_that_come_and_go(seed):
    random = np.random.default_rng(seed)
    points = random.random((300, 3))
    population = Population3D()
    removed = 0
    for _ in range(20):
        order = random.permutation(np.flatnonzero(random.random(300) < 0.9))
        points = points + random.normal(0, 10.0 ** random.integers(-4, -1), points.shape)
        before = len(population)
        report = population.update(IDS[order], points[order])
        assert isinstance(report, UpdateReport3D) and report == population.last_report
        assert before + report.inserted - report.removed == len(order)
        assert_is_crowd(population, IDS[order], points[order])
        removed += report.removed
    assert removed > 0
    box = population.voronoi_cells((-9, -9, -9, 9, 9, 9))
    assert box.volumes.sum() == pytest.approx(18**3) and len(box.indptr) == len(population) + 1
    for row in range(len(population)):
        assert set(box.neighbors[box.indptr[row] : box.indptr[row + 1]]) <= set(population.neighbors_of(row))
    assert population.is_current(population.simplices)


def test_measures_cells_as_a_triangulation_without_gaps():
    points = cloud(200)
    population = Population(IDS[:200], points)
    population.remove(IDS[20:60])
    points = np.concatenate([points[:20], points[60:]])
    expected = DynamicDelaunay(points)
    assert population.ids.tolist() == [*IDS[:20], *IDS[60:200]]
    assert population.volumes().sum() == pytest.approx(expected.volumes().sum())
    for box in (None, (0, 0, 0, 1, 1, 1)):
        for ours, theirs in zip(population.voronoi_cells(box), expected.voronoi_cells(box)):
            assert ours.dtype == theirs.dtype and np.allclose(ours, theirs, rtol=1e-9, atol=1e-12)


def test_inserts_removes_and_moves_by_the_users_ids():
    points = cloud(20)
    population = Population(IDS[:10], points[:10])
    assert population.insert(IDS[10], points[10]) is None
    population.insert(IDS[11:15], points[11:15])
    assert population.last_report.inserted == 4
    assert IDS[14] in population and IDS[15] not in population and 0 not in population and "x" not in population
    assert population.remove(IDS[0]).removed == 1
    assert population.remove(IDS[[5, 3]]).removed == 2
    points[[1, 7, 2]] = points[[15, 16, 17]]
    population.move(IDS[1], points[1])
    assert population.move(IDS[[7, 2]], points[[7, 2]]).certified
    stay = np.setdiff1d(np.arange(15), [0, 3, 5])
    assert_is_crowd(population, IDS[stay], points[stay])


def test_knows_points_that_coincide():
    points = cloud(30)
    points[[4, 9]] = points[20]
    population = Population(IDS[:30], points)
    population.remove(IDS[2])
    assert population.number_of_vertices == 27 and len(population) == 29
    pairs = population.ids[population.duplicates]
    assert set(pairs.ravel()) == set(IDS[[4, 9, 20]]) and len(pairs) == 2
    assert_fits_together(population)
    population.remove(pairs[0, 1])
    assert len(population.duplicates) == 1
    assert_fits_together(population)


@pytest.mark.parametrize("points", [np.empty((0, 3)), [(1, 2, 3)], [(0, 0, 0), (1, 1, 1)],
                                    [(0, 0, 5), (1, 0, 5), (0, 1, 5), (1, 1.5, 5)]])
def test_takes_frames_of_any_size(points):
    population = Population(IDS[: len(points)], points)
    assert population.ids.tolist() == list(IDS[: len(points)]) and len(population.simplices) == 0
    assert_fits_together(population)
    for others in (cloud(50), np.empty((0, 3)), cloud(1), cloud(30, seed=4)):
        population.update(IDS[: len(others)], others)
        assert_is_crowd(population, IDS[: len(others)], others)


def test_refuses_wrong_input_before_anything_changes():
    points = cloud(20)
    population = Population(IDS[:20], points)
    checkpoint = population.checkpoint()
    nan = points.copy()
    nan[4, 2] = np.nan
    a, b, c = IDS[:3].tolist()
    for call, kind, text in (
        (lambda: population.update(IDS[:20], points[:, :2]), errors.InputValueError, r"\(20, 2\): it must be \(n, 3\)"),
        (lambda: population.update(IDS[:19], points), errors.InputValueError, "19 ids and 20 points"),
        (lambda: population.update(IDS[[0, 0]], points[:2]), errors.RepeatedIdError, str(a)),
        (lambda: population.update(IDS[:20], nan), errors.NonFiniteCoordinateError, "point 4 has the coordinates"),
        (lambda: population.insert(a, points[0]), errors.RepeatedIdError, str(a)),
        (lambda: population.insert([7, 7], points[:2]), errors.RepeatedIdError, "7"),
        (lambda: population.insert([7, 8], nan[3:5]), errors.NonFiniteCoordinateError, "point 1 has"),
        (lambda: population.insert([7, 8], points[0]), errors.InputValueError, "2 ids and 1 points"),
        (lambda: population.remove([b, 7]), errors.UnknownIdError, "7"),
        (lambda: population.remove([b, b]), errors.RepeatedIdError, str(b)),
        (lambda: population.remove(0.5), errors.InputTypeError, "integers are needed"),
        (lambda: population.move([b, -7], points[:2]), errors.UnknownIdError, "-7"),
        (lambda: population.move([c, c], points[:2]), errors.RepeatedIdError, str(c)),
        (lambda: population.move([b, c], nan[[3, 4]]), errors.NonFiniteCoordinateError, "point 1 has"),
        (lambda: Population3D(IDS[:20]), errors.InputTypeError, "there are no points"),
        (lambda: Population3D(points=points), errors.InputTypeError, "there are no ids"),
        (lambda: Population3D(threads=-1), errors.InputValueError, "threads is -1"),
        (lambda: population.__init__(), errors.UseError, "initialized once"),
    ):
        with pytest.raises(kind, match=text):
            call()
        assert population.checkpoint() == checkpoint
    with pytest.raises(errors.UnknownIdError) as refused:
        population.remove(-7)
    assert refused.value.id == -7


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy, lambda it: pickle.loads(pickle.dumps(it))])
def test_copies_go_on_alike(duplicate):
    points = cloud(200)
    population = Population(IDS[:200], points, threads=2)
    population.note = ["note"]
    population.update(IDS[50:200], points[50:])
    twin = duplicate(population)
    assert type(twin) is Population3D and twin.note == ["note"]
    for frame in range(5):
        points = moved(points, 0.003, frame)
        there = np.random.default_rng(frame).permutation(200)[:150]
        assert population.update(IDS[there], points[there]) == twin.update(IDS[there], points[there])
        for name in ("ids", "points", "simplices", "neighbors"):
            assert np.array_equal(getattr(population, name), getattr(twin, name))
    twin.remove(IDS[there[0]])
    assert IDS[there[0]] in population and population.is_valid() and twin.is_valid()


def test_saves_and_loads(tmp_path):
    population = Population(IDS[:60], cloud(60))
    population.remove(IDS[:20])
    population.save(tmp_path / "checkpoint")
    other = Population3D([5], [(1, 2, 3)])
    other.load(tmp_path / "checkpoint")
    assert np.array_equal(other.ids, IDS[20:60]) and np.array_equal(other.simplices, population.simplices)
    assert 5 not in other
    for wrong in (DynamicDelaunay(cloud(9)).checkpoint(), Population([1], [(0, 0)]).checkpoint(), b"text"):
        with pytest.raises(errors.CheckpointError):
            other.restore(wrong)
    assert other.checkpoint() == population.checkpoint()


def test_is_tracked_with_births_and_deaths():
    trajectory = cloud(100) + np.cumsum(np.random.default_rng(2).normal(0, 0.003, (20, 100, 3)), axis=0)
    pairs = [(IDS[n:80 + n], points[n:80 + n]) for n, points in enumerate(trajectory)]
    for frame, (ids, points) in zip(track(iter(pairs), threads=1), pairs):
        assert type(frame.triangulation) is Population3D and frame.report.certified
        assert_is_crowd(frame.triangulation, ids, points)
        assert (frame.report.inserted, frame.report.removed) == ((1, 1) if frame.number else (80, 0))
    named = [([str(id) for id in ids], points) for ids, points in pairs[:3]]
    for frame, (ids, points) in zip(track(named), named):
        assert sorted(frame.ids) == sorted(ids)
        assert dict(zip(frame.ids, frame.triangulation.points.tolist())) == dict(zip(ids, points.tolist()))
    with pytest.raises(errors.NonFiniteCoordinateError, match=r"^frame 1, id 7: point 1 has"):
        list(track([([1, 7], [(0, 0, 0), (1, 1, 1)]), ([1, 7], [(0, 0, 0), (1, 1, np.inf)])]))
    with pytest.raises(errors.InputValueError, match=r"^frame 1: .*it must be \(n, 3\)"):
        list(track([pairs[0], (IDS[:9], cloud(9)[:, :2])]))
