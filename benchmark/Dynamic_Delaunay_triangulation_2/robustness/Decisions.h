// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_DECISIONS_H
#define ROBUSTNESS_DECISIONS_H

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace robustness {

// Whatever a trial has to choose, it asks here.
class Decisions
{
public:
  Decisions() = default;
  Decisions(const Decisions&) = delete;
  Decisions& operator=(const Decisions&) = delete;
  virtual ~Decisions() = default;

  // From 0 to end - 1; 0 if `end` is.
  virtual std::size_t below(std::size_t end) = 0;
  // From 0 to below 1.
  virtual double share() = 0;
  virtual bool has_more() const { return true; }

  bool one_in(std::size_t n) { return below(n) == 0; }

  // From `lowest` to `highest`.
  int whole(int lowest, int highest)
  {
    return lowest + static_cast<int>(below(static_cast<std::size_t>(highest - lowest) + 1));
  }

  double real(double lowest, double highest) { return lowest + (highest - lowest) * share(); }

  // Mostly small, seldom up to 2.
  double deviation()
  {
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) {
      sum += share();
    }
    return sum - 2.0;
  }

  template <class T>
  const T& any_of(const std::vector<T>& choices)
  {
    return choices[below(choices.size())];
  }
};

// The distributions of the standard library differ between its implementations.
class Random_decisions : public Decisions
{
public:
  explicit Random_decisions(std::uint64_t seed)
    : m_random(seed)
  {
  }

  std::size_t below(std::size_t end) override
  {
    return end == 0 ? 0 : static_cast<std::size_t>(m_random() % end);
  }
  double share() override { return static_cast<double>(m_random() >> 11) * 0x1p-53; }

private:
  std::mt19937_64 m_random;
};

} // namespace robustness

#endif // ROBUSTNESS_DECISIONS_H
