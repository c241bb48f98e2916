# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Edges that come and go."""

import numpy as np
import pytest

from dynamic_delaunay import DynamicDelaunay, PeriodicDelaunay, PeriodicPopulation, Population, errors


def images(pairs, shifts=None):
    """Edges as (i, j, shift), seen from both ends."""
    shifts = np.zeros((len(pairs), 2), int) if shifts is None else shifts
    edges = set()
    for (i, j), (a, b) in zip(pairs.tolist(), shifts.tolist()):
        edges |= {(i, j, (a, b)), (j, i, (-a, -b))}
    return edges


def edges_of_ids(population):
    return images(population.ids[population.edges], getattr(population, "edge_shifts", None))


def created(triangulation):
    return images(triangulation.created_edges, getattr(triangulation, "created_edge_shifts", None))


def removed(triangulation):
    return images(triangulation.removed_edges, getattr(triangulation, "removed_edge_shifts", None))


def assert_tells_what_changed(population, before):
    now = edges_of_ids(population)
    assert created(population) == now - before
    assert removed(population) == before - now


@pytest.mark.parametrize("kind", [Population, PeriodicPopulation])
@pytest.mark.parametrize("share", [0.97, 0.3])
def test_of_a_population_by_the_users_ids(kind, share):
    random = np.random.default_rng(1)
    ids = random.choice(10**12, 200, replace=False) - 5 * 10**11
    points = random.random((200, 2)) * 0.9 + 0.05
    population = kind(changes=True)
    some_left = 0
    for _ in range(30):
        before = edges_of_ids(population)
        there = random.random(200) < share
        points = np.clip(points + random.normal(0, 0.003, points.shape), 0, 0.99)
        population.update(ids[there], points[there])
        assert_tells_what_changed(population, before)
        some_left += population.last_report.removed
        assert population.created_edges.dtype == np.int64
    assert some_left > 30


@pytest.mark.parametrize("kind", [Population, PeriodicPopulation])
def test_of_single_points_by_the_users_ids(kind):
    random = np.random.default_rng(1)

    def places(*size):  # no point moves through half of the cell, where it would get another image
        return random.random((*size, 2)) * 0.49

    population = kind(np.arange(50) * 3 - 40, places(50), changes=True)
    ids = set(population.ids.tolist())
    for step in range(200):
        before = edges_of_ids(population)
        choice = random.integers(3)
        if choice == 0:
            id = int(random.integers(10**6))
            population.insert(id, places())
            ids.add(id)
        elif choice == 1:
            id = int(random.choice(sorted(ids)))
            population.remove(id)
            ids.remove(id)
        else:
            population.move(random.choice(sorted(ids)), places())
        assert_tells_what_changed(population, before)


@pytest.mark.parametrize("kind", [Population, PeriodicPopulation])
def test_of_coincident_points_that_leave_and_come(kind):
    random = np.random.default_rng(1)
    places = random.random((12, 2)) * 0.45  # no way between them is longer than that around the cell
    population = kind(changes=True)
    for _ in range(60):
        before = edges_of_ids(population)
        ids = random.choice(30, random.integers(20), replace=False)
        population.update(ids, places[random.integers(12, size=len(ids))])
        assert population.is_valid()
        assert_tells_what_changed(population, before)


def test_of_points_on_a_line_and_fewer_than_three():
    population = Population(changes=True)
    for ids in ([], [5], [5, 7], [7, 8, 9], [1, 2, 3, 4], [4, 9], [9]):
        before = edges_of_ids(population)
        population.update(np.array(ids, int), np.array([(i, 0) for i in ids], float).reshape(-1, 2))
        assert_tells_what_changed(population, before)


def test_of_points_that_are_wrapped_while_others_leave_and_the_cell_changes():
    random = np.random.default_rng(1)
    ids, points = np.arange(60), random.random((60, 2))
    population = PeriodicPopulation(changes=True)

    def vectors(edges):
        """Edges by what no image of a point changes: to fractions of a step."""
        at = dict(zip(ids.tolist(), points))
        return {(i, j, *np.rint((at[j] + s - at[i]) * 8)) for i, j, s in edges if i in at and j in at}

    before = set()
    for frame in range(20):
        there = random.random(60) < 0.8
        points = points + random.normal(0, 0.02, points.shape)
        population.update(ids[there], points[there] % 1 if frame % 2 else points[there], cell=(1, 1))
        now = edges_of_ids(population)
        assert created(population) <= now and not removed(population) & now
        degrees = {id: sum(i == id for i, *_ in now) for id in ids[there].tolist()}
        assert len(now) - len(before) == len(created(population)) - len(removed(population))
        assert all(degrees.values())
        before = now


def test_of_a_frame_that_is_refused_are_those_of_the_last_one():
    population = Population([1, 2, 3, 4], [(0, 0), (1, 0), (0, 1), (1, 1.5)], changes=True)
    population.update([1, 2, 3], [(0, 0), (1, 0), (0, 1)])
    before = removed(population)
    assert before
    with pytest.raises(errors.NonFiniteCoordinateError):
        population.update([1, 2], [(0, 0), (1, np.nan)])
    assert not removed(population) or removed(population) == before
    population.insert(9, (2, 2))
    assert {i for i, *_ in created(population)} == {2, 3, 9} and not removed(population)


def test_of_a_frame_that_a_classifier_stopped_are_none():
    def classifier(frame):
        raise KeyError("stopped")

    points = np.random.default_rng(1).random((50, 2))
    population = Population(np.arange(50), points, classifier=classifier, changes=True)
    before = edges_of_ids(population)
    with pytest.raises(KeyError):
        population.update(np.arange(1, 51), points)
    assert edges_of_ids(population) == before and not created(population) and not removed(population)


def test_of_a_population_that_is_restored():
    points = np.random.default_rng(1).random((40, 2))
    population = Population(np.arange(40), points, changes=True)
    checkpoint = population.checkpoint()
    population.update(np.arange(20, 60), points)
    before = edges_of_ids(population)
    population.restore(checkpoint)
    assert_tells_what_changed(population, before)


@pytest.mark.parametrize(
    "make",
    [DynamicDelaunay, lambda points: PeriodicDelaunay(points, (2, 2)), lambda points: Population(np.arange(9), points)],
)
def test_are_there_only_if_asked_for(make):
    triangulation = make(np.random.default_rng(1).random((9, 2)))
    with pytest.raises(ValueError, match="only with changes=True"):
        triangulation.created_edges
