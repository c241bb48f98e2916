# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# For cpack, before it packs what it has installed: a Debian package does not bring copies of others' scripts. Its
# manual has a link to Debian's MathJax instead.

file(GLOB manuals "${CPACK_TEMPORARY_DIRECTORY}/usr/share/doc/*/html")
foreach(manual IN LISTS manuals)
  file(REMOVE_RECURSE "${manual}/mathjax")
  file(CREATE_LINK ../../../javascript/mathjax "${manual}/mathjax" SYMBOLIC)
endforeach()
