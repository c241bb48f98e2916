// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_SUBJECT_H
#define ROBUSTNESS_SUBJECT_H

#include "Model.h"

#include <CGAL/Update_report_2.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace robustness {

// Names that a user may give.
struct Key_range
{
  Key lowest = 0, highest = -1;

  bool is_empty() const { return highest < lowest; }
};

using Moves = std::vector<std::pair<Key, Place>>;

// Ways to call a triangulation that it has to refuse.
enum class Misuse { NAN_COORDINATE, INFINITE_COORDINATE, WRONG_COUNT, UNKNOWN_ID, REPEATED_ID };

// The triangulation of a trial, whatever its kernel and classifier are, by itself or in a
// population.
class Subject
{
public:
  using Report = CGAL::Update_report_2;

  Subject() = default;
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;
  virtual ~Subject() = default;

  // Empty where it names the points itself.
  virtual Key_range names() const = 0;

  // Puts a fresh triangulation of these points in place of the old one.
  virtual void start(const Model& points) = 0;
  virtual Report insert(Keys& keys, const Places& places) = 0;
  virtual Key insert(const Place& place) = 0;
  virtual Report remove(const Keys& keys) = 0;
  virtual Report move(const Moves& moves) = 0;
  // To a model with the same points, or with any, where the user names them.
  virtual Report update(const Model& next) = 0;
  virtual Report mend() = 0;
  virtual bool certify() = 0;
  // To another object.
  virtual void hand_over() = 0;
  // Whether it was refused; it has to be.
  virtual bool refuses(Misuse misuse, const Model& points) = 0;

  virtual bool is_exact() const = 0;
  virtual bool is_certified() const = 0;
  // Of the point's vertex, the infinite one among them; 0 if there are no faces.
  virtual std::size_t number_of_neighbors(Key key) const = 0;
  virtual bool is_at_hull(Key key) const = 0;

  // Throws a Finding unless everything is as it has to be.
  virtual void check(const Model& points) = 0;
};

} // namespace robustness

#endif // ROBUSTNESS_SUBJECT_H
