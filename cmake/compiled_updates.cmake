# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Target Dynamic_Delaunay_triangulation_2::compiled: the package, with the code of its updates in a static library, so that
# programs need not compile it in each of their files. It is built where the program is, with the same options, and only
# if a program links it. Target Dynamic_Delaunay_triangulation_2::compiled_parallel has that code for Parallel_tag. A
# program that uses triangulations with and without this tag links both. Targets compiled_3 and compiled_3_parallel do the
# same for points in space.

# SUFFIX DIMENSION HEADER FIRST LAST: the target of this suffix, a library of these parts of the header.
function(add_compiled_updates suffix dimension header first last)
  set(name Dynamic_Delaunay_triangulation_2_${suffix})
  if(TARGET ${name})
    return()
  endif()
  set(macro CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_${dimension}_COMPILED)
  set(sources "")
  foreach(part RANGE ${first} ${last})
    set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}_${part}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "#define ${macro}_PART ${part}
#include <CGAL/${header}>
" @ONLY)
    list(APPEND sources "${source}")
  endforeach()
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${sources})
  target_link_libraries(${name} PUBLIC Dynamic_Delaunay_triangulation_2::Dynamic_Delaunay_triangulation_2)
  target_compile_definitions(${name} PUBLIC ${macro})
  if(suffix MATCHES "parallel")
    target_compile_definitions(${name} PUBLIC ${macro}_PARALLEL)
  endif()
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  add_library(Dynamic_Delaunay_triangulation_2::${suffix} ALIAS ${name})
endfunction()

set(header Dynamic_Delaunay_triangulation_2/compiled_updates.h)
add_compiled_updates(compiled 2 ${header} 1 2)
add_compiled_updates(compiled_parallel 2 ${header} 3 4)
set(header Dynamic_Delaunay_triangulation_3/compiled/compiled_updates.h)
add_compiled_updates(compiled_3 3 ${header} 1 2)
add_compiled_updates(compiled_3_parallel 3 ${header} 3 4)
