# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The same positions on any number of ranks.

include("${CMAKE_CURRENT_LIST_DIR}/same_on_any_ranks.cmake")

foreach(ranks IN ITEMS 1 2 3 4)
  expect_same(${ranks})
endforeach()
