// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The second lines of frames in extended XYZ files: an input is a file without its first line. What
// is accepted is written back, in each of the ways that the format has for one value, and read as
// equal. What a plain line says is found without the parser as well, and compared.

#include "parser_checks.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Recorded_motion.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace {

using scenario::Recorded_frame;
using scenario::Recording;

// Ways to write the same.
enum class Style { USUAL, NEW_ARRAYS, BRACES, FORTRAN };
constexpr std::array<Style, 4> styles = {Style::USUAL, Style::NEW_ARRAYS, Style::BRACES,
                                         Style::FORTRAN};

std::string number(double value, Style style)
{
  std::string text = run::number_text(value);
  if (style == Style::FORTRAN) {
    std::replace(text.begin(), text.end(), 'e', 'D');
    text += text.find('D') == text.npos ? "D0" : "";
  }
  return text;
}

std::string joined(const std::vector<std::string>& words, const std::string& separator)
{
  std::string text;
  for (std::size_t i = 0; i != words.size(); ++i) {
    text += (i == 0 ? "" : separator) + words[i];
  }
  return text;
}

std::string array(const std::vector<std::string>& words, Style style)
{
  switch (style) {
  case Style::NEW_ARRAYS:
    return "[" + joined(words, ", ") + "]";
  case Style::BRACES:
    return "{" + joined(words, " ") + "}";
  default:
    return '"' + joined(words, " ") + '"';
  }
}

std::string matrix(const std::vector<std::string>& words, Style style)
{
  if (style != Style::NEW_ARRAYS) {
    return array(words, style);
  }
  std::vector<std::string> rows;
  for (std::ptrdiff_t i = 0; i != 9; i += 3) {
    rows.push_back(array({words.begin() + i, words.begin() + i + 3}, style));
  }
  return array(rows, style);
}

std::string box_text(const scenario::Cell_3& box, Style style, const std::string& equals)
{
  const auto text = [style](double value) { return number(value, style); };
  const auto letter = [](bool is_true) { return is_true ? "T" : "F"; };
  std::vector<std::string> sides, corner, are_periodic;
  for (std::size_t i = 0; i != 3; ++i) {
    for (const double coordinate : box.sides[i]) {
      sides.push_back(text(coordinate));
    }
    corner.push_back(text(box.corner[i]));
    are_periodic.emplace_back(letter(box.is_periodic[i]));
  }
  return "Lattice" + equals + matrix(sides, style) + " Origin" + equals + array(corner, style) +
         " pbc" + equals + array(are_periodic, style) + " ";
}

std::string written(const Recorded_frame& frame, Style style)
{
  const std::string equals = style == Style::FORTRAN ? "  = " : "=";
  std::string text = std::to_string(frame.ids.size()) + "\nremark=\"a \\\" Lattice = 1\" ";
  text += frame.box ? box_text(*frame.box, style, equals) : "";
  text += std::string("Properties") + equals + "pos:R:2:id:" + (frame.names ? "S" : "I") +
          ":1 Time" + equals + number(frame.time, style) + " Frame" + equals +
          std::to_string(frame.number) + "\n";
  for (std::size_t i = 0; i != frame.ids.size(); ++i) {
    text += number(frame.points[i].x, style) + ' ' + number(frame.points[i].y, style) + ' ' +
            (frame.names ? (*frame.names)[static_cast<std::size_t>(frame.ids[i])]
                         : std::to_string(frame.ids[i])) +
            '\n';
  }
  return text;
}

std::string written(const Recording& recording, Style style)
{
  std::string text;
  for (const Recorded_frame& frame : recording) {
    text += written(frame, style);
  }
  return text;
}

bool are_equal(const Recorded_frame& a, const Recorded_frame& b)
{
  const auto is_same = [](const scenario::Point& p, const scenario::Point& q) {
    return p.x == q.x && p.y == q.y;
  };
  const auto has_same_name = [&](std::int64_t i, std::int64_t j) {
    return a.names
               ? (*a.names)[static_cast<std::size_t>(i)] == (*b.names)[static_cast<std::size_t>(j)]
               : i == j;
  };
  return a.time == b.time && a.number == b.number && a.cell == b.cell && a.box == b.box &&
         !a.names == !b.names &&
         std::equal(a.ids.begin(), a.ids.end(), b.ids.begin(), b.ids.end(), has_same_name) &&
         std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), is_same);
}

