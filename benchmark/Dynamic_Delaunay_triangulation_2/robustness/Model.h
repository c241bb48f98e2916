// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_MODEL_H
#define ROBUSTNESS_MODEL_H

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace robustness {

// The name of a point: its id, or what the user of a population calls it.
using Key = std::int64_t;
using Keys = std::vector<Key>;

// Kernels make their points of these.
struct Place
{
  double x, y;
};
using Places = std::vector<Place>;

// Who has to be where.
using Model = std::map<Key, Place>;

inline Keys keys_of(const Model& model)
{
  Keys keys;
  keys.reserve(model.size());
  for (const auto& [key, place] : model) {
    keys.push_back(key);
  }
  return keys;
}

inline Places places_of(const Model& model)
{
  Places places;
  places.reserve(model.size());
  for (const auto& [key, place] : model) {
    places.push_back(place);
  }
  return places;
}

} // namespace robustness

#endif // ROBUSTNESS_MODEL_H
