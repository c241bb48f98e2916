// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Text_input.h"

#include "scenario_runner/Number_text.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Decimal_number.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <system_error>
#include <utility>

#ifdef SCENARIO_HAS_ZLIB
#define ZLIB_CONST // input is not written
#include <zlib.h>
#endif

namespace scenario {

namespace {

// Messages quote foreign data, which must neither break the line nor steer a terminal.
std::string printable(const std::string& message)
{
  constexpr char digits[] = "0123456789ABCDEF";
  std::string text;
  for (const char c : message) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7F) {
      text += c;
    } else {
      text += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
    }
  }
  return text;
}

std::string with_place(const std::string& file, const std::string& message, std::size_t line,
                       std::size_t column)
{
  std::string place = file;
  if (line != 0) {
    place += ", line " + std::to_string(line);
  }
  if (column != 0) {
    place += ", column " + std::to_string(column);
  }
  return place + ": " + printable(message);
}

bool is_gzip(std::string_view bytes)
{
  constexpr std::string_view magic = "\x1F\x8B";
  return bytes.substr(0, magic.size()) == magic;
}

#ifdef SCENARIO_HAS_ZLIB

// Unzips a gzip file that is in memory; it may have several members, one after the other.
class Gzip_reader
{
public:
  Gzip_reader(std::string file, std::string_view zipped)
    : m_file(std::move(file))
    , m_rest(zipped)
  {
    constexpr int gzip_alone = 16;
    if (inflateInit2(&m_stream, MAX_WBITS + gzip_alone) != Z_OK) {
      throw Scenario_error(m_file, "cannot be unzipped: zlib does not start");
    }
  }
  Gzip_reader(const Gzip_reader&) = delete;
  Gzip_reader& operator=(const Gzip_reader&) = delete;
  ~Gzip_reader() { inflateEnd(&m_stream); }

  std::string text()
  {
    do {
      inflateReset(&m_stream);
      read_member();
    } while (is_gzip(m_rest));
    if (m_rest.find_first_not_of('\0') != std::string_view::npos) {
      fail("something else follows the end of the gzip stream");
    }
    return std::move(m_text);
  }

private:
  void read_member()
  {
    char buffer[1 << 16];
    for (int state = Z_OK; state != Z_STREAM_END;) {
      const auto given = static_cast<uInt>(
          (std::min<std::size_t>)(m_rest.size(), (std::numeric_limits<uInt>::max)()));
      m_stream.next_in = reinterpret_cast<const Bytef*>(m_rest.data());
      m_stream.avail_in = given;
      m_stream.next_out = reinterpret_cast<Bytef*>(buffer);
      m_stream.avail_out = sizeof buffer;
      state = inflate(&m_stream, Z_NO_FLUSH);
      m_rest.remove_prefix(given - m_stream.avail_in);
      m_text.append(buffer, sizeof buffer - m_stream.avail_out);
      check(state);
    }
  }

  void check(int state) const
  {
    if (state == Z_BUF_ERROR && m_rest.empty()) {
      fail("the gzip stream ends too early");
    }
    if (state != Z_OK && state != Z_STREAM_END) {
      fail(std::string("the gzip stream is damaged") +
           (m_stream.msg != nullptr ? std::string(": ") + m_stream.msg : ""));
    }
  }

  // Throws an error in the line of the text up to which it could be unzipped.
  [[noreturn]] void fail(const std::string& message) const
  {
    const auto ends = std::count(m_text.begin(), m_text.end(), '\n');
    throw Scenario_error(m_file, message, static_cast<std::size_t>(ends) + 1);
  }

  std::string m_file;
  std::string_view m_rest;
  std::string m_text;
  z_stream m_stream{};
};

std::string unzipped(const std::string& file, std::string_view zipped)
{
  return Gzip_reader(file, zipped).text();
}

#else

std::string unzipped(const std::string& file, std::string_view)
{
  throw Scenario_error(file, "is compressed by gzip, and this program was built without zlib: "
                             "unzip it first (gzip -d)");
}

#endif

// `size` is what the stream is expected to have, and 0 if that is not known.
std::string read_text(std::istream& stream, const std::string& file, std::uintmax_t size)
{
  std::string text;
  text.reserve(static_cast<std::size_t>(size));
  char buffer[1 << 16];
  while (stream.read(buffer, sizeof buffer), stream.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) {
    throw Scenario_error(file, "cannot be read to its end");
  }
  return is_gzip(text) ? unzipped(file, text) : text;
}

template <class Number>
std::errc read_number(std::string_view text, Number& value)
{
  const char* const end = text.data() + text.size();
  const auto result =
      CGAL::Dynamic_Delaunay_triangulations_2::internal::read_number(text.data(), end, value);
  return result.ptr == end ? result.ec : std::errc::invalid_argument;
}

} // namespace

Scenario_error::Scenario_error(const std::string& file, const std::string& message,
                               std::size_t line, std::size_t column)
  : std::runtime_error(with_place(file, message, line, column))
  , m_file(file)
  , m_line(line)
  , m_column(column)
{
}

std::string Range::text() const
{
  constexpr int digits = 6;
  return (low_is_allowed ? "from " : "above ") + run::number_text(low, digits) + " to " +
         run::number_text(high, digits);
}

