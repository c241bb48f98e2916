# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the Debian package, and looks at what it says and holds.

cmake_minimum_required(VERSION 3.20)

function(expect text)
  foreach(line IN LISTS ARGN)
    if(NOT text MATCHES "(^|\n) *${line}\n")
      message(FATAL_ERROR "No line '${line}' in\n${text}")
    endif()
  endforeach()
endfunction()

set(name libcgal-dynamic-delaunay-triangulation-2-dev)
file(REMOVE_RECURSE "${WORK}")
execute_process(COMMAND "${CPACK}" -G DEB -C "${CONFIG}" --config "${BUILD}/CPackConfig.cmake" -B "${WORK}"
  COMMAND_ERROR_IS_FATAL ANY)
set(package "${WORK}/${name}_${VERSION}_all.deb")
execute_process(COMMAND "${DPKG_DEB}" --info "${package}" OUTPUT_VARIABLE info COMMAND_ERROR_IS_FATAL ANY)
expect("${info}" "Package: ${name}" "Version: ${VERSION}" "Architecture: all" "Section: libdevel"
  "Depends: libcgal-dev [^\n]*" "Recommends: libtbb-dev" "Maintainer: [^\n]* <[^\n]*@[^\n]*>" "Description: [^\n]+")

execute_process(COMMAND "${DPKG_DEB}" --contents "${package}" OUTPUT_VARIABLE contents COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE files RELATIVE "${SOURCE}" "${SOURCE}/include/*.h")
foreach(file IN ITEMS Config ConfigVersion Targets)
  list(APPEND files "share/cmake/Dynamic_Delaunay_triangulation_2/Dynamic_Delaunay_triangulation_2${file}.cmake")
endforeach()
foreach(file IN ITEMS README.md CHANGELOG.md LICENSE copyright)
  list(APPEND files "share/doc/${name}/${file}")
endforeach()
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
