# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The dam break ends with the same positions, bit for bit, on any number of ranks, and when it is interrupted on the way.
# RUN_RANKS is the command up to the number of ranks.

set(checkpoint "${CMAKE_CURRENT_BINARY_DIR}/dam_break.checkpoint")
file(REMOVE "${checkpoint}")
set(expected "")

function(expect_same ranks)
  execute_process(COMMAND ${RUN_RANKS} ${ranks} "${PROGRAM}" --quiet --points 400 ${ARGN}
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

expect_same(1 --frames 700)
expect_same(2 --frames 700)
expect_same(4 --frames 700)
expect_same(3 --frames 700 --checkpoint "${checkpoint}") # written in frame 500
if(NOT EXISTS "${checkpoint}")
  message(FATAL_ERROR "there is no checkpoint")
endif()
expect_same(2 --frames 700 --checkpoint "${checkpoint}")
file(REMOVE "${checkpoint}")
