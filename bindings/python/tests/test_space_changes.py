# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Edges in space that come and go."""

import copy
import itertools
import pickle
import subprocess
import sys
import threading

import numpy as np
import pytest
from agreement import edge_set
from scipy.spatial import Delaunay
from space_agreement import assert_edges_agree, cloud, edges_of, moved

from dynamic_delaunay import DynamicDelaunay, DynamicDelaunay3D, Population, Population3D, errors, track

IDS = np.random.default_rng(3).choice(10**15, 300, replace=False) - 5 * 10**14


def edges_by_ids(dt):
    return edge_set(dt.ids[dt.edges] if isinstance(dt, Population3D) else dt.edges)


class Followed:
    """The edges as they are by what is told of each call alone."""

    def __init__(self, dt):
        self.dt, self.edges = dt, edges_by_ids(dt)

    def go_on(self):
        created, removed = self.dt.created_edges, self.dt.removed_edges
        assert created.dtype == removed.dtype == (np.int64 if isinstance(self.dt, Population3D) else np.int32)
        assert created.shape[1:] == removed.shape[1:] == (2,)
        created, removed = edge_set(created), edge_set(removed)
        now = edges_by_ids(self.dt)
        assert created == now - self.edges and removed == self.edges - now
        assert len(self.dt.created_edges) == len(created) and len(self.dt.removed_edges) == len(removed)
        self.edges = now


def test_follow_scipy():
    points = cloud(300)
    dt = DynamicDelaunay(points, changes=True)
    assert edge_set(dt.created_edges) == edges_by_ids(dt) and dt.removed_edges.shape == (0, 2)
    edges = edges_of(Delaunay(points).simplices)
    for frame in range(10):
        points = moved(points, 10.0 ** -(1 + frame % 4), frame)
        dt.update(points)
        edges = edges - edge_set(dt.removed_edges) | edge_set(dt.created_edges)
        assert edges == edges_of(Delaunay(points).simplices)


def test_are_none_where_nothing_changes():
    dt = DynamicDelaunay(cloud(100), changes=True)
    for call in (lambda: dt.update(dt.points), lambda: dt.move([], np.empty((0, 3))), lambda: dt.remove([])):
        call()
        assert dt.created_edges.shape == dt.removed_edges.shape == (0, 2)
    created = dt.created_edges
    assert dt.is_current(created) and created is dt.created_edges and not created.flags.writeable
    dt.move(3, (0.5, 0.5, 0.5))
    assert not dt.is_current(created) and len(dt.created_edges) > 0


@pytest.mark.parametrize("grid", [False, True])
def test_of_points_that_move_come_and_go(grid):
    random = np.random.default_rng(4)

    def places(n):  # on the grid many coincide, and lie in planes and on lines
        return random.integers(3, size=(n, 3)).astype(float) if grid else random.random((n, 3))

    dt = DynamicDelaunay3D(changes=True)
    followed = Followed(dt)
    for _ in range(300):
        ids, kind = dt.ids, random.integers(4)
        some = random.choice(ids, random.integers(min(len(ids), 6)), replace=False) if len(ids) else ids
        if kind == 0 and len(ids) < 40:
            dt.insert(places(random.integers(1, 6)))
        elif kind == 1:
            dt.remove(some)
        elif kind == 2:
            dt.move(some, places(len(some)))
        else:
            dt.update(places(dt.number_of_ids) if grid else moved(np.nan_to_num(dt.points), 0.01, len(ids)))
        assert dt.is_valid()
        followed.go_on()


def test_of_a_lattice_follow_its_ties():
    lattice = np.array(list(itertools.product(range(4), repeat=3)), float)
    dt = DynamicDelaunay(lattice, changes=True)
    followed = Followed(dt)
    for frame in range(4):
        for points in (moved(lattice, 0.01, frame), lattice):
            dt.update(points)
            followed.go_on()
        assert_edges_agree(dt)
    lattice[:, 2] = 0
    lattice += np.random.default_rng(1).integers(9, size=lattice.shape) * (1, 1, 0)
    dt.update(lattice)  # now in a plane
    assert dt.dimension == 2
    followed.go_on()
    for change in (lambda: dt.insert((1, 2, 3)), lambda: dt.remove(64)):
        change()
        followed.go_on()


