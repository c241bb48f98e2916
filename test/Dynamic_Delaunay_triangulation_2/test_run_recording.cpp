// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The page that plays a run: what it holds is read here as its script reads it, and compared with
// the run.

#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Periodic_run.h"
#include "scenario_runner/Picture_geometry.h"
#include "scenario_runner/Player_page.h"
#include "scenario_runner/Scenario_run.h"
#include "temporary_files.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using Json = nlohmann::json;
using scenario::Cell;
using scenario::Point;
using Integers = std::vector<std::int64_t>;

// What is shown, by ids. Edges and triangles are lists of ids, followed by shifts.
struct Shown_frame
{
  std::map<std::int64_t, Point> positions;
  std::map<std::int64_t, std::int64_t> sets;
  std::set<Integers> edges;
  std::set<Integers> wrong;
  std::set<Integers> triangles;
};

Integers edge(std::int64_t i, std::int64_t j, std::int64_t s, std::int64_t t)
{
  return (std::min)(Integers{i, j, s, t}, Integers{j, i, -s, -t});
}

struct Corner
{
  std::int64_t id;
  std::int64_t s;
  std::int64_t t;
};

// The normal form of a counterclockwise triangle, whichever corner comes first.
Integers triangle(const std::array<Corner, 3>& corners)
{
  Integers least;
  for (std::size_t a = 0; a != 3; ++a) {
    const Corner &p = corners[a], &q = corners[(a + 1) % 3], &r = corners[(a + 2) % 3];
    const Integers turned{p.id, q.id, r.id, q.s - p.s, q.t - p.t, r.s - p.s, r.t - p.t};
    least = least.empty() ? turned : (std::min)(least, turned);
  }
  return least;
}

Shown_frame shown(const run::Run_view& run)
{
  Shown_frame frame;
  const auto& ids = run.motion().ids();
  const auto sets = run.sets();
  for (std::size_t i = 0; i != ids.size(); ++i) {
    frame.positions[ids[i]] = run.motion().points()[i];
    frame.sets[ids[i]] = static_cast<std::int64_t>(sets[i]);
  }
  for (const run::Shown_edge& e : run.edges()) {
    const Integers known = edge(ids[e.from], ids[e.to], e.shift[0], e.shift[1]);
    frame.edges.insert(known);
    if (!e.is_delaunay) {
      frame.wrong.insert(known);
    }
  }
  for (const run::Shown_triangle& t : run.triangles()) {
    std::array<Corner, 3> corners{};
    for (std::size_t k = 0; k != 3; ++k) {
      corners[k] = {ids[t.corners[k]], t.shifts[k][0], t.shifts[k][1]};
    }
    frame.triangles.insert(triangle(corners));
  }
  return frame;
}

std::string bytes_of(const std::string& text)
{
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int number_of_bits = 0;
  for (const char letter : text) {
    if (letter == '=') {
      break;
    }
    bits = bits << 6 | static_cast<std::uint32_t>(letters.find(letter));
    number_of_bits += 6;
    if (number_of_bits >= 8) {
      number_of_bits -= 8;
      bytes += static_cast<char>(bits >> number_of_bits & 255);
    }
  }
  return bytes;
}

class Reader
{
public:
  explicit Reader(const std::string& text)
    : m_bytes(bytes_of(text))
  {
  }

  std::int64_t next()
  {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(m_bytes.at(m_at++));
      value |= static_cast<std::uint64_t>(byte & 127) << shift;
      if (byte < 128) {
        return static_cast<std::int64_t>(value);
      }
    }
  }
  std::int64_t next_signed()
  {
    const std::int64_t value = next();
    return value % 2 == 0 ? value / 2 : -(value / 2) - 1;
  }
  Integers next_list()
  {
    Integers list(static_cast<std::size_t>(next()));
    std::int64_t value = 0;
    for (std::int64_t& number : list) {
      number = value += next();
    }
    return list;
  }
  bool is_at_end() const { return m_at == m_bytes.size(); }

