// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_POLYGON_TEXT_H
#define SCENARIO_RUNNER_POLYGON_TEXT_H

#include "scenario_runner/Cell.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenario {

// Rings without the first corner at their end, as the text has them: either way around.
struct Polygon
{
  std::vector<Point> boundary;
  std::vector<std::vector<Point>> holes;
};

// A POLYGON, or a MULTIPOLYGON or GEOMETRYCOLLECTION of one, in well-known text. Z and M are
// dropped, and so is a SRID in front. All corners must have as many numbers as the type says.
// \throws Scenario_error with line and column, in which the text is called `file`
Polygon parse_wkt(const std::string& file, std::string_view text);

// A Polygon, or another type that holds just one, in GeoJSON. A third coordinate is dropped.
// \throws Scenario_error, in which the text is called `file`
Polygon parse_geojson(const std::string& file, const std::string& text);

// What is wrong with a ring as a text has it, with the first corner at its end; empty if nothing.
std::string problem_of_ring(const std::vector<Point>& corners);

// A polygon of rings as a text has them, the boundary first. At least one ring is needed.
Polygon polygon_of_rings(std::vector<std::vector<Point>> rings);

} // namespace scenario

#endif // SCENARIO_RUNNER_POLYGON_TEXT_H
