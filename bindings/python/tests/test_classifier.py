# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

import copy
import gc
import pickle
import weakref

import numpy as np
import pytest
from agreement import assert_is_delaunay

from dynamic_delaunay import DynamicDelaunay, PeriodicDelaunay, PeriodicPopulation, Population, errors

POINTS = np.random.default_rng(1).random((300, 2))


def next_frame(points, seed=2):
    return points + np.random.default_rng(seed).normal(0, 0.003, points.shape)


def everything(frame):
    return np.arange(1, len(frame.positions))


def broken_edges(frame):
    """Those that a determinant says are not locally Delaunay."""
    edges, p = frame.edges, frame.positions
    finite = np.flatnonzero((edges > 0).all(axis=1))
    a, b, c, d = p[edges[finite].T]
    rows = [np.column_stack([q - d, ((q - d) ** 2).sum(axis=1)]) for q in (a, b, c)]
    determinant = np.linalg.det(np.stack(rows, axis=1))
    return [], finite[determinant > 0]


def test_a_classifier_in_python_names_vertices():
    dt = DynamicDelaunay(POINTS, classifier=everything, repair="flip")
    points = next_frame(POINTS)
    report = dt.update(points)
    assert report.classified == 300 and not report.certified
    assert dt.certify()
    assert_is_delaunay(dt, points)


def test_a_classifier_in_python_names_edges():
    dt = DynamicDelaunay(POINTS, classifier=broken_edges, repair="flip")
    points = next_frame(POINTS)
    report = dt.update(points)
    assert 0 < report.classified < 300
    dt.mend()
    assert_is_delaunay(dt, points)


@pytest.mark.parametrize("kind", [DynamicDelaunay, PeriodicDelaunay])
def test_what_needs_a_delaunay_triangulation_is_refused_until_it_is_mended(kind):
    dt = kind(POINTS, classifier=lambda frame: None)
    dt.update(next_frame(POINTS))
    asked = [lambda: dt.areas, lambda: dt.ridges, dt.neighbor_list, lambda: dt.voronoi_cell(3)]
    asked.append(lambda: dt.bounded_cells(0.1))
    if kind is DynamicDelaunay:
        asked += [lambda: dt.find_simplex(POINTS), lambda: dt.clipped_cells((0, 0, 1, 1))]
    for ask in asked:
        with pytest.raises(errors.UncertifiedTriangulationError, match="call mend().* edges, triangles and indices"):
            ask()
    assert len(dt.edges) and len(dt.triangles) and len(dt.indices) and len(dt.points) == 300
    dt.mend()
    for ask in asked:
        ask()


def test_nothing_named_leaves_everything_as_it_is():
    dt = DynamicDelaunay(POINTS, classifier=lambda frame: None)
    triangles = dt.triangles
    assert dt.update(next_frame(POINTS)).classified == 0
    assert np.array_equal(dt.triangles, triangles) and not dt.certify()


def test_a_frame_shows_positions_edges_and_ids():
    seen = {}

    def look(frame):
        for name in ("positions", "previous_positions", "edges", "ids"):
            seen[name] = getattr(frame, name)
        seen["frame"] = frame

    dt = DynamicDelaunay(POINTS, classifier=look)
    points = next_frame(POINTS)
    dt.update(points)
    ids = seen["ids"][1:]
    assert sorted(ids) == list(range(300)) and seen["ids"][0] == -1
    assert np.array_equal(seen["positions"][1:], points[ids])
    assert np.array_equal(seen["previous_positions"][1:], POINTS[ids])
    assert np.isnan(seen["positions"][0]).all()
    assert seen["edges"].shape == (3 * 300 - 3, 4) and seen["edges"].max() == 300
    with pytest.raises(RuntimeError, match="only while its classifier is called"):
        seen["frame"].positions


@pytest.mark.parametrize("answer", [None, [], (None, None), ([], None), (None, [0, 1]), np.array([], np.uint8)])
def test_nothing_has_many_names(answer):
    assert DynamicDelaunay(POINTS, classifier=lambda frame: answer).update(POINTS).rebuild_reason is None


class Counting:
    def __init__(self):
        self.updates = []

    def __call__(self, frame):
        return everything(frame)

    def after_update(self, frame):
        self.updates.append((frame.everything_is_new, len(frame.new_edges)))


def test_an_object_hears_what_is_new():
    classifier = Counting()
    dt = DynamicDelaunay(POINTS, classifier=classifier, repair="flip")
    assert classifier.updates[-1][0]
    dt.update(next_frame(POINTS))
    assert not dt.last_report.rebuilt and not classifier.updates[-1][0] and classifier.updates[-1][1] > 0


def fails(frame):
    raise KeyError("nothing there")


def test_an_exception_of_a_classifier_leaves_everything_as_it_was():
    dt = DynamicDelaunay(POINTS, classifier=fails)
    with pytest.raises(KeyError, match="nothing there"):
        dt.update(next_frame(POINTS))
    assert np.array_equal(dt.points, POINTS) and dt.is_valid()


@pytest.mark.parametrize(
    "answer, error",
    [([1.5], TypeError), ("x", TypeError), ([[1]], ValueError), (([], [], []), ValueError), ([301], IndexError),
     ([-1], IndexError), (([], [10**10]), IndexError)],
)
def test_refuses_other_answers(answer, error):
    dt = DynamicDelaunay(POINTS, classifier=lambda frame: answer)
    with pytest.raises(error, match="classifier") as refused:
        dt.update(next_frame(POINTS))
    assert isinstance(refused.value, errors.DynamicDelaunayError)
    assert np.array_equal(dt.points, POINTS)


