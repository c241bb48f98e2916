# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Edges in periodic space of three dimensions that come and go."""

import copy
import itertools
import pickle
import subprocess
import sys

import numpy as np
import pytest

from dynamic_delaunay import (
    PeriodicDelaunay,
    PeriodicDelaunay3D,
    PeriodicPopulation,
    PeriodicPopulation3D,
    errors,
    track,
)

CELL = np.array([(1.0, 0.1, 0.0), (0.3, 0.9, 0.1), (-0.2, 0.1, 1.1)])
IDS = np.random.default_rng(3).choice(10**15, 100, replace=False) - 5 * 10**14
SAME = np.eye(3, dtype=int)
FLIPS = [SAME, np.array([(1, 0, 0), (1, 1, 0), (0, -1, 1)]), np.array([(0, 1, 0), (0, 0, 1), (1, 0, 0)]),
         np.array([(1, 0, 0), (0, 1, 0), (-1, 2, 1)]), np.array([(-1, 0, 0), (0, -1, 0), (3, 0, 1)])]


def cloud(n, cell=CELL, seed=1):
    return np.random.default_rng(seed).random((n, 3)) @ cell


def images(edges, shifts):
    """Edges as (i, j, shift), seen from both ends."""
    found = set()
    for (i, j), shift in zip(edges.tolist(), shifts.tolist()):
        found |= {(i, j, tuple(shift)), (j, i, tuple(-number for number in shift))}
    assert len(found) == 2 * len(edges)
    return found


def edges_by_ids(dt):
    return images(dt.ids[dt.edges] if isinstance(dt, PeriodicPopulation3D) else dt.edges, dt.edge_shifts)


def created(dt):
    return images(dt.created_edges, dt.created_edge_shifts)


def removed(dt):
    return images(dt.removed_edges, dt.removed_edge_shifts)


class Followed:
    """The edges as they are by what is told of each call alone."""

    def __init__(self, dt):
        self.dt, self.edges = dt, edges_by_ids(dt)

    def go_on(self, ways=None, flip=SAME):
        """After points went by these ways besides, in vectors of the cell, which are these multiples of the former
        ones."""
        ways, now = ways or {}, edges_by_ids(self.dt)
        by_flip = np.rint(np.linalg.inv(flip)).astype(int)
        none = np.zeros(3, int)
        former = {(i, j, tuple((np.array(shift) @ by_flip + ways.get(i, none) - ways.get(j, none)).tolist()))
                  for i, j, shift in self.edges}
        kind = np.int64 if isinstance(self.dt, PeriodicPopulation3D) else np.int32
        for edges, shifts in ((self.dt.created_edges, self.dt.created_edge_shifts),
                              (self.dt.removed_edges, self.dt.removed_edge_shifts)):
            assert edges.dtype == kind and shifts.dtype == np.int32 and shifts.shape == (len(edges), 3)
        assert created(self.dt) == now - former and removed(self.dt) == former - now
        assert former - removed(self.dt) | created(self.dt) == now
        self.edges = now


