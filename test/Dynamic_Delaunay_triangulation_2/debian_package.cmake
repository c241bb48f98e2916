# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the Debian package, and looks at what it says and holds. Unpacks it, and builds and runs an example with it.

cmake_minimum_required(VERSION 3.20)

if(NOT CCACHE)
  set(CCACHE "")
endif()

function(expect text)
  foreach(line IN LISTS ARGN)
    if(NOT text MATCHES "(^|\n) *${line}\n")
      message(FATAL_ERROR "No line '${line}' in\n${text}")
    endif()
  endforeach()
endfunction()

set(name libcgal-dynamic-delaunay-triangulation-2-dev)
file(REMOVE_RECURSE "${WORK}" "${BUILD}/manual")
if(MANUAL)
  execute_process(COMMAND "${CMAKE_COMMAND}" --build "${BUILD}" --config "${CONFIG}" --target manual
    COMMAND_ERROR_IS_FATAL ANY)
endif()
execute_process(COMMAND "${CPACK}" -G DEB -C "${CONFIG}" --config "${BUILD}/CPackConfig.cmake" -B "${WORK}"
  COMMAND_ERROR_IS_FATAL ANY)
set(package "${WORK}/${name}_${VERSION}_all.deb")
execute_process(COMMAND "${DPKG_DEB}" --info "${package}" OUTPUT_VARIABLE info COMMAND_ERROR_IS_FATAL ANY)
expect("${info}" "Package: ${name}" "Version: ${VERSION}" "Architecture: all" "Section: libdevel"
  "Depends: libcgal-dev [^\n]*" "Recommends: libjs-mathjax, libtbb-dev" "Suggests: libcgal-qt5-dev"
  "Maintainer: [^\n]* <[^\n]*@[^\n]*>" "Description: [^\n]+")

execute_process(COMMAND "${DPKG_DEB}" --contents "${package}" OUTPUT_VARIABLE contents COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE files RELATIVE "${SOURCE}" "${SOURCE}/include/*.h")
foreach(file IN ITEMS Config ConfigVersion Targets)
  list(APPEND files "share/cmake/Dynamic_Delaunay_triangulation_2/Dynamic_Delaunay_triangulation_2${file}.cmake")
endforeach()
list(APPEND files "share/cmake/Dynamic_Delaunay_triangulation_2/compiled_updates.cmake")
foreach(file IN ITEMS README.md CHANGELOG.md LICENSE copyright)
  list(APPEND files "share/doc/${name}/${file}")
endforeach()
file(GLOB_RECURSE documents RELATIVE "${SOURCE}" "${SOURCE}/examples/*")
if(MANUAL)
  file(GLOB_RECURSE pages RELATIVE "${BUILD}/manual" "${BUILD}/manual/html/*")
  list(FILTER pages EXCLUDE REGEX "^html/mathjax/")
  if(NOT "html/index.html" IN_LIST pages)
    message(FATAL_ERROR "No manual was made")
  endif()
  list(APPEND documents ${pages})
  expect("${contents}"
    "lrwxrwxrwx root/root [^\n]* \\./usr/share/doc/${name}/html/mathjax -> ../../../javascript/mathjax")
endif()
list(TRANSFORM documents PREPEND "share/doc/${name}/")
list(APPEND files ${documents})
foreach(file IN LISTS files)
  expect("${contents}" "-rw-r--r-- root/root [^\n]* \\./usr/${file}")
endforeach()
# Nothing else: the lines that are not of folders
string(REGEX MATCHALL "(^|\n)-" lines "${contents}")
list(LENGTH lines number_of_lines)
list(LENGTH files number_of_files)
if(NOT number_of_lines EQUAL number_of_files)
  message(FATAL_ERROR "${number_of_lines} files instead of ${number_of_files}:\n${contents}")
endif()

set(root "${WORK}/root")
set(example "${WORK}/example")
execute_process(COMMAND "${DPKG_DEB}" --extract "${package}" "${root}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${root}/usr/share/doc/${name}/examples/Dynamic_Delaunay_triangulation_2"
  -B "${example}" -G "${GENERATOR}" -D "CMAKE_PREFIX_PATH=${root}/usr" -D "CMAKE_CXX_COMPILER=${COMPILER}"
  -D "CMAKE_CXX_COMPILER_LAUNCHER=${CCACHE}" -D "CGAL_DIR=${CGAL_DIR}" -D CMAKE_BUILD_TYPE=Debug
  -D CMAKE_CXX_FLAGS_DEBUG=-O0 COMMAND_ERROR_IS_FATAL ANY)
load_cache("${example}" READ_WITH_PREFIX "" Dynamic_Delaunay_triangulation_2_DIR)
if(NOT Dynamic_Delaunay_triangulation_2_DIR MATCHES "^${root}/")
  message(FATAL_ERROR "Found ${Dynamic_Delaunay_triangulation_2_DIR}, not what was unpacked")
endif()
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${example}" --config Debug --target hello_world
  COMMAND_ERROR_IS_FATAL ANY)
find_program(hello_world hello_world PATHS "${example}" "${example}/Debug" NO_DEFAULT_PATH REQUIRED)
execute_process(COMMAND "${hello_world}" COMMAND_ERROR_IS_FATAL ANY)
