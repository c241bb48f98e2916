// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_OUTPUT_FILE_H
#define SCENARIO_RUNNER_OUTPUT_FILE_H

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace run {

// A file that exists as a whole or not at all: it gets its name when it is finished. A device or a
// pipe is written directly.
class Output_file
{
public:
  explicit Output_file(const std::string& path);
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;
  ~Output_file();

  std::ostream& stream() { return m_stream; }

  // To be called after each frame: throws when the disk is full, not only after the last frame.
  void check();

  void finish();

private:
  std::string m_path;
  std::string m_written_path;
  std::ofstream m_stream;
  bool m_is_finished = false;
};

// A directory of files, some of them one for a frame. It is made if it is not there.
class Output_directory
{
public:
  explicit Output_directory(const std::string& path);

  std::string path_of(const std::string& name) const { return (m_path / name).string(); }

private:
  std::filesystem::path m_path;
};

// The table that has the names of points whose ids are numbers in the file `path`.
std::string id_table_of(const std::string& path);

// `number`: of the frame. `ending` begins with a dot.
std::string frame_file_name(std::int64_t number, const std::string& ending);

} // namespace run

#endif // SCENARIO_RUNNER_OUTPUT_FILE_H
