# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

import os
import pathlib
import shutil
import subprocess
import sys

import pytest

BUILD = os.environ.get("BUILD", "")
TOOLS = ("cpack", "dpkg-deb", "dpkg-shlibdeps", "file")


def output_of(*command, **options):
    return subprocess.run([*map(str, command)], check=True, capture_output=True, text=True, **options).stdout


@pytest.mark.skipif(not BUILD or not all(map(shutil.which, TOOLS)), reason="there is no build folder, or no dpkg-dev")
def test_the_debian_package_can_be_imported(tmp_path):
    output_of("cpack", "-G", "DEB", "--config", pathlib.Path(BUILD, "CPackPythonConfig.cmake"), "-B", tmp_path)
    (package,) = tmp_path.glob("python3-dynamic-delaunay_*.deb")
    info = output_of("dpkg-deb", "--info", package)
    for line in ("Package: python3-dynamic-delaunay", "Section: python", "python3-numpy", "libc6", "libgmp10"):
        assert line in info
    assert "Architecture: all" not in info
    output_of("dpkg-deb", "--extract", package, tmp_path / "root")
    modules = tmp_path / "root/usr/lib/python3/dist-packages"
    program = "import dynamic_delaunay as d; print(d.__file__); print(d.DynamicDelaunay([(0, 0), (1, 0), (0, 1)]))"
    environment = {**os.environ, "PYTHONPATH": str(modules)}
    file, shown = output_of(sys.executable, "-B", "-c", program, env=environment, cwd=tmp_path).splitlines()
    assert file.startswith(str(modules))
    assert shown == "<DynamicDelaunay of 3 points, certified>"
    files = {path.name for path in modules.rglob("*")}
    assert {"py.typed", "_core.pyi", "errors.py"} <= files
    assert (tmp_path / "root/usr/share/doc/python3-dynamic-delaunay/copyright").is_file()