// Reads a file. If it is compressed by gzip, whatever its name, it is unzipped.
std::string read_text_file(const std::string& path)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw Scenario_error(path, "is a directory, not a file");
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw Scenario_error(path, std::string("cannot be opened: ") + std::strerror(errno));
  }
  std::error_code no_size;
  const std::uintmax_t size = std::filesystem::file_size(path, no_size);
  return read_text(stream, path, no_size ? 0 : size);
}

std::string read_standard_input(const std::string& name)
{
  return read_text(std::cin, name, 0);
}

std::string_view without_byte_order_mark(const std::string& file, std::string_view text)
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  const std::string_view start = text.substr(0, 2);
  if (start == "\xFF\xFE" || start == "\xFE\xFF") {
    throw Scenario_error(file, "is UTF-16 text, expected UTF-8", 1);
  }
  return text.substr(text.substr(0, mark.size()) == mark ? mark.size() : 0);
}

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::string lower_case(std::string text)
{
  for (char& c : text) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

bool is_one_of(char c, std::string_view characters)
{
  return characters.find(c) != std::string_view::npos;
}

bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

std::string_view trimmed(std::string_view text)
{
  while (!text.empty() && is_blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields)
{
  constexpr std::string_view blanks = " \t\r";
  fields.clear();
  std::size_t begin = 0;
  while ((begin = line.find_first_not_of(blanks)) != std::string_view::npos) {
    line.remove_prefix(begin);
    const std::size_t end = line.find_first_of(blanks);
    fields.push_back(line.substr(0, end));
    line.remove_prefix(end == std::string_view::npos ? line.size() : end);
  }
}

void split_at(char separator, std::string_view line, std::vector<std::string_view>& fields)
{
  fields.clear();
  std::size_t end = 0;
  while ((end = line.find(separator)) != std::string_view::npos) {
    fields.push_back(line.substr(0, end));
    line.remove_prefix(end + 1);
  }
  fields.push_back(line);
}

std::string in_quotes(std::string_view text)
{
  constexpr std::size_t longest = 40;
  std::string quoted(1, '\'');
  quoted += text.substr(0, longest);
  quoted += text.size() > longest ? "...'" : "'";
  return quoted;
}

bool is_number(std::string_view text, double& value)
{
  return read_number(text, value) == std::errc();
}

bool is_number(std::string_view text, std::uint64_t& value)
{
  return read_number(text, value) == std::errc();
}

Text_scanner::Text_scanner(std::string file, std::string_view text)
  : m_file(std::move(file))
  , m_rest(without_byte_order_mark(m_file, text))
{
}

bool Text_scanner::next_line(std::string_view& line)
{
  const bool is_there = next_whole_line(line);
  line = trimmed(line);
  return is_there;
}

bool Text_scanner::next_whole_line(std::string_view& line)
{
  while (next_line_as_it_is(line)) {
    if (!std::all_of(line.begin(), line.end(), is_blank)) {
      return true;
    }
  }
  return false;
}

bool Text_scanner::next_line_as_it_is(std::string_view& line)
{
  if (m_rest.empty()) {
    return false;
  }
  ++m_line_number;
  const std::size_t end = m_rest.find('\n');
  line = m_rest.substr(0, end);
  m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
  return true;
}

template <class Number>
bool Text_scanner::is_parsed(std::string_view text, std::string_view what, Number& value) const
{
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const std::errc error = read_number(has_plus ? text.substr(1) : text, value);
  if (error == std::errc::result_out_of_range) {
    fail(std::string(what) + " " + in_quotes(text) + " is out of range");
  }
  return error == std::errc();
}

template <class Number>
Number Text_scanner::parsed(std::string_view text, std::string_view what, const char* wanted) const
{
  Number value{};
  if (!is_parsed(text, what, value)) {
    fail(std::string(what) + " " + in_quotes(text) + " is not " + wanted);
  }
  return value;
}

double Text_scanner::number(std::string_view text, std::string_view what) const
{
  return parsed<double>(text, what, "a number");
}

std::int64_t Text_scanner::integer(std::string_view text, std::string_view what) const
{
  return parsed<std::int64_t>(text, what, "an integer");
}

std::optional<std::int64_t> Text_scanner::whole_number(std::string_view text,
                                                       std::string_view what) const
{
  std::int64_t integer{};
  if (is_parsed(text, what, integer)) {
    return integer;
  }
  double value{};
  if (!is_parsed(text, what, value)) {
    return std::nullopt;
  }
  if (!(std::trunc(value) == value)) {
    fail(std::string(what) + " " + in_quotes(text) + " is not an integer");
  }
  constexpr double most = 9007199254740992.0; // beyond it not all integers are doubles
  if (std::abs(value) > most) {
    fail(std::string(what) + " " + in_quotes(text) + " is out of range");
  }
  return static_cast<std::int64_t>(value);
}

double Text_scanner::coordinate(std::string_view text, std::string_view name,
                                const std::string& id) const
{
  const double value = number(text, name);
  if (!std::isfinite(value)) {
    fail(std::string(name) + " of id " + id + " is " + in_quotes(text) + ", not a finite number");
  }
  return value;
}

void Text_scanner::fail(const std::string& message) const
{
  throw Scenario_error(m_file, message, m_line_number);
}

} // namespace scenario
