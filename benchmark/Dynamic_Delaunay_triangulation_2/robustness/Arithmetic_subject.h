// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_ARITHMETIC_SUBJECT_H
#define ROBUSTNESS_ARITHMETIC_SUBJECT_H

#include "Arithmetic.h"
#include "Finding.h"
#include "Model.h"
#include "Subject.h"

#include <cstddef>
#include <type_traits>

namespace robustness {

// Does everything to another one in the caller's arithmetic, which has to be given back. Looking at
// it is done in the usual one.
class Arithmetic_subject : public Subject
{
public:
  Arithmetic_subject(Subject& subject, const Arithmetic& arithmetic)
    : m_subject(subject)
    , m_arithmetic(arithmetic)
  {
  }

  Key_range names() const override { return m_subject.names(); }

  void start(const Model& points) override
  {
    compute([&] {
      m_subject.start(points);
      return true;
    });
  }
  Report insert(Keys& keys, const Places& places) override
  {
    return compute([&] { return m_subject.insert(keys, places); });
  }
  Key insert(const Place& place) override
  {
    return compute([&] { return m_subject.insert(place); });
  }
  Report remove(const Keys& keys) override
  {
    return compute([&] { return m_subject.remove(keys); });
  }
  Report move(const Moves& moves) override
  {
    return compute([&] { return m_subject.move(moves); });
  }
  Report update(const Model& next) override
  {
    return compute([&] { return m_subject.update(next); });
  }
  Report mend() override
  {
    return compute([&] { return m_subject.mend(); });
  }
  bool certify() override
  {
    return compute([&] { return m_subject.certify(); });
  }
  void hand_over() override
  {
    compute([&] {
      m_subject.hand_over();
      return true;
    });
  }
  bool refuses(Misuse misuse, const Model& points) override
  {
    return compute([&] { return m_subject.refuses(misuse, points); });
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
  template <class Call>
  std::invoke_result_t<Call> compute(const Call& call)
  {
    const Arithmetic_in_use in_use(m_arithmetic);
    const std::invoke_result_t<Call> result = call();
    require(in_use.is_kept(), Fault::WRONG, "the caller's arithmetic was not given back");
    return result;
  }

  Subject& m_subject;
  const Arithmetic& m_arithmetic;
};

} // namespace robustness

#endif // ROBUSTNESS_ARITHMETIC_SUBJECT_H
