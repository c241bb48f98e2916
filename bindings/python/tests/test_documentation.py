# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

import ast
import inspect
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest

import dynamic_delaunay
from dynamic_delaunay import (
    DynamicDelaunay,
    DynamicDelaunay3D,
    PeriodicDelaunay,
    PeriodicDelaunay3D,
    PeriodicPopulation,
    PeriodicPopulation3D,
    Population,
    Population3D,
    _core,
    errors,
)

PACKAGE = pathlib.Path(dynamic_delaunay.__file__).parent
PACKAGE_README = pathlib.Path(__file__).parents[1] / "README.md"
ARRAYS = (DynamicDelaunay, Population, PeriodicDelaunay, PeriodicPopulation)


def test_stubs_have_all_that_the_module_has():
    body = ast.parse((PACKAGE / "_core.pyi").read_text()).body
    stubs = {node.name: node for node in body if isinstance(node, ast.ClassDef)}
    kinds = {name: kind for name, kind in vars(_core).items() if inspect.isclass(kind)}
    assert stubs.keys() == kinds.keys()
    functions = {node.name for node in body if isinstance(node, ast.FunctionDef)}
    assert functions == {name for name, member in vars(_core).items() if inspect.isbuiltin(member)}
    for name, kind in kinds.items():
        if name in ("Group", "Query"):  # enumerations
            continue
        stubbed = {node.name for node in stubs[name].body if isinstance(node, ast.FunctionDef)} - {"__init__"}
        assert stubbed == {member for member in vars(kind) if not member.startswith("__")}


@pytest.mark.parametrize("kind", [*ARRAYS, DynamicDelaunay3D, Population3D, PeriodicDelaunay3D,
                                  PeriodicPopulation3D])
def test_everything_public_is_documented(kind):
    assert inspect.getdoc(kind)
    for name, member in inspect.getmembers(kind):
        if not name.startswith("_"):
            assert inspect.getdoc(member), name


def count_documented_arrays(triangulation):
    """How many properties are arrays, each of the type and shape that its documentation says."""
    seen = 0
    for name, member in inspect.getmembers(type(triangulation), lambda member: isinstance(member, property)):
        documented = inspect.getdoc(member)
        array = getattr(triangulation, name)
        if isinstance(array, np.ndarray):
            assert documented.startswith(f"{array.dtype} ("), name
            dimensions = documented[documented.index("(") + 1 : documented.index(")")].strip(",").split(",")
            assert len(dimensions) == array.ndim, name
            for extent, dimension in zip(array.shape, dimensions):
                assert not dimension.strip().isdigit() or extent == int(dimension), name
            seen += 1
    return seen


@pytest.mark.parametrize("kind", ARRAYS)
def test_documented_types_and_shapes_are_those_of_the_arrays(kind):
    points = np.random.default_rng(1).random((20, 2))
    ids = [] if kind in (DynamicDelaunay, PeriodicDelaunay) else [np.arange(20)]
    assert count_documented_arrays(kind(*ids, points, changes=True)) >= 14


def test_documented_types_and_shapes_in_space_are_those_of_the_arrays():
    points = np.random.default_rng(1).random((20, 3))
    for in_space in (DynamicDelaunay(points, changes=True), Population(np.arange(20), points, changes=True)):
        assert count_documented_arrays(in_space) == 11
    for periodic in (PeriodicDelaunay(points, changes=True),
                     PeriodicPopulation(np.arange(20), points, changes=True)):
        assert count_documented_arrays(periodic) == 16


def test_has_the_version_of_the_headers():
    assert [part.isdigit() for part in dynamic_delaunay.__version__.split(".")] == [True] * 3


def test_exceptions_are_documented_and_have_one_base():
    kinds = [kind for kind in vars(errors).values() if inspect.isclass(kind)]
    assert len(kinds) == 19
    for kind in kinds:
        assert kind.__doc__ and issubclass(kind, errors.DynamicDelaunayError)
        assert getattr(dynamic_delaunay, kind.__name__) is kind


def test_type_checkers_find_no_fault_also_for_the_oldest_python():
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir=/dev/null", "--python-version=3.9", str(PACKAGE)]
    checked = subprocess.run(command, capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout


def test_the_program_of_the_description_runs():
    (program,) = re.findall(r"^```python\n(.*?)^```$", PACKAGE_README.read_text(), re.MULTILINE | re.DOTALL)
    output = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
    assert output.endswith("certified: True\n")
