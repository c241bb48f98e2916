# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Wires in space, periodic along one vector and open across it, against SciPy's triangulation of copies."""

import copy
import pickle

import numpy as np
import pytest
from scipy.spatial import ConvexHull, Delaunay

from dynamic_delaunay import (
    PeriodicDelaunay,
    PeriodicDelaunay3D,
    PeriodicPopulation,
    PeriodicPopulation3D,
    errors,
    read_recording,
    track,
)

CELL = np.array([(1.0, 0.25, 0.125)])
SHIFTS = np.array(sorted(range(-4, 5), key=abs))


def cloud(n, seed=1):
    random = np.random.default_rng(seed)
    return random.random((n, 1)) @ CELL + random.normal(size=(n, 3)) * (0, 0.5, 0.5)


def images_by_scipy(points, cell):
    """Edges as (i, j, shift) of the middle one of nine copies."""
    copies = np.concatenate([points + shift * cell[0] for shift in SHIFTS])
    indptr, indices = Delaunay(copies).vertex_neighbor_vertices
    n = len(points)
    return {(i, j % n, (int(SHIFTS[j // n]), 0, 0)) for i in range(n) for j in indices[indptr[i] : indptr[i + 1]]}


def images(edges, shifts):
    found = set()
    for (i, j), shift in zip(edges.tolist(), shifts.tolist()):
        found |= {(i, j, tuple(shift)), (j, i, tuple(-number for number in shift))}
    return found


def test_follows_a_cell_that_turns_and_grows():
    random = np.random.default_rng(2)
    points, cell = cloud(50), CELL
    dt = PeriodicDelaunay(points, cell)
    for _ in range(10):
        assert type(dt) is PeriodicDelaunay3D and dt.is_valid() and np.array_equal(dt.cell, cell)
        assert images(dt.edges, dt.edge_shifts) == images_by_scipy(points, cell)
        points, cell = points * 1.01 + random.normal(0, 0.01, points.shape), cell * 1.01 + (0, 0.01, 0)
        assert dt.update(points, cell).certified


def test_cells_fill_a_prism():
    points = cloud(60)
    dt = PeriodicDelaunay(points, CELL)
    along = CELL[0] / np.linalg.norm(CELL[0])
    first = np.cross(along, (0, 0, 1.0))
    first /= np.linalg.norm(first)
    section = ConvexHull(points @ np.column_stack([first, np.cross(along, first)]))
    assert np.isclose(dt.volumes().sum(), section.volume * np.linalg.norm(CELL[0]))
    cells = dt.voronoi_cells()
    assert set(section.vertices.tolist()) == set(np.flatnonzero(np.isinf(cells.volumes)).tolist())
    assert (dt.simplex_shifts[:, :, 1:] == 0).all()


def test_finds_images():
    points = cloud(30)
    dt = PeriodicDelaunay(points, CELL)
    nearest = dt.nearest(points + 8 * CELL[0])
    assert nearest.rows.tolist() == list(range(30)) and (nearest.shifts == (8, 0, 0)).all()
    found = dt.within(points[0], 2.5)
    ways = points[found.indices] + found.shifts[:, :1] * CELL[0] - points[0]
    every = np.concatenate([points + shift * CELL[0] - points[0] for shift in SHIFTS])
    assert (np.linalg.norm(ways, axis=1) <= 2.5).all()
    assert len(ways) == (np.linalg.norm(every, axis=1) <= 2.5).sum()


def test_has_nothing_where_points_are_in_a_plane():
    points = np.outer(np.random.default_rng(1).random(20), CELL[0]) + np.outer(np.arange(20), (0, 0, 1))
    dt = PeriodicDelaunay(points, CELL)
    assert dt.is_valid() and len(dt.simplices) == len(dt.edges) == 0
    assert dt.neighbor_lists().indices.size == 0 and np.isinf(dt.voronoi_cells().volumes).all()
    assert dt.nearest(points + CELL[0]).rows.tolist() == list(range(20))


def test_is_copied_and_stays_a_wire():
    population = PeriodicPopulation(range(10), cloud(10), CELL)
    assert type(population) is PeriodicPopulation3D
    dt = PeriodicDelaunay(cloud(10), CELL)
    for other in (copy.copy(dt), pickle.loads(pickle.dumps(dt))):
        assert np.array_equal(other.cell, CELL) and np.array_equal(other.simplices, dt.simplices)
    for wrong in ((1, 1, 1), np.eye(3)[:2], np.zeros((1, 3)), [(np.inf, 0, 0)]):
        with pytest.raises(errors.PeriodicCellError):
            dt.update(cloud(10), wrong)
    with pytest.raises(errors.PeriodicCellError, match=r"a wire has the vector \(0, 0, 0\): its vector must not be 0"):
        PeriodicDelaunay(cloud(10), np.zeros((1, 3)))

def test_tracks_a_recording(tmp_path):
    random = np.random.default_rng(4)
    points = random.random((30, 3)) * (5, 2, 2)
    path = tmp_path / "wire.dump"
    with path.open("w") as file:
        for step in range(4):
            rows = "\n".join(f"{i + 1} {x} {y} {z}" for i, (x, y, z) in enumerate(points.tolist()))
            file.write(f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n30\nITEM: BOX BOUNDS pp ff ff\n0 5\n0 2\n0 2\n"
                       f"ITEM: ATOMS id x y z\n{rows}\n")
            points = points + random.normal(0, 0.02, points.shape)
    frames = list(track(read_recording(path)))
    assert len(frames) == 4 and all(frame.triangulation.cell.tolist() == [[5, 0, 0]] for frame in frames)
