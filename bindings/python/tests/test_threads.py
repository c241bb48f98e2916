# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Threads, processes and interruptions."""

import copy
import multiprocessing
import os
import pickle
import signal
import threading

import numpy as np
import pytest

from dynamic_delaunay import DynamicDelaunay, PeriodicDelaunay, Population, track

POINTS = np.random.default_rng(1).random((2000, 2))


def test_runs_in_threads():
    def follow(seed, results):
        random = np.random.default_rng(seed)
        points = random.random((2000, 2))
        dt = DynamicDelaunay(points)
        for _ in range(30):
            points = points + random.normal(0, 0.001, points.shape)
            dt.update(points)
        results[seed] = dt.triangles

    together, alone = {}, {}
    threads = [threading.Thread(target=follow, args=(seed, together)) for seed in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for seed in range(8):
        follow(seed, alone)
        assert np.array_equal(together[seed], alone[seed])


def test_calls_of_one_object_wait_for_each_other():
    points = np.random.default_rng(1).random((3000, 2))
    dt = DynamicDelaunay(points)
    failures = []

    def use(seed):
        random = np.random.default_rng(seed)
        try:
            for _ in range(20):
                dt.update(points + random.normal(0, 0.001, points.shape))
                triangles, positions = dt.triangles, dt.points
                assert triangles.max() < len(positions) and len(dt.areas) == 3000
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=use, args=(seed,)) for seed in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures and dt.is_valid()


def test_answers_belong_to_one_moment():
    population = Population(np.arange(2000), POINTS)
    failures, is_over = [], threading.Event()

    def change():
        random = np.random.default_rng(1)
        for _ in range(150):
            count = random.integers(3, 2000)
            population.update(np.arange(count), POINTS[:count])
        is_over.set()

    def ask():
        try:
            while not is_over.is_set():
                population.find_simplex(POINTS[:50])
                pairs = population.neighbor_list()
                assert pairs.neighbor_counts.sum() == len(pairs.vectors)
                assert population.convex_hull.shape[1] == 2 and len(population.neighbors_of(0)) > 1
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=work) for work in (change, ask, ask)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures and population.is_valid()


def moved(dt):
    dt.update(POINTS + 1e-4)
    return dt, dt.last_report


@pytest.mark.parametrize("threads", [1, 4])
@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_goes_to_other_processes_and_comes_back(method, threads):
    dt = DynamicDelaunay(POINTS, threads=threads)
    dt.update(POINTS)
    with multiprocessing.get_context(method).Pool(2) as pool:
        twins = pool.map(moved, [dt, dt])
    report = dt.update(POINTS + 1e-4)
    for twin, its_report in twins:
        assert np.array_equal(twin.triangles, dt.triangles) and its_report == report == dt.last_report


def interrupt_soon():
    threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()


def test_can_be_interrupted():
    def frames():
        while True:
            yield POINTS + np.random.default_rng(1).normal(0, 0.01, POINTS.shape)

    interrupt_soon()
    with pytest.raises(KeyboardInterrupt):
        for frame in track(frames()):
            dt = frame.triangulation
    assert dt.is_valid() and dt.is_certified


def test_can_be_interrupted_while_a_classifier_is_at_work():
    def classifier(frame):
        if dt is not None:
            while True:
                threading.Event().wait(0.01)

    dt = None
    dt = DynamicDelaunay(POINTS, classifier=classifier)
    interrupt_soon()
    with pytest.raises(KeyboardInterrupt):
        dt.update(POINTS + 1e-4)
    assert np.array_equal(dt.points, POINTS) and dt.is_valid() and dt.is_certified


@pytest.mark.parametrize("kind", [DynamicDelaunay, PeriodicDelaunay])
def test_a_classifier_may_write_to_the_array_of_its_frame(kind):
    frame = np.concatenate([POINTS, POINTS[:5] + 1e-3])
    expected = frame.copy()

    def classifier(shown):
        frame[:] = np.nan

    dt = kind(np.concatenate([POINTS, POINTS[:5]]), classifier=classifier)
    dt.update(frame)
    assert np.array_equal(dt.points, expected) and dt.is_valid()


def test_may_lose_its_name_while_its_classifier_is_at_work():
    names = {}
    names["dt"] = DynamicDelaunay(POINTS, classifier=lambda frame: names.clear())
    assert names["dt"].update(POINTS).classified == 0 and not names


class Labeled(DynamicDelaunay):
    def __init__(self, points, label):
        super().__init__(points)
        self.label = label


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy, lambda dt: pickle.loads(pickle.dumps(dt))])
def test_copies_of_derived_classes_have_their_attributes(duplicate):
    dt = Labeled(POINTS, ["label"])
    twin = duplicate(dt)
    assert type(twin) is Labeled and twin.label == ["label"] and np.array_equal(twin.triangles, dt.triangles)
    twin.remove(3)
    assert 3 in dt and twin.last_report != dt.last_report