void require_written_back(const Recording& recording)
{
  for (const Style style : styles) {
    const Recording again = scenario::parse_xyz(fuzz::file_name, written(recording, style));
    fuzz::require(
        std::equal(recording.begin(), recording.end(), again.begin(), again.end(), are_equal),
        "what was accepted is read otherwise when it is written back");
  }
}

bool is_blank(char c)
{
  return c == ' ' || c == '\t';
}

std::string lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

// The text in double quotes after `key` and =, in a line that has no other quotes, brackets or
// escapes: a reader that is as simple as can be.
std::optional<std::string> plain_value(const std::string& line, const std::string& key)
{
  if (line.find_first_of("'{}[]\\") != line.npos) {
    return std::nullopt;
  }
  bool is_quoted = false;
  const std::string text = lower(line);
  for (std::size_t i = 0; i != line.size(); ++i) {
    is_quoted = line[i] == '"' ? !is_quoted : is_quoted;
    if (is_quoted || text.compare(i, key.size(), key) != 0 || (i != 0 && !is_blank(line[i - 1]))) {
      continue;
    }
    std::size_t place = i + key.size();
    const auto skip_blanks = [&] {
      while (place != line.size() && is_blank(line[place])) {
        ++place;
      }
    };
    skip_blanks();
    if (place == line.size() || line[place++] != '=') {
      continue;
    }
    skip_blanks();
    const std::size_t end = place == line.size() ? line.npos : line.find('"', place + 1);
    if (end != line.npos && line[place] == '"') {
      return line.substr(place + 1, end - place - 1);
    }
  }
  return std::nullopt;
}

// The numbers in a text; none if there is anything else.
std::vector<double> plain_numbers(const std::string& text)
{
  std::vector<double> numbers;
  if (text.find_first_not_of("0123456789.+-eE \t") != text.npos) {
    return {};
  }
  const char* rest = text.c_str();
  while (rest[std::strspn(rest, " \t")] != '\0') {
    char* end = nullptr;
    numbers.push_back(std::strtod(rest, &end));
    if (end == rest || (*end != '\0' && !is_blank(*end))) {
      return {};
    }
    rest = end;
  }
  return numbers;
}

// Whether nothing that the line plainly says is lost or otherwise.
void require_what_is_said(const std::string& line, const Recorded_frame& frame)
{
  const auto lattice = plain_value(line, "lattice");
  const auto pbc = plain_value(line, "pbc");
  const std::vector<double> vectors = lattice ? plain_numbers(*lattice) : std::vector<double>();
  if (vectors.size() == 9 && frame.cell) {
    const auto& [a, b] = frame.cell->sides;
    fuzz::require(a.x == vectors[0] && a.y == vectors[1] && b.x == vectors[3] && b.y == vectors[4],
                  "a Lattice is misread");
  }
  if (lattice && !frame.cell) {
    fuzz::require(lower(line).find("pbc") != line.npos, "a Lattice has vanished");
  }
  if (pbc && (*pbc == "T T T" || *pbc == "T T F")) {
    fuzz::require(frame.cell && !frame.cell->is_slab(), "a torus is misread");
  }
  if (pbc && (*pbc == "F F F" || *pbc == "F F T")) {
    fuzz::require(!frame.cell, "a plane is misread");
  }
  const auto time = plain_value(line, "time");
  const std::vector<double> times = time ? plain_numbers(*time) : std::vector<double>();
  fuzz::require(times.size() != 1 || times[0] == frame.time, "a Time is misread");
}

} // namespace

void fuzz::examine(const std::string& input)
{
  const std::string text = "1\n" + input;
  const auto recording =
      parsed_or_refused(text, [](const std::string& file, const std::string& file_text) {
        return scenario::parse_xyz(file, file_text);
      });
  if (recording) {
    require_sound(*recording);
    require_written_back(*recording);
    require_what_is_said(input.substr(0, input.find('\n')), recording->front());
  }
}