private:
  std::string m_bytes;
  std::size_t m_at = 0;
};

// The frames of a recording, one after the other.
class Decoder
{
public:
  explicit Decoder(const Json& json)
    : m_json(json)
    , m_positions(json["positions"].get<std::string>())
    , m_changes(json["changes"].get<std::string>())
    , m_is_periodic(!json["cells"].is_null())
  {
  }

  // Reads the next frame. Points have numbers; steps are positions as multiples of the quantum.
  void advance()
  {
    for (const std::int64_t number : m_changes.next_list()) {
      m_steps.erase(number);
      m_sets.erase(number);
    }
    for (std::int64_t come = m_changes.next(); come != 0; --come) {
      const auto number = static_cast<std::int64_t>(m_ids.size());
      m_steps[number] = {0, 0};
      m_sets[number] = 0;
      m_ids.push_back(m_changes.next_signed());
    }
    read_tuples(m_edges, 2, m_is_periodic ? 4 : 2);
    m_wrong = m_changes.next_list();
    read_tuples(m_triangles, 3, m_is_periodic ? 7 : 3);
    const Integers changed = m_changes.next_list();
    for (const std::int64_t number : changed) {
      m_sets.at(number) = m_changes.next();
    }
    for (auto& [number, step] : m_steps) {
      step[0] += m_positions.next_signed();
      step[1] += m_positions.next_signed();
    }
  }

  bool is_at_end() const { return m_positions.is_at_end() && m_changes.is_at_end(); }

  // With the shifts between the points of the motion, of which the recording has images.
  Shown_frame frame(const scenario::Motion& motion) const
  {
    Shown_frame frame;
    const double quantum = m_json["quantum"];
    std::map<std::int64_t, std::array<std::int64_t, 2>> images;
    std::map<std::int64_t, Point> points;
    for (std::size_t i = 0; i != motion.ids().size(); ++i) {
      points[motion.ids()[i]] = motion.points()[i];
    }
    for (const auto& [number, step] : m_steps) {
      const std::int64_t id = m_ids[static_cast<std::size_t>(number)];
      Point at{m_json["low"][0].get<double>() + quantum * static_cast<double>(step[0]),
               m_json["low"][1].get<double>() + quantum * static_cast<double>(step[1])};
      images[number] = {0, 0};
      if (const auto cell = motion.cell()) {
        const scenario::Shift by = run::nearest_shift(points.at(id), at, *cell);
        images[number] = {by[0], by[1]};
        const Point back = cell->translation(by);
        at = {at.x - back.x, at.y - back.y};
      }
      frame.positions[id] = at;
      frame.sets[id] = m_sets.at(number);
    }
    const auto edge_of = [&](const Integers& t) {
      const auto &from = images.at(t[0]), &to = images.at(t[1]);
      return edge(id(t[0]), id(t[1]), t[2] - from[0] + to[0], t[3] - from[1] + to[1]);
    };
    for (const Integers& tuple : m_edges) {
      frame.edges.insert(edge_of(tuple));
    }
    for (const std::int64_t e : m_wrong) {
      frame.wrong.insert(edge_of(m_edges.at(static_cast<std::size_t>(e))));
    }
    for (const Integers& t : m_triangles) {
      const auto corner = [&](std::int64_t number, std::int64_t s, std::int64_t u) {
        return Corner{id(number), s + images.at(number)[0], u + images.at(number)[1]};
      };
      frame.triangles.insert(
          triangle({corner(t[0], 0, 0), corner(t[1], t[3], t[4]), corner(t[2], t[5], t[6])}));
    }
    return frame;
  }

private:
  std::int64_t id(std::int64_t number) const { return m_ids.at(static_cast<std::size_t>(number)); }

