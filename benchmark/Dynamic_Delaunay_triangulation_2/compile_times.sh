#!/usr/bin/env bash
# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What first programs cost a compiler, in seconds of its own time: with CGAL's triangulation, with the package, with a
# second classifier and a visitor, with the code of updates in a library, with the headers precompiled, and with the one file of an example that knows of CGAL.
# Headers alone tell how much of it is to read them; the rest is to compile what the program uses. CXX is the compiler,
# g++ if it is not set.

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
examples=$root/examples/Dynamic_Delaunay_triangulation_2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
TIMEFORMAT=%U

cat >"$work/cgal_alone.cpp" <<'TEXT'
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main()
{
  const std::vector<Kernel::Point_2> points = {{0, 0}, {1, 0}, {0, 1}, {1, 2}};
  const CGAL::Delaunay_triangulation_2<Kernel> triangulation(points.begin(), points.end());
  return triangulation.is_valid() ? 0 : 1;
}
TEXT
cat >"$work/cgal.cpp" <<'TEXT'
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
TEXT
cat >"$work/all.h" <<'TEXT'
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
TEXT
cat >"$work/library.cpp" <<'TEXT'
#include <CGAL/Dynamic_Delaunay_triangulation_2/compiled_updates.h>
TEXT
cat >"$work/choices.cpp" <<'TEXT'
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_changes_visitor_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Triangulation>
bool follows()
{
  std::vector<Kernel::Point_2> points = {{0, 0}, {1, 0}, {0, 1}, {1, 2}};
  Triangulation triangulation(points);
  points[3] = {2, 2};
  return !triangulation.update(points).rebuilt();
}

int main()
{
  return follows<CGAL::Dynamic_Delaunay_triangulation_2<Kernel>>() +
         follows<CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Point_distance_classifier_2>>() +
         follows<CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Default,
                                                        CGAL::With_visitor_2<CGAL::Edge_changes_visitor_2>>>();
}
TEXT
cat >"$work/library_3.cpp" <<'TEXT'
#include <CGAL/Dynamic_Delaunay_triangulation_3/compiled/compiled_updates.h>
TEXT
compiled=-DCGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED
compiled_3=-DCGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED

compile() {
  "${CXX:-g++}" -std=c++17 -DNDEBUG -frounding-math "-I$root/include" "$@"
}

seconds() { # NAME, then what compile() takes
  printf '%-34s' "$1"
  { time compile "${@:2}"; } 2>&1
}

for level in -O0 -O2; do
  echo "$level"
  seconds "CGAL's triangulation alone" "$level" -c "$work/cgal_alone.cpp" -o "$work/object"
  seconds "CGAL's headers, read" "$level" -c "$work/cgal.cpp" -o "$work/object"
  seconds "the package's headers, read" "$level" -x c++ -c "$work/all.h" -o "$work/object"
  seconds hello_world "$level" -c "$examples/hello_world.cpp" -o "$work/object"
  seconds "hello_world, compiled updates" "$level" "$compiled" -c "$examples/hello_world.cpp" -o "$work/object"
  seconds "three choices, compiled updates" "$level" "$compiled" -c "$work/choices.cpp" -o "$work/object"
  seconds "three choices" "$level" -c "$work/choices.cpp" -o "$work/object"
  seconds "the library of these, once" "$level" "$compiled" -c "$work/library.cpp" -o "$work/object"
  seconds "the headers, precompiled" "$level" -x c++-header "$work/all.h" -o "$work/all.h.gch"
  seconds "hello_world with these" "$level" -include "$work/all.h" -c "$examples/hello_world.cpp" -o "$work/object"
  seconds hello_space "$level" -c "$examples/hello_space.cpp" -o "$work/object"
  seconds "hello_space, compiled updates" "$level" "$compiled_3" -c "$examples/hello_space.cpp" -o "$work/object"
  seconds "the library in space, once" "$level" "$compiled_3" -c "$work/library_3.cpp" -o "$work/object"
  seconds growing_tissue "$level" -c "$examples/growing_tissue.cpp" -o "$work/object"
  seconds growing_tissue/Cell_neighbors "$level" -c "$examples/growing_tissue/Cell_neighbors.cpp" -o "$work/object"
done
