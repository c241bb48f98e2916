# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs the package, and builds and runs consumer/ with what was installed. Then configures consumer/ with the
# package as a subdirectory.

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

# configure_consumer(DIRECTORY cmake options): with TBB where the package is built with it, and only there
function(configure_consumer directory)
  run("${CMAKE_COMMAND}" -S "${consumer}" -B "${directory}" -G "${GENERATOR}" -D "CMAKE_CXX_COMPILER=${COMPILER}"
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

set(consumer "${CMAKE_CURRENT_LIST_DIR}/consumer")
set(prefix "${WORK}/prefix")
file(REMOVE_RECURSE "${WORK}")

# The program is README's first one, after comments that README has no use for.
file(READ "${SOURCE}/README.md" readme)
file(READ "${consumer}/main.cpp" program)
string(FIND "${readme}" "\n```cpp\n" begin)
math(EXPR begin "${begin} + 8")
string(SUBSTRING "${readme}" ${begin} -1 readme)
string(FIND "${readme}" "```" length)
string(SUBSTRING "${readme}" 0 ${length} readme)
string(REGEX REPLACE "^(//[^\n]*\n|\n)+" "" program "${program}")
if(NOT program STREQUAL readme)
  message(FATAL_ERROR "consumer/main.cpp is not the first program of README.md")
endif()

# What is installed may be moved.
run("${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIG}" --prefix "${WORK}/somewhere")
file(RENAME "${WORK}/somewhere" "${prefix}")
file(GLOB_RECURSE headers RELATIVE "${SOURCE}/include" "${SOURCE}/include/*.h")
file(GLOB_RECURSE installed RELATIVE "${prefix}/include" "${prefix}/include/*")
if(NOT installed STREQUAL headers)
  message(FATAL_ERROR "Installed were\n${installed}\ninstead of\n${headers}")
endif()

configure_consumer("${WORK}/installed" -D "CMAKE_PREFIX_PATH=${prefix}")
load_cache("${WORK}/installed" READ_WITH_PREFIX "" Dynamic_Delaunay_triangulation_2_DIR)
if(NOT Dynamic_Delaunay_triangulation_2_DIR MATCHES "^${prefix}/")
  message(FATAL_ERROR "Found ${Dynamic_Delaunay_triangulation_2_DIR}, not what was installed")
endif()
run("${CMAKE_COMMAND}" --build "${WORK}/installed" --config Debug)
find_program(program_file consumer PATHS "${WORK}/installed" "${WORK}/installed/Debug" NO_DEFAULT_PATH REQUIRED)
run("${program_file}")

configure_consumer("${WORK}/subdirectory" -D "PACKAGE_SOURCE=${SOURCE}")
