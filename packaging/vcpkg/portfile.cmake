# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Headers alone: TBB is looked for where a program is built.

set(VCPKG_BUILD_TYPE release)
vcpkg_download_distfile(archive
  URLS "@HOMEPAGE@/${PORT}-${VERSION}.tar.gz"
  FILENAME "${PORT}-${VERSION}.tar.gz"
  SHA512 @SHA512@)
vcpkg_extract_source_archive(source ARCHIVE "${archive}")
vcpkg_cmake_configure(SOURCE_PATH "${source}"
  OPTIONS -DWITH_TESTS=OFF -DWITH_RUNNER=OFF -DWITH_EXAMPLES=OFF -DWITH_BENCHMARKS=OFF -DWITH_PYTHON=OFF -DWITH_PAGE=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME Dynamic_Delaunay_triangulation_2
  CONFIG_PATH share/cmake/Dynamic_Delaunay_triangulation_2)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/share/doc")
vcpkg_install_copyright(FILE_LIST "${source}/LICENSE")
