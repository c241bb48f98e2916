# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Tests of the package as a whole: each header by itself, the installed package, the Debian package, the manual, and
# the licences.

# Each header has to bring all that it needs, and to bear being included twice. That they compile is the test. A
# precompiled header or a unity build would hide what is missing. The internal ones are many, and a user includes none
# of them alone: they take a minute and a half more of two cores.
option(CHECK_INTERNAL_HEADERS "Compile internal headers by themselves, too" OFF)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/include" "${PROJECT_SOURCE_DIR}/include/*.h")
if(NOT CHECK_INTERNAL_HEADERS)
  list(FILTER headers EXCLUDE REGEX "/internal/")
endif()
# That one is a program's source file: CMake's target `compiled` includes nothing else.
list(FILTER headers EXCLUDE REGEX "/compiled_updates\\.h$")
if(NOT MPI_CXX_FOUND)
  list(FILTER headers EXCLUDE REGEX "/(Distributed_[a-zA-Z_]*|Message_exchange)_2\\.h$")
endif()
set(sources "")
foreach(header IN LISTS headers)
  string(REGEX REPLACE "\\.h$" ".cpp" source "${CMAKE_CURRENT_BINARY_DIR}/headers/${header}")
  file(CONFIGURE OUTPUT "${source}" CONTENT "#include <@header@>\n#include <@header@>\n" @ONLY)
  list(APPEND sources "${source}")
endforeach()
add_library(self_sufficient_headers OBJECT ${sources})
target_link_libraries(self_sufficient_headers PRIVATE program_settings $<TARGET_NAME_IF_EXISTS:MPI::MPI_CXX>)
set_target_properties(self_sufficient_headers PROPERTIES UNITY_BUILD OFF)
if(NOT MSVC)
  # Assertions need their includes as well. The result is not run.
  target_compile_options(self_sufficient_headers PRIVATE -UNDEBUG -O0)
endif()

# Nothing in headers is defined twice where several files of a program include them. That it links is the test.
file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/linked_headers.cpp" CONTENT "int main() {}\n" @ONLY)
add_executable(linked_headers "${CMAKE_CURRENT_BINARY_DIR}/linked_headers.cpp")
target_link_libraries(linked_headers PRIVATE program_settings self_sufficient_headers
  $<TARGET_NAME_IF_EXISTS:MPI::MPI_CXX>)

# What must not compile: the message is the test.
if(NOT MSVC)
  set(include_directories $<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_INCLUDE_DIRECTORIES>)
  function(add_refusal name source message)
    add_test(NAME refused_${name} COMMAND_EXPAND_LISTS
      COMMAND "${CMAKE_CXX_COMPILER}" -std=c++17 -fsyntax-only ${ARGN} "-I${PROJECT_SOURCE_DIR}/include"
        "$<$<BOOL:${include_directories}>:-I$<JOIN:${include_directories},;-I>>"
        "${CMAKE_CURRENT_SOURCE_DIR}/refused/${source}.cpp")
    set_tests_properties(refused_${name} PROPERTIES LABELS test TIMEOUT 120 PASS_REGULAR_EXPRESSION "${message}")
  endfunction()
  foreach(flag IN ITEMS fast-math finite-math-only)
    add_refusal(${flag} fast_math "impossible under" -f${flag} -Wfatal-errors)
  endforeach()
  add_refusal(Ofast fast_math "impossible under" -Ofast -Wfatal-errors)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_refusal(associative_math fast_math "impossible under" -funsafe-math-optimizations -Wfatal-errors)
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|i.86")
      add_refusal(x87 fast_math "more digits than they have" -mfpmath=387 -Wfatal-errors)
    endif()
  endif()
  add_refusal(periodic_boxes periodic_boxes "there are no boxes" -Wfatal-errors)
  add_refusal(compiled_updates compiled_updates "is for programs that define" -Wfatal-errors)
  add_refusal(compiled_updates_3 compiled_updates_3 "is for programs that define" -Wfatal-errors)
  add_refusal(rounded_predicates rounded_predicates "nothing could be certified")
  # Compilers go on after the first error, and after many.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(all_errors -fmax-errors=0)
  else()
    set(all_errors -ferror-limit=0)
  endif()
  add_refusal(options options "and nothing else.*is given twice.*in the plane only.*in space takes" ${all_errors})
  # Each of them by name.
  set(kinds "becomes no vertex by itself" "an edge is no vertex" "become one" "assigned to a vertex" "lists alike"
    "equals no vertex" "in a column of vertices" "nor has a number" "an edge has no id")
  list(JOIN kinds ".*" kinds)
  add_refusal(wrong_kinds wrong_kinds "${kinds}" ${all_errors})
  set(private_members m_triangulation m_storage m_arrays m_shifts m_ids m_changes m_visitor_calls m_positions)
  list(TRANSFORM private_members APPEND "[^\n]*private")
  list(JOIN private_members ".*" private_members)
  add_refusal(foreign_writer foreign_writer "${private_members}.*flip.*const" ${all_errors})
  add_refusal(second_writer foreign_writer "a constant state has no writer" ${all_errors})
  add_refusal(gpl licensed_under_gpl "2D Dynamic Delaunay Triangulation would be used under the GPL" -DCGAL_LICENSE_ERROR)
endif()

# A program that finds the installed package, fetches it, or has it as a subdirectory.
add_test(NAME consumer
  COMMAND "${CMAKE_COMMAND}" -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILD=${PROJECT_BINARY_DIR} -D CONFIG=$<CONFIG>
    -D WORK=${CMAKE_CURRENT_BINARY_DIR}/consumer -D GENERATOR=${CMAKE_GENERATOR} -D COMPILER=${CMAKE_CXX_COMPILER}
    -D CGAL_DIR=${CGAL_DIR} -D CCACHE=${CCACHE} -D TBB=$<TARGET_EXISTS:CGAL::TBB_support>
    -P "${CMAKE_CURRENT_SOURCE_DIR}/consumer.cmake")
# Both write the list of what they install into the build folder.
set(package_tests consumer)
find_program(DPKG_DEB dpkg-deb)
if(DPKG_DEB)
  add_test(NAME debian_package
    COMMAND "${CMAKE_COMMAND}" -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILD=${PROJECT_BINARY_DIR} -D CONFIG=$<CONFIG>
      -D WORK=${CMAKE_CURRENT_BINARY_DIR}/debian_package -D CPACK=${CMAKE_CPACK_COMMAND} -D DPKG_DEB=${DPKG_DEB}
      -D VERSION=${PROJECT_VERSION} -D MANUAL=$<TARGET_EXISTS:manual> -D GENERATOR=${CMAKE_GENERATOR}
      -D COMPILER=${CMAKE_CXX_COMPILER} -D CGAL_DIR=${CGAL_DIR} -D CCACHE=${CCACHE}
      -P "${CMAKE_CURRENT_SOURCE_DIR}/debian_package.cmake")
  list(APPEND package_tests debian_package)
else()
  message(STATUS "No test of the Debian package: it needs dpkg-deb")
endif()
set_tests_properties(${package_tests} PROPERTIES LABELS test TIMEOUT 900 RESOURCE_LOCK installation)

# Each folder of programs by itself, as CGAL's testsuite has it, and there some programs.
set(standalone_flags "")
if(NOT MSVC)
  set(standalone_flags "-Wall -Wextra -Wconversion -Wshadow $<$<BOOL:${WARNINGS_AS_ERRORS}>:-Werror>")
endif()
function(add_standalone_test name folder)
  add_test(NAME standalone_${name}
    COMMAND "${CMAKE_COMMAND}" -D FOLDER=${PROJECT_SOURCE_DIR}/${folder}/Dynamic_Delaunay_triangulation_2
      -D WORK=${CMAKE_CURRENT_BINARY_DIR}/standalone/${name} -D GENERATOR=${CMAKE_GENERATOR}
      -D COMPILER=${CMAKE_CXX_COMPILER} -D CCACHE=${CCACHE} -D FLAGS=${standalone_flags} -D CGAL_DIR=${CGAL_DIR}
      -D CTEST=${CMAKE_CTEST_COMMAND} -D PROGRAM=${ARGN} -P "${CMAKE_CURRENT_SOURCE_DIR}/standalone_folder.cmake")
  set_tests_properties(standalone_${name} PROPERTIES LABELS test TIMEOUT 300)
endfunction()
file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/dynamic_delaunay_*_2.cpp")
foreach(source IN LISTS sources)
  get_filename_component(name "${source}" NAME_WE)
  add_standalone_test(${name} test ${name})
endforeach()
add_standalone_test(hello_world examples hello_world)
add_standalone_test(benchmarks benchmark)

# The manual. That every public name is documented, every reference leads somewhere, and every example that is shown is
# there: a warning is an error. Its result is not the one of `./dev doc`.
if(DOXYGEN AND DOT)
  set(manual "${CMAKE_CURRENT_BINARY_DIR}/manual")
  add_test(NAME manual
    COMMAND "${CMAKE_COMMAND}" -D OUTPUT=${manual} -D DOXYGEN=${DOXYGEN} -D SECTIONS=EVERY_NAME
      -P "${PROJECT_SOURCE_DIR}/cmake/write_manual.cmake")
  set_tests_properties(manual PROPERTIES LABELS test TIMEOUT 300 FIXTURES_SETUP manual)
else()
  message(STATUS "No test of the manual: it needs doxygen and dot")
endif()

# That the code in it, and in the README, is that of examples; what a reader sees; and what CGAL's checks of a branch look
# for.
find_package(Python3 COMPONENTS Interpreter QUIET)
if(Python3_FOUND)
  find_path(MATHJAX MathJax.js PATHS /usr/share/javascript/mathjax NO_DEFAULT_PATH)
  if(NOT MATHJAX)
    message(STATUS "No test of what a reader of the manual sees: it needs MathJax, Debian's libjs-mathjax")
  elseif(TEST manual)
    add_test(NAME built_manual
      COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/built_manual.py"
        "${PROJECT_SOURCE_DIR}/doc/Dynamic_Delaunay_triangulation_2" "${manual}/html")
    set_tests_properties(built_manual PROPERTIES LABELS test TIMEOUT 60 FIXTURES_REQUIRED manual)
    find_program(CHROMIUM chromium)
    if(CHROMIUM)
      add_test(NAME manual_on_a_phone
        COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/manual_on_a_phone.py"
          "${CHROMIUM}" "${manual}/html")
      set_tests_properties(manual_on_a_phone PROPERTIES LABELS test TIMEOUT 300 FIXTURES_REQUIRED manual)
    else()
      message(STATUS "No test of the manual on a narrow screen: it needs Chromium")
    endif()
  endif()
  add_test(NAME shown_code
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/shown_code.py" "${PROJECT_SOURCE_DIR}")
  add_test(NAME cgal_rules
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/cgal_rules.py" "${PROJECT_SOURCE_DIR}")
  add_test(NAME floors
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/floors.py" "${PROJECT_SOURCE_DIR}")
  set_tests_properties(shown_code cgal_rules floors PROPERTIES LABELS test TIMEOUT 60)
  find_program(BASH_PROGRAM bash)
  if(BASH_PROGRAM)
    add_test(NAME dev_script
      COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/dev_script.py" "${PROJECT_SOURCE_DIR}/dev")
    set_tests_properties(dev_script PROPERTIES LABELS test TIMEOUT 60)
  endif()
  if(Python3_VERSION VERSION_GREATER_EQUAL 3.11) # which reads TOML
    add_test(NAME mutations_fit
      COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/mutations/run.py" --check)
    set_tests_properties(mutations_fit PROPERTIES LABELS test TIMEOUT 60)
  endif()
else()
  message(STATUS "No test of the code in the manual, and of CGAL's rules: they need Python 3")
endif()

# That each file of the repository says who holds its copyright, and its licence. What Git ignores is no part of it, which
# `reuse` knows in a clone alone.
find_program(REUSE reuse)
find_package(Git QUIET)
set(no_clone TRUE)
if(Git_FOUND)
  execute_process(COMMAND "${GIT_EXECUTABLE}" rev-parse --git-dir WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    RESULT_VARIABLE no_clone OUTPUT_QUIET ERROR_QUIET)
endif()
if(REUSE AND NOT no_clone)
  add_test(NAME reuse COMMAND "${REUSE}" --root "${PROJECT_SOURCE_DIR}" lint)
  add_test(NAME licence_texts COMMAND "${CMAKE_COMMAND}" -E compare_files
    "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/LICENSES/GPL-3.0-or-later.txt")
  set_tests_properties(reuse licence_texts PROPERTIES LABELS test TIMEOUT 60)
else()
  message(STATUS "No test of the licences: it needs reuse, Git, and a clone")
endif()
