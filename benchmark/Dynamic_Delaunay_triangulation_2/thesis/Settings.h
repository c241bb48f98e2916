// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_SETTINGS_H
#define THESIS_SETTINGS_H

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace thesis {

// What a person asks for.
struct Settings
{
  bool is_quick = false;
  std::size_t trials = 0;          // 0: what the experiments say
  std::uint64_t seed = 1;          // of the first trial; the next one has the next seed
  std::vector<std::string> only{}; // experiments; empty: all
  std::filesystem::path output{};
  std::string command{};

  std::size_t number_of_trials(std::size_t usual) const { return trials == 0 ? usual : trials; }
};

} // namespace thesis

#endif // THESIS_SETTINGS_H
