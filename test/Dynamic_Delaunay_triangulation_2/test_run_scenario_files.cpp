// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares the page of the manual on scenario files and recordings with what the program does.

#include "scenario_program.h"
#include "scenario_runner/Open_motion.h"
#include "temporary_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Row
{
  std::string value;
  std::string otherwise; // the default
};

using Table = std::map<std::string, Row>; // by key
using Keys = std::set<std::string>;

std::string page()
{
  const std::string text = content_of(SCENARIO_FILES_PAGE);
  EXPECT_FALSE(text.empty());
  return text;
}

std::vector<std::string> lines_of(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> cells_of(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    cells.emplace_back(scenario::trimmed(cell));
  }
  return cells;
}

// The tables of keys: of both kinds, of particles, of a body, and of Brownian motion.
std::vector<Table> tables()
{
  std::vector<Table> tables;
  bool is_inside = false;
  for (const std::string& line : lines_of(page())) {
    if (line.rfind("| key |", 0) == 0) {
      tables.emplace_back();
      is_inside = true;
    } else if (line.rfind("| `", 0) == 0 && is_inside) {
      const std::vector<std::string> cells = cells_of(line);
      EXPECT_EQ(cells.size(), 4u) << line;
      tables.back()[cells.at(0).substr(1, cells.at(0).size() - 2)] = {cells.at(1), cells.at(2)};
    } else if (line.rfind("|-", 0) != 0) {
      is_inside = false;
    }
  }
  EXPECT_EQ(tables.size(), 4u);
  tables.resize(4);
  return tables;
}

Table united(Table one, const Table& other)
{
  for (const auto& [key, row] : other) {
    const bool is_new = one.emplace(key, row).second;
    EXPECT_TRUE(is_new || one[key].value == row.value) << key;
  }
  return one;
}

Keys keys_of(const Table& table)
{
  Keys keys;
  for (const auto& [key, row] : table) {
    keys.insert(key);
  }
  return keys;
}

// The blocks of the page that show files.
std::vector<std::string> shown_files()
{
  std::vector<std::string> files;
  bool is_inside = false;
  for (const std::string& line : lines_of(page())) {
    if (line == "\\verbatim") {
      files.emplace_back();
      is_inside = true;
    } else if (line == "\\endverbatim") {
      is_inside = false;
      if (files.back().rfind("./dev", 0) == 0) {
        files.pop_back();
      }
    } else if (is_inside) {
      files.back() += line + '\n';
    }
  }
  return files;
}

std::string extension_of(const std::string& file)
{
  if (contains(file, "Properties=")) {
    return ".xyz";
  }
  return file[0] == '{' ? ".json" : file.rfind("ITEM:", 0) == 0 ? ".dump" : ".csv";
}

Json shown_scenario(const std::string& kind)
{
  for (const std::string& file : shown_files()) {
    if (extension_of(file) == ".json" && Json::parse(file)["kind"] == kind) {
      return Json::parse(file);
    }
  }
  ADD_FAILURE() << "no example of the kind " << kind;
  return {};
}

// The message with which the program refuses the file; empty if it accepts it.
std::string refusal_of(const Json& json)
{
  try {
    scenario::parse_scenario("file", json.dump());
  } catch (const scenario::Scenario_error& error) {
    return error.what();
  }
  return "";
}

// One of the objects that have keys: where it is in an example, and the table that describes it.
struct Described
{
  std::string name;
  Json example;
  std::function<Json&(Json&)> object;
  Table table;
};

std::vector<Described> described()
{
  const auto all = tables();
  const auto itself = [](Json& json) -> Json& { return json; };
  const auto last_body = [](Json& json) -> Json& { return json["bodies"].back(); };
  return {{"particles", shown_scenario("particles"), itself, united(all[0], all[1])},
          {"body", shown_scenario("particles"), last_body, all[2]},
          {"brownian", shown_scenario("brownian"), itself, united(all[0], all[3])}};
}

TEST(Files_on_the_page, run_exactly)
{
  std::map<std::string, int> numbers;
  for (const std::string& file : shown_files()) {
    SCOPED_TRACE(file);
    const std::string extension = extension_of(file);
    ++numbers[extension];
    const std::string path = write_file("shown" + extension, file);
    const scenario::Opened_motion motion = scenario::open_any_motion(path, {}, {}, std::nullopt);
    const Json report =
        report_of(extension == ".json" ? Words{path, "--points", "100"} : Words{path});
    if (motion.in_plane) {
      expect_exact_report(report, motion.in_plane->frames());
    } else {
      EXPECT_EQ(report["certified_frames"], motion.in_space->frames());
    }
  }
  EXPECT_EQ(numbers[".json"], 3);
  EXPECT_EQ(numbers[".csv"], 3);
  EXPECT_EQ(numbers[".dump"], 3);
  EXPECT_EQ(numbers[".xyz"], 1);
}

