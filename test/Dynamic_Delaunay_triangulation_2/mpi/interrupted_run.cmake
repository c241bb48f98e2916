# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A rank that dies or throws ends the run within seconds, with a message; another number of ranks continues from the last
# complete checkpoint. RUN_RANKS is the command up to the number of ranks, PROGRAM is that of all themes.

set(file "${CMAKE_CURRENT_BINARY_DIR}/interrupted_run.checkpoint")

# expect_end(MODE MESSAGE): MESSAGE is a regular expression
function(expect_end mode message)
  file(REMOVE "${file}")
  string(TIMESTAMP begin "%s")
  execute_process(COMMAND ${RUN_RANKS} 4 "${PROGRAM}" interrupted_run "${file}" ${mode}
    RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text TIMEOUT 60)
  string(TIMESTAMP end "%s")
  math(EXPR seconds "${end} - ${begin}")
  if(result EQUAL 0 OR NOT text MATCHES "${message}")
    message(FATAL_ERROR "${mode}: ended with ${result}, and said\n${text}")
  endif()
  if(seconds GREATER 30)
    message(FATAL_ERROR "${mode}: ended after ${seconds} seconds only")
  endif()
endfunction()

function(expect_continuation ranks frame)
  execute_process(COMMAND ${RUN_RANKS} ${ranks} "${PROGRAM}" interrupted_run "${file}" resume ${frame}
    RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text TIMEOUT 60)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ranks} ranks do not continue: ${result}\n${text}")
  endif()
endfunction()

expect_end(kill "(rank 3 |BAD TERMINATION).*signal 9") # Open MPI, MPICH
expect_continuation(4 30)
expect_continuation(3 30)
expect_continuation(1 30)
expect_end(throw "the last rank has had enough")
expect_continuation(2 40)
file(REMOVE "${file}" "${file}.unfinished")
