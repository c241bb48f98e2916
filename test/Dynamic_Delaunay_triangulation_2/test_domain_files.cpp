// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Polygons in well-known text and GeoJSON: what is read, and what is refused where.

#include "scenario_runner/Polygon_text.h"
#include "scenario_runner/Text_input.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using scenario::Point;
using scenario::Polygon;
using Ring = std::vector<Point>;
using Rings = std::vector<std::vector<std::pair<double, double>>>;

// A ring from its smallest corner on, counterclockwise.
std::vector<std::pair<double, double>> normal(const Ring& ring)
{
  double area = 0.0;
  for (std::size_t i = 0; i != ring.size(); ++i) {
    const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    area += p.x * q.y - p.y * q.x;
  }
  std::vector<std::pair<double, double>> corners;
  for (const Point& corner : ring) {
    corners.emplace_back(corner.x, corner.y);
  }
  if (area < 0.0) {
    std::reverse(corners.begin(), corners.end());
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

Rings rings_of(const Polygon& polygon)
{
  Rings rings = {normal(polygon.boundary)};
  for (const Ring& hole : polygon.holes) {
    rings.push_back(normal(hole));
  }
  return rings;
}

const Rings room = {{{0, 0}, {10.5, 0}, {10.5, 4.25}, {0, 4.25}}, {{2, 1}, {3, 1.1}, {3, 3}}};
const Rings triangle = {{{0, 0}, {4, 0}, {4, 4}}};

Rings read_wkt(const std::string& text)
{
  return rings_of(scenario::parse_wkt("file", text));
}

Rings read_geojson(const std::string& text)
{
  return rings_of(scenario::parse_geojson("file", text));
}

template <class Read>
std::string error_of(Read read, const std::string& text)
{
  try {
    read(text);
  } catch (const scenario::Scenario_error& error) {
    return error.what();
  }
  return "is accepted";
}

std::string geojson_ring(const std::string& places)
{
  return R"({"type": "Polygon", "coordinates": [[)" + places + "]]}";
}

TEST(Domain_files, of_other_programs_are_read)
{
  std::set<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(DOMAINS_FOLDER)) {
    const std::string path = file.path().string();
    const bool is_wkt = file.path().extension() == ".wkt";
    names.insert(file.path().filename().string());
    const std::string text = scenario::read_text_file(path);
    EXPECT_EQ(is_wkt ? read_wkt(text) : read_geojson(text), room) << path;
  }
  EXPECT_EQ(names, (std::set<std::string>{
                       "geos.wkt", "jupedsim.wkt", "ogr2ogr.geojson", "postgis_st_asewkt.wkt",
                       "postgis_st_asewkt_measures.wkt", "postgis_st_asgeojson.geojson",
                       "postgis_st_astext.wkt", "postgis_st_astext_heights.wkt",
                       "qgis_saved_by_an_editor.wkt", "shapely.geojson", "shapely.wkt",
                       "shapely_collection.geojson", "shapely_heights.wkt"}));
}

TEST(Wkt, is_read_in_any_case_with_any_blanks_and_types_of_corners)
{
  for (const char* text :
       {"POLYGON ((0 0, 4 0, 4 4, 0 0))", "polygon((0 0,4 0,4 4,0 0))",
        "\xEF\xBB\xBF \n\tPolyGon\r\n(\n(0\t0 ,\r\n 4 0,4 4\n,0 0 )\n)\n\n",
        "POLYGON ((0 0, 4 4, 4 0, 0 0))", "POLYGON ((4 4, 0 0, 4 0, 4 4))",
        "POLYGON ((+0 -0, 4. 0e0, .4E+1 400e-2, -0.0 0))",
        "POLYGON Z ((0 0 7, 4 0 8, 4 4 9, 0 0 7))", "POLYGONZ((0 0 nan, 4 0 NaN, 4 4 inf, 0 0 -3))",
        "POLYGON M ((0 0 7, 4 0 8, 4 4 9, 0 0 7))",
        "POLYGON zm ((0 0 7 1, 4 0 8 1, 4 4 9 1, 0 0 7 1))",
        "POLYGONZM((0 0 7 1, 4 0 8 1, 4 4 9 1, 0 0 7 1))",
        "SRID=4326;POLYGON((0 0, 4 0, 4 4, 0 0))", "srid = 0 ; POLYGON ((0 0, 4 0, 4 4, 0 0))",
        "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 0)))",
        "MULTIPOLYGON (EMPTY, ((0 0, 4 0, 4 4, 0 0)), EMPTY)",
        "MULTIPOLYGON Z (((0 0 7, 4 0 8, 4 4 9, 0 0 7)))",
        "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 0)))",
        "GEOMETRYCOLLECTION Z (POLYGON Z ((0 0 7, 4 0 8, 4 4 9, 0 0 7)))",
        "GEOMETRYCOLLECTION (POLYGON EMPTY, GEOMETRYCOLLECTION (MULTIPOLYGON (((0 0, 4 0, 4 4, 0 "
        "0)))))"}) {
    EXPECT_EQ(error_of(read_wkt, text), "is accepted") << text;
    EXPECT_EQ(read_wkt(text), triangle) << text;
  }
}

TEST(Wkt, that_ends_early_or_is_too_deep_or_too_long_is_refused)
{
  const std::string whole =
      "SRID=1;GEOMETRYCOLLECTION ZM (POLYGON ZM ((0 0 1 2, 4 0 1 2, 4 4 1 2, 0 0 1 2)))";
  EXPECT_EQ(read_wkt(whole), triangle);
  for (std::size_t size = 0; size != whole.size(); ++size) {
    EXPECT_NE(error_of(read_wkt, whole.substr(0, size)), "is accepted") << size;
  }
  std::string deep;
  for (int i = 0; i != 100'000; ++i) {
    deep += "GEOMETRYCOLLECTION(";
  }
  EXPECT_NE(error_of(read_wkt, deep).find("is nested too deeply, allowed are 16 levels"),
            std::string::npos);
  const std::string long_word =
      error_of(read_wkt, "POLYGON ((0 0, " + std::string(5000, 'x') + " 0))");
  EXPECT_LT(long_word.size(), 200u) << long_word;
}

TEST(Geojson, is_one_polygon_in_any_type_that_holds_it)
{
  const std::string rings = "[[[0,0],[4,0],[4,4],[0,0]]]";
  const std::string polygon = R"({"type": "Polygon", "coordinates": )" + rings + "}";
  for (const std::string& text :
       {polygon, "\xEF\xBB\xBF" + polygon,
        R"({"type": "MultiPolygon", "coordinates": [)" + rings + "]}",
        R"({"type": "GeometryCollection", "geometries": [)" + polygon + "]}",
        R"({"type": "Feature", "properties": null, "geometry": )" + polygon + "}",
        R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": )" + polygon +
            "}]}",
        geojson_ring("[0,0,7],[4,0,7],[4,4,8.5],[0,0,7]")}) {
    EXPECT_EQ(read_geojson(text), triangle) << text;
  }
}

} // namespace