TEST(Tables_on_the_page, have_exactly_the_keys_that_the_program_knows)
{
  for (const Described& thing : described()) {
    SCOPED_TRACE(thing.name);
    Json json = thing.example;
    thing.object(json)["unknown"] = 1;
    std::string refusal = refusal_of(json);
    const std::string before = "allowed are ";
    ASSERT_TRUE(contains(refusal, before)) << refusal;
    refusal = refusal.substr(refusal.find(before) + before.size());
    Keys known;
    std::istringstream stream(refusal);
    for (std::string key; std::getline(stream, key, ',');) {
      known.emplace(scenario::trimmed(key));
    }
    EXPECT_EQ(keys_of(thing.table), known);
  }
}

TEST(Examples_on_the_page, have_every_key)
{
  for (const Described& thing : described()) {
    SCOPED_TRACE(thing.name);
    Json json = thing.example;
    Keys keys;
    for (const auto& member : thing.object(json).items()) {
      keys.insert(member.key());
    }
    EXPECT_EQ(keys, keys_of(thing.table));
  }
}

TEST(Tables_on_the_page, say_which_keys_are_needed)
{
  for (const Described& thing : described()) {
    for (const auto& [key, row] : thing.table) {
      SCOPED_TRACE(thing.name + ": " + key);
      Json json = thing.example;
      thing.object(json).erase(key);
      if (key == "bonded") { // two other keys need it
        thing.object(json).erase("strain_limit");
        thing.object(json).erase("shiver");
      }
      const std::string refusal = refusal_of(json);
      EXPECT_EQ(row.otherwise == "needed", contains(refusal, key + "' is missing")) << refusal;
      EXPECT_EQ(row.otherwise == "needed", !refusal.empty()) << refusal;
    }
  }
}

// The part of the message for a wrong value that says which values are allowed.
std::string allowed_instead_of(const Described& thing, const std::string& key, const Json& value)
{
  Json json = thing.example;
  thing.object(json)[key] = value;
  const std::string refusal = refusal_of(json);
  for (const std::string before :
       {"allowed are values ", "allowed are ", "expected an ", "expected a ", "expected "}) {
    if (contains(refusal, before)) {
      return refusal.substr(refusal.find(before) + before.size());
    }
  }
  return refusal;
}

TEST(Tables_on_the_page, say_what_values_may_be)
{
  for (const Described& thing : described()) {
    for (const auto& [key, row] : thing.table) {
      SCOPED_TRACE(thing.name + ": " + key + ": " + row.value);
      Json example = thing.example;
      const Json& value = thing.object(example)[key];
      if (value.is_string()) {
        const std::string allowed = allowed_instead_of(thing, key, "no such word");
        for (std::size_t begin = 0; key != "name" && begin < allowed.size();) {
          const std::size_t end = (std::min)(allowed.find(", ", begin), allowed.size());
          EXPECT_TRUE(contains(row.value, "`" + allowed.substr(begin, end - begin) + "`"));
          begin = end + 2;
        }
      } else if (value.is_boolean()) {
        EXPECT_EQ(allowed_instead_of(thing, key, 1), "true or false");
        EXPECT_EQ(row.value, "`true` or `false`");
      } else if (value.is_number_integer()) {
        EXPECT_EQ("integer " + allowed_instead_of(thing, key, -1), row.value);
      } else if (value.is_number()) {
        EXPECT_EQ("number " + allowed_instead_of(thing, key, 1e300), row.value);
      } else if (key != "bodies") {
        EXPECT_EQ("array of two numbers " + allowed_instead_of(thing, key, {1e300, 1e300}),
                  row.value);
      } else {
        EXPECT_TRUE(
            contains(allowed_instead_of(thing, key, Json::array()), "array of at least one"));
      }
    }
  }
}

TEST(Dialects_on_the_page, are_those_that_are_tested)
{
  std::set<std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(DIALECTS_FOLDER)) {
    files.insert("`" + file.path().filename().string() + "`");
  }
  std::set<std::string> on_the_page;
  const std::string tests = content_of(DIALECTS_FOLDER "/../test_recording_dialects.cpp");
  for (const std::string& line : lines_of(page())) {
    const auto cells = line.rfind("| ", 0) == 0 ? cells_of(line) : std::vector<std::string>();
    if (cells.size() == 4 && cells[3].rfind("`Dialect.", 0) == 0) {
      on_the_page.insert(cells[2]);
      const std::string name = cells[3].substr(9, cells[3].size() - 10);
      EXPECT_TRUE(contains(tests, "TEST(Dialect, " + name + ")")) << name;
    }
  }
  EXPECT_EQ(on_the_page, files);
}

} // namespace
