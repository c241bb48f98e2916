// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace scenario {

namespace {

using Format = Recording_format;

std::string extension_of(const std::filesystem::path& file)
{
  return lower_case(file.extension().string());
}

// The first line that is not blank.
std::string_view first_line(std::string_view text)
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  text.remove_prefix(text.substr(0, mark.size()) == mark ? mark.size() : 0);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  text.remove_prefix((std::min)(begin, text.size()));
  return trimmed(text.substr(0, text.find('\n')));
}

// What begins as no other format does, and so needs no name.
std::optional<Format> format_by_content(std::string_view text)
{
  const std::string_view line = first_line(text);
  std::uint64_t number{};
  if (line.substr(0, 5) == "ITEM:") {
    return Format::LAMMPS_DUMP;
  }
  if (line.substr(0, 7) == "MTrackJ") {
    return Format::MTRACKJ;
  }
  if (line == "$VISION") {
    return Format::TABLE;
  }
  return is_number(line, number) ? std::optional(Format::XYZ) : std::nullopt;
}

// Without an extension, as from standard input, it is a table.
Format format_of(const std::string& file, std::string_view text)
{
  const auto by_content = format_by_content(text);
  const auto format = by_content ? by_content : format_by_name(file);
  const std::string extension = without_gz(file).extension().string();
  if (!format && !extension.empty()) {
    throw Scenario_error(file, "has the unknown extension " + in_quotes(extension) +
                                   ", and its first line does not tell what it is; allowed are " +
                                   recording_extensions + ", also followed by .gz");
  }
  return format.value_or(Format::TABLE);
}

} // namespace

std::filesystem::path without_gz(const std::filesystem::path& file)
{
  return extension_of(file) == ".gz" ? file.parent_path() / file.stem() : file;
}

std::optional<Recording_format> format_by_name(const std::string& path)
{
  constexpr std::array<std::pair<std::string_view, Format>, 9> extensions = {
      {{".csv", Format::TABLE},
       {".tsv", Format::TABLE},
       {".txt", Format::TABLE},
       {".pp", Format::TABLE},
       {".lammpstrj", Format::LAMMPS_DUMP},
       {".dump", Format::LAMMPS_DUMP},
       {".xyz", Format::XYZ},
       {".extxyz", Format::XYZ},
       {".mdf", Format::MTRACKJ}}};
  const std::string extension = extension_of(without_gz(path));
  for (const auto& [known, format] : extensions) {
    if (extension == known) {
      return format;
    }
  }
  return std::nullopt;
}

Recording parse_recording(const std::string& file, std::string_view text,
                          const Table_columns& columns)
{
  const Format format = format_of(file, text);
  if (format != Format::TABLE && !columns.empty()) {
    throw Scenario_error(file, "is no table, so its columns cannot be named");
  }
  switch (format) {
  case Format::LAMMPS_DUMP:
    return parse_lammps_dump(file, text);
  case Format::XYZ:
    return parse_xyz(file, text);
  case Format::MTRACKJ:
    return parse_mtrackj(file, text);
  default:
    return parse_csv(file, text, columns);
  }
}

} // namespace scenario
