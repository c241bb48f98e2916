# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Writes the manual so that it can be read without a network:
#
#   cmake -D OUTPUT=DIRECTORY [-D DOXYGEN=PROGRAM] [-D SECTIONS=NAMES] -P write_manual.cmake
#
# OUTPUT/html can be moved as a whole, and opened as files. SECTIONS are Doxygen's ENABLED_SECTIONS.
#
# Doxygen leaves formulas to MathJax or to LaTeX. Debian's MathJax is 8 MB to download and 46 MB on the disk, LaTeX with
# what makes pictures of formulas 57 MB and 188 MB. The pages need 2 MB of MathJax, which are copied beside them. It
# draws the outlines of letters itself: from files, browsers may refuse to load fonts. KaTeX is smaller, 2 MB on the
# disk, but has fonts, and Doxygen writes nothing for it.

cmake_minimum_required(VERSION 3.20)

get_filename_component(sources "${CMAKE_CURRENT_LIST_DIR}" DIRECTORY)
get_filename_component(OUTPUT "${OUTPUT}" ABSOLUTE)
if(NOT DOXYGEN)
  set(DOXYGEN doxygen)
endif()

# A page that is no more would stay.
file(REMOVE_RECURSE "${OUTPUT}/html")
file(WRITE "${OUTPUT}/Doxyfile"
  "@INCLUDE = doc/Dynamic_Delaunay_triangulation_2/Doxyfile\n"
  "OUTPUT_DIRECTORY = \"${OUTPUT}\"\n"
  "ENABLED_SECTIONS += ${SECTIONS}\n")
execute_process(COMMAND "${DOXYGEN}" "${OUTPUT}/Doxyfile" WORKING_DIRECTORY "${sources}" COMMAND_ERROR_IS_FATAL ANY)

find_path(mathjax MathJax.js PATHS /usr/share/javascript/mathjax NO_DEFAULT_PATH)
if(NOT mathjax)
  message(NOTICE "Formulas will be TeX: there is no /usr/share/javascript/mathjax, from Debian's libjs-mathjax")
  return()
endif()
foreach(part IN ITEMS MathJax.js extensions/tex2jax.js extensions/MathEvents.js extensions/TeX jax/element jax/input/TeX
    jax/output/SVG/autoload jax/output/SVG/config.js jax/output/SVG/fonts/TeX jax/output/SVG/jax.js)
  get_filename_component(folder "${OUTPUT}/html/mathjax/${part}" DIRECTORY)
  file(COPY "${mathjax}/${part}" DESTINATION "${folder}")
endforeach()
