# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The same positions on any number of ranks, and when the run is interrupted on the way.

include("${CMAKE_CURRENT_LIST_DIR}/same_on_any_ranks.cmake")

set(checkpoint "${CMAKE_CURRENT_BINARY_DIR}/dam_break.checkpoint")
file(REMOVE "${checkpoint}")
set(options --quiet --points 400 --frames 700)
expect_same(1 ${options})
expect_same(2 ${options})
expect_same(4 ${options})
expect_same(3 ${options} --checkpoint "${checkpoint}") # written in frame 500
if(NOT EXISTS "${checkpoint}")
  message(FATAL_ERROR "there is no checkpoint")
endif()
expect_same(2 ${options} --checkpoint "${checkpoint}")
file(REMOVE "${checkpoint}")
