// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_TOLD_SUBJECT_H
#define ROBUSTNESS_TOLD_SUBJECT_H

#include "Model.h"
#include "Subject.h"

#include <cstddef>
#include <limits>
#include <ostream>

namespace robustness {

// Says what is done to another one before it is done, all numbers to the last digit.
class Told_subject : public Subject
{
public:
  Told_subject(Subject& subject, std::ostream& out)
    : m_subject(subject)
    , m_out(out)
  {
    m_out.precision(std::numeric_limits<double>::max_digits10);
  }

  Key_range names() const override { return m_subject.names(); }

  void start(const Model& points) override
  {
    tell("start", points);
    m_subject.start(points);
  }
  Report insert(Keys& keys, const Places& places) override
  {
    m_out << "insert";
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i < keys.size()) {
        m_out << ' ' << keys[i];
      }
      tell(places[i]);
    }
    m_out << std::endl;
    return m_subject.insert(keys, places);
  }
  Key insert(const Place& place) override
  {
    m_out << "insert";
    tell(place);
    m_out << std::endl;
    return m_subject.insert(place);
  }
  Report remove(const Keys& keys) override
  {
    m_out << "remove";
    for (const Key key : keys) {
      m_out << ' ' << key;
    }
    m_out << std::endl;
    return m_subject.remove(keys);
  }
  Report move(const Moves& moves) override
  {
    tell("move", moves);
    return m_subject.move(moves);
  }
  Report update(const Model& next) override
  {
    tell("update", next);
    return m_subject.update(next);
  }
  Report mend() override
  {
    m_out << "mend" << std::endl;
    return m_subject.mend();
  }
  bool certify() override
  {
    m_out << "certify" << std::endl;
    return m_subject.certify();
  }
  void hand_over() override
  {
    m_out << "hand_over" << std::endl;
    m_subject.hand_over();
  }
  bool refuses(Misuse misuse, const Model& points) override
  {
    m_out << "misuse " << static_cast<int>(misuse) << std::endl;
    return m_subject.refuses(misuse, points);
  }

  bool is_exact() const override { return m_subject.is_exact(); }
  bool is_certified() const override { return m_subject.is_certified(); }
  std::size_t number_of_neighbors(Key key) const override
  {
    return m_subject.number_of_neighbors(key);
  }
  bool is_at_hull(Key key) const override { return m_subject.is_at_hull(key); }
  void check(const Model& points) override { m_subject.check(points); }

private:
  void tell(const Place& place) { m_out << " (" << place.x << ", " << place.y << ')'; }

  template <class Points>
  void tell(const char* what, const Points& points)
  {
    m_out << what;
    for (const auto& [key, place] : points) {
      m_out << ' ' << key;
      tell(place);
    }
    m_out << std::endl;
  }

  Subject& m_subject;
  std::ostream& m_out;
};

} // namespace robustness

#endif // ROBUSTNESS_TOLD_SUBJECT_H
