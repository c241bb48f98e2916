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

void expect_refused_wkt(const std::string& text, const std::string& message)
{
  const std::string error = error_of(read_wkt, text);
  EXPECT_EQ(error.rfind("file, line ", 0), 0u) << text << ": " << error;
  EXPECT_NE(error.find(message), std::string::npos) << text << ": " << error;
}

void expect_refused_geojson(const std::string& text, const std::string& message)
{
  const std::string error = error_of(read_geojson, text);
  EXPECT_NE(error.find(message), std::string::npos) << text << ": " << error;
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

TEST(Wkt, corners_without_two_numbers_are_refused_with_their_place)
{
  expect_refused_wkt("POLYGON ((0 -1, 6 -1, 6 2, 3, 0 2, 0 -1))",
                     "column 28: corner 3 of ring 0 has 1 number, expected 2");
  expect_refused_wkt("POLYGON ((0 -1, 6 -1,\n  5, 6 2, 0 -1))", "line 2, column 3: corner 2");
  expect_refused_wkt("POLYGON ((0 -1, 6 -1,5, 6 2, 3 2, 0 -1))", "column 22: corner 2 of ring 0");
  expect_refused_wkt("POLYGON ((0 1, 1 3, 3 4 5, 0 1))",
                     "column 21: corner 2 of ring 0 has 3 numbers, expected 2");
  expect_refused_wkt("POLYGON ((0 1, 1 3, , 0 1))", "column 21: corner 2 of ring 0 has 0 numbers");
  expect_refused_wkt("POLYGON ((0 1, 1 3, 3 4, 0 1,))", "corner 4 of ring 0 has 0 numbers");
  expect_refused_wkt("POLYGON ((, 0 1, 1 3, 3 4, 0 1))", "corner 0 of ring 0 has 0 numbers");
  expect_refused_wkt("POLYGON ((0 0, 9 0, 9 9, 0 0), (1 1, 2 1, 2, 1 1))", "corner 2 of ring 1");
  expect_refused_wkt("POLYGON ((0 0 1, 4 0 1, 4 4 1, 0 0 1))", "a type with heights is POLYGON Z");
  expect_refused_wkt("POLYGON Z ((0 0 1, 4 0, 4 4 1, 0 0 1))", "corner 1 of ring 0 has 2 numbers");
  expect_refused_wkt("POLYGON ZM ((0 0 1, 4 0 1, 4 4 1, 0 0 1))", "corner 0 of ring 0");
  expect_refused_wkt("GEOMETRYCOLLECTION Z (POLYGON ((0 0 1, 4 0 1, 4 4 1, 0 0 1)))", "corner 0");
  expect_refused_wkt("POLYGON M ((0 0, 4 0, 4 4, 0 0))", "has 2 numbers, expected 3");
}

TEST(Wkt, numbers_are_finite_and_whole_words)
{
  expect_refused_wkt("POLYGON ((0 0, four 0, 4 4, 0 0))", "column 16: 'four' in corner 1");
  expect_refused_wkt("POLYGON ((0 0, nan 0, 4 4, 0 0))", "'nan' in corner 1 of ring 0 is not a");
  expect_refused_wkt("POLYGON ((0 0, 4 -inf, 4 4, 0 0))", "not a finite number");
  for (const char* number :
       {"1e999", "-1e999", "0x10", "4,5", "4d", "1-2", "--4", "+-4", "e5", "."}) {
    expect_refused_wkt(std::string("POLYGON ((0 0, ") + number + " 0, 4 4, 0 0))", "corner 1");
  }
  expect_refused_wkt("POLYGON Z ((0 0 high, 4 0 1, 4 4 1, 0 0 1))", "'high'");
}

TEST(Wkt, rings_are_closed_and_have_four_corners)
{
  expect_refused_wkt("POLYGON ((0 0, 4 0, 4 4))",
                     "column 10: ring 0 is not closed: it begins at (0, 0) and ends at (4, 4)");
  expect_refused_wkt("POLYGON ((0 0, 9 0, 9 9, 0 0),\n (1 1, 2 1, 2 2))",
                     "line 2, column 2: ring 1");
  expect_refused_wkt("POLYGON ((0 0, 4 0, 0 0))",
                     "ring 0 has 3 corners, needed are at least three");
  expect_refused_wkt("POLYGON ((0 0))", "ring 0 has 1 corner,");
  expect_refused_wkt("POLYGON (EMPTY)", "ring 0 has no corners");
  expect_refused_wkt("POLYGON ()", "expected '(' before the corners of ring 0, found ')'");
  expect_refused_wkt("POLYGON (())", "corner 0 of ring 0 has 0 numbers");
}

TEST(Wkt, is_one_polygon_and_nothing_else)
{
  const std::string one = "((0 0, 4 0, 4 4, 0 0))";
  expect_refused_wkt("MULTIPOLYGON (" + one + ", " + one + ")",
                     "column 39: holds a second polygon");
  expect_refused_wkt("GEOMETRYCOLLECTION (POLYGON " + one + ", MULTIPOLYGON (" + one + "))",
                     "second polygon, and a domain is one");
  for (const char* empty : {"POLYGON EMPTY", "MULTIPOLYGON Z EMPTY", "GEOMETRYCOLLECTION EMPTY",
                            "MULTIPOLYGON (EMPTY, EMPTY)"}) {
    expect_refused_wkt(empty, "holds no polygon: it is EMPTY, allowed are POLYGON");
  }
  for (const char* other :
       {"LINESTRING (0 0, 4 0)", "POINT (1 1)", "CURVEPOLYGON ((0 0))", "", " \n",
        "((0 0, 4 0, 4 4, 0 0))", "Z ((0 0))", "PolygonX ((0 0))", "0103000000",
        "GEOMETRYCOLLECTION (POINT (1 1), POLYGON ((0 0, 4 0, 4 4, 0 0)))"}) {
    expect_refused_wkt(other, "is no polygon in well-known text: allowed are POLYGON ((x y");
  }
  for (const char* behind : {"x", ")", ";", ",", "POLYGON EMPTY", "0"}) {
    expect_refused_wkt("POLYGON " + one + " " + behind, "expected nothing behind the polygon");
  }
  expect_refused_wkt("POLYGON " + one + std::string(1, '\0'),
                     "expected nothing behind the polygon");
}

TEST(Wkt, that_ends_early_or_is_no_text_is_refused)
{
  const std::string whole =
      "SRID=1;GEOMETRYCOLLECTION ZM (POLYGON ZM ((0 0 1 2, 4 0 1 2, 4 4 1 2, 0 0 1 2)))";
  EXPECT_EQ(read_wkt(whole), triangle);
  for (std::size_t size = 0; size != whole.size(); ++size) {
    EXPECT_NE(error_of(read_wkt, whole.substr(0, size)), "is accepted") << size;
  }
  expect_refused_wkt("POLYGON ((0 0, 4 0", "but the text ends");
  expect_refused_wkt("\xFF\xFEP", "UTF-16");
  expect_refused_wkt("SRID=x;POLYGON ((0 0, 4 0, 4 4, 0 0))",
                     "expected an integer behind SRID=, found 'x'");
  expect_refused_wkt("SRID=4326 POLYGON ((0 0, 4 0, 4 4, 0 0))",
                     "expected ';' behind the number of SRID");
  std::string deep;
  for (int i = 0; i != 100'000; ++i) {
    deep += "GEOMETRYCOLLECTION(";
  }
  expect_refused_wkt(deep, "is nested too deeply, allowed are 16 levels");
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
  expect_refused_geojson(R"({"type": "MultiPolygon", "coordinates": [)" + rings + "," + rings +
                             "]}",
                         "is a MultiPolygon with 2 elements in 'coordinates'");
  expect_refused_geojson(R"({"type": "MultiPolygon", "coordinates": []})", "with 0 elements");
  expect_refused_geojson(R"({"type": "GeometryCollection", "geometries": {}})", "must be an array");
  expect_refused_geojson(R"({"type": "Feature", "geometry": null})", "is no GeoJSON");
  expect_refused_geojson(R"({"type": "Polygon", "coordinates": []})", "at least one ring");
}

TEST(Geojson, places_have_two_numbers_or_three_all_of_them)
{
  expect_refused_geojson(geojson_ring("[0,0],[4],[4,4],[0,0]"), "place 1 of ring 0");
  expect_refused_geojson(geojson_ring("[0,0],[],[4,4],[0,0]"), "place 1 of ring 0");
  expect_refused_geojson(geojson_ring("[0,0],4,0,[4,4],[0,0]"), "place 1 of ring 0");
  expect_refused_geojson(geojson_ring(R"([0,0],["4",0],[4,4],[0,0])"), "two numbers, or of three");
  expect_refused_geojson(geojson_ring("[0,0],[4,null],[4,4],[0,0]"), "place 1 of ring 0");
  expect_refused_geojson(geojson_ring(R"([0,0,"a"],[4,0,1],[4,4,1],[0,0,1])"), "place 0 of ring 0");
  expect_refused_geojson(geojson_ring("[0,0],[4,0,4,4],[0,4],[0,0]"), "place 1 of ring 0");
  expect_refused_geojson(geojson_ring("[0,0],[4,0,4],[4,4],[0,0]"),
                         "has 3 numbers, and those before it 2");
  expect_refused_geojson(geojson_ring("[0,0,1],[4,0],[4,4,1],[0,0,1]"),
                         "has 2 numbers, and those before it 3");
  expect_refused_geojson(geojson_ring("[0,0],[4,0],[4,1e999],[0,0]"), "out of range");
  expect_refused_geojson(geojson_ring("[0,0],[4,0],[4,NaN],[0,0]"), "is not valid JSON");
  expect_refused_geojson(geojson_ring("[0,0],[4,0],[4,4]"), "ring 0 of the polygon is not closed");
  expect_refused_geojson(geojson_ring("[0,0],[4,0],[0,0]"), "has 3 corners");
  expect_refused_geojson(geojson_ring(""), "has no corners");
}

} // namespace
