// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_SCENARIO_ERROR_H
#define SCENARIO_SCENARIO_ERROR_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace scenario {

// What is wrong with a scenario or a recording, and where. Lines and columns count from 1; 0 stands
// for "not known".
class Scenario_error : public std::runtime_error
{
public:
  Scenario_error(std::string file, const std::string& message, std::size_t line = 0,
                 std::size_t column = 0)
    : std::runtime_error(with_place(file, message, line, column))
    , m_file(std::move(file))
    , m_line(line)
    , m_column(column)
  {
  }

  const std::string& file() const { return m_file; }
  std::size_t line() const { return m_line; }
  std::size_t column() const { return m_column; }

private:
  static std::string with_place(const std::string& file, const std::string& message,
                                std::size_t line, std::size_t column)
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

  // Messages quote foreign data, which must neither break the line nor steer a terminal.
  static std::string printable(const std::string& message)
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

  std::string m_file;
  std::size_t m_line;
  std::size_t m_column;
};

} // namespace scenario

#endif // SCENARIO_SCENARIO_ERROR_H
