// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_POLICY_CHOICE_H
#define RUN_POLICY_CHOICE_H

#include "Number_argument.h"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace run {

struct Policy_choice
{
  std::string name;
  std::optional<unsigned> parameter{}; // of key_frames

  std::string text() const { return parameter ? name + ':' + std::to_string(*parameter) : name; }
};

inline constexpr unsigned usual_key_frame_distance = 10;
inline constexpr unsigned max_key_frame_distance = 1'000'000;

inline std::string policy_list()
{
  return "always_dynamic, always_static, hybrid, key_frames:K (K from 1 to " +
         std::to_string(max_key_frame_distance) + ", default " +
         std::to_string(usual_key_frame_distance) + ')';
}

inline unsigned key_frame_distance(const std::string& text)
{
  try {
    return static_cast<unsigned>(count_argument(text, 1, max_key_frame_distance));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("the parameter of key_frames: ") + error.what());
  }
}

// From NAME or NAME:PARAMETER.
inline Policy_choice policy_choice(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const auto parameter =
      colon == std::string::npos ? std::nullopt : std::optional(text.substr(colon + 1));
  if (name == "key_frames") {
    return {name, parameter ? key_frame_distance(*parameter) : usual_key_frame_distance};
  }
  if (name != "always_dynamic" && name != "always_static" && name != "hybrid") {
    throw std::invalid_argument("there is no policy '" + name + "'; there are " + policy_list());
  }
  if (parameter) {
    throw std::invalid_argument(name + " takes no parameter; there are " + policy_list());
  }
  return {name};
}

} // namespace run

#endif // RUN_POLICY_CHOICE_H