@pytest.mark.parametrize("share", [0.97, 0.3])
def test_of_a_population_by_the_users_ids(share):
    random = np.random.default_rng(1)
    points = random.random((300, 3))
    population = Population3D(changes=True)
    followed = Followed(population)
    removed = 0
    for _ in range(25):
        order = random.permutation(np.flatnonzero(random.random(300) < share))
        points = points + random.normal(0, 0.003, points.shape)
        removed += population.update(IDS[order], points[order]).removed
        followed.go_on()
    assert removed > 30


def test_of_a_population_in_calls_for_some_points():
    random = np.random.default_rng(2)
    population = Population(IDS[:60], cloud(60), changes=True)
    assert type(population) is Population3D
    followed = Followed(population)
    for _ in range(200):
        kind, there = random.integers(3), population.ids
        if kind == 0:
            new = np.setdiff1d(IDS, there)[: random.integers(4)]
            population.insert(new, random.random((len(new), 3)))
        else:
            some = random.choice(there, random.integers(5), replace=False)
            if kind == 1:
                population.remove(some)
            else:
                population.move(some, random.random((len(some), 3)))
        followed.go_on()


def test_of_coincident_points_that_leave_and_come():
    random = np.random.default_rng(1)
    places = np.array(list(itertools.product(range(2), range(2), range(4))), float)
    population = Population3D(changes=True)
    followed = Followed(population)
    for _ in range(100):
        ids = random.choice(30, random.integers(25), replace=False)
        population.update(ids, places[random.integers(len(places), size=len(ids))])
        assert population.is_valid()
        followed.go_on()


def test_of_few_points():
    population = Population3D(changes=True)
    followed = Followed(population)
    for ids in ([], [5], [5, 7], [7, 8, 9], [1, 2, 3, 4], [4, 9], [9], [1, 2, 3, 9, 10], []):
        population.update(np.array(ids, int), np.array([(i, i * i, i**3) for i in ids], float).reshape(-1, 3))
        followed.go_on()


def test_of_calls_that_are_refused_are_none_or_those_of_the_last_one():
    population = Population(IDS[:50], cloud(50), changes=True)
    followed = Followed(population)
    population.update(IDS[10:60], cloud(50, seed=2))
    before = edge_set(population.removed_edges)
    nan = cloud(50)
    nan[7] = np.nan
    for refused in (lambda: population.update(IDS[20:70], nan), lambda: population.update(IDS[[20, 20]], nan[:2]),
                    lambda: population.remove(IDS[[20, 0]]), lambda: population.remove(IDS[[20, 20]]),
                    lambda: population.insert(IDS[20], (0, 0, 0)), lambda: population.restore(b"text")):
        with pytest.raises(errors.DynamicDelaunayError):
            refused()
        assert edge_set(population.removed_edges) in (set(), before)
    followed.edges = edges_by_ids(population)
    population.remove(IDS[20:30])
    followed.go_on()


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy])
def test_copies_record_for_themselves(duplicate):
    points = cloud(100)
    population = Population(IDS[:100], points, changes=True)
    population.update(IDS[20:100], points[20:])
    twin = duplicate(population)
    assert np.array_equal(twin.removed_edges, population.removed_edges) and len(twin.removed_edges) > 0
    followed = Followed(twin)
    twin.update(IDS[:90], moved(points, 0.02)[:90])
    followed.go_on()
    assert not np.array_equal(twin.removed_edges, population.removed_edges)


def test_of_what_is_restored():
    for dt, change in (
        (DynamicDelaunay(cloud(60), changes=True), lambda dt: dt.update(cloud(60, seed=2))),
        (Population(IDS[:60], cloud(60), changes=True), lambda dt: dt.update(IDS[30:90], cloud(60, seed=2))),
    ):
        checkpoint = dt.checkpoint()
        change(dt)
        followed = Followed(dt)
        dt.restore(checkpoint)
        followed.go_on()
        twin = pickle.loads(pickle.dumps(dt))
        followed = Followed(twin)
        assert edge_set(twin.created_edges) == edges_by_ids(twin)
        change(twin)
        followed.go_on()


