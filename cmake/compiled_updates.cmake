# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Target Dynamic_Delaunay_triangulation_2::compiled: the package, with the code of its updates in a static library, so that
# programs need not compile it in each of their files. It is built where the program is, with the same options, and only
# if a program links it. Target Dynamic_Delaunay_triangulation_2::compiled_parallel has that code for Parallel_tag. A
# program that uses triangulations with and without this tag links both.

# NAME FIRST LAST: a library of these parts of compiled_updates.h.
function(add_compiled_updates name first last)
  set(sources "")
  foreach(part RANGE ${first} ${last})
    set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}_${part}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_PART ${part}
#include <CGAL/Dynamic_Delaunay_triangulation_2/compiled_updates.h>
" @ONLY)
    list(APPEND sources "${source}")
  endforeach()
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${sources})
  target_link_libraries(${name} PUBLIC Dynamic_Delaunay_triangulation_2::Dynamic_Delaunay_triangulation_2)
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
endfunction()

if(NOT TARGET Dynamic_Delaunay_triangulation_2_compiled)
  add_compiled_updates(Dynamic_Delaunay_triangulation_2_compiled 1 4)
  target_compile_definitions(Dynamic_Delaunay_triangulation_2_compiled PUBLIC
    CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED)
  add_library(Dynamic_Delaunay_triangulation_2::compiled ALIAS Dynamic_Delaunay_triangulation_2_compiled)
endif()

if(NOT TARGET Dynamic_Delaunay_triangulation_2_compiled_parallel)
  add_compiled_updates(Dynamic_Delaunay_triangulation_2_compiled_parallel 5 8)
  target_compile_definitions(Dynamic_Delaunay_triangulation_2_compiled_parallel PUBLIC
    CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_PARALLEL)
  add_library(Dynamic_Delaunay_triangulation_2::compiled_parallel ALIAS
    Dynamic_Delaunay_triangulation_2_compiled_parallel)
endif()
