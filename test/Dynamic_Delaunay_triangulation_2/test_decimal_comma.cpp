// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A program may set a locale whose numbers have decimal commas, and dots between thousands. All
// that the runner reads and writes is the same there, byte for byte. CMake makes the locale, and
// says in LOCPATH where it is.

#include "scenario_runner/Cell_log.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Output_formats.h"
#include "scenario_runner/Pictures.h"
#include "scenario_runner/Player_page.h"
#include "scenario_runner/Polygon_text.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Run_report.h"
#include "scenario_runner/Scenario_file.h"
#include "temporary_files.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

// Sets the locale of C and of C++ for a test.
class Decimal_comma : public testing::Test
{
protected:
  void SetUp() override
  {
    m_before = std::locale::global(std::locale("de_DE.UTF-8")); // throws if it is not there
    ASSERT_STREQ(std::localeconv()->decimal_point, ",");
    ASSERT_EQ(std::strtod("1,5", nullptr), 1.5);
    std::ostringstream stream;
    stream << 1234.5;
    ASSERT_EQ(stream.str(), "1.234,5");
  }

  void TearDown() override { std::locale::global(m_before); }

  // What a function returns in the locale of C.
  template <class Function>
  static auto in_classic_locale(Function function)
  {
    const std::locale comma = std::locale::global(std::locale::classic());
    auto result = function();
    std::locale::global(comma);
    return result;
  }

private:
  std::locale m_before;
};

std::string text_of(const std::vector<scenario::Point>& points)
{
  std::string text;
  for (const scenario::Point& point : points) {
    text += run::number_text(point.x) + ' ' + run::number_text(point.y) + '\n';
  }
  return text;
}

std::string text_of(const scenario::Recording& recording)
{
  std::string text;
  for (const scenario::Recorded_frame& frame : recording) {
    text += run::number_text(frame.time) + '\n' + text_of(frame.points);
    if (frame.cell) {
      text += text_of({frame.cell->corner, frame.cell->sides[0], frame.cell->sides[1]});
    }
  }
  return text;
}

const std::string points_text = "0.25 -0.0015\n1000.125 2\n";

TEST_F(Decimal_comma, leaves_recordings_as_they_are)
{
  EXPECT_EQ(text_of(scenario::parse_csv("file", "frame,time,id,x,y\n0,1234.5,1,0.25,-1.5e-3\n"
                                                "0,1234.5,2,1000.125,2.0\n")),
            "1234.5\n" + points_text);
  EXPECT_EQ(text_of(scenario::parse_lammps_dump(
                "file", "ITEM: TIME\n1234.5\nITEM: TIMESTEP\n1000\nITEM: NUMBER OF ATOMS\n2\n"
                        "ITEM: BOX BOUNDS pp pp pp\n-0.5 2000.5\n-0.5 9.25\n-0.5 0.5\n"
                        "ITEM: ATOMS id x y\n1 0.25 -1.5e-3\n2 1000.125 2\n")),
            "1234.5\n" + points_text + "-0.5 -0.5\n2001 0\n0 9.75\n");
  EXPECT_EQ(text_of(scenario::parse_xyz(
                "file", "2\nLattice=\"2000.5 0 0 0.5 8.25 0 0 0 1\" Origin=\"-0.5 -0.25 0\" "
                        "Properties=pos:R:3 Time=1234.5\n0.25 -1.5e-3 0.0\n1000.125 2 0\n")),
            "1234.5\n" + points_text + "-0.5 -0.25\n2000.5 0\n0.5 8.25\n");
  EXPECT_THROW(scenario::parse_csv("file", "frame;id;x;y\n0;1;0,25;1\n"), scenario::Scenario_error);
}

TEST_F(Decimal_comma, leaves_domains_scenarios_and_arguments_as_they_are)
{
  EXPECT_EQ(
      text_of(scenario::parse_wkt("file", "POLYGON ((0.5 0, 1000.25 0, 1000.25 1.5e3, 0.5 0))")
                  .boundary),
      text_of({{0.5, 0}, {1000.25, 0}, {1000.25, 1500}}));
  EXPECT_EQ(text_of(scenario::parse_geojson("file", R"({"type": "Polygon", "coordinates":
                [[[0.5,0],[1000.25,0],[1000.25,1.5e3],[0.5,0]]]})")
                        .boundary),
            text_of({{0.5, 0}, {1000.25, 0}, {1000.25, 1500}}));
  EXPECT_THROW(scenario::parse_wkt("file", "POLYGON ((0,5 0, 1 0, 1 1, 0,5 0))"),
               scenario::Scenario_error);
  const auto description = scenario::parse_scenario("file", R"({"name": "cloud", "kind": "brownian",
      "seed": 1, "frames": 1000, "time_step": 0.015625, "points": 2000, "box": [1000.5, 1.25]})");
  const auto& brownian = std::get<scenario::Brownian_description>(description.kind);
  EXPECT_EQ(brownian.time_step, 0.015625);
  EXPECT_EQ(brownian.box.width, 1000.5);
  EXPECT_EQ(run::number_argument("0.25", scenario::positive_up_to(10)), 0.25);
  EXPECT_THROW(run::number_argument("0,25", scenario::positive_up_to(10)), std::invalid_argument);
  EXPECT_EQ(run::count_argument("10000", 0, 1'000'000), 10000u);
}

