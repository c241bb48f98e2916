// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_DOMAIN_FILE_H
#define SCENARIO_RUNNER_DOMAIN_FILE_H

#include "scenario_runner/Cell.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>

#include <string>
#include <vector>

namespace scenario {

// Corners without the first one at the end again: counterclockwise of the boundary, clockwise of
// the holes.
struct Polygon
{
  std::vector<Point> boundary;
  std::vector<std::vector<Point>> holes;
};

// From a file .wkt in well-known text, or .geojson or .json in GeoJSON.
// \throws Scenario_error
Polygon read_polygon_file(const std::string& path);

// What polygons there may be is decided here.
// \throws Scenario_error, which names the file, for others
void set_domain(CGAL::Bounded_voronoi_cells_2& cells, const Polygon& polygon,
                const std::string& file);

} // namespace scenario

#endif // SCENARIO_RUNNER_DOMAIN_FILE_H
