// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_MOTION_FILE_H
#define SCENARIO_MOTION_FILE_H

#include <cctype>
#include <filesystem>
#include <optional>
#include <string>

namespace scenario {

enum class Motion_format { scenario, csv, lammps_dump };

inline const std::string motion_extensions = ".json, .csv, .tsv, .txt, .lammpstrj or .dump";

// The path that stands for standard input, which is CSV.
inline bool is_standard_input(const std::string& path)
{
  return path == "-";
}

inline std::string lower_case(std::string text)
{
  for (char& c : text) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

inline std::filesystem::path without_gz(const std::filesystem::path& file)
{
  return lower_case(file.extension().string()) == ".gz" ? file.parent_path() / file.stem() : file;
}

// What a file has to hold, by its name alone; nothing if the name does not say it.
inline std::optional<Motion_format> motion_format(const std::filesystem::path& file)
{
  const std::string extension = lower_case(without_gz(file).extension().string());
  if (extension == ".json") {
    return Motion_format::scenario;
  }
  if (extension == ".csv" || extension == ".tsv" || extension == ".txt") {
    return Motion_format::csv;
  }
  if (extension == ".lammpstrj" || extension == ".dump") {
    return Motion_format::lammps_dump;
  }
  return std::nullopt;
}

// What a recording is called after its file.
inline std::string recording_name(const std::string& path)
{
  return is_standard_input(path) ? "standard_input" : without_gz(path).stem().string();
}

} // namespace scenario

#endif // SCENARIO_MOTION_FILE_H
