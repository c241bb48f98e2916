# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Builds the module by CMake, with the options in the environment variable CMAKE_ARGS. The rest is in pyproject.toml."""

import os
import pathlib
import re
import shlex
import subprocess
import sys

import pybind11
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
VERSION_HEADER = ROOT / "include/CGAL/Dynamic_Delaunay_triangulation_2/version.h"
LEFT_OUT = [f"-DWITH_{part}=OFF" for part in ("TESTS", "RUNNER", "EXAMPLES", "BENCHMARKS", "PAGE")]


def version():
    parts = re.findall(r"_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", VERSION_HEADER.read_text(), re.M)
    return ".".join(parts)


def numpy():
    """The module asks NumPy for its functions when it is loaded, which NumPy 2 answers since pybind11 2.12."""
    return "numpy>=1.20" if pybind11.version_info[:2] >= (2, 12) else "numpy>=1.20,<2"


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        build = pathlib.Path(self.build_temp).resolve()
        built = build / "python/dynamic_delaunay" / pathlib.Path(self.get_ext_filename(extension.name)).name
        options = [*LEFT_OUT, f"-DPython_EXECUTABLE={sys.executable}", *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *options], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "_core", "--parallel"], check=True)
        self.copy_file(built, self.get_ext_fullpath(extension.name))


setup(
    version=version(),
    install_requires=[numpy()],
    ext_modules=[Extension("dynamic_delaunay._core", sources=[])],
    cmdclass={"build_ext": BuildByCMake},
)
