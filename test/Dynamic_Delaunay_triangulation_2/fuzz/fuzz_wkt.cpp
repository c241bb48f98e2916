// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parser_checks.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Polygon_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace {

using fuzz::require;
using Ring = std::vector<scenario::Point>;

std::vector<Ring> rings_of(const scenario::Polygon& polygon)
{
  std::vector<Ring> rings = polygon.holes;
  rings.insert(rings.begin(), polygon.boundary);
  return rings;
}

bool are_equal(const std::vector<Ring>& a, const std::vector<Ring>& b)
{
  const auto is_same = [](const scenario::Point& p, const scenario::Point& q) {
    return p.x == q.x && p.y == q.y;
  };
  const auto is_same_ring = [&](const Ring& r, const Ring& s) {
    return std::equal(r.begin(), r.end(), s.begin(), s.end(), is_same);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), is_same_ring);
}

void require_sound(const Ring& ring)
{
  require(ring.size() >= 3, "a ring has too few corners");
  for (const scenario::Point& corner : ring) {
    require(std::isfinite(corner.x) && std::isfinite(corner.y), "a corner is not finite");
  }
}

// The words of a text that has numbers: those of one corner.
std::vector<std::string> numbers_in(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

// Requires that the text, read by its commas and parentheses alone, has these corners, each once,
// with equally many numbers.
void require_as_written(const std::vector<Ring>& rings, const std::string& text)
{
  Ring written;
  std::size_t numbers = 0;
  constexpr const char* const ends = "(),";
  for (std::size_t begin = text.find('('); begin != text.npos;) {
    const std::size_t end = text.find_first_of(ends, begin + 1);
    const auto words = numbers_in(text.substr(begin + 1, end - begin - 1));
    if (!words.empty() && words[0].find_first_of("0123456789") != std::string::npos) {
      require(words.size() == (numbers == 0 ? words.size() : numbers),
              "corners have different numbers of coordinates");
      require(words.size() >= 2 && words.size() <= 4, "a corner does not have two coordinates");
      numbers = words.size();
      written.push_back(
          {std::strtod(words[0].c_str(), nullptr), std::strtod(words[1].c_str(), nullptr)});
    }
    begin = end;
  }
  Ring read;
  for (const Ring& ring : rings) {
    read.insert(read.end(), ring.begin(), ring.end());
    read.push_back(ring.front());
  }
  require(are_equal({read}, {written}), "corners are not those that were written");
}

std::string written_rings(const std::vector<Ring>& rings, const std::string& heights)
{
  std::string text = "(";
  for (const Ring& ring : rings) {
    text += text == "(" ? "(" : ", (";
    for (const scenario::Point& corner : ring) {
      text += run::number_text(corner.x) + ' ' + run::number_text(corner.y) + heights + ", ";
    }
    text += run::number_text(ring[0].x) + ' ' + run::number_text(ring[0].y) + heights + ')';
  }
  return text + ')';
}

void require_read_back(const std::vector<Ring>& rings, const std::string& text)
{
  const auto again = fuzz::parsed_or_refused(text, scenario::parse_wkt);
  require(again && are_equal(rings_of(*again), rings), "what is written is read otherwise");
}

} // namespace

void fuzz::examine(const std::string& input)
{
  const auto polygon = parsed_or_refused(input, scenario::parse_wkt);
  if (!polygon) {
    return;
  }
  const std::vector<Ring> rings = rings_of(*polygon);
  std::for_each(rings.begin(), rings.end(), ::require_sound);
  require_as_written(rings, input);
  require_read_back(rings, "POLYGON " + written_rings(rings, ""));
  require_read_back(rings, "multipolygonm(" + written_rings(rings, " nan") + ')');
  require_read_back(rings, "SRID=1;GEOMETRYCOLLECTION ZM (POLYGON EMPTY, POLYGON ZM\n" +
                               written_rings(rings, " 1 2") + ")\n");
}
