# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Whether a wheel can be built where nothing but the source distribution is, and be used where nothing but the wheel is.

The module is compiled with the options of the build in BUILD, below a folder of the same name. So ccache has it already.
"""

import email
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import zipfile

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
BUILD = pathlib.Path(os.environ.get("BUILD", ROOT / "build"))
NO_PART = shutil.ignore_patterns(".git", "build", "build-*", "recordings", "*.egg-info", "__pycache__")
TOOLS = ("build", "pip", "pybind11", "setuptools", "wheel")

FIRST_FRAME = """
import dynamic_delaunay, gzip, numpy, pathlib
pathlib.Path("tracks.csv.gz").write_bytes(gzip.compress(b"frame,id,x,y\\n7,1,0,0\\n"))
assert dynamic_delaunay.read_recording("tracks.csv.gz")[0].number == 7
points = numpy.random.default_rng(1).random((1000, 2))
triangulation = dynamic_delaunay.DynamicDelaunay(points)
print(dynamic_delaunay.__file__)
print(dynamic_delaunay.__version__)
print(triangulation.update(points + 1e-4 * numpy.random.default_rng(2).normal(size=points.shape)).certified)
"""


def output_of(*command, folder, **variables):
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    finished = subprocess.run([*map(str, command)], cwd=folder, env={**environment, **variables}, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert finished.returncode == 0, finished.stdout
    return finished.stdout


def only(paths):
    (path,) = paths
    return path


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    missing = [tool for tool in TOOLS if not importlib.util.find_spec(tool)]  # imported here, some disturb each other
    if missing:
        pytest.skip(f"there is no {', no '.join(missing)}")
    return tmp_path_factory.mktemp("empty")


@pytest.fixture(scope="module")
def source_distribution(folder):
    repository = shutil.copytree(ROOT, folder / "repository", ignore=NO_PART)
    output_of(sys.executable, "-m", "build", "--no-isolation", "--sdist", "--outdir", folder, repository, folder=folder)
    shutil.rmtree(repository)
    return only(folder.glob("dynamic*.tar.gz"))


@pytest.fixture(scope="module")
def wheel(folder, source_distribution):
    shutil.unpack_archive(source_distribution, folder / "unpacked")
    source = only((folder / "unpacked").iterdir())
    options = folder / "options.cfg"
    inside = BUILD.relative_to(ROOT) if BUILD.is_relative_to(ROOT) else pathlib.Path("build")
    options.write_text(f"[build]\nbuild_temp = {inside}\n")
    output_of(sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-index", "--no-deps", "--wheel-dir", folder,
              source, folder=folder, DIST_EXTRA_CONFIG=str(options))
    shutil.rmtree(source)
    return only(folder.glob("*.whl"))


def test_a_wheel_of_the_source_distribution_proves_its_first_frame(folder, wheel):
    place = folder / "environment"
    output_of(sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", place, folder=folder)
    python = place / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    output_of(sys.executable, "-m", "pip", "--python", python, "install", "--no-index", wheel, folder=folder)
    file, version, certified = output_of(python, "-c", FIRST_FRAME, folder=folder).split("\n")[:3]
    assert pathlib.Path(file).is_relative_to(place)
    assert version == wheel.name.split("-")[1]
    assert certified == "True"


def test_a_wheel_says_for_which_python_and_numpy_it_is(wheel):
    import pybind11

    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        metadata = email.message_from_bytes(archive.read(only(n for n in names if n.endswith("/METADATA"))))
    modules = {path.name for path in (ROOT / "bindings/python/dynamic_delaunay").glob("*.py*") if path.is_file()}
    core = only(n for n in names if n.startswith("dynamic_delaunay/_core.") and not n.endswith(".pyi"))
    assert {n.partition("/")[2] for n in names if n.startswith("dynamic_delaunay/")} == \
        {*modules, "py.typed", core.partition("/")[2]}
    assert any(n.endswith("/LICENSE") for n in names)
    assert metadata["Description-Content-Type"] == "text/markdown"
    readme = (ROOT / "bindings/python/README.md").read_text()
    assert metadata.get_payload(decode=True).decode().strip() == readme.strip()
    assert f"-cp{sys.version_info[0]}{sys.version_info[1]}-" in wheel.name
    assert metadata["Name"] == "dynamic-delaunay" and metadata["Requires-Python"] == ">=3.9"
    requirement = metadata["Requires-Dist"].replace(" ", "").replace("(", "").replace(")", "")
    assert requirement.startswith("numpy") and ">=1.20" in requirement
    assert ("<2" in requirement) == (pybind11.version_info[:2] < (2, 12))
