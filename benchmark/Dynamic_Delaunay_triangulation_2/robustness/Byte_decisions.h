// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_BYTE_DECISIONS_H
#define ROBUSTNESS_BYTE_DECISIONS_H

#include "Decisions.h"

#include <cstddef>
#include <string>

namespace robustness {

// Decisions decoded from the bytes of a fuzzer: one for each small number, two for the others. When
// they are used up, everything is 0.
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

  double share() override
  {
    constexpr double values = 65536.0;
    return static_cast<double>(below(static_cast<std::size_t>(values))) / values;
  }

  bool has_more() const override { return m_place < m_bytes.size(); }

private:
  std::size_t next()
  {
    return has_more() ? static_cast<unsigned char>(m_bytes[m_place++]) : std::size_t(0);
  }

  const std::string& m_bytes;
  std::size_t m_place = 0;
};

} // namespace robustness

#endif // ROBUSTNESS_BYTE_DECISIONS_H