def flip_of(frame):
    """Other vectors of the same lattice, and in the next frame the former ones again."""
    flip = FLIPS[frame // 2 % len(FLIPS)]
    return flip if frame % 2 == 0 else np.rint(np.linalg.inv(flip)).astype(int)


def test_follow_points_that_are_wrapped_and_cells_that_are_flipped():
    random = np.random.default_rng(1)
    points, cell = cloud(60), CELL
    dt = PeriodicDelaunay(points, cell, changes=True)
    assert created(dt) == edges_by_ids(dt) and dt.removed_edges.shape == (0, 2)
    followed, changes = Followed(dt), 0
    for frame in range(20):
        flip = flip_of(frame)
        cell = flip @ cell + (0, 0.002, 0.005)
        ways = random.integers(-2, 3, points.shape) * (random.random((60, 1)) < 0.3)
        points = points + random.normal(0, 0.01, points.shape) + ways @ cell
        dt.update(points, cell)
        followed.go_on(dict(enumerate(ways)), flip)
        changes += len(dt.created_edges)
    assert changes > 50 and dt.is_valid()


def test_are_none_where_points_are_only_wrapped_or_the_cell_is_flipped():
    points = cloud(50)
    dt = PeriodicDelaunay(points, CELL, changes=True)
    ways = np.random.default_rng(1).integers(-3, 4, points.shape)
    for call in (lambda: dt.update(dt.points), lambda: dt.update(points + ways @ CELL), lambda: dt.update(points),
                 lambda: dt.update(points, FLIPS[1] @ CELL), lambda: dt.update(points + ways @ CELL, CELL),
                 lambda: dt.move([], np.empty((0, 3))), lambda: dt.remove([])):
        call()
        assert dt.created_edges.shape == dt.removed_edges.shape == (0, 2)
        assert dt.created_edge_shifts.shape == dt.removed_edge_shifts.shape == (0, 3)
    created_edges = dt.created_edges
    assert dt.is_current(created_edges) and created_edges is dt.created_edges and not created_edges.flags.writeable
    dt.move(3, dt.points[3] + 0.3)
    assert not dt.is_current(created_edges) and len(dt.created_edges) > 0


@pytest.mark.parametrize("grid", [False, True])
def test_of_points_that_move_come_and_go(grid):
    random = np.random.default_rng(4)

    def places(n):  # no way between them is longer than that around the cell; on the grid many coincide
        return random.integers(3, size=(n, 3)) * 0.2 if grid else random.random((n, 3)) * 0.49

    dt = PeriodicDelaunay3D(changes=True)
    followed = Followed(dt)
    for _ in range(150):
        ids, kind = dt.ids, random.integers(4)
        some = random.choice(ids, random.integers(min(len(ids), 6)), replace=False) if len(ids) else ids
        if kind == 0 and len(ids) < 30:
            dt.insert(places(random.integers(1, 6)))
        elif kind == 1:
            dt.remove(some)
        elif kind == 2:
            dt.move(some, places(len(some)))
        else:
            dt.update(places(dt.number_of_ids) if grid else np.nan_to_num(dt.points) * 0.99)
        followed.go_on()
    assert dt.is_valid()


def test_of_a_lattice_follow_its_ties():
    lattice = np.array(list(itertools.product(range(4), repeat=3)), float)
    dt = PeriodicDelaunay(lattice, (4, 4, 4), changes=True)
    followed = Followed(dt)
    for frame in range(3):
        for points in (lattice + np.random.default_rng(frame).normal(0, 0.01, lattice.shape), lattice):
            dt.update(points)
            followed.go_on()
    assert dt.is_valid()


@pytest.mark.parametrize("share", [0.95, 0.3])
def test_of_a_population_by_the_users_ids(share):
    random = np.random.default_rng(1)
    points, cell = cloud(100), CELL
    population = PeriodicPopulation(cell=cell, changes=True)
    followed, gone = Followed(population), 0
    for frame in range(20):
        flip = flip_of(frame)
        cell = flip @ cell
        ways = random.integers(-2, 3, points.shape) * (random.random((100, 1)) < 0.3)
        points = points + random.normal(0, 0.003, points.shape) + ways @ cell
        order = random.permutation(np.flatnonzero(random.random(100) < share))
        gone += population.update(IDS[order], points[order], cell).removed
        followed.go_on({IDS[k]: ways[k] for k in order}, flip)
    assert gone > 30 and population.is_valid()


def test_of_a_population_in_calls_for_some_points():
    random = np.random.default_rng(2)
    population = PeriodicPopulation(IDS[:30], random.random((30, 3)) * 0.49, changes=True)
    assert type(population) is PeriodicPopulation3D
    followed = Followed(population)
    for _ in range(100):
        kind, there = random.integers(3), population.ids
        if kind == 0:
            new = np.setdiff1d(IDS, there)[: random.integers(4)]
            population.insert(new, random.random((len(new), 3)) * 0.49)
        else:
            some = random.choice(there, random.integers(min(5, len(there) + 1)), replace=False)
            if kind == 1:
                population.remove(some)
            else:
                population.move(some, random.random((len(some), 3)) * 0.49)
        followed.go_on()


def test_of_coincident_points_that_leave_and_come():
    random = np.random.default_rng(1)
    places = np.array(list(itertools.product((0.0, 0.2), (0.1, 0.3), (0.0, 0.1, 0.2))))
    population = PeriodicPopulation3D(changes=True)
    followed = Followed(population)
    for _ in range(50):
        ids = random.choice(30, random.integers(25), replace=False)
        population.update(ids, places[random.integers(len(places), size=len(ids))])
        assert population.is_valid()
        followed.go_on()


def test_of_few_points():
    population = PeriodicPopulation3D(changes=True)
    followed = Followed(population)
    for ids in ([], [5], [5, 7], [7, 8, 9], [1, 2, 3, 4], [4, 9], [9], [1, 2, 3, 9, 10], []):
        population.update(np.array(ids, int), np.array([(i, i * i, i**3) for i in ids], float).reshape(-1, 3) / 7000)
        followed.go_on()


def test_of_calls_that_are_refused_are_none_or_those_of_the_last_one():
    population = PeriodicPopulation(IDS[:50], cloud(50), CELL, changes=True)
    population.update(IDS[10:60], cloud(50, seed=2))
    before = removed(population)
    nan = cloud(50)
    nan[7] = np.nan
    for refused in (lambda: population.update(IDS[20:70], nan), lambda: population.update(IDS[[20, 20]], nan[:2]),
                    lambda: population.update(IDS[20:70], cloud(50), (1, 1, 0)),
                    lambda: population.remove(IDS[[20, 0]]), lambda: population.remove(IDS[[20, 20]]),
                    lambda: population.insert(IDS[20], (0, 0, 0)), lambda: population.restore(b"text")):
        with pytest.raises(errors.DynamicDelaunayError):
            refused()
        assert removed(population) in (set(), before)
    followed = Followed(population)
    population.remove(IDS[20:30])
    followed.go_on()


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy])
def test_copies_record_for_themselves(duplicate):
    points = cloud(60)
    population = PeriodicPopulation(IDS[:60], points, CELL, changes=True)
    population.update(IDS[20:60], points[20:])
    twin = duplicate(population)
    assert removed(twin) == removed(population) and len(twin.removed_edges) > 0
    followed = Followed(twin)
    twin.update(IDS[:50], points[:50])
    followed.go_on()
    assert removed(twin) != removed(population)


