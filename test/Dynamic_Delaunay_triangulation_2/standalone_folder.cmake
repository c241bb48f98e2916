# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Configures a folder of programs by itself, as CGAL's testsuite does. If one of its programs is given as well, CTest
# builds and runs it there.

cmake_minimum_required(VERSION 3.20)

if(NOT CCACHE)
  set(CCACHE "")
endif()
file(REMOVE_RECURSE "${WORK}")
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${FOLDER}" -B "${WORK}" -G "${GENERATOR}"
  -D "CMAKE_CXX_COMPILER=${COMPILER}" -D "CMAKE_CXX_COMPILER_LAUNCHER=${CCACHE}" -D "CMAKE_CXX_FLAGS=${FLAGS}"
  -D "CGAL_DIR=${CGAL_DIR}" -D BUILD_TESTING=ON -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG=-O0
  COMMAND_ERROR_IS_FATAL ANY)
if(PROGRAM)
  execute_process(COMMAND "${CTEST}" --test-dir "${WORK}" -C Debug --output-on-failure -R "${PROGRAM}$"
    OUTPUT_VARIABLE output ECHO_OUTPUT_VARIABLE COMMAND_ERROR_IS_FATAL ANY)
  foreach(step IN ITEMS compilation execution)
    if(NOT output MATCHES "${step}[ _]+of[ _]+${PROGRAM} [.]+ +Passed")
      message(FATAL_ERROR "CTest shows no ${step} of ${PROGRAM}")
    endif()
  endforeach()
endif()
