// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Json_text.h"
#include "scenario_runner/Polygon_text.h"
#include "scenario_runner/Text_input.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace scenario {

namespace {

using Json = nlohmann::json;

constexpr const char* const allowed_objects =
    "allowed are a Polygon, and a MultiPolygon, GeometryCollection, Feature or FeatureCollection "
    "of one";

class Geojson_reader
{
public:
  explicit Geojson_reader(const std::string& file)
    : m_file(file)
  {
  }

  Polygon polygon_of(const Json& object)
  {
    const std::string type = type_of(object);
    if (type == "Feature") {
      return polygon_of(member(object, "geometry"));
    }
    if (type == "FeatureCollection") {
      return polygon_of(only_one(object, "features"));
    }
    if (type == "GeometryCollection") {
      return polygon_of(only_one(object, "geometries"));
    }
    if (type == "MultiPolygon") {
      return polygon_of_coordinates(only_one(object, "coordinates"));
    }
    if (type != "Polygon") {
      fail("holds a " + in_quotes(type) + ", " + allowed_objects);
    }
    return polygon_of_coordinates(member(object, "coordinates"));
  }

private:
  [[noreturn]] void fail(const std::string& message) const
  {
    throw Scenario_error(m_file, message);
  }

  std::string type_of(const Json& object) const
  {
    if (!object.is_object() || !object.contains("type") || !object["type"].is_string()) {
      fail("is no GeoJSON: an object has no 'type', " + std::string(allowed_objects));
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

  const Json& only_one(const Json& object, const char* key) const
  {
    const Json& list = member(object, key);
    if (!list.is_array()) {
      fail("key '" + std::string(key) + "' of the " + std::string(object["type"]) +
           " must be an array");
    }
    if (list.size() != 1) {
      fail("is a " + std::string(object["type"]) + " with " + std::to_string(list.size()) +
           " elements in '" + key + "', and a domain is one polygon; " + allowed_objects);
    }
    return list[0];
  }

  Polygon polygon_of_coordinates(const Json& list)
  {
    if (!list.is_array() || list.empty()) {
      fail("key 'coordinates' of the polygon must be an array of at least one ring");
    }
    std::vector<std::vector<Point>> rings;
    for (const Json& places : list) {
      rings.push_back(ring(places, "ring " + std::to_string(rings.size()) + " of the polygon"));
    }
    return polygon_of_rings(std::move(rings));
  }

  std::vector<Point> ring(const Json& places, const std::string& name)
  {
    if (!places.is_array()) {
      fail(name + " must be an array of places");
    }
    std::vector<Point> corners;
    for (const Json& place : places) {
      check_place(place, "place " + std::to_string(corners.size()) + " of " + name);
      corners.push_back({place[0].get<double>(), place[1].get<double>()});
    }
    const std::string problem = problem_of_ring(corners);
    if (!problem.empty()) {
      fail(name + " " + problem);
    }
    return corners;
  }

  // All places have as many numbers as the first one: others have lost one, or are two in one.
  void check_place(const Json& place, const std::string& name)
  {
    const bool has_numbers =
        place.is_array() && (place.size() == 2 || place.size() == 3) &&
        std::all_of(place.begin(), place.end(), [](const Json& n) { return n.is_number(); });
    if (!has_numbers) {
      fail(name + " must be an array of two numbers, or of three with a height");
    }
    m_numbers_of_place = m_numbers_of_place == 0 ? place.size() : m_numbers_of_place;
    if (place.size() != m_numbers_of_place) {
      fail(name + " has " + std::to_string(place.size()) + " numbers, and those before it " +
           std::to_string(m_numbers_of_place));
    }
  }

  std::string m_file;
  std::size_t m_numbers_of_place = 0; // none yet
};

} // namespace

Polygon parse_geojson(const std::string& file, const std::string& text)
{
  return Geojson_reader(file).polygon_of(parse_json(file, text));
}

} // namespace scenario
