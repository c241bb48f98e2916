# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The tests of what may be different on another processor, compiled for it and run by CMAKE_CROSSCOMPILING_EMULATOR.
# They are optimized, as compilers contract products and sums only then.

set(GOOGLETEST_SOURCE /usr/src/googletest CACHE PATH "GoogleTest, which is compiled for that processor as well")
set(INSTALL_GTEST OFF)
set(BUILD_GMOCK OFF)
enable_language(C)
add_subdirectory("${GOOGLETEST_SOURCE}" googletest EXCLUDE_FROM_ALL)
foreach(name IN ITEMS test_exact_motion test_filters test_indexed_data_structure test_periodic test_robustness_findings
    test_safe_edges)
  add_executable(${name} ${name}.cpp)
  target_compile_options(${name} PRIVATE -UNDEBUG $<$<CONFIG:Release>:-O2>)
  target_compile_definitions(${name} PRIVATE _GLIBCXX_ASSERTIONS)
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE program_settings GTest::gtest_main)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS test TIMEOUT 3000)
endforeach()
