# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

import copy
import pickle

import numpy as np
import pytest
from agreement import assert_is_delaunay, edge_set, edges_by_scipy
from scipy.spatial import Delaunay, Voronoi

from dynamic_delaunay import DynamicDelaunay, errors


def cloud(n, seed=1):
    return np.random.default_rng(seed).random((n, 2))


def moved(points, size, seed=2):
    return points + np.random.default_rng(seed).normal(0, size, points.shape)


def test_triangulates_what_it_is_given():
    points = cloud(500)
    dt = DynamicDelaunay(points)
    assert_is_delaunay(dt, points)
    assert len(dt) == dt.number_of_points == dt.number_of_ids == dt.number_of_vertices == dt.npoints == 500
    assert np.array_equal(dt.points, points)
    assert np.array_equal(dt.ids, np.arange(500))
    assert repr(dt) == "<DynamicDelaunay of 500 points, certified>"


def test_follows_points_that_move_and_reports_what_it_did():
    points = cloud(500)
    dt = DynamicDelaunay(points)
    for frame in range(20):
        points = moved(points, 0.002, frame)
        report = dt.update(points)
        assert report.certified and not report.rebuilt and report.rebuild_reason is None
        assert_is_delaunay(dt, points)
    assert report.flips > 0
    assert f"flips={report.flips}" in repr(report)
    assert dt.last_report.flips == report.flips


def test_says_why_it_triangulated_anew():
    dt = DynamicDelaunay(cloud(500))
    report = dt.update(cloud(500, seed=3))
    assert report.rebuilt
    assert report.rebuild_reason == "too_much_broken"


def test_inserts_removes_and_moves():
    points = cloud(200)
    dt = DynamicDelaunay(points)
    assert list(dt.insert([(0.5, 0.5), (0.25, 0.75)])) == [200, 201]
    assert list(dt.insert((0.1, 0.2))) == [202]
    assert dt.remove([3, 200]).removed == 2
    assert 3 not in dt and 4 in dt and -1 not in dt
    assert np.isnan(dt.points[3]).all()
    assert list(dt.insert((0.9, 0.9))) == [3]
    dt.move(4, (0.3, 0.3))
    dt.move([5, 6], [(0.31, 0.3), (0.3, 0.31)])
    assert np.array_equal(dt.points[[4, 5, 6]], [(0.3, 0.3), (0.31, 0.3), (0.3, 0.31)])
    assert 200 not in dt.ids and len(dt.ids) == len(dt) == 202
    dt.insert((0.7, 0.1))
    assert_is_delaunay(dt, dt.points)


def test_orders_triangles_and_neighbors_as_scipy_does():
    points = cloud(300)
    dt, theirs = DynamicDelaunay(points), Delaunay(points)
    assert {frozenset(t) for t in dt.triangles.tolist()} == {frozenset(t) for t in theirs.simplices.tolist()}
    assert dt.simplices is dt.triangles
    a, b, c = points[dt.triangles.T]
    assert (np.cross(b - a, c - a) > 0).all()
    for t, (corners, neighbors) in enumerate(zip(dt.triangles, dt.neighbors)):
        for k in range(3):
            others = set(np.delete(corners, k))
            if neighbors[k] >= 0:
                assert others < set(dt.triangles[neighbors[k]])
                assert t in dt.neighbors[neighbors[k]]
    hull = edge_set(theirs.convex_hull)
    assert edge_set(dt.convex_hull) == hull
    a, b = points[dt.convex_hull.T]
    assert (np.cross(b - a, points.mean(axis=0) - a) > 0).all()


def test_finds_triangles_of_places_as_scipy_does():
    points = cloud(1000)
    dt, theirs = DynamicDelaunay(points), Delaunay(points)
    places = np.random.default_rng(5).random((2000, 2)) * 1.4 - 0.2
    ours, found = dt.find_simplex(places), theirs.find_simplex(places)
    assert np.array_equal(ours < 0, found < 0)
    inside = ours >= 0
    assert inside.sum() > 500
    assert np.array_equal(np.sort(dt.triangles[ours[inside]]), np.sort(theirs.simplices[found[inside]]))
    assert dt.find_simplex((5.0, 5.0)) == -1
    assert dt.find_simplex((np.nan, 0.0)) == -1
    corner = dt.find_simplex(points[7])
    assert 7 in dt.triangles[corner]


