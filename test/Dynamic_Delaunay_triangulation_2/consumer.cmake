# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds and runs README's first program, in the project that README shows, with the package in each way that CMake has:
# installed; fetched, from an archive as a release has it; and as a subdirectory.

cmake_minimum_required(VERSION 3.20)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

if(NOT CCACHE)
  set(CCACHE "")
endif()
set(without_tbb "")
if(NOT TBB)
  set(without_tbb -D CMAKE_DISABLE_FIND_PACKAGE_TBB=ON)
endif()

# configure_consumer(SOURCE DIRECTORY cmake options): with TBB where the package is built with it, and only there
function(configure_consumer source directory)
  run("${CMAKE_COMMAND}" -S "${source}" -B "${directory}" -G "${GENERATOR}" -D "CMAKE_CXX_COMPILER=${COMPILER}"
    -D "CMAKE_CXX_COMPILER_LAUNCHER=${CCACHE}" -D "CGAL_DIR=${CGAL_DIR}" -D CMAKE_BUILD_TYPE=Debug
    -D CMAKE_CXX_FLAGS_DEBUG=-O0 -D CMAKE_EXPORT_COMPILE_COMMANDS=ON ${without_tbb} ${ARGN})
  if(EXISTS "${directory}/compile_commands.json") # not all generators write it
    file(READ "${directory}/compile_commands.json" commands)
    if(commands MATCHES "CGAL_LINKED_WITH_TBB")
      set(has_tbb 1)
    else()
      set(has_tbb 0)
    endif()
    if(NOT has_tbb EQUAL TBB)
      message(FATAL_ERROR "CGAL_LINKED_WITH_TBB: package ${TBB}, consumer ${has_tbb}")
    endif()
  endif()
endfunction()

function(build_and_run directory)
  run("${CMAKE_COMMAND}" --build "${directory}" --config Debug)
  find_program(program_file my_program PATHS "${directory}" "${directory}/Debug" NO_DEFAULT_PATH REQUIRED)
  run("${program_file}")
  unset(program_file CACHE)
endfunction()

set(project "${WORK}/project")
set(prefix "${WORK}/prefix")
file(REMOVE_RECURSE "${WORK}")

# write_shown(LANGUAGE FILE): README's first block in this language
function(write_shown language file)
  file(READ "${SOURCE}/README.md" text)
  set(fence "\n```${language}\n")
  string(FIND "${text}" "${fence}" begin)
  string(LENGTH "${fence}" length)
  math(EXPR begin "${begin} + ${length}")
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(FIND "${text}" "```" length)
  string(SUBSTRING "${text}" 0 ${length} text)
  file(WRITE "${file}" "${text}")
endfunction()
write_shown(cpp "${project}/main.cpp")
write_shown(cmake "${project}/CMakeLists.txt")

# What is installed may be moved.
run("${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIG}" --prefix "${WORK}/somewhere")
file(RENAME "${WORK}/somewhere" "${prefix}")
file(GLOB_RECURSE headers RELATIVE "${SOURCE}/include" "${SOURCE}/include/*.h")
file(GLOB_RECURSE installed RELATIVE "${prefix}/include" "${prefix}/include/*")
if(NOT installed STREQUAL headers)
  message(FATAL_ERROR "Installed were\n${installed}\ninstead of\n${headers}")
endif()

configure_consumer("${project}" "${WORK}/installed" -D "CMAKE_PREFIX_PATH=${prefix}")
load_cache("${WORK}/installed" READ_WITH_PREFIX "" Dynamic_Delaunay_triangulation_2_DIR)
if(NOT Dynamic_Delaunay_triangulation_2_DIR MATCHES "^${prefix}/")
  message(FATAL_ERROR "Found ${Dynamic_Delaunay_triangulation_2_DIR}, not what was installed")
endif()
build_and_run("${WORK}/installed")
file(READ "${project}/CMakeLists.txt" shown_lists)
function(link_library)
  file(READ "${project}/CMakeLists.txt" lists)
  string(REGEX REPLACE "::Dynamic_Delaunay_triangulation_2\\)" "::compiled)" lists "${lists}")
  file(WRITE "${project}/CMakeLists.txt" "${lists}")
endfunction()
link_library()
run("${CMAKE_COMMAND}" "${WORK}/installed")
build_and_run("${WORK}/installed")

# The two others replace the line find_package(). They need nothing but the headers, CMakeLists.txt and cmake/. Both take
# the headers from one place. With the installed package and the subdirectory the program also links the library.
function(write_lists lines)
  string(REGEX REPLACE "find_package\\([^\n]*" "${lines}" lists "${shown_lists}")
  file(WRITE "${project}/CMakeLists.txt" "${lists}")
endfunction()
set(archive "${WORK}/archive.tar.gz")
execute_process(COMMAND "${CMAKE_COMMAND}" -E tar czf "${archive}" CMakeLists.txt cmake include WORKING_DIRECTORY "${SOURCE}"
  COMMAND_ERROR_IS_FATAL ANY)
file(SHA256 "${archive}" hash)
write_lists("include(FetchContent)
FetchContent_Declare(Dynamic_Delaunay_triangulation_2 URL \"file://${archive}\" URL_HASH SHA256=${hash})
FetchContent_MakeAvailable(Dynamic_Delaunay_triangulation_2)")
configure_consumer("${project}" "${WORK}/fetched")
build_and_run("${WORK}/fetched")
write_lists("add_subdirectory(\"${WORK}/fetched/_deps/dynamic_delaunay_triangulation_2-src\" package)")
link_library()
configure_consumer("${project}" "${WORK}/subdirectory")
build_and_run("${WORK}/subdirectory")
