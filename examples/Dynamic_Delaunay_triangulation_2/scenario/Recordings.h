// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RECORDINGS_H
#define SCENARIO_RECORDINGS_H

#include "Motion_file.h"
#include "Open_motion.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace scenario {

// Where recorded motion is, which is no part of the package: in the directory that the environment
// names, or else next to the package.
inline std::string recordings_directory()
{
  const char* const variable = std::getenv("SHARED_DATA_DIR");
  return variable != nullptr ? variable : SHARED_DATA_DIR;
}

inline std::string no_recordings_message()
{
  return "no recordings in " + recordings_directory() +
         "; set SHARED_DATA_DIR to the directory that holds them";
}

// Whether they have to be there: the environment names a directory, or the usual one exists.
inline bool recordings_are_expected()
{
  return std::getenv("SHARED_DATA_DIR") != nullptr ||
         std::filesystem::is_directory(recordings_directory());
}

// A .txt beside recordings more often tells of them.
inline bool is_recording(const std::filesystem::path& file)
{
  const auto format = motion_format(file);
  return format && *format != Motion_format::scenario && without_gz(file).extension() != ".txt";
}

// The paths of all recordings in a directory, in the order of their names; none if there is none.
inline std::vector<std::string> recordings_in(const std::string& directory)
{
  std::vector<std::string> paths;
  std::error_code ignored;
  for (const auto& file : std::filesystem::directory_iterator(directory, ignored)) {
    if (is_recording(file.path())) {
      paths.push_back(file.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

inline std::vector<std::string> recordings()
{
  return recordings_in(recordings_directory());
}

} // namespace scenario

#endif // SCENARIO_RECORDINGS_H
