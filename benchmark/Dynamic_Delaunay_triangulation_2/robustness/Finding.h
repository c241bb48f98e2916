// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_FINDING_H
#define ROBUSTNESS_FINDING_H

#include <stdexcept>
#include <string>

namespace robustness {

enum class Fault {
  WRONG,  // not Delaunay, or not what it claims to be
  LOST,   // a point, an id or a vertex is not where it has to be
  CRASHED // an exception that nobody has asked for
};

class Finding : public std::runtime_error
{
public:
  Finding(Fault fault, const std::string& what)
    : std::runtime_error(what)
    , m_fault(fault)
  {
  }

  Fault fault() const { return m_fault; }

private:
  Fault m_fault;
};

inline void require(bool is_true, Fault fault, const char* what)
{
  if (!is_true) {
    throw Finding(fault, what);
  }
}

} // namespace robustness

#endif // ROBUSTNESS_FINDING_H
