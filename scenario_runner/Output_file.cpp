// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Output_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <locale>
#include <stdexcept>
#include <system_error>

namespace run {

namespace {

// The reason of a failure, if the system has given one since the last check.
std::string reason()
{
  return errno != 0 ? std::string(": ") + std::strerror(errno) : "";
}

bool is_special(const std::string& path)
{
  std::error_code ignored;
  return std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
}

} // namespace

Output_file::Output_file(const std::string& path)
  : m_path(path)
  , m_written_path(is_special(path) ? path : path + ".part")
{
  m_stream.imbue(std::locale::classic()); // numbers are for programs
  errno = 0;
  m_stream.open(m_written_path, std::ios::binary | std::ios::trunc);
  if (!m_stream) {
    throw std::runtime_error(m_path + ": cannot be written: " + std::strerror(errno));
  }
}

Output_file::~Output_file()
{
  if (!m_is_finished && m_written_path != m_path) {
    m_stream.close();
    std::error_code ignored;
    std::filesystem::remove(m_written_path, ignored);
  }
}

void Output_file::check()
{
  if (!m_stream) {
    throw std::runtime_error(m_path + ": cannot be written to its end" + reason());
  }
  errno = 0;
}

void Output_file::finish()
{
  check();
  m_stream.close();
  check();
  std::error_code error;
  if (m_written_path != m_path) {
    std::filesystem::rename(m_written_path, m_path, error);
  }
  if (error) {
    throw std::runtime_error(m_path + ": cannot be written: " + error.message());
  }
  m_is_finished = true;
}

Output_directory::Output_directory(const std::string& path)
  : m_path(path)
{
  std::error_code error;
  std::filesystem::create_directories(m_path, error);
  if (!std::filesystem::is_directory(m_path)) {
    throw std::runtime_error(path + ": cannot be made a directory" +
                             (error ? ": " + error.message() : ""));
  }
}

std::string id_table_of(const std::string& path)
{
  return path + ".ids.csv";
}

std::string frame_file_name(std::int64_t number, const std::string& ending)
{
  const std::string sign = number < 0 ? "-" : "";
  const std::string digits = std::to_string(number).substr(sign.size());
  const std::size_t zeros = 5 - (std::min<std::size_t>)(5, digits.size());
  return "frame_" + sign + std::string(zeros, '0') + digits + ending;
}

} // namespace run
