// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_OUTPUT_DIRECTORY_H
#define RUN_OUTPUT_DIRECTORY_H

#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace run {

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

#endif // RUN_OUTPUT_DIRECTORY_H
