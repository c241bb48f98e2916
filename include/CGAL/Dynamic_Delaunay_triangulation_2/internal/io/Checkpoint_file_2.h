// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_FILE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_FILE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Decimal_number_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Guibas_stolfi_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Lazy_exact_nt.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The lines of a checkpoint, whatever their content: words separated by single spaces. The first
// line names the kind of file, the last one holds the checksum of all bytes before it.

class Checkpoint_sum_2
{
public:
  void add(std::string_view text) { m_sum.process_bytes(text.data(), text.size()); }

  // As eight hexadecimal digits.
  std::string text() const
  {
    std::string digits(8, '0');
    for (std::uint32_t i = 0; i < 8; ++i)
      digits[i] = "0123456789abcdef"[m_sum.checksum() >> (28 - 4 * i) & 15];
    return digits;
  }

private:
  boost::crc_32_type m_sum;
};

// Whether the whole word is one number.
template <class Number>
bool read_whole(std::string_view word, Number& number)
{
  const char* const beyond = word.data() + word.size();
  const std::from_chars_result result = read_number(word.data(), beyond, number);
  return result.ec == std::errc() && result.ptr == beyond;
}

inline bool read_finite(std::string_view word, double& number)
{
  return read_whole(word, number) && std::isfinite(number);
}

// An exception in the middle of an update can leave a state that the next update repairs. It must
// not be written, because no reader could tell it from nonsense.
[[noreturn]] inline void refuse_incomplete_triangulation()
{
  throw Checkpoint_error_2(0, "an exception has ended the last call before each point had its "
                              "vertex: write after the next update()");
}

inline std::string checkpoint_title(std::string_view subject)
{
  return std::string(subject) + " checkpoint 1";
}

class Checkpoint_output_2
{
public:
  Checkpoint_output_2(std::ostream& out, std::string_view subject)
    : m_out(out)
  {
    line(checkpoint_title(subject));
  }

  // Writes words and numbers as one line.
  template <class... Fields>
  void line(const Fields&... fields)
  {
    m_text.clear();
    (append(fields), ...);
    m_text.back() = '\n';
    m_sum.add(m_text);
    write();
  }

  void finish()
  {
    m_text = "checksum " + m_sum.text() + '\n';
    write();
    m_out.flush();
    check();
  }

private:
  template <class Field>
  void append(const Field& field)
  {
    if constexpr (std::is_arithmetic_v<Field>)
      append_number(m_text, field);
    else
      m_text += field;
    m_text += ' ';
  }

  void write()
  {
    ++m_line;
    m_out.write(m_text.data(), std::streamsize(m_text.size()));
    check();
  }

  void check() const
  {
    if (!m_out)
      throw Checkpoint_error_2(m_line, "the stream takes no more: what it has is not complete");
  }

  std::ostream& m_out;
  Checkpoint_sum_2 m_sum;
  std::string m_text;
  std::size_t m_line = 0;
};

class Checkpoint_input_2
{
public:
  Checkpoint_input_2(std::istream& in, std::string_view subject)
    : m_in(in)
  {
    const std::string title = checkpoint_title(subject);
    next_line();
    if (m_text != title)
      refuse("it is " + quoted(m_text) + ", and has to be " + quoted(title));
    m_rest = {};
  }

  std::size_t line() const { return m_line; }

  void next_line()
  {
    if (m_line > 0)
      m_sum.add(m_text += '\n');
    ++m_line;
    std::getline(m_in, m_text);
    if (m_in.bad())
      refuse("the stream cannot be read");
    if (!m_in || m_in.eof())
      refuse("the file ends here, and is not complete");
    m_rest = m_text;
    m_is_at_end = false;
  }

  // Reads the next word of the line. `what` names it in error messages.
  std::string_view word(const char* what)
  {
    if (m_is_at_end)
      refuse(std::string(what) + " is missing");
    const std::size_t end = m_rest.find(' ');
    const std::string_view word = m_rest.substr(0, end);
    m_is_at_end = end == std::string_view::npos;
    m_rest.remove_prefix(m_is_at_end ? m_rest.size() : end + 1);
    return word;
  }

  template <class Integer>
  Integer number(const char* what, Integer lowest, Integer highest)
  {
    const std::string_view text = word(what);
    Integer number;
    if (!read_whole(text, number) || number < lowest || number > highest)
      refuse(std::string(what) + " is " + quoted(text) + ", and has to be a number from " +
             std::to_string(lowest) + " to " + std::to_string(highest));
    return number;
  }

  double finite(const char* what)
  {
    const std::string_view text = word(what);
    double number;
    if (!read_finite(text, number))
      refuse(std::string(what) + " is " + quoted(text) + ", and has to be a finite number");
    return number;
  }

  void end_line() const
  {
    if (!m_is_at_end)
      refuse(quoted(m_rest) + " is too much in this line");
  }

  // Reads the first word of a line, which has to be this one.
  void begin_entry(const char* name)
  {
    next_line();
    const std::string_view found = word(name);
    if (found != name)
      refuse("it begins with " + quoted(found) + ", and has to begin with " + quoted(name));
  }

  // Reads a line of this word and one more, and returns the second one.
  std::string_view entry(const char* name)
  {
    begin_entry(name);
    const std::string_view value = word(name);
    end_line();
    return value;
  }

