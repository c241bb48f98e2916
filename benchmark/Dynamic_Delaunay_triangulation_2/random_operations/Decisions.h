// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_DECISIONS_H
#define RANDOM_OPERATIONS_DECISIONS_H

#include "scenario_runner/Simulated_motion.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace random_operations {

// All choices are made by this class. The distributions of the standard library differ between its
// implementations; these do not.
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

  // A number around 0, mostly small: here at most 2; derived classes may use a normal distribution.
  virtual double deviation()
  {
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) {
      sum += share();
    }
    return sum - 2.0;
  }

  bool one_in(std::size_t n) { return below(n) == 0; }

  // From `lowest` to `highest`.
  int whole(int lowest, int highest)
  {
    return lowest + static_cast<int>(below(static_cast<std::size_t>(highest - lowest) + 1));
  }

  double real(double lowest, double highest) { return lowest + (highest - lowest) * share(); }

  template <class T>
  const T& any_of(const std::vector<T>& choices)
  {
    return choices[below(choices.size())];
  }
};

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

// Deviations are normally distributed, as those of the scenarios.
class Normal_decisions : public Decisions
{
public:
  explicit Normal_decisions(std::uint64_t seed)
    : m_random(seed)
  {
  }

  std::size_t below(std::size_t end) override
  {
    const auto number = static_cast<std::size_t>(share() * static_cast<double>(end));
    return end == 0 ? 0 : (std::min)(number, end - 1);
  }

  double share() override { return m_random.uniform(); }
  double deviation() override { return m_random.gaussian(); }

private:
  scenario::Random_source m_random;
};

// Decoded from the bytes of a fuzzer: one for each small number, two for the others. When they are
// used up, everything is 0.
class Byte_decisions : public Decisions
{
public:
  explicit Byte_decisions(const std::string& bytes)
    : m_bytes(bytes)
  {
  }

  std::size_t below(std::size_t end) override
  {
    constexpr std::size_t values = 256;
    if (end < 2) {
      return 0;
    }
    const std::size_t first = next();
    return (end <= values ? first : values * first + next()) % end;
  }

  double share() override { return static_cast<double>(below(65536)) / 65536.0; }
  bool has_more() const override { return m_place < m_bytes.size(); }

private:
  std::size_t next()
  {
    return has_more() ? static_cast<unsigned char>(m_bytes[m_place++]) : std::size_t(0);
  }

  const std::string& m_bytes;
  std::size_t m_place = 0;
};

} // namespace random_operations

#endif // RANDOM_OPERATIONS_DECISIONS_H
