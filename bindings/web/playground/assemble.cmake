# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Puts together what a web server gives out:
#
#   cmake -D SITE=FOLDER -D ROOT=REPOSITORY -D PACKAGE=FOLDER -D DELAUNATOR=FOLDER -P assemble.cmake
#
# PACKAGE is the built package for web pages, DELAUNATOR the one of npm, which need not be there.

set(web "${ROOT}/bindings/web")
file(COPY "${web}/drawing" "${web}/playground" "${web}/index.html" "${ROOT}/scenario_runner/scenarios"
  DESTINATION "${SITE}"
  PATTERN "*.cmake" EXCLUDE PATTERN CMakeLists.txt EXCLUDE)
file(COPY "${web}/motion/motion.mjs" "${web}/motion/read.mjs" DESTINATION "${SITE}/motion")
file(COPY "${PACKAGE}/" DESTINATION "${SITE}/package")
if(EXISTS "${DELAUNATOR}/delaunator.min.js")
  file(COPY "${DELAUNATOR}/delaunator.min.js" "${DELAUNATOR}/LICENSE" DESTINATION "${SITE}/delaunator")
  file(WRITE "${SITE}/playground/opponents.js" "export const delaunator = \"../delaunator/delaunator.min.js\";\n")
endif()
