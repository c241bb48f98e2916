# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The target of the scenarios, which use the package like any other program does.

find_package(nlohmann_json QUIET)
find_package(CLI11 QUIET)
find_package(ZLIB QUIET)
if(nlohmann_json_FOUND)
  # The folder that holds examples/ and scenarios/, in the repository and where both are installed.
  get_filename_component(top "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
  add_library(scenario INTERFACE)
  target_include_directories(scenario INTERFACE "${top}/examples/Dynamic_Delaunay_triangulation_2")
  target_link_libraries(scenario INTERFACE program_settings nlohmann_json::nlohmann_json)
  if(ZLIB_FOUND)
    target_link_libraries(scenario INTERFACE ZLIB::ZLIB)
    target_compile_definitions(scenario INTERFACE SCENARIO_HAS_ZLIB)
  else()
    message(STATUS "No files compressed by gzip for run_scenario: they need zlib")
  endif()
  target_compile_definitions(scenario INTERFACE
    SCENARIOS_DIR="${top}/scenarios"
    SHARED_DATA_DIR="${top}/../shared/data") # recorded motion, where it is at hand
  unset(top)
endif()
