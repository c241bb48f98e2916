// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Polygon_text.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenario {

namespace {

constexpr const char* const allowed_texts =
    "allowed are POLYGON ((x y, x y, ...)), and a MULTIPOLYGON or GEOMETRYCOLLECTION of one";

// One of ( ) , ; = or a word or number, which ends before the next of them or a blank. Empty at the
// end of the text.
struct Wkt_token
{
  std::string_view text;
  std::size_t offset; // in the text
};

// Walks over the tokens of a text.
class Wkt_scanner
{
public:
  Wkt_scanner(const std::string& file, std::string_view text)
    : m_file(file)
    , m_text(without_byte_order_mark(file, text))
  {
    take();
  }

  const Wkt_token& next() const { return m_next; }
  bool is_next(std::string_view text) const { return m_next.text == text; }

  Wkt_token take()
  {
    const Wkt_token taken = m_next;
    const std::size_t begin = m_text.find_first_not_of(blanks, taken.offset + taken.text.size());
    m_next = begin == m_text.npos ? Wkt_token{{}, m_text.size()} : token_at(begin);
    return taken;
  }

  bool take_if(std::string_view text)
  {
    const bool is_there = is_next(text);
    if (is_there) {
      take();
    }
    return is_there;
  }

  void expect(std::string_view text, const std::string& where)
  {
    if (!take_if(text)) {
      fail_found("expected " + in_quotes(text) + " " + where);
    }
  }

  // Fails with what is next.
  [[noreturn]] void fail_found(const std::string& message) const
  {
    fail(message +
             (m_next.text.empty() ? ", but the text ends" : ", found " + in_quotes(m_next.text)),
         m_next);
  }

  [[noreturn]] void fail(const std::string& message, const Wkt_token& token) const
  {
    const std::string_view before = m_text.substr(0, token.offset);
    const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
    const std::size_t line_end = before.rfind('\n');
    const std::size_t line_begin = line_end == before.npos ? 0 : line_end + 1;
    throw Scenario_error(m_file, message, line, token.offset - line_begin + 1);
  }

private:
  static constexpr std::string_view blanks = " \t\r\n";
  static constexpr std::string_view marks = "(),;=";

  Wkt_token token_at(std::size_t begin) const
  {
    std::size_t end = begin + 1;
    if (marks.find(m_text[begin]) == marks.npos) {
      while (end != m_text.size() && marks.find(m_text[end]) == marks.npos &&
             blanks.find(m_text[end]) == blanks.npos) {
        ++end;
      }
    }
    return {m_text.substr(begin, end - begin), begin};
  }

  std::string m_file;
  std::string_view m_text;
  Wkt_token m_next{{}, 0};
};

class Wkt_parser
{
public:
  Wkt_parser(const std::string& file, std::string_view text)
    : m_scanner(file, text)
  {
  }

  Polygon parse()
  {
    const Wkt_token begin = m_scanner.next();
    read_reference_system();
    read_geometry(0);
    if (!m_scanner.next().text.empty()) {
      m_scanner.fail_found("expected nothing behind the polygon");
    }
    if (m_rings.empty()) {
      m_scanner.fail(std::string("holds no polygon: it is EMPTY, ") + allowed_texts, begin);
    }
    return polygon_of_rings(std::move(m_rings));
  }

private:
  enum class Type { polygon, multipolygon, collection };

  // A type, and how many numbers its corners have.
  struct Tag
  {
    Type type;
    std::size_t numbers;
  };

  // PostGIS writes SRID=4326; in front, a number that says where on Earth coordinates are.
  void read_reference_system()
  {
    if (lower_case(std::string(m_scanner.next().text)) != "srid") {
      return;
    }
    m_scanner.take();
    m_scanner.expect("=", "behind SRID");
    std::uint64_t ignored = 0;
    if (!is_number(m_scanner.next().text, ignored)) {
      m_scanner.fail_found("expected an integer behind SRID=");
    }
    m_scanner.take();
    m_scanner.expect(";", "behind the number of SRID");
  }

  void read_geometry(std::size_t depth)
  {
    constexpr std::size_t deepest = 16;
    if (depth == deepest) {
      m_scanner.fail("is nested too deeply, allowed are " + std::to_string(deepest) + " levels",
                     m_scanner.next());
    }
    const Tag tag = read_tag();
    switch (tag.type) {
    case Type::polygon:
      read_polygon(tag.numbers);
      break;
    case Type::multipolygon:
      read_list("polygons", [&] { read_polygon(tag.numbers); });
      break;
    default:
      read_list("geometries", [&] { read_geometry(depth + 1); });
    }
  }