def test_of_what_is_restored():
    points = cloud(40)
    other = points + np.random.default_rng(2).normal(0, 0.03, points.shape)
    for dt, change in (
        (PeriodicDelaunay(points, CELL, changes=True), lambda dt: dt.update(other)),
        (PeriodicPopulation(IDS[:40], points, CELL, changes=True),
         lambda dt: dt.update(IDS[30:70], [*other[30:], *cloud(30, seed=3)])),
    ):
        checkpoint = dt.checkpoint()
        change(dt)
        followed = Followed(dt)
        dt.restore(checkpoint)
        followed.go_on()
        twin = pickle.loads(pickle.dumps(dt))
        followed = Followed(twin)
        assert created(twin) == edges_by_ids(twin)
        change(twin)
        followed.go_on()


def test_are_there_only_if_asked_for():
    for dt in (PeriodicDelaunay(cloud(9), CELL), PeriodicPopulation(np.arange(9), cloud(9), CELL)):
        kind = type(dt).__name__
        for name in ("created_edges", "removed_edges", "created_edge_shifts", "removed_edge_shifts"):
            with pytest.raises(errors.NotRecordedError, match=rf"only with changes=True, as by {kind}\("):
                getattr(dt, name)
            assert not hasattr(dt, name)
    for wrong in (1, "yes", None):
        with pytest.raises(errors.InputTypeError, match="it must be True or False"):
            PeriodicDelaunay(cloud(9), CELL, changes=wrong)
    (frame,) = track([cloud(30)], CELL, changes=True)
    assert created(frame.triangulation) == edges_by_ids(frame.triangulation)


def test_do_not_depend_on_threads():
    points = cloud(2000)
    alone, together = (PeriodicDelaunay(points, CELL, changes=True, threads=threads) for threads in (1, 0))
    for frame in range(3):
        points = points + np.random.default_rng(frame).normal(0, 0.002, points.shape)
        alone.update(points)
        together.update(points)
        assert created(alone) == created(together) and removed(alone) == removed(together)
        assert len(alone.created_edges) > 0


WITHOUT_MEMORY = """
import resource
import sys
import numpy as np
from dynamic_delaunay import PeriodicPopulation, errors
random = np.random.default_rng(1)

def rows(edges, shifts):  # one for each edge, from the smaller id
    turned = edges[:, :1] > edges[:, 1:]
    edges, shifts = np.where(turned, edges[:, ::-1], edges), np.where(turned, -shifts, shifts)
    return set(map(tuple, np.hstack([edges, shifts]).tolist()))

def edges():
    return rows(population.ids[population.edges], population.edge_shifts)

def assert_is_told(before):
    now = edges()
    assert rows(population.created_edges, population.created_edge_shifts) == now - before
    assert rows(population.removed_edges, population.removed_edge_shifts) == before - now

ids, points = np.arange(1000), random.random((1000, 3)) * 0.49
population = PeriodicPopulation(ids, points, changes=True)
before = edges()
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
many = np.arange(500, 20_000), random.random((19_500, 3)) * 0.49
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
    for refused in (lambda: population.created_edges, lambda: population.removed_edge_shifts,
                    lambda: population.nearest((0, 0, 0)), lambda: population.within((0, 0, 0), 1)):
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
print(was_certified, has_failed)
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="memory is limited as Linux does it")
def test_are_told_in_the_end_after_memory_was_exhausted():
    outcomes = []
    for megabytes in (2, 10, 20, 30):  # at some of these while cells are made, at some while changes are told
        command = [sys.executable, "-c", WITHOUT_MEMORY, str(megabytes)]
        finished = subprocess.run(command, capture_output=True, text=True, check=False)
        assert finished.returncode == 0, finished.stderr
        outcomes.append(finished.stdout.split()[0])
    assert "False" in outcomes