def test_lists_neighbors_as_scipy_does():
    points = cloud(300)
    dt = DynamicDelaunay(points)
    indptr, indices = Delaunay(points).vertex_neighbor_vertices
    assert dt.indptr.dtype == dt.indices.dtype == np.int32
    for i in range(300):
        assert set(dt.neighbors_of(i)) == set(indices[indptr[i] : indptr[i + 1]])
    assert dt.vertex_neighbor_vertices == (dt.indptr, dt.indices)
    with pytest.raises(IndexError, match="there is no row 300"):
        dt.neighbors_of(300)


def test_measures_cells():
    points = cloud(300)
    dt, voronoi = DynamicDelaunay(points), Voronoi(points)
    for i in range(300):
        region = voronoi.regions[voronoi.point_region[i]]
        if -1 in region:
            assert np.isinf(dt.areas[i]) and len(dt.voronoi_cell(i)) == 0
            continue
        x, y = dt.voronoi_cell(i).T
        area = 0.5 * abs(x @ np.roll(y, 1) - y @ np.roll(x, 1))
        assert dt.areas[i] == pytest.approx(area)
        assert len(x) == len(region)
        perimeter = np.hypot(x - np.roll(x, 1), y - np.roll(y, 1)).sum()
        assert dt.perimeters[i] == pytest.approx(perimeter)
        assert dt.shape_indices[i] == pytest.approx(perimeter / np.sqrt(area))
    clipped = dt.clipped_cells((0, 0, 1, 1))
    assert clipped.areas.sum() == pytest.approx(1)
    assert clipped.areas @ clipped.centroids == pytest.approx([0.5, 0.5])


def test_lists_pairs_with_vectors_as_freud_does():
    points = cloud(100)
    dt = DynamicDelaunay(points)
    pairs = dt.neighbor_list()
    assert len(pairs) == 2 * len(dt.edges)
    assert np.array_equal(pairs.vectors, points[pairs.point_indices] - points[pairs.query_point_indices])
    assert np.array_equal(pairs.neighbor_counts, np.diff(dt.indptr))
    assert np.array_equal(pairs.segments, dt.indptr[:-1])
    assert pairs.distances == pytest.approx(np.linalg.norm(pairs.vectors, axis=1))
    total = np.bincount(pairs.query_point_indices, pairs.weights)
    finite = np.isfinite(dt.areas)
    assert total[finite] == pytest.approx(dt.perimeters[finite])


def test_lists_the_changed_edges():
    points = cloud(300)
    dt = DynamicDelaunay(points, changes=True)
    edges = edge_set(dt.edges)
    assert edge_set(dt.created_edges) == edges
    for frame in range(10):
        points = moved(points, 0.005, frame)
        dt.update(points)
        created, removed = edge_set(dt.created_edges), edge_set(dt.removed_edges)
        assert created and removed <= edges and not created & edges
        edges = edges - removed | created
        assert edges == edge_set(dt.edges)


def test_records_no_changes_unless_asked_to():
    with pytest.raises(ValueError, match="changes=True"):
        DynamicDelaunay(cloud(10)).created_edges


def test_knows_points_that_coincide():
    dt = DynamicDelaunay([(0, 0), (1, 0), (0, 1), (1, 0), (1, 0)])
    assert dt.number_of_points == 5 and dt.number_of_vertices == 3
    assert dt.duplicates.tolist() == [[3, 1], [4, 1]]
    assert dt.neighbors_of(3).tolist() == [1]
    assert sorted(dt.triangles[0]) == [0, 1, 2]


@pytest.mark.parametrize("points", [[], [(1, 2)], [(0, 0), (1, 1)], [(0, 0), (2, 2), (1, 1)]])
def test_has_no_triangles_without_an_extent(points):
    dt = DynamicDelaunay(points)
    assert dt.is_valid() and dt.is_certified
    assert dt.triangles.shape == dt.neighbors.shape == (0, 3)
    assert dt.convex_hull.shape == (0, 2)
    assert dt.edges.shape == (max(len(points) - 1, 0), 2)
    assert dt.points.shape == (len(points), 2)
    assert len(dt.indptr) == len(points) + 1
    assert dt.find_simplex([(0.5, 0.5)]).tolist() == [-1]
    assert np.isinf(dt.areas).all()