  // POLYGON Z, POLYGONZ, polygon and so on.
  Tag read_tag()
  {
    std::string name = lower_case(std::string(m_scanner.next().text));
    std::optional<std::size_t> numbers;
    for (const char* const ending : {"zm", "z", "m"}) {
      const std::size_t size = std::string_view(ending).size();
      if (!numbers && name.size() > size && name.compare(name.size() - size, size, ending) == 0) {
        numbers = 2 + size;
        name.resize(name.size() - size);
      }
    }
    const std::optional<Type> type = type_named(name);
    if (!type) {
      m_scanner.fail_found(std::string("is no polygon in well-known text: ") + allowed_texts);
    }
    m_scanner.take();
    return {*type, numbers ? *numbers : read_numbers_of_corners()};
  }

  static std::optional<Type> type_named(std::string_view name)
  {
    return name == "polygon"              ? std::optional(Type::polygon)
           : name == "multipolygon"       ? std::optional(Type::multipolygon)
           : name == "geometrycollection" ? std::optional(Type::collection)
                                          : std::nullopt;
  }

  std::size_t read_numbers_of_corners()
  {
    const std::string name = lower_case(std::string(m_scanner.next().text));
    const std::size_t numbers = name == "zm" ? 4 : name == "z" || name == "m" ? 3 : 2;
    if (numbers != 2) {
      m_scanner.take();
    }
    return numbers;
  }

  // Reads EMPTY, or elements in parentheses with commas between them.
  template <class Read>
  void read_list(const std::string& of, Read read)
  {
    if (lower_case(std::string(m_scanner.next().text)) == "empty") {
      m_scanner.take();
      return;
    }
    m_scanner.expect("(", "before the " + of);
    do {
      read();
    } while (m_scanner.take_if(","));
    m_scanner.expect(")", "behind the " + of);
  }

  void read_polygon(std::size_t numbers)
  {
    const Wkt_token begin = m_scanner.next();
    const bool is_another = !m_rings.empty();
    std::vector<std::vector<Point>> rings;
    read_list("rings", [&] { rings.push_back(read_ring(rings.size(), numbers)); });
    if (is_another && !rings.empty()) {
      m_scanner.fail(std::string("holds a second polygon, and a domain is one; ") + allowed_texts,
                     begin);
    }
    if (!rings.empty()) {
      m_rings = std::move(rings);
    }
  }

  std::vector<Point> read_ring(std::size_t number, std::size_t numbers)
  {
    const Wkt_token begin = m_scanner.next();
    const std::string name = "ring " + std::to_string(number);
    std::vector<Point> corners;
    read_list("corners of " + name, [&] {
      corners.push_back(
          read_corner("corner " + std::to_string(corners.size()) + " of " + name, numbers));
    });
    const std::string problem = problem_of_ring(corners);
    if (!problem.empty()) {
      m_scanner.fail(name + " " + problem, begin);
    }
    return corners;
  }

  Point read_corner(const std::string& name, std::size_t numbers)
  {
    const Wkt_token begin = m_scanner.next();
    std::vector<double> values;
    while (!is_end_of_corner(m_scanner.next())) {
      values.push_back(read_number(name, values.size()));
    }
    if (values.size() != numbers) {
      m_scanner.fail(name + " has " + std::to_string(values.size()) +
                         (values.size() == 1 ? " number" : " numbers") + ", expected " +
                         std::to_string(numbers) +
                         (numbers > 2         ? " by its type"
                          : values.size() > 2 ? "; a type with heights is POLYGON Z"
                                              : ""),
                     begin);
    }
    return {values[0], values[1]};
  }

  // An empty token is the end of the text.
  static bool is_end_of_corner(const Wkt_token& token)
  {
    return token.text.empty() || token.text == "," || token.text == ")";
  }

  // Numbers beyond the first two are dropped; GEOS writes NaN where a height is unknown.
  double read_number(const std::string& name, std::size_t place)
  {
    const Wkt_token token = m_scanner.take();
    const bool has_plus = token.text.size() > 1 && token.text[0] == '+' && token.text[1] != '-';
    double value = 0.0;
    if (!is_number(token.text.substr(has_plus ? 1 : 0), value)) {
      m_scanner.fail(in_quotes(token.text) + " in " + name +
                         " is not a number in the range of doubles",
                     token);
    }
    if (place < 2 && !std::isfinite(value)) {
      m_scanner.fail(in_quotes(token.text) + " in " + name + " is not a finite number", token);
    }
    return value;
  }

  Wkt_scanner m_scanner;
  std::vector<std::vector<Point>> m_rings; // of the polygon, once it is found
};

} // namespace

Polygon parse_wkt(const std::string& file, std::string_view text)
{
  return Wkt_parser(file, text).parse();
}

} // namespace scenario
