// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../sealed_checkpoint.h"
#include "fuzz_target.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Nearly_delaunay_classifier_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Exact = CGAL::Dynamic_Delaunay_triangulation_2<CGAL::Epick>;
using Heuristic =
    CGAL::Dynamic_Delaunay_triangulation_2<CGAL::Epick, CGAL::Nearly_delaunay_classifier_2>;
using Rational = CGAL::Dynamic_Delaunay_triangulation_2<CGAL::Epeck>;
using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<CGAL::Epick>;

// A triangulation without points. A periodic one needs a cell all the same.
template <class Dynamic>
Dynamic empty()
{
  return Dynamic();
}
template <>
Periodic empty<Periodic>()
{
  return Periodic(CGAL::Periodic_cell_2(1, 1));
}

// The lines before the first checksum. A file with more lines after it would always be refused.
std::string lines_of(const std::string& input)
{
  std::string lines = input.substr(0, input.find("\nchecksum "));
  if (lines.empty() || lines.back() != '\n')
    lines += '\n';
  return lines;
}

// Requires a message that a person can read in a terminal.
void require_readable(const CGAL::Checkpoint_error_2& error, const std::string& text)
{
  const std::string message = error.what();
  const auto lines = std::count(text.begin(), text.end(), '\n');
  fuzz::require(message.size() < 500, "an error is drowned in foreign data");
  fuzz::require(
      std::none_of(message.begin(), message.end(), [](char c) { return c < ' ' || c > '~'; }),
      "an error sends control characters to the terminal");
  fuzz::require(error.line() > 0 && error.line() <= static_cast<std::size_t>(lines) + 1,
                "an error is in a line that is not there");
}

template <class Subject>
bool is_read(Subject& subject, const std::string& text)
{
  std::istringstream in(text);
  const std::string before = checkpoint_of(subject);
  try {
    subject.read_checkpoint(in);
    return true;
  } catch (const CGAL::Checkpoint_error_2& error) {
    require_readable(error, text);
    fuzz::require(checkpoint_of(subject) == before, "a refused file has changed something");
    return false;
  }
}

// The positions of all points, the first one moved onto the last one.
template <class Dynamic>
auto next_frame(const Dynamic& dt)
{
  using Point = typename Dynamic::Point;
  std::vector<Point> points(dt.number_of_ids(), Point(0, 0));
  for (std::size_t id = 0; id < points.size(); ++id)
    if (dt.has_id(id))
      points[id] = dt.point(id);
  if (!points.empty())
    points.front() = points.back();
  return points;
}

template <class Dynamic>
bool is_sound(const Dynamic& dt)
{
  return dt.is_valid(true);
}

// An uncertified triangulation need not be Delaunay.
bool is_sound(const Periodic& pt)
{
  return !pt.is_certified() || pt.is_valid();
}

template <class Dynamic>
void insert_anywhere(Dynamic& dt)
{
  dt.insert(typename Dynamic::Point(1, 2));
}

// Inserts a point inside the cell: one that is too many cells away is refused.
void insert_anywhere(Periodic& pt)
{
  pt.insert(Periodic::Point(0.7 * pt.cell().ax(), 0.7 * pt.cell().ay()));
}

template <class Dynamic>
void require_usable(Dynamic& dt)
{
  fuzz::require(is_sound(dt), "a checkpoint was read that is not valid");
  Dynamic copy = empty<Dynamic>();
  const std::string text = checkpoint_of(dt);
  fuzz::require(is_read(copy, text), "what was written is refused");
  fuzz::require(checkpoint_of(copy) == text, "what was written is not what was read");
  const auto points = next_frame(dt);
  dt.update(points.begin(), points.end());
  fuzz::require(is_sound(dt), "an update has spoilt what was read");
  insert_anywhere(dt);
  dt.mend();
  fuzz::require(dt.is_certified() && is_sound(dt), "what was read cannot be mended");
}

template <class Dynamic>
void examine_triangulation(const std::string& text)
{
  Dynamic dt = empty<Dynamic>();
  if (is_read(dt, text))
    require_usable(dt);
}

template <class Dynamic>
void examine_population(const std::string& text)
{
  CGAL::Dynamic_population_2<Dynamic> population(empty<Dynamic>());
  if (!is_read(population, text))
    return;
  fuzz::require(is_sound(population.triangulation()), "a population is not valid");
  std::vector<std::pair<std::int64_t, CGAL::Epick::Point_2>> crowd;
  for (std::size_t id = 0; id < population.triangulation().number_of_ids(); ++id)
    if (population.triangulation().has_id(id))
      crowd.emplace_back(population.user_id(id), population.triangulation().point(id));
  fuzz::require(crowd.size() == population.size(), "a point has no id");
  population.update(crowd.begin(), crowd.end());
  fuzz::require(is_sound(population.triangulation()), "an update has spoilt a population");
}

} // namespace

void fuzz::examine(const std::string& input)
{
  const std::string text = sealed(lines_of(input));
  examine_triangulation<Exact>(text);
  examine_triangulation<Heuristic>(text);
  examine_triangulation<Rational>(text);
  examine_population<Exact>(text);
  examine_triangulation<Periodic>(text);
  examine_population<Periodic>(text);
}
