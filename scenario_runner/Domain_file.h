// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_DOMAIN_FILE_H
#define SCENARIO_RUNNER_DOMAIN_FILE_H

#include "scenario_runner/Cells_in_domains.h"
#include "scenario_runner/Polygon_text.h"

#include <string>

namespace scenario {

// From a file .wkt in well-known text, or .geojson or .json in GeoJSON.
// \throws Scenario_error
Polygon read_polygon_file(const std::string& path);

// \throws Scenario_error, which names the file, for a polygon that is not simple
CGAL::Voronoi_cells_in_domain_2 cells_in(const Polygon& polygon, run::Cell_rule rule,
                                         const std::string& file);

} // namespace scenario

#endif // SCENARIO_RUNNER_DOMAIN_FILE_H
