// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_GZIP_H
#define SCENARIO_GZIP_H

#include "Scenario_error.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#ifdef SCENARIO_HAS_ZLIB
#define ZLIB_CONST // input is not written
#include <zlib.h>
#endif

namespace scenario {

inline bool is_gzip(std::string_view bytes)
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

  // In the line of the text up to which it could be unzipped.
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

inline std::string unzipped(const std::string& file, std::string_view zipped)
{
  return Gzip_reader(file, zipped).text();
}

#else

inline std::string unzipped(const std::string& file, std::string_view)
{
  throw Scenario_error(file, "is compressed by gzip, and this program was built without zlib: "
                             "unzip it first (gzip -d)");
}

#endif

} // namespace scenario

#endif // SCENARIO_GZIP_H
