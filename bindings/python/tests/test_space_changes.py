# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Edges that come and go in space, open and periodic."""

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

from dynamic_delaunay import (
    DynamicDelaunay,
    DynamicDelaunay3D,
    PeriodicDelaunay,
    PeriodicDelaunay3D,
    PeriodicPopulation,
    PeriodicPopulation3D,
    Population,
    Population3D,
    errors,
    track,
)

IDS = np.random.default_rng(3).choice(10**15, 300, replace=False) - 5 * 10**14
CELL = np.array([(1.0, 0.1, 0.0), (0.3, 0.9, 0.1), (-0.2, 0.1, 1.1)])
SAME = np.eye(3, dtype=int)
FLIPS = [SAME, np.array([(1, 0, 0), (1, 1, 0), (0, -1, 1)]), np.array([(0, 1, 0), (0, 0, 1), (1, 0, 0)]),
         np.array([(1, 0, 0), (0, 1, 0), (-1, 2, 1)]), np.array([(-1, 0, 0), (0, -1, 0), (3, 0, 1)])]


class Open:
    cell, near = (), 1.0
    triangulation_type, population_type = DynamicDelaunay3D, Population3D
    names_of_edges = "created_edges", "removed_edges"

    @staticmethod
    def triangulation(points, **options):
        return DynamicDelaunay(points, **options)

    @staticmethod
    def population(ids, points, **options):
        return Population(ids, points, **options)

    @staticmethod
    def cloud(n, seed=1):
        return cloud(n, seed)


class Periodic:
    # No way between points that are nearer than this is longer than that around a cell with vectors of length 1.
    cell, near = (CELL,), 0.4
    triangulation_type, population_type = PeriodicDelaunay3D, PeriodicPopulation3D
    names_of_edges = "created_edges", "removed_edges", "created_edge_shifts", "removed_edge_shifts"

    @staticmethod
    def triangulation(points, cell=CELL, **options):
        return PeriodicDelaunay(points, cell, **options)

    @staticmethod
    def population(ids, points, cell=CELL, **options):
        return PeriodicPopulation(ids, points, cell, **options)

    @staticmethod
    def cloud(n, seed=1):
        return cloud(n, seed) @ CELL


SPACES = pytest.mark.parametrize("space", [Open, Periodic])


def is_periodic(dt):
    return isinstance(dt, (PeriodicDelaunay3D, PeriodicPopulation3D))


def is_population(dt):
    return isinstance(dt, (Population3D, PeriodicPopulation3D))


def images(dt, edges, shifts):
    """Edges as (i, j, shift), seen from both ends. In open space shifts have no numbers."""
    shifts = getattr(dt, shifts) if is_periodic(dt) else np.empty((len(edges), 0), int)
    assert len(shifts) == len(edges)
    found = set()
    for (i, j), shift in zip(edges.tolist(), shifts.tolist()):
        found |= {(i, j, tuple(shift)), (j, i, tuple(-number for number in shift))}
    assert len(found) == 2 * len(edges)
    return found


def present(dt):
    return images(dt, dt.ids[dt.edges] if is_population(dt) else dt.edges, "edge_shifts")


def created(dt):
    return images(dt, dt.created_edges, "created_edge_shifts")


def removed(dt):
    return images(dt, dt.removed_edges, "removed_edge_shifts")


class Followed:
    """The edges as they are by what is told of each call alone."""

    def __init__(self, dt):
        self.dt, self.edges = dt, present(dt)

    def by_other_vectors(self, ways, flip):
        """The former edges, if points go by these ways besides, in vectors that are these multiples of the former."""
        back, none = np.rint(np.linalg.inv(flip)).astype(int), np.zeros(3, int)
        return {(i, j, tuple((np.array(shift) @ back + ways.get(i, none) - ways.get(j, none)).tolist()))
                for i, j, shift in self.edges}

    def go_on(self, ways=None, flip=SAME):
        dt, now = self.dt, present(self.dt)
        former = self.by_other_vectors(ways or {}, flip) if is_periodic(dt) else self.edges
        for edges in (dt.created_edges, dt.removed_edges):
            assert edges.dtype == (np.int64 if is_population(dt) else np.int32) and edges.shape[1:] == (2,)
        if is_periodic(dt):
            for shifts in (dt.created_edge_shifts, dt.removed_edge_shifts):
                assert shifts.dtype == np.int32 and shifts.shape[1:] == (3,)
        assert created(dt) == now - former and removed(dt) == former - now
        self.edges = now