def test_refuses_what_is_neither_a_name_nor_a_function():
    with pytest.raises(TypeError, match="a name or a function"):
        DynamicDelaunay(POINTS, classifier=3)


def test_a_classifier_cannot_use_its_own_triangulation():
    dt = DynamicDelaunay(POINTS, classifier=lambda frame: dt.edges)
    with pytest.raises(RuntimeError, match="its own classifier"):
        dt.update(next_frame(POINTS))


class Referring:
    def __call__(self, frame):
        return self.dt and None


@pytest.mark.parametrize("make", [DynamicDelaunay, PeriodicDelaunay,
                                  lambda points, classifier: Population(np.arange(300), points, classifier=classifier)])
def test_a_classifier_that_refers_to_its_triangulation_is_collected_with_it(make):
    classifier = Referring()
    dt = classifier.dt = make(POINTS, classifier=classifier)
    gone = [weakref.ref(classifier), weakref.ref(dt)]
    edges = dt.edges
    del classifier, dt
    gc.collect()
    assert [reference() for reference in gone] == [None, None]
    assert edges.max() == 299


def test_a_triangulation_in_use_is_not_collected():
    dt = DynamicDelaunay(POINTS, classifier=lambda frame: (gc.collect(), everything(frame))[1])
    edges = dt.edges
    gc.collect()
    assert dt.update(next_frame(POINTS)).classified == 300 and dt.edges is not edges


def broken_images(frame):
    """The same as broken_edges(), by what works in both spaces."""
    corners = frame.corners
    finite = np.flatnonzero(np.isfinite(corners).all(axis=(1, 2)))
    a, b, c, d = corners[finite].transpose(1, 0, 2)
    rows = [np.column_stack([q - d, ((q - d) ** 2).sum(axis=1)]) for q in (a, b, c)]
    return [], finite[np.linalg.det(np.stack(rows, axis=1)) > 0]


@pytest.mark.parametrize("make", [DynamicDelaunay, PeriodicDelaunay])
def test_corners_work_in_both_spaces(make):
    dt = make(POINTS, classifier=broken_images, repair="flip")
    points = POINTS
    for frame in range(5):
        points = next_frame(points, frame)
        assert 0 < dt.update(points).classified < 300
    assert dt.mend().certified and dt.is_valid()
    exact = make(points)
    assert {frozenset(e) for e in dt.edges.tolist()} == {frozenset(e) for e in exact.edges.tolist()}


def test_a_classifier_in_python_follows_a_periodic_population():
    seen = []

    def classifier(frame):
        seen.append((frame.positions[1:], frame.ids[1:], frame.edges.shape))
        return everything(frame)

    population = PeriodicPopulation(np.arange(300) + 7, POINTS, classifier=classifier)
    points = next_frame(POINTS)
    population.update(np.arange(300) + 7, points)
    positions, ids, shape = seen[-1]
    assert np.array_equal(positions % 1, points[ids] % 1) and shape == (900, 4)


NAMES = ["circumcircle", "safe_region", "point_distance:0.7", "inflation_aware", "voronoi_circumcenter",
         "voronoi_circumcenter_estimated", "voronoi_edge_length", "nearly_delaunay", "random:0.9",
         "refined:point_distance+circumcircle"]
REPAIRS = ["hold_and_flip", "splice", "flip", "relocate", "rebuild"]


@pytest.mark.parametrize("classifier", NAMES)
@pytest.mark.parametrize("kind", [DynamicDelaunay, PeriodicDelaunay])
def test_classifiers_have_names(kind, classifier):
    dt = kind(POINTS, classifier=classifier)
    points = next_frame(POINTS)
    report = dt.update(points)
    assert report.certified or classifier not in NAMES[:2]
    assert dt.mend().certified and dt.is_valid()
    twin = copy.deepcopy(dt)
    assert type(twin) is kind and np.array_equal(twin.triangles, dt.triangles)
    twin.update(POINTS)
    assert np.array_equal(dt.points, points)


@pytest.mark.parametrize("repair", REPAIRS)
@pytest.mark.parametrize("policy", ["always_dynamic", "always_static", "hybrid", "key_frames:2"])
@pytest.mark.parametrize("kind", [DynamicDelaunay, PeriodicDelaunay])
def test_repairs_and_policies_have_names(kind, repair, policy):
    dt = kind(POINTS, repair=repair, policy=policy, changes=True)
    for frame in range(3):
        report = dt.update(next_frame(POINTS, frame))
        assert report.certified and dt.is_valid()
        assert report.rebuild_reason == "policy" or policy != "always_static"


@pytest.mark.parametrize("kind", [DynamicDelaunay, Population, PeriodicDelaunay, PeriodicPopulation])
def test_refuses_unknown_names_and_says_which_there_are(kind):
    for setting, known in (("classifier", "circumcircle"), ("repair", "relocate"), ("policy", "hybrid")):
        with pytest.raises(ValueError, match=f"there is no {setting} 'best'; there are .*{known}"):
            kind(**{setting: "best"})
    with pytest.raises(ValueError, match="the parameter of point_distance"):
        kind(classifier="point_distance:7")


def test_pickles_with_a_function_of_a_module():
    twin = pickle.loads(pickle.dumps(DynamicDelaunay(POINTS, classifier=everything)))
    assert twin.update(next_frame(POINTS)).classified == 300
