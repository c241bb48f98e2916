// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The pictures that run_scenario draws, and the page that shows them.

#include "scenario_program.h"
#include "scenario_runner/Pictures.h"
#include "temporary_files.h"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cstddef>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Xml = boost::property_tree::ptree;

std::filesystem::path drawn(const std::string& directory, const Words& arguments)
{
  const std::string path = temporary_path(directory);
  run_quietly(with(arguments, {"--svg", path}));
  return path;
}

// The svg element; whatever is not well-formed throws.
Xml picture(const std::filesystem::path& file)
{
  Xml xml;
  boost::property_tree::read_xml(file.string(), xml);
  return xml.get_child("svg");
}

void collect_texts(const Xml& element, std::vector<std::string>& texts)
{
  for (const auto& [name, child] : element) {
    if (name == "text") {
      texts.push_back(child.data());
    }
    collect_texts(child, texts);
  }
}

std::vector<std::string> texts_of(const Xml& svg)
{
  std::vector<std::string> texts;
  collect_texts(svg, texts);
  return texts;
}

// How many points are drawn in each color; the legend is not among them.
std::map<std::string, std::size_t> points_by_color(const Xml& svg)
{
  std::map<std::string, std::size_t> numbers;
  for (const auto& [name, group] : svg) {
    for (const auto& [inner_name, inner] : group) {
      if (inner_name == "g") {
        numbers[inner.get<std::string>("<xmlattr>.fill")] = inner.count("circle");
      }
    }
  }
  return numbers;
}

std::vector<double> view_box(const Xml& svg)
{
  std::istringstream text(svg.get<std::string>("<xmlattr>.viewBox"));
  std::vector<double> box(4, -1.0);
  for (double& number : box) {
    text >> number;
  }
  return box;
}

TEST(Pictures, scale_to_whatever_shows_them)
{
  const auto pictures = drawn("scaled", {"brownian", "--points", "30", "--frames", "3"});
  const Xml svg = picture(pictures / "frame_00003.svg");
  EXPECT_FALSE(svg.get_child_optional("<xmlattr>.width"));
  const std::vector<double> box = view_box(svg);
  EXPECT_EQ(box[0], 0.0);
  EXPECT_EQ(box[1], 0.0);
  EXPECT_EQ(box[2], 1000.0);
  EXPECT_GT(box[3], 1000.0) << "a square, a line above and a line below";
}

TEST(Pictures, say_the_frame_and_its_time_and_what_the_colors_mean)
{
  const auto pictures = drawn("told", {"explosion", "--points", "100", "--frames", "46", "--every",
                                       "46", "--classifier", "random:0.02"});
  const std::vector<std::string> texts = texts_of(picture(pictures / "frame_00046.svg"));
  EXPECT_EQ(texts, (std::vector<std::string>{"frame 46, time 13.8", "classified", "padded",
                                             "border", "other", "edge"}));
  const std::string text = content_of((pictures / "frame_00046.svg").string());
  for (const run::Set_legend& legend : run::set_legends) {
    EXPECT_TRUE(contains(text, legend.meaning)) << legend.meaning;
  }
}

TEST(Pictures, say_that_a_frame_was_triangulated_anew)
{
  const auto pictures =
      drawn("anew", {"brownian", "--points", "30", "--frames", "1", "--policy", "always_static"});
  EXPECT_EQ(texts_of(picture(pictures / "frame_00001.svg")).front(),
            "frame 1, time 1, triangulated anew");
}

TEST(Pictures, have_every_point_in_the_color_of_its_set)
{
  const auto pictures = drawn("colored", {"explosion", "--points", "100", "--frames", "20",
                                          "--classifier", "random:0.02", "--every", "20"});
  auto numbers = points_by_color(picture(pictures / "frame_00020.svg"));
  ASSERT_EQ(numbers.size(), 4u);
  EXPECT_GT(numbers["red"], 0u);
  EXPECT_GT(numbers["green"], 0u);
  EXPECT_GT(numbers["cyan"], 0u);
  EXPECT_GT(numbers["#333333"], 0u);
  EXPECT_EQ(numbers["red"] + numbers["green"] + numbers["cyan"] + numbers["#333333"], 100u);
}

TEST(Pictures, of_points_on_a_vertical_line_have_room_for_the_legend)
{
  const auto pictures = drawn(
      "narrow", {write_file("narrow.csv", "frame,id,x,y\n0,1,0,0\n0,2,0,5\n0,3,0,6\n0,4,0,9\n")});
  EXPECT_EQ(view_box(picture(pictures / "frame_00000.svg"))[2], 1000.0);
}

std::vector<std::string> all_matches(const std::string& text, const char* pattern)
{
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), regex);
       match != std::sregex_iterator(); ++match) {
    found.push_back((*match)[1]);
  }
  return found;
}

TEST(Page_of_pictures, lists_those_of_the_run_in_their_order)
{
  const auto directory = drawn("listed", {"static", "--points", "30", "--frames", "10"});
  std::filesystem::copy_file(directory / "frame_00003.svg", directory / "frame_99999.svg");
  drawn("listed", {"static", "--points", "30", "--frames", "10", "--every", "4"});
  const std::string page = content_of((directory / "index.html").string());
  const std::vector<std::string> links = all_matches(page, "<a href=\"([^\"]*)\">");
  EXPECT_EQ(links, (std::vector<std::string>{"frame_00000.svg", "frame_00004.svg",
                                             "frame_00008.svg", "frame_00010.svg"}));
  EXPECT_TRUE(contains(page, ">frame 10, time 3</a>")) << page;
  EXPECT_TRUE(contains(page, "<title>static</title>"));
}

TEST(Page_of_pictures, stands_by_itself)
{
  std::ostringstream out;
  run::write_picture_page(out, "a<b & c", {{"frame_00000.svg", 0, 0.1}});
  const std::string page = out.str();
  EXPECT_FALSE(contains(page, "http")) << "it asks the network for something";
  for (const std::string& source : all_matches(page, "(?:src|href)=\"([^\"]*)\"")) {
    EXPECT_EQ(source, "frame_00000.svg");
  }
  EXPECT_TRUE(contains(page, "<h1>a&lt;b &amp; c"));
  EXPECT_TRUE(contains(page, "width=device-width"));
  EXPECT_TRUE(contains(page, "type=\"range\""));
  for (const char* key : {"ArrowLeft", "ArrowRight", "Home", "End"}) {
    EXPECT_TRUE(contains(page, key)) << key;
  }
}

// Each element that the script looks for by its name is there.
TEST(Page_of_pictures, has_what_its_script_moves)
{
  std::ostringstream out;
  run::write_picture_page(out, "name", {{"frame_00000.svg", 0, 0.0}});
  const std::vector<std::string> names = all_matches(out.str(), "element\\(\"(\\w+)\"\\)");
  EXPECT_GT(names.size(), 8u);
  for (const std::string& name : names) {
    EXPECT_EQ(all_matches(out.str(), ("id=\"(" + name + ")\"").c_str()).size(), 1u) << name;
  }
}

} // namespace