def flip_of(frame):
    """Other vectors of the same lattice, and in the next frame the former ones again."""
    flip = FLIPS[frame // 2 % len(FLIPS)]
    return flip if frame % 2 == 0 else np.rint(np.linalg.inv(flip)).astype(int)


def test_follow_scipy():
    points = cloud(300)
    dt = DynamicDelaunay(points, changes=True)
    assert created(dt) == present(dt) and dt.removed_edges.shape == (0, 2)
    edges = edges_of(Delaunay(points).simplices)
    for frame in range(10):
        points = moved(points, 10.0 ** -(1 + frame % 4), frame)
        dt.update(points)
        edges = edges - edge_set(dt.removed_edges) | edge_set(dt.created_edges)
        assert edges == edges_of(Delaunay(points).simplices)


def test_follow_points_that_are_wrapped_and_cells_that_are_flipped():
    random = np.random.default_rng(1)
    points, cell = Periodic.cloud(60), CELL
    dt = PeriodicDelaunay(points, cell, changes=True)
    assert created(dt) == present(dt) and dt.removed_edges.shape == (0, 2)
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


@SPACES
def test_are_none_where_nothing_changes(space):
    points = space.cloud(100)
    dt = space.triangulation(points, changes=True)
    calls = [lambda: dt.update(dt.points), lambda: dt.move([], np.empty((0, 3))), lambda: dt.remove([])]
    if space is Periodic:
        wrapped = points + np.random.default_rng(1).integers(-3, 4, points.shape) @ CELL
        calls += [lambda: dt.update(wrapped), lambda: dt.update(points), lambda: dt.update(points, FLIPS[1] @ CELL),
                  lambda: dt.update(wrapped, CELL)]
    for call in calls:
        call()
        assert dt.created_edges.shape == dt.removed_edges.shape == (0, 2)
        if space is Periodic:
            assert dt.created_edge_shifts.shape == dt.removed_edge_shifts.shape == (0, 3)
    edges = dt.created_edges
    assert dt.is_current(edges) and edges is dt.created_edges and not edges.flags.writeable
    dt.move(3, dt.points[3] + 0.3)
    assert not dt.is_current(edges) and len(dt.created_edges) > 0


@SPACES
@pytest.mark.parametrize("grid", [False, True])
def test_of_points_that_move_come_and_go(space, grid):
    random = np.random.default_rng(4)

    def places(n):  # on the grid many coincide, and lie in planes and on lines
        return random.integers(3, size=(n, 3)) * 0.2 if grid else random.random((n, 3)) * space.near

    dt = space.triangulation_type(changes=True)
    followed = Followed(dt)
    for _ in range(300 if space is Open else 150):
        ids, kind = dt.ids, random.integers(4)
        some = random.choice(ids, random.integers(min(len(ids), 6)), replace=False) if len(ids) else ids
        if kind == 0 and len(ids) < 30:
            dt.insert(places(random.integers(1, 6)))
        elif kind == 1:
            dt.remove(some)
        elif kind == 2:
            dt.move(some, places(len(some)))
        else:
            dt.update(places(dt.number_of_ids) if grid else moved(np.nan_to_num(dt.points), 0.01, len(ids)))
        assert dt.is_valid()
        followed.go_on()


@SPACES
def test_of_a_lattice_follow_its_ties(space):
    lattice = np.array(list(itertools.product(range(4), repeat=3)), float)
    dt = space.triangulation(lattice, changes=True, **({} if space is Open else {"cell": (4, 4, 4)}))
    followed = Followed(dt)
    for frame in range(4):
        for points in (moved(lattice, 0.01, frame), lattice):
            dt.update(points)
            followed.go_on()
        if space is Open:
            assert_edges_agree(dt)
    assert dt.is_valid()


def test_of_a_lattice_that_becomes_flat():
    lattice = np.array(list(itertools.product(range(4), repeat=3)), float)
    dt = DynamicDelaunay(lattice, changes=True)
    followed = Followed(dt)
    lattice[:, 2] = 0
    lattice += np.random.default_rng(1).integers(9, size=lattice.shape) * (1, 1, 0)
    dt.update(lattice)
    assert dt.dimension == 2
    followed.go_on()
    for change in (lambda: dt.insert((1, 2, 3)), lambda: dt.remove(64)):
        change()
        followed.go_on()


@SPACES
@pytest.mark.parametrize("share", [0.97, 0.3])
def test_of_a_population_by_the_users_ids(space, share):
    random = np.random.default_rng(1)
    points, cell = space.cloud(100), CELL
    population = space.population([], np.empty((0, 3)), changes=True)
    assert type(population) is space.population_type
    followed, gone = Followed(population), 0
    for frame in range(25):
        order = random.permutation(np.flatnonzero(random.random(100) < share))
        points = points + random.normal(0, 0.003, points.shape)
        if space is Open:
            gone += population.update(IDS[order], points[order]).removed
            followed.go_on()
        else:
            flip = flip_of(frame)
            cell = flip @ cell
            ways = random.integers(-2, 3, points.shape) * (random.random((100, 1)) < 0.3)
            points = points + ways @ cell
            gone += population.update(IDS[order], points[order], cell).removed
            followed.go_on({IDS[k]: ways[k] for k in order}, flip)
    assert gone > 30 and population.is_valid()


@SPACES
def test_of_a_population_in_calls_for_some_points(space):
    random = np.random.default_rng(2)
    population = space.population_type(changes=True)
    population.insert(IDS[:30], random.random((30, 3)) * space.near)
    followed = Followed(population)
    for _ in range(150):
        kind, there = random.integers(3), population.ids
        if kind == 0:
            new = np.setdiff1d(IDS[:100], there)[: random.integers(4)]
            population.insert(new, random.random((len(new), 3)) * space.near)
        else:
            some = random.choice(there, random.integers(min(5, len(there) + 1)), replace=False)
            if kind == 1:
                population.remove(some)
            else:
                population.move(some, random.random((len(some), 3)) * space.near)
        followed.go_on()


@SPACES
def test_of_coincident_points_that_leave_and_come(space):
    random = np.random.default_rng(1)
    places = np.array(list(itertools.product(range(2), range(2), range(4))), float) / 10
    population = space.population_type(changes=True)
    followed = Followed(population)
    for _ in range(75):
        ids = random.choice(30, random.integers(25), replace=False)
        population.update(ids, places[random.integers(len(places), size=len(ids))])
        assert population.is_valid()
        followed.go_on()


@SPACES
def test_of_few_points(space):
    population = space.population_type(changes=True)
    followed = Followed(population)
    for ids in ([], [5], [5, 7], [7, 8, 9], [1, 2, 3, 4], [4, 9], [9], [1, 2, 3, 9, 10], []):
        population.update(np.array(ids, int), np.array([(i, i * i, i**3) for i in ids], float).reshape(-1, 3) / 7000)
        followed.go_on()


@SPACES
def test_of_calls_that_are_refused_are_none_or_those_of_the_last_one(space):
    population = space.population(IDS[:50], space.cloud(50), changes=True)
    population.update(IDS[10:60], space.cloud(50, seed=2))
    before = removed(population)
    nan = space.cloud(50)
    nan[7] = np.nan
    refused = [lambda: population.update(IDS[20:70], nan), lambda: population.update(IDS[[20, 20]], nan[:2]),
               lambda: population.remove(IDS[[20, 0]]), lambda: population.remove(IDS[[20, 20]]),
               lambda: population.insert(IDS[20], (0, 0, 0)), lambda: population.restore(b"text")]
    if space is Periodic:
        refused.append(lambda: population.update(IDS[20:70], space.cloud(50), (1, 1, 0)))
    for call in refused:
        with pytest.raises(errors.DynamicDelaunayError):
            call()
        assert removed(population) in (set(), before)
    followed = Followed(population)
    population.remove(IDS[20:30])
    followed.go_on()


@SPACES
@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy])
def test_copies_record_for_themselves(space, duplicate):
    points = space.cloud(80)
    population = space.population(IDS[:80], points, changes=True)
    population.update(IDS[20:80], points[20:])
    twin = duplicate(population)
    assert removed(twin) == removed(population) and len(twin.removed_edges) > 0
    followed = Followed(twin)
    twin.update(IDS[:70], moved(points, 0.02)[:70])
    followed.go_on()
    assert removed(twin) != removed(population)


