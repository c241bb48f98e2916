# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class DynamicDelaunayTriangulation2(CMakePackage):
    """A C++ package in the style of CGAL, headers alone, that keeps the Delaunay triangulation of moving points exact,
    frame by frame, in the plane and in periodic cells."""

    homepage = "@HOMEPAGE@"
    url = "@HOMEPAGE@/dynamic-delaunay-triangulation-2-@VERSION@.tar.gz"

    license("GPL-3.0-or-later")

    version("@VERSION@", sha256="@SHA256@")

    variant("tbb", default=True, description="Several threads for one triangulation")

    depends_on("cxx", type="build")
    depends_on("cmake@3.20:", type="build")
    depends_on("cgal@5.5:")
    depends_on("tbb", when="+tbb")

    def cmake_args(self):
        return [self.define(f"WITH_{part}", False)
                for part in ("TESTS", "RUNNER", "EXAMPLES", "BENCHMARKS", "PYTHON", "PAGE")]
