# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Target Dynamic_Delaunay_triangulation_2::compiled: the package, with the code of its updates in a static library, so that
# programs need not compile it in each of their files. It is built where the program is, with the same options, and only
# if a program links it.

if(NOT TARGET Dynamic_Delaunay_triangulation_2_compiled)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/Dynamic_Delaunay_triangulation_2_compiled.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "#include <CGAL/Dynamic_Delaunay_triangulation_2/compiled_updates.h>\n" @ONLY)
  add_library(Dynamic_Delaunay_triangulation_2_compiled STATIC EXCLUDE_FROM_ALL "${source}")
  unset(source)
  target_compile_definitions(Dynamic_Delaunay_triangulation_2_compiled PUBLIC
    CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED)
  target_link_libraries(Dynamic_Delaunay_triangulation_2_compiled PUBLIC
    Dynamic_Delaunay_triangulation_2::Dynamic_Delaunay_triangulation_2)
  set_target_properties(Dynamic_Delaunay_triangulation_2_compiled PROPERTIES POSITION_INDEPENDENT_CODE ON)
  add_library(Dynamic_Delaunay_triangulation_2::compiled ALIAS Dynamic_Delaunay_triangulation_2_compiled)
endif()