@SPACES
def test_of_what_is_restored(space):
    points = space.cloud(50)
    other = moved(points, 0.03)
    for dt, change in (
        (space.triangulation(points, changes=True), lambda dt: dt.update(other)),
        (space.population(IDS[:50], points, changes=True),
         lambda dt: dt.update(IDS[30:80], [*other[30:], *space.cloud(30, seed=3)])),
    ):
        checkpoint = dt.checkpoint()
        change(dt)
        followed = Followed(dt)
        dt.restore(checkpoint)
        followed.go_on()
        twin = pickle.loads(pickle.dumps(dt))
        followed = Followed(twin)
        assert created(twin) == present(twin)
        change(twin)
        followed.go_on()


@SPACES
def test_are_there_only_if_asked_for(space):
    points = space.cloud(9)
    for dt in (space.triangulation(points), space.population(np.arange(9), points)):
        kind = type(dt).__name__
        for name in space.names_of_edges:
            with pytest.raises(errors.NotRecordedError, match=rf"only with changes=True, as by {kind}\("):
                getattr(dt, name)
            assert not hasattr(dt, name)
    for wrong in (1, "yes", None):
        with pytest.raises(errors.InputTypeError, match="it must be True or False"):
            space.triangulation(points, changes=wrong)
    (frame,) = track([space.cloud(30)], *space.cell, changes=True)
    assert created(frame.triangulation) == present(frame.triangulation)


