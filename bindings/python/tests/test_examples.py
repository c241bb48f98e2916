# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

import pathlib
import subprocess
import sys

import numpy as np
import pytest
from agreement import edges_by_scipy
from scipy.spatial import Delaunay

EXAMPLES = pathlib.Path(__file__).parent.parent / "examples"


def output_of(name, *options):
    run = subprocess.run(
        [sys.executable, EXAMPLES / f"{name}.py", *map(str, options)], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    return run.stdout


def test_crowd_density(tmp_path):
    pytest.importorskip("matplotlib")
    picture = tmp_path / "crowd.png"
    lines = output_of("crowd_density", "--picture", picture).splitlines()
    densities = [float(line.split()[2]) for line in lines[:-1]]
    assert densities[-1] > 2 * densities[0] > 1
    came, left = (int(part.split()[0]) for part in lines[-1].split(", "))
    assert came - left == 150 and left > 0
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_tissue():
    lines = output_of("tissue").splitlines()
    first, second = (float(part.split()[0]) for part in lines[1].split(": ")[1].split(", "))
    assert first > second > 0
    assert 3.7 < float(lines[0].split()[-1]) < 3.9


def test_lloyd():
    spreads = [float(line.split()[5]) for line in output_of("lloyd").splitlines()]
    assert len(spreads) == 6 and all(later < earlier for earlier, later in zip(spreads, spreads[1:]))
    assert spreads[-1] < 0.3 * spreads[0]


def test_cloud_density():
    lines = [line.replace(",", "").split() for line in output_of("cloud_density").splitlines()]
    assert [line[1] for line in lines] == [f"{frame}:" for frame in range(0, 101, 20)]
    assert all(14 < float(line[2]) < 16 for line in lines)  # 15.5 in the middle of a random cloud
    densities = [float(line[5]) for line in lines]
    assert densities[0] == 1 and abs(densities[-1] - 0.997**-300) < 0.1 * densities[-1]


BOX = np.array([10.0, 8.0])
SHIFTS = np.array([(i, j) for i in (0, -1, 1) for j in (0, -1, 1)])


def neighbors_by_scipy(points):
    """Of each row in the periodic box, in ascending order: those among nine copies."""
    neighbors = [set() for _ in points]
    for i, j in edges_by_scipy(np.concatenate([points + shift * BOX for shift in SHIFTS])):
        if min(i, j) < len(points):
            neighbors[i % len(points)].add(j % len(points))
            neighbors[j % len(points)].add(i % len(points))
    return neighbors


def test_lammps_neighbors(tmp_path):
    random = np.random.default_rng(1)
    points = random.random((60, 2)) * BOX
    frames, text = [], ""
    for step in range(3):
        ids = random.permutation(60)[step:]
        frames.append((ids, points[ids]))
        rows = "".join(f"{id} 1 {points[id, 0]!r} {points[id, 1]!r} 0\n" for id in ids)
        text += (f"ITEM: TIMESTEP\n{100 * step}\nITEM: NUMBER OF ATOMS\n{len(ids)}\n"
                 f"ITEM: BOX BOUNDS pp pp pp\n0 10\n0 8\n-0.5 0.5\nITEM: ATOMS id type x y z\n{rows}")
        points = (points + random.normal(0, 0.1, points.shape)) % BOX
    dump = tmp_path / "motion.lammpstrj"
    dump.write_text(text)
    lines = iter(output_of("lammps_neighbors", dump).splitlines())
    for step, (ids, places) in enumerate(frames):
        assert next(lines).startswith(f"step {100 * step}: {len(ids)} atoms")
        printed = [[int(id) for id in next(lines).split()] for _ in ids]
        assert sorted(row[0] for row in printed) == sorted(ids)
        for id, neighbors in zip(ids, neighbors_by_scipy(places)):
            assert next(row[1:] for row in printed if row[0] == id) == sorted(ids[list(neighbors)])
    assert next(lines, None) is None


def test_lammps_neighbors_in_space(tmp_path):
    points = np.random.default_rng(1).random((40, 3))
    rows = "".join(f"{id} {x!r} {y!r} {z!r}\n" for id, (x, y, z) in enumerate(points.tolist()))
    dump = tmp_path / "motion.lammpstrj"
    dump.write_text("ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n40\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
                    f"ITEM: ATOMS id x y z\n{rows}")
    first, *lines = output_of("lammps_neighbors", dump).splitlines()
    indptr, indices = Delaunay(points).vertex_neighbor_vertices
    assert first.startswith("step 7: 40 atoms") and len(lines) == 40
    for id, line in enumerate(lines):
        assert [int(number) for number in line.split()] == [id, *sorted(indices[indptr[id] : indptr[id + 1]])]


def test_voronoi_trajectory(tmp_path):
    random = np.random.default_rng(1)
    cell = np.array([(4, 0, 0), (1, 3, 0), (-0.5, 0.5, 5)])
    fractions, text = random.random((30, 3)), ""
    lattice = " ".join(map(repr, cell.ravel().tolist()))
    for frame in range(3):
        points = fractions @ cell
        text += f'30\nLattice="{lattice}" pbc="T T T" Properties=id:I:1:pos:R:3 Frame={10 * frame}\n'
        text += "".join(f"{id} {x!r} {y!r} {z!r}\n" for id, (x, y, z) in enumerate(points.tolist(), 100))
        fractions = fractions + random.normal(0, 0.05, fractions.shape)
    recording = tmp_path / "melt.xyz"
    recording.write_text(text)
    head, *rows = output_of("voronoi_trajectory", recording).splitlines()
    assert head == "step id volume neighbors" and len(rows) == 3 * 30
    rows = [row.split() for row in rows]
    for step in ("0", "10", "20"):
        frame = {row[1]: row for row in rows if row[0] == step}
        assert sorted(map(int, frame)) == list(range(100, 130))
        assert sum(float(row[2]) for row in frame.values()) == pytest.approx(60)
        for id, row in frame.items():  # symmetric, also where images are neighbors
            assert all(row[3:].count(other) == frame[other][3:].count(id) for other in row[3:])


def test_table_densities(tmp_path):
    pandas = pytest.importorskip("pandas")
    x, y = (numbers.ravel() for numbers in np.meshgrid(np.arange(5.0), np.arange(4.0)))
    frames = [pandas.DataFrame({"particle": np.arange(20), "x": scale * x, "y": scale * y, "frame": frame, "mass": 3.0})
              for frame, scale in enumerate((2.0, 1.0))]
    tracks = pandas.concat(frames).sample(frac=1, random_state=1)
    tracks.to_csv(tmp_path / "tracks.csv", index=False)
    output_of("table_densities", tmp_path / "tracks.csv", tmp_path / "densities.csv")
    densities = pandas.read_csv(tmp_path / "densities.csv")
    assert (densities[["particle", "x", "y", "frame", "mass"]].to_numpy() == tracks.to_numpy()).all()
    inner = densities[(densities.frame == 0) & densities.x.between(1, 7) & densities.y.between(1, 5)]
    assert len(inner) == 6 and np.allclose(inner.density, 0.25)  # squares of the side 2
    assert np.allclose(densities[densities.frame == 0].groupby("frame").density.apply(lambda d: (1 / d).sum()), 8 * 6)
