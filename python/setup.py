# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Builds the module by CMake, which needs the repository around this folder. The rest is in pyproject.toml."""

import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent.parent
VERSION_HEADER = ROOT / "include/CGAL/Dynamic_Delaunay_triangulation_2/version.h"
LEFT_OUT = [f"-DWITH_{part}=OFF" for part in ("TESTS", "RUNNER", "EXAMPLES", "BENCHMARKS")]


def version():
    parts = re.findall(r"_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", VERSION_HEADER.read_text(), re.M)
    return ".".join(parts)


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        build = pathlib.Path(self.build_temp).resolve()
        built = build / "python/dynamic_delaunay" / pathlib.Path(self.get_ext_filename(extension.name)).name
        subprocess.run(
            ["cmake", "-S", ROOT, "-B", build, *LEFT_OUT, f"-DPython_EXECUTABLE={sys.executable}"], check=True
        )
        subprocess.run(["cmake", "--build", build, "--target", "_core", "--parallel"], check=True)
        self.copy_file(built, self.get_ext_fullpath(extension.name))


setup(
    version=version(),
    ext_modules=[Extension("dynamic_delaunay._core", sources=[])],
    cmdclass={"build_ext": BuildByCMake},
)
