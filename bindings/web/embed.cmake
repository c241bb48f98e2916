# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Writes a page as string literals of C++, with its styles and scripts inside:
#
#   cmake -D PAGE=FILE.html -D OUTPUT=FILE -P embed.cmake
#
# A line of the page that says EMBED and a list of files, by their places below this folder, becomes these files. A line
# that says SPLIT, or that word inside of a line, ends a literal. Modules become one: what they import from each other is
# in it, and so the names that they have at their top must be different, which the browser would tell.

cmake_minimum_required(VERSION 3.20)

# Brackets and semicolons mean something in CMake's lists, so files are only ever treated as one text.
file(READ "${PAGE}" page)
while(page MATCHES "\n *EMBED ([^\n]*)\n")
  set(line "${CMAKE_MATCH_0}")
  string(REPLACE " " ";" names "${CMAKE_MATCH_1}")
  set(content "")
  foreach(name IN LISTS names)
    file(READ "${CMAKE_CURRENT_LIST_DIR}/${name}" text)
    string(REGEX REPLACE "(^|\n)import [^\"]*\"[^\"]*\";" "" text "${text}")
    string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
    string(APPEND content "${text}")
  endforeach()
  string(REPLACE "${line}" "\n${content}" page "${page}")
endwhile()

string(REPLACE "SPLIT" ")~~~\",\nR\"~~~(" page "${page}")
file(WRITE "${OUTPUT}" "R\"~~~(${page})~~~\"\n")