TEST_F(Decimal_comma, leaves_texts_of_numbers_as_they_are)
{
  EXPECT_EQ(run::number_text(12345.678), "12345.678");
  EXPECT_EQ(run::number_text(0.1, 3), "0.1");
  EXPECT_EQ(run::fixed_text(1234.5, 2), "1234.50");
  EXPECT_EQ(run::readable(1234.5), "1230");
  EXPECT_EQ(run::readable(0.25), "0.25");
  EXPECT_EQ(run::readable_validity(0.9999999), "0.999999");
  EXPECT_EQ(scenario::positive_up_to(0.5).text(), "above 0 to 0.5");
}

// A frame of a run that stands still: what all that writes looks at.
class Still_run : public run::Run_view
{
public:
  explicit Still_run(const std::optional<scenario::Cell>& cell)
    : m_motion(
          "still",
          {{1234.5, {1000, 2000, 3000}, {{0.25, 0.5}, {1000.125, 1.5}, {3.5, 1e4}}, cell, 12000}})
  {
    m_record.frame = 1;
    m_record.number = 12000;
    m_record.time = 1234.5;
    m_record.points = 3;
    m_record.validity = 0.9375;
    m_record.nanoseconds = {1234.5, 54321.5, 0.125};
    m_record.update.flips = 12345;
  }

  const scenario::Motion& motion() const override { return m_motion; }
  const run::Frame_record& record() const override { return m_record; }
  std::vector<run::Vertex_set> sets() const override
  {
    return {run::Vertex_set::classified, run::Vertex_set::padded, run::Vertex_set::none};
  }
  std::vector<run::Shown_edge> edges() const override
  {
    return {{0, 1, true}, {1, 2, true}, {2, 0, false}};
  }
  std::vector<run::Shown_triangle> triangles() const override { return {{{0, 1, 2}, false}}; }
  std::vector<run::Shown_cell> cells(run::Cells_in_domains&, double radius) const override
  {
    return {{1234.5, 0.25, 1000, radius, 0.5}, {0.125, 1e4, 2, 0, 1.5}, {0.75, 3.5, 1, 0, 2.5}};
  }

private:
  scenario::Recorded_motion m_motion;
  run::Frame_record m_record;
};

run::Run_subject subject()
{
  return {"still",  run::classifier_choice("point_distance:0.75"),
          "splice", {},
          1,        "automatic",
          1,        0.25,
          1000,     std::nullopt};
}

// All outputs of runs in the plane and on a torus, by their names.
std::map<std::string, std::string> written()
{
  const std::filesystem::path folder = temporary_path("written");
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const std::string domain =
      write_file("room.wkt", "POLYGON ((-0.5 -0.5, 9.5 0, 9.5 9.25, -0.5 -0.5))");
  const run::Frame_choice all(1, 1);
  const scenario::Cell torus{{-0.5, 0.25}, {{{2000.5, 0.5}, {0.125, 1e4 + 0.5}}}, {true, true}};
  for (const std::optional<scenario::Cell>& cell :
       {std::optional<scenario::Cell>(), std::optional(torus)}) {
    const Still_run run(cell);
    const auto path = [&](const std::string& name) {
      return (folder / ((cell ? "torus_" : "plane_") + name)).string();
    };
    const auto write = [&](run::Frame_output&& output) {
      output.take(run);
      output.finish();
    };
    using Format = run::Point_file::Format;
    write(run::Frame_log(path("frames.csv")));
    write(run::Point_log(path("points.xyz"), Format::EXTENDED_XYZ, all, std::nullopt));
    write(run::Point_log(path("points.dump"), Format::LAMMPS_DUMP, all, std::nullopt));
    write(run::Vtk_series(path("vtk"), all));
    write(run::Picture_series(path("svg"), "still", all, std::nullopt));
    write(run::Player_page(path("page.html"), "still", run::method_text(subject()), all));
    write(run::Cell_log(path("cells.csv"), all, 1000.5, domain, run::Cell_rule::WHOLE));
  }
  std::map<std::string, std::string> files;
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
    if (file.is_regular_file()) {
      files[file.path().lexically_relative(folder).string()] = content_of(file.path().string());
    }
  }
  return files;
}

TEST_F(Decimal_comma, leaves_all_outputs_as_they_are)
{
  const auto expected = in_classic_locale(written);
  EXPECT_EQ(expected.size(), 2u * 9u);
  const auto files = written();
  ASSERT_EQ(files.size(), expected.size());
  for (const auto& [name, content] : files) {
    EXPECT_EQ(content, expected.at(name)) << name;
  }
}

TEST_F(Decimal_comma, leaves_reports_tables_and_rows_of_frames_as_they_are)
{
  const run::Frame_record record = Still_run(std::nullopt).record();
  const auto texts = [&] {
    const run::Run_summary summary = run::summarize(10'000, {record, record});
    std::ostringstream report, table;
    report.imbue(std::locale::classic()); // as files of the runner
    run::write_report(report, subject(), summary);
    run::write_table(table, subject(), summary);
    return std::pair(report.str(), table.str());
  };
  const auto expected = in_classic_locale(texts);
  EXPECT_NE(expected.first.find("\"flips_mean\": 12345.0"), std::string::npos) << expected.first;
  EXPECT_EQ(texts(), expected);
}

} // namespace
