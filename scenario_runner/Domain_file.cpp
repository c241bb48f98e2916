// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Domain_file.h"

#include "scenario_runner/Number_text.h"
#include "scenario_runner/Text_input.h"

#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <filesystem>
#include <vector>

namespace scenario {

Polygon read_polygon_file(const std::string& path)
{
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  if (extension == ".wkt") {
    return parse_wkt(path, read_text_file(path));
  }
  if (extension == ".geojson" || extension == ".json") {
    return parse_geojson(path, read_text_file(path));
  }
  throw Scenario_error(path, "is no polygon by its name, allowed are .wkt, .geojson and .json");
}

CGAL::Voronoi_cells_in_domain_2 cells_in(const Polygon& polygon, run::Cell_rule rule,
                                         const std::string& file)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Point> corners; // by the numbers that errors have
  const auto ring = [&](const std::vector<Point>& points) {
    CGAL::Polygon_2<Kernel> result;
    for (const Point& corner : points) {
      result.push_back({corner.x, corner.y});
      corners.push_back(corner);
    }
    return result;
  };
  CGAL::Polygon_with_holes_2<Kernel> domain(ring(polygon.boundary));
  for (const std::vector<Point>& hole : polygon.holes) {
    domain.add_hole(ring(hole));
  }
  try {
    return CGAL::Voronoi_cells_in_domain_2(domain, rule);
  } catch (const CGAL::Domain_error_2& error) {
    std::string place;
    if (error.corner() < corners.size()) {
      const Point& corner = corners[error.corner()];
      place =
          ", and is at (" + run::number_text(corner.x) + ", " + run::number_text(corner.y) + ")";
    }
    throw Scenario_error(file, std::string(error.what()) + place +
                                   "; a domain is one simple polygon with holes that do not touch");
  }
}

} // namespace scenario
