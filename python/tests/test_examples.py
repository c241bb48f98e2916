# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

import pathlib
import subprocess
import sys

import pytest

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
