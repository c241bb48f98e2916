# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A toolchain file: programs for 64-bit ARM, compiled here by Debian's g++-aarch64-linux-gnu and run by its qemu-user.
# Headers are this machine's, as those of CGAL and Boost are the same on every one. CGAL's own numbers stand in for
# GMP's, so no package of another architecture is needed.

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /usr/aarch64-linux-gnu)
set(CGAL_DISABLE_GMP ON)
file(GLOB CGAL_DIR /usr/lib/cmake/CGAL /usr/lib/*/cmake/CGAL) # says where headers are, whatever the processor