@pytest.mark.parametrize(
    "classifier, exact",
    [
        ("circumcircle", True),
        ("safe_region", True),
        ("refined:circumcircle+safe_region", True),
        ("point_distance:0.7", False),
        ("nearly_delaunay", False),
        ("refined:point_distance:0.5+voronoi_circumcenter", False),
    ],
)
def test_takes_classifiers_by_the_names_of_run_scenario(classifier, exact):
    points = cloud(500)
    dt = DynamicDelaunay(points, classifier=classifier)
    points = moved(points, 0.0003)
    assert dt.update(points).certified == exact
    assert dt.mend().certified
    assert_is_delaunay(dt, points)


def test_certifies_what_a_heuristic_left_right():
    points = cloud(100)
    dt = DynamicDelaunay(points, classifier="point_distance")
    dt.update(points)
    assert not dt.is_certified
    with pytest.raises(errors.UncertifiedTriangulationError, match="mend"):
        dt.areas
    with pytest.raises(errors.UncertifiedTriangulationError, match="mend"):
        dt.find_simplex((0.5, 0.5))
    assert dt.certify() and dt.is_certified


@pytest.mark.parametrize("repair", ["hold_and_flip", "splice", "flip", "relocate", "rebuild"])
def test_takes_repairs_by_name(repair):
    points = cloud(300)
    dt = DynamicDelaunay(points, repair=repair)
    dt.update(moved(points, 0.002))
    assert_is_delaunay(dt, dt.points)


def test_takes_policies_by_name():
    points = cloud(300)
    dt = DynamicDelaunay(points, policy="always_static")
    assert dt.update(points).rebuild_reason == "policy"


@pytest.mark.parametrize(
    "choice", [dict(classifier="none"), dict(classifier="point_distance:2"), dict(repair="x"), dict(policy="x")]
)
def test_refuses_unknown_choices(choice):
    with pytest.raises(ValueError, match="there are|from 0 to 1"):
        DynamicDelaunay(cloud(5), **choice)


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda dt: pickle.loads(pickle.dumps(dt))])
def test_goes_on_from_a_copy_as_if_nothing_had_happened(again):
    points = cloud(300)
    dt = DynamicDelaunay(points, classifier="safe_region", changes=True)
    dt.remove(7)
    twin = again(dt)
    for frame in range(5):
        points = moved(points, 0.003, frame)
        assert repr(dt.update(points)) == repr(twin.update(points))
        assert np.array_equal(dt.triangles, twin.triangles)
        assert np.array_equal(dt.created_edges, twin.created_edges)
    assert_is_delaunay(DynamicDelaunay(dt.points[dt.ids]), dt.points[dt.ids])


def test_saves_and_loads(tmp_path):
    dt = DynamicDelaunay(cloud(50))
    dt.save(tmp_path / "checkpoint")
    other = DynamicDelaunay()
    other.load(tmp_path / "checkpoint")
    assert np.array_equal(dt.triangles, other.triangles)
    text = dt.checkpoint().replace(b"0", b"1", 1)
    with pytest.raises(errors.CheckpointError) as refused:
        other.restore(text)
    assert refused.value.line > 0
    assert np.array_equal(dt.points, other.points)


def test_random_operations_agree_with_scipy_and_exact_predicates():
    random = np.random.default_rng(11)
    dt = DynamicDelaunay(random.random((20, 2)))
    operations = 100_000
    for operation in range(operations):
        kind = random.integers(8)
        ids = dt.ids
        if kind == 0 and len(ids) < 30:
            dt.insert(random.random(2))
        elif kind == 1 and len(ids) > 8:
            dt.remove(random.choice(ids))
        elif kind == 2:
            dt.move(random.choice(ids), random.random(2))
        elif kind == 3:
            some = random.choice(ids, 3, replace=False)
            dt.move(some, random.random((3, 2)))
        else:
            points = np.nan_to_num(dt.points)
            assert dt.update(points + random.normal(0, 10.0 ** random.integers(-4, 0), points.shape)).certified
        assert dt.is_valid()
        if operation % 10 == 0:
            ids = dt.ids
            assert edge_set(np.searchsorted(ids, dt.edges)) == edges_by_scipy(dt.points[ids])
