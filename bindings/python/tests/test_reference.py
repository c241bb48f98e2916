# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""The module of the benchmark, which follows the same motion in C++."""

import importlib.util
import os
import pathlib

import numpy as np
import pytest

from dynamic_delaunay import DynamicDelaunay, Population

FILES = sorted((pathlib.Path(os.environ.get("BUILD", "nowhere")) / "python").glob("reference.*"))


@pytest.fixture
def reference():
    if not FILES:
        pytest.skip("it is built with the benchmarks")
    description = importlib.util.spec_from_file_location("reference", FILES[0])
    module = importlib.util.module_from_spec(description)
    description.loader.exec_module(module)
    return module


def test_follows_scenarios_and_populations(reference):
    motion = reference.Motion("brownian", 100)
    assert (motion.name, motion.has_fixed_population, motion.is_periodic) == ("brownian", True, False)
    frames = [motion.points]
    while len(frames) < 4 and motion.advance():
        frames.append(motion.points)
    assert len(frames) == 4 and DynamicDelaunay(frames[-1]).is_certified
    assert all(frame.shape == (100, 2) for frame in frames) and not np.array_equal(frames[0], frames[1])
    assert len(reference.Reference(frames[0]).follow(frames[1:])) == 3
    ids = motion.ids
    assert Population(ids, frames[0]).ids.tolist() == ids.tolist()
    fewer = [(ids[:-n], frame[:-n]) for n, frame in enumerate(frames, 1)]
    assert min(reference.PopulationReference().follow(fewer)) > 0
    assert isinstance(reference.recordings(), list)