def test_are_there_only_if_asked_for():
    for dt in (DynamicDelaunay(cloud(9)), Population(np.arange(9), cloud(9))):
        kind = type(dt).__name__
        for refused in (lambda: dt.created_edges, lambda: dt.removed_edges):
            with pytest.raises(errors.NotRecordedError, match=rf"only with changes=True, as by {kind}\("):
                refused()
        assert not hasattr(dt, "created_edges")
    for wrong in (1, "yes", None):
        with pytest.raises(errors.InputTypeError, match="it must be True or False"):
            DynamicDelaunay(cloud(9), changes=wrong)
    (frame,) = track([cloud(30)], changes=True)
    assert edge_set(frame.triangulation.created_edges) == edges_by_ids(frame.triangulation)


def test_do_not_depend_on_threads():
    points = cloud(3000)
    alone, together = (DynamicDelaunay(points, changes=True, threads=threads) for threads in (1, 0))
    for frame in range(3):
        points = moved(points, 0.002, frame)
        alone.update(points)
        together.update(points)
        assert np.array_equal(alone.created_edges, together.created_edges) and len(alone.created_edges) > 0
        assert np.array_equal(alone.removed_edges, together.removed_edges)


def test_are_read_while_other_threads_change_points():
    points = cloud(500)
    dt = DynamicDelaunay(points, changes=True)
    failures, is_over = [], threading.Event()

    def ask():
        try:
            while not is_over.is_set():
                assert dt.created_edges.shape[1] == dt.removed_edges.shape[1] == 2
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=ask) for _ in range(3)]
    for thread in threads:
        thread.start()
    for frame in range(50):
        dt.update(moved(points, 0.01, frame))
    is_over.set()
    for thread in threads:
        thread.join()
    assert not failures and dt.is_valid()


WITHOUT_MEMORY = """
import resource
import sys
import numpy as np
from dynamic_delaunay import Population, errors
random = np.random.default_rng(1)

def numbers(edges):  # one for each edge
    return np.unique(np.sort(edges) @ (10**6, 1))

def edges():
    return numbers(population.ids[population.edges])

def assert_is_told(before):
    now = edges()
    assert np.array_equal(numbers(population.created_edges), np.setdiff1d(now, before))
    assert np.array_equal(numbers(population.removed_edges), np.setdiff1d(before, now))

ids, points = np.arange(1000), random.random((1000, 3))
population = Population(ids, points, changes=True)
before = edges()
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
many = np.arange(500, 100_000), random.random((99_500, 3))
unlimited = resource.getrlimit(resource.RLIMIT_AS)
resource.setrlimit(resource.RLIMIT_AS, (used + (int(sys.argv[1]) << 20), unlimited[1]))
has_failed = False
try:
    population.update(*many)
except MemoryError:
    has_failed = True
resource.setrlimit(resource.RLIMIT_AS, unlimited)
was_certified = population.is_certified
assert population.certify() == was_certified
if not was_certified:
    for refused in (lambda: population.created_edges, lambda: population.nearest((0, 0, 0)),
                    lambda: population.within((0, 0, 0), 1)):
        try:
            refused()
        except errors.UncertifiedTriangulationError as error:
            assert "call mend()" in str(error) and not hasattr(population, "removed_edges")
        else:
            raise AssertionError("no cells, but answers")
    assert population.mend().rebuilt and 0 not in population
    assert_is_told(before)
elif has_failed:  # all was taken back, or the triangulation is new, but not all was told
    is_new = 0 not in population
    assert hasattr(population, "created_edges") == (not is_new)
    population.mend()
    if not is_new or len(population.created_edges) > 0:
        assert_is_told(before)
else:
    assert_is_told(before)
assert population.certify()
before = edges()
population.update(ids, points)
assert_is_told(before)
print(was_certified)
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="memory is limited as Linux does it")
def test_are_told_in_the_end_after_memory_was_exhausted():
    outcomes = []
    for megabytes in (2, 30, 40, 90):  # at some of these while cells are made, at some while changes are told
        command = [sys.executable, "-c", WITHOUT_MEMORY, str(megabytes)]
        finished = subprocess.run(command, capture_output=True, text=True, check=False)
        assert finished.returncode == 0, finished.stderr
        outcomes.append(finished.stdout.strip())
    assert "False" in outcomes
