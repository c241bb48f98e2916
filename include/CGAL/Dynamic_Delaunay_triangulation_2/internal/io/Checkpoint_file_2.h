// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_FILE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_FILE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Decimal_number.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <boost/crc.hpp>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ios>
#include <istream>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

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

// Reads a number. False unless the whole word is one.
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

  // Writes words, numbers, and tuples or arrays of them as one line.
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
    if constexpr (std::is_convertible_v<const Field&, std::string_view>)
      m_text += field;
    else if constexpr (std::is_arithmetic_v<Field>)
      append_number(m_text, field);
    else if constexpr (std::is_convertible_v<const Field&, Index>)
      append_number(m_text, Index(field));
    else
      return std::apply([&](const auto&... fields) { (append(fields), ...); }, field);
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
    Integer number{};
    if (!read_whole(text, number) || number < lowest || number > highest)
      refuse(what, text,
             "a number from " + std::to_string(lowest) + " to " + std::to_string(highest));
    return number;
  }

  double finite(const char* what)
  {
    const std::string_view text = word(what);
    double number;
    if (!read_finite(text, number))
      refuse(what, text, "a finite number");
    return number;
  }

  void end_line() const
  {
    if (!m_is_at_end)
      refuse(quoted(m_rest) + " is too much in this line");
  }

  // Starts a new line and reads its first word, which has to be `name`.
  void begin_entry(const char* name)
  {
    next_line();
    const std::string_view found = word(name);
    if (found != name)
      refuse("it begins with " + quoted(found) + ", and has to begin with " + quoted(name));
  }

  // Reads a line of two words, of which the first has to be `name`. Returns the second.
  std::string_view entry(const char* name)
  {
    begin_entry(name);
    const std::string_view value = word(name);
    end_line();
    return value;
  }

  // Reads a line of the word `name` and a number in this range. Returns the number.
  template <class Integer>
  Integer number_entry(const char* name, Integer lowest, Integer highest)
  {
    begin_entry(name);
    const Integer value = number(name, lowest, highest);
    end_line();
    return value;
  }

  // Reads a line of the word `name` and one of the words `yes` and `no`. True if that one is `yes`.
  bool flag_entry(const char* name, std::string_view yes, std::string_view no)
  {
    const std::string_view value = entry(name);
    if (value != yes && value != no)
      refuse(name, value, std::string(yes) + " or " + std::string(no));
    return value == yes;
  }

  void finish()
  {
    const std::string_view given = entry("checksum");
    if (given != m_sum.text())
      refuse("the checksum is " + quoted(given) + ", and that of the lines above is " +
             quoted(m_sum.text()) + ": the file was changed or damaged");
  }

  // Refuses a word. The message tells what the word means (`what`), and what it has to be (`due`).
  [[noreturn]] void refuse(const char* what, std::string_view word, const std::string& due) const
  {
    refuse(std::string(what) + " is " + quoted(word) + ", and has to be " + due);
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
  std::string_view m_rest; // the words of the line that were not read yet
  bool m_is_at_end = true;
  std::size_t m_line = 0;
};

// `operator<<` and `operator>>` for everything that has checkpoints. Users of streams test the
// stream's state, so these operators set `failbit` where write_checkpoint() and read_checkpoint()
// throw.

template <class Written>
std::ostream& write_to_stream(std::ostream& out, const Written& written)
{
  try {
    written.write_checkpoint(out);
  } catch (const Checkpoint_error_2&) {
    out.setstate(std::ios_base::failbit);
  }
  return out;
}

template <class Read>
std::istream& read_from_stream(std::istream& in, Read& target)
{
  const std::istream::sentry has_text(in); // skips white space, as every operator>> does
  if (!has_text)
    return in;
  try {
    target.read_checkpoint(in);
  } catch (const Checkpoint_error_2&) {
    in.setstate(std::ios_base::failbit);
  }
  return in;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_FILE_2_H
