// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_TEXT_FILE_H
#define SCENARIO_TEXT_FILE_H

#include "Gzip.h"
#include "Scenario_error.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>

namespace scenario {

// `size` is what the stream is expected to have, and 0 if nobody knows.
inline std::string read_text(std::istream& stream, const std::string& file, std::uintmax_t size)
{
  std::string text;
  text.reserve(size);
  char buffer[1 << 16];
  while (stream.read(buffer, sizeof buffer), stream.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) {
    throw Scenario_error(file, "cannot be read to its end");
  }
  return is_gzip(text) ? unzipped(file, text) : text;
}

// What is compressed by gzip, whatever its name, is unzipped.
inline std::string read_text_file(const std::string& path)
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

inline std::string read_standard_input(const std::string& name)
{
  return read_text(std::cin, name, 0);
}

} // namespace scenario

#endif // SCENARIO_TEXT_FILE_H
