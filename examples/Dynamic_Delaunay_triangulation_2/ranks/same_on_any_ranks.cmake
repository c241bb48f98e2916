# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# expect_same(N [options]): the program ends with the same positions, bit for bit, as the last time. RUN_RANKS is the
# command up to the number of ranks.

set(expected "")

function(expect_same ranks)
  execute_process(COMMAND ${RUN_RANKS} ${ranks} "${PROGRAM}" ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL 0 OR NOT text MATCHES "all positions: ([0-9a-f]+)")
    message(FATAL_ERROR "${ranks} ranks, ${ARGN}: ended with ${result}, and said\n${text}")
  endif()
  set(bits "${CMAKE_MATCH_1}")
  if(expected AND NOT bits STREQUAL expected)
    message(FATAL_ERROR "${ranks} ranks, ${ARGN}: ${bits} instead of ${expected}")
  endif()
  set(expected "${bits}" PARENT_SCOPE)
endfunction()