  // The same, but the second word is a number in this range.
  template <class Integer>
  Integer number_entry(const char* name, Integer lowest, Integer highest)
  {
    begin_entry(name);
    const Integer value = number(name, lowest, highest);
    end_line();
    return value;
  }

  // The same, but the second word is one of these two. Returns whether it is the first of them.
  bool flag_entry(const char* name, std::string_view yes, std::string_view no)
  {
    const std::string_view value = entry(name);
    if (value != yes && value != no)
      refuse(std::string(name) + " is " + quoted(value) + ", and has to be " + std::string(yes) +
             " or " + std::string(no));
    return value == yes;
  }

  void finish()
  {
    const std::string_view given = entry("checksum");
    if (given != m_sum.text())
      refuse("the checksum is " + quoted(given) + ", and that of the lines above is " +
             quoted(m_sum.text()) + ": the file was changed or damaged");
  }

  [[noreturn]] void refuse(const std::string& what) const { refuse(m_line, what); }
  [[noreturn]] static void refuse(std::size_t line, const std::string& what)
  {
    throw Checkpoint_error_2(line, what);
  }

  // Makes any text fit for a terminal: shortened, and without control characters.
  static std::string quoted(std::string_view text)
  {
    constexpr std::size_t longest = 60;
    std::string result = "\"";
    for (const char c : text.substr(0, longest))
      result += c >= ' ' && c <= '~' ? c : '?';
    return result + (text.size() > longest ? "...\"" : "\"");
  }

private:
  std::istream& m_in;
  Checkpoint_sum_2 m_sum; // of the lines before the current one
  std::string m_text;
  std::string_view m_rest; // of the current line, as is m_is_at_end
  bool m_is_at_end = true;
  std::size_t m_line = 0;
};

template <class FT>
const FT& exact_value(const FT& x)
{
  return x;
}
template <class ET>
const ET& exact_value(const Lazy_exact_nt<ET>& x)
{
  return x.exact();
}

// Writes a coordinate as a fraction of integers, so that exactly the same number is read back.
template <class FT>
class Checkpoint_coordinate_2
{
  using Exact = std::decay_t<decltype(exact_value(std::declval<const FT&>()))>;
  using Fraction = Fraction_traits<Exact>;
  using Numerator = typename Fraction::Numerator_type;
  using Denominator = typename Fraction::Denominator_type;
  template <class Integer>
  static constexpr bool is_integer =
      std::is_convertible_v<typename Algebraic_structure_traits<Integer>::Algebraic_category,
                            Euclidean_ring_tag>;
  static_assert(Fraction::Is_fraction::value && is_integer<Numerator> && is_integer<Denominator>,
                "a checkpoint needs coordinates that can be written exactly: doubles, or fractions "
                "of integers as in Exact_predicates_exact_constructions_kernel");

public:
  static constexpr const char* kind = "rational";
  static constexpr const char* meaning = "a fraction of integers";

  static std::string text(const FT& x)
  {
    Numerator numerator;
    Denominator denominator;
    typename Fraction::Decompose()(exact_value(x), numerator, denominator);
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << numerator;
    if (denominator != 1)
      out << '/' << denominator;
    return out.str();
  }

  // False if the text is not a number.
  static bool read(std::string_view text, FT& x)
  {
    const std::size_t bar = text.find('/');
    const std::string_view above = text.substr(0, bar);
    const std::string_view below = bar == text.npos ? "1" : text.substr(bar + 1);
    const bool is_negative = !above.empty() && above.front() == '-';
    if (!is_natural(above.substr(is_negative)) || !is_natural(below) || below == "0")
      return false;
    x = FT(typename Fraction::Compose()(integer<Numerator>(above), integer<Denominator>(below)));
    return true;
  }

private:
  // Rejects leading zeros, which would make some number types read octal digits.
  static bool is_natural(std::string_view text)
  {
    return !text.empty() && (text.front() != '0' || text == "0") &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  }

  template <class Integer>
  static Integer integer(std::string_view digits)
  {
    std::istringstream in{std::string(digits)};
    in.imbue(std::locale::classic());
    Integer result;
    in >> result;
    return result;
  }
};

template <>
class Checkpoint_coordinate_2<double>
{
public:
  static constexpr const char* kind = "double";
  static constexpr const char* meaning = "a finite number";

  static double text(double x) { return x; }
  static bool read(std::string_view text, double& x) { return read_finite(text, x); }
};

// Half-edges and faces are named by their numbers in the arrays.
struct Checkpoint_edge_2
{
  Index forward;  // the half-edge from the edge's source to its target
  Index halfedge; // the half-edge that the arrays stores: `forward` or its twin
};
struct Checkpoint_corner_2
{
  Index halfedge; // the corner that the arrays stores
  Index face;     // the face that CGAL's vertex stores
};

// What a checkpoint keeps of a maintained triangulation: everything that can influence the next
// update, except for the state of classifiers, repairs and policies.
template <class Point>
struct Checkpoint_arrays_2
{
  bool positions_are_exact = true;
  std::vector<Point> points;         // of all finite vertices
  std::vector<Position_2> positions; // the same, as doubles
  Point_ids_2<Point> ids;

  // Empty if the points do not span the plane: then every frame is triangulated from scratch.
  Flat_faces_2 faces;
  std::vector<Checkpoint_corner_2> corners; // of all vertices
  std::vector<Checkpoint_edge_2> edges;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_FILE_2_H
