// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_OUTPUT_FILE_H
#define SCENARIO_RUNNER_OUTPUT_FILE_H

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace run {

// A file that is there as a whole or not at all: it gets its name when it is finished. A device or
// a pipe is written directly.
class Output_file
{
public:
  explicit Output_file(const std::string& path)
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
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  ~Output_file()
  {
    if (!m_is_finished && m_written_path != m_path) {
      m_stream.close();
      std::error_code ignored;
      std::filesystem::remove(m_written_path, ignored);
    }
  }

  std::ostream& stream() { return m_stream; }

  // After each frame: a full disk is told when it is full, not after the last frame.
  void check()
  {
    if (!m_stream) {
      throw std::runtime_error(m_path + ": cannot be written to its end" + reason());
    }
    errno = 0;
  }

  void finish()
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

private:
  // If the system has said it since the last check.
  static std::string reason() { return errno != 0 ? std::string(": ") + std::strerror(errno) : ""; }

  static bool is_special(const std::string& path)
  {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored) &&
           !std::filesystem::is_regular_file(path, ignored);
  }

  std::string m_path;
  std::string m_written_path;
  std::ofstream m_stream;
  bool m_is_finished = false;
};

// A directory of files, some of them one for a frame. It is made if it is not there.
class Output_directory
{
public:
  explicit Output_directory(const std::string& path)
    : m_path(path)
  {
    std::error_code error;
    std::filesystem::create_directories(m_path, error);
    if (!std::filesystem::is_directory(m_path)) {
      throw std::runtime_error(path + ": cannot be made a directory" +
                               (error ? ": " + error.message() : ""));
    }
  }

  std::string path_of(const std::string& name) const { return (m_path / name).string(); }

private:
  std::filesystem::path m_path;
};

// `ending` begins with a dot.
inline std::string frame_file_name(std::size_t frame, const std::string& ending)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "frame_" << std::setw(5) << std::setfill('0') << frame << ending;
  return text.str();
}

} // namespace run

#endif // SCENARIO_RUNNER_OUTPUT_FILE_H