  // Those of the plane have shifts of 0.
  void read_tuples(std::vector<Integers>& tuples, std::size_t corners, std::size_t numbers)
  {
    const Integers removed = m_changes.next_list();
    for (auto place = removed.rbegin(); place != removed.rend(); ++place) {
      ASSERT_LT(static_cast<std::size_t>(*place), tuples.size());
      tuples.erase(tuples.begin() + *place);
    }
    std::int64_t first = 0;
    for (std::int64_t added = m_changes.next(); added != 0; --added) {
      Integers tuple(corners == 2 ? 4 : 7, 0);
      tuple[0] = first += m_changes.next();
      for (std::size_t k = 1; k != numbers; ++k) {
        tuple[k] = m_changes.next_signed() + (k < corners ? first : 0);
      }
      tuples.push_back(tuple);
    }
    std::sort(tuples.begin(), tuples.end());
  }

  Json m_json;
  Reader m_positions;
  Reader m_changes;
  bool m_is_periodic;
  Integers m_ids;
  std::map<std::int64_t, std::array<std::int64_t, 2>> m_steps;
  std::map<std::int64_t, std::int64_t> m_sets;
  std::vector<Integers> m_edges;
  std::vector<Integers> m_triangles;
  Integers m_wrong;
};

Json recording_in(const std::string& page)
{
  const std::string head = "<script type=\"application/json\" id=\"recording\">";
  const std::size_t begin = page.find(head) + head.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

// Rounding to the nearest multiple, and what doubles lose where the page computes the position and
// this test brings it back into the cell.
double tolerance(const Json& json)
{
  const auto size = [](const Json& point) {
    return (std::max)(std::abs(point[0].get<double>()), std::abs(point[1].get<double>()));
  };
  return 0.5 * json["quantum"].get<double>() + 1e-14 * (size(json["low"]) + size(json["high"]));
}

struct Played
{
  std::string page;
  std::size_t frames = 0;
  std::size_t wrong = 0;
  std::size_t in_sets = 0;
};

template <class Run>
Played expect_played(const std::string& path, std::size_t frames, Run run_of)
{
  const auto motion = scenario::open_motion(path);
  frames = (std::min)(frames, motion->frames());
  const std::string file = temporary_path("played.html");
  std::vector<Shown_frame> expected;
  {
    auto run = run_of(*motion);
    run::Player_page page(file, motion->name(), "a method", run::Frame_choice(frames, 1));
    run.check_first_frame();
    page.take(run);
    expected.push_back(shown(run));
    while (expected.size() <= frames && run.advance()) {
      page.take(run);
      expected.push_back(shown(run));
    }
    page.finish();
  }
  Played played{content_of(file)};
  const Json json = recording_in(played.page);
  EXPECT_EQ(json["columns"]["frame"].size(), expected.size());
  Decoder decoder(json);
  const auto again = scenario::open_motion(path);
  auto run = run_of(*again); // the motion may depend on the triangulation
  for (const Shown_frame& frame : expected) {
    decoder.advance();
    const Shown_frame read = decoder.frame(*again);
    EXPECT_EQ(read.sets, frame.sets) << "frame " << played.frames;
    EXPECT_EQ(read.edges, frame.edges) << "frame " << played.frames;
    EXPECT_EQ(read.wrong, frame.wrong) << "frame " << played.frames;
    EXPECT_EQ(read.triangles, frame.triangles) << "frame " << played.frames;
    for (const auto& [id, point] : frame.positions) {
      EXPECT_NEAR(read.positions.at(id).x, point.x, tolerance(json)) << "id " << id;
      EXPECT_NEAR(read.positions.at(id).y, point.y, tolerance(json)) << "id " << id;
      played.in_sets += frame.sets.at(id) != 0;
    }
    played.wrong += frame.wrong.size();
    ++played.frames;
    if (played.frames != expected.size()) {
      run.measure();
    }
  }
  EXPECT_TRUE(decoder.is_at_end());
  return played;
}

using Exact = CGAL::Circumcircle_classifier_2;

run::Scenario_run<Exact> exact_run(scenario::Motion& motion)
{
  return {motion, Exact(), run::Any_repair(), {}, run::Any_policy()};
}

run::Periodic_run<Exact> periodic_run(scenario::Motion& motion)
{
  return {motion, Exact(), run::Any_repair(), {}, run::Any_policy()};
}

TEST(Player_page, of_1008_points_and_300_frames_is_below_5_megabytes_and_has_every_frame)
{
  const Played played = expect_played(SCENARIOS_FOLDER "/dam_break.json", 300, exact_run);
  EXPECT_EQ(played.frames, 301u);
  EXPECT_EQ(recording_in(played.page)["columns"]["points"][0], 1008);
  EXPECT_LT(played.page.size(), 5'000'000u);
  EXPECT_GT(played.in_sets, 0u);
  EXPECT_EQ(played.wrong, 0u);
}

TEST(Player_page, rounds_positions_to_the_longer_side_divided_by_2_to_the_20)
{
  const Json json =
      recording_in(expect_played(SCENARIOS_FOLDER "/brownian_periodic.json", 1, periodic_run).page);
  EXPECT_EQ(json["quantum"].get<double>(), std::ldexp(1.0, -20)) << "of the unit cell";
}

TEST(Player_page, follows_points_across_the_sides_of_a_cell)
{
  std::string text;
  for (int frame = 0; frame != 12; ++frame) {
    text +=
        "9\nLattice=\"1 0 0 " + std::to_string(0.02 * frame) +
        " 1 0 0 0 1\" pbc=\"T T F\" Properties=species:S:1:pos:R:3 Time=" + std::to_string(frame) +
        "\n";
    for (int i = 0; i != 9; ++i) {
      text += "X " + std::to_string(std::fmod(0.11 * i + 0.13 * frame, 1.0)) + " " +
              std::to_string(std::fmod(0.37 * i + 0.05 * frame * (i % 3), 1.0)) + " 0\n";
    }
  }
  const Played played = expect_played(write_file("sheared.xyz", text), 11, periodic_run);
  EXPECT_EQ(played.frames, 12u);
}

TEST(Player_page, has_points_that_come_go_and_return)
{
  std::string text = "frame,id,x,y\n";
  for (int frame = 0; frame != 10; ++frame) {
    for (int id = -2; id != 20; ++id) {
      if (frame != 4 && (3 * id + 2 * frame) % 7 != 1) {
        text += std::to_string(frame) + ',' + std::to_string(id) + ',' +
                std::to_string(id * 7 % 10 + 0.01 * frame) + ',' + std::to_string(id * id % 13) +
                '\n';
      }
    }
  }
  const std::string path = write_file("coming_and_going.csv", text);
  EXPECT_EQ(expect_played(path, 9, exact_run).frames, 9u) << "frame 4 has no row";
}

TEST(Player_page, marks_the_edges_that_a_heuristic_classifier_leaves_wrong)
{
  using Heuristic = CGAL::Random_classifier_2;
  const auto heuristic_run = [](scenario::Motion& motion) {
    return run::Scenario_run<Heuristic>(motion, Heuristic(0.01, 1), run::make_repair("splice", 1),
                                        {}, run::Any_policy());
  };
  const Played played = expect_played(SCENARIOS_FOLDER "/explosion.json", 15, heuristic_run);
  EXPECT_GT(played.wrong, 0u);
  EXPECT_GT(played.in_sets, 0u);
}

TEST(Player_page, shows_any_name_as_text)
{
  const std::string name = "</title></script><script>alert(1)</script> & \xff";
  const std::string file = temporary_path("named.html");
  const auto motion = scenario::open_motion(SCENARIOS_FOLDER "/dam_break.json");
  auto run = exact_run(*motion);
  run::Player_page page(file, name, "a method", run::Frame_choice(0, 1));
  page.take(run);
  page.finish();
  const std::string text = content_of(file);
  EXPECT_EQ(text.find("<script>alert"), std::string::npos);
  const std::string read = recording_in(text)["name"];
  EXPECT_EQ(read.rfind("</title></script><script>alert(1)</script> & ", 0), 0u) << read;
}

} // namespace
