// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Domain_file.h"

#include "scenario_runner/Json_text.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Text_input.h"

#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <boost/geometry/algorithms/correct.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/io/wkt/read.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>

namespace scenario {

namespace {

using Json = nlohmann::json;
namespace geometry = boost::geometry;
using Corner = geometry::model::d2::point_xy<double>;
using Read_polygon = geometry::model::polygon<Corner, false>; // counterclockwise
using Read_ring = Read_polygon::ring_type;

constexpr const char* const allowed_types =
    "allowed are a Polygon, a Feature of one, and a FeatureCollection of one Feature";

// The text may have lines, which Boost does not expect.
Read_polygon read_wkt(const std::string& file, std::string text)
{
  const auto ends_word = [](char c) { return c == '\n' || c == '\r' || c == '\t'; };
  std::replace_if(text.begin(), text.end(), ends_word, ' ');
  Read_polygon polygon;
  try {
    geometry::read_wkt(std::string(trimmed(text)), polygon);
  } catch (const geometry::exception& error) {
    throw Scenario_error(file, "is no POLYGON ((x y, x y, ...)) in well-known text: " +
                                   std::string(error.what()));
  }
  return polygon;
}

class Geojson_reader
{
public:
  explicit Geojson_reader(const std::string& file)
    : m_file(file)
  {
  }

  Read_polygon polygon_of(const Json& object) const
  {
    const std::string type = type_of(object);
    if (type == "FeatureCollection") {
      const Json& features = member(object, "features");
      if (!features.is_array() || features.size() != 1) {
        fail("is a FeatureCollection of another number of features than one, " +
             std::string(allowed_types));
      }
      return polygon_of(features[0]);
    }
    if (type == "Feature") {
      return polygon_of(member(object, "geometry"));
    }
    if (type != "Polygon") {
      fail("holds a " + in_quotes(type) + ", " + allowed_types);
    }
    const Json& rings = member(object, "coordinates");
    if (!rings.is_array() || rings.empty()) {
      fail("key 'coordinates' of the polygon must be an array of at least one ring");
    }
    Read_polygon polygon;
    polygon.outer() = ring(rings[0], 0);
    for (std::size_t i = 1; i != rings.size(); ++i) {
      polygon.inners().push_back(ring(rings[i], i));
    }
    return polygon;
  }

private:
  [[noreturn]] void fail(const std::string& message) const
  {
    throw Scenario_error(m_file, message);
  }

  std::string type_of(const Json& object) const
  {
    if (!object.is_object() || !object.contains("type") || !object["type"].is_string()) {
      fail("is no GeoJSON: an object has no 'type', " + std::string(allowed_types));
    }
    return object["type"];
  }

  const Json& member(const Json& object, const char* key) const
  {
    if (!object.contains(key)) {
      fail("key '" + std::string(key) + "' is missing in the " + std::string(object["type"]));
    }
    return object[key];
  }

  Read_ring ring(const Json& places, std::size_t number) const
  {
    const std::string name = "ring " + std::to_string(number) + " of the polygon";
    if (!places.is_array()) {
      fail(name + " must be an array of places");
    }
    Read_ring corners;
    for (const Json& place : places) {
      if (!place.is_array() || place.size() < 2 || !place[0].is_number() || !place[1].is_number()) {
        fail("place " + std::to_string(corners.size()) + " of " + name +
             " must be an array of two numbers");
      }
      corners.emplace_back(place[0].get<double>(), place[1].get<double>());
    }
    return corners;
  }

  std::string m_file;
};

// The corners of a ring without the last one, which repeats the first one.
std::vector<Point> points_of(const Read_ring& ring)
{
  std::vector<Point> points;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    points.push_back({ring[i].x(), ring[i].y()});
  }
  return points;
}

} // namespace

Polygon read_polygon_file(const std::string& path)
{
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  const bool is_wkt = extension == ".wkt";
  if (!is_wkt && extension != ".geojson" && extension != ".json") {
    throw Scenario_error(path, "is no polygon by its name, allowed are .wkt, .geojson and .json");
  }
  const std::string text = read_text_file(path);
  Read_polygon read =
      is_wkt ? read_wkt(path, text) : Geojson_reader(path).polygon_of(parse_json(path, text));
  geometry::correct(read); // orients and closes all rings
  Polygon polygon{points_of(read.outer()), {}};
  for (const Read_ring& hole : read.inners()) {
    polygon.holes.push_back(points_of(hole));
  }
  return polygon;
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