@SPACES
def test_do_not_depend_on_threads(space):
    points = space.cloud(3000)
    alone, together = (space.triangulation(points, changes=True, threads=threads) for threads in (1, 0))
    for frame in range(3):
        points = moved(points, 0.002, frame)
        alone.update(points)
        together.update(points)
        for name in space.names_of_edges:
            assert np.array_equal(getattr(alone, name), getattr(together, name))
        assert len(alone.created_edges) > 0


@SPACES
def test_are_read_while_other_threads_change_points(space):
    points = space.cloud(500)
    dt = space.triangulation(points, changes=True)
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
from dynamic_delaunay import PeriodicPopulation, Population, errors
is_periodic, megabytes, number = sys.argv[1] == "Periodic", int(sys.argv[2]), int(sys.argv[3])
random = np.random.default_rng(1)

def rows(edges, shifts):  # one for each edge, from the smaller id
    if not is_periodic:
        return set(map(tuple, np.sort(edges).tolist()))
    turned = edges[:, :1] > edges[:, 1:]
    edges, shifts = np.where(turned, edges[:, ::-1], edges), np.where(turned, -shifts, shifts)
    return set(map(tuple, np.hstack([edges, shifts]).tolist()))

def shifts(name):
    return getattr(population, name) if is_periodic else None

def edges():
    return rows(population.ids[population.edges], shifts("edge_shifts"))

def assert_is_told(before):
    now = edges()
    assert rows(population.created_edges, shifts("created_edge_shifts")) == now - before
    assert rows(population.removed_edges, shifts("removed_edge_shifts")) == before - now

ids, points = np.arange(1000), random.random((1000, 3)) * 0.49
population = (PeriodicPopulation if is_periodic else Population)(ids, points, changes=True)
before = edges()
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
many = np.arange(500, 500 + number), random.random((number, 3)) * 0.49
unlimited = resource.getrlimit(resource.RLIMIT_AS)
resource.setrlimit(resource.RLIMIT_AS, (used + (megabytes << 20), unlimited[1]))
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
            assert not hasattr(population, "removed_edge_shifts")
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


# Memory ends while cells are made at some of these limits, while changes are told at others.
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="memory is limited as Linux does it")
@pytest.mark.parametrize("space, limits, number", [(Open, (2, 30, 40, 90), 99_500), (Periodic, (2, 10, 20, 30), 19_500)])
def test_are_told_in_the_end_after_memory_was_exhausted(space, limits, number):
    outcomes = []
    for megabytes in limits:
        command = [sys.executable, "-c", WITHOUT_MEMORY, space.__name__, str(megabytes), str(number)]
        finished = subprocess.run(command, capture_output=True, text=True, check=False)
        assert finished.returncode == 0, finished.stderr
        outcomes.append(finished.stdout.strip())
    assert "False" in outcomes
