// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_ARITHMETIC_H
#define RANDOM_OPERATIONS_ARITHMETIC_H

#include <cfenv>
#include <ostream>
#include <string>
#include <vector>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace random_operations {

// How a caller has set up floating-point arithmetic.
struct Arithmetic
{
  std::string name = "usual";
  int rounding = FE_TONEAREST;
  bool flushes_subnormals = false; // takes them for zero, as operands and as results
  bool traps = false;              // invalid operations, overflow and division by zero
};

inline std::ostream& operator<<(std::ostream& out, const Arithmetic& arithmetic)
{
  return out << arithmetic.name;
}

// All that can be set up here.
inline const std::vector<Arithmetic>& all_arithmetic()
{
  static const std::vector<Arithmetic> all = {{"usual", FE_TONEAREST},
                                              {"upward", FE_UPWARD},
                                              {"downward", FE_DOWNWARD},
                                              {"toward_zero", FE_TOWARDZERO},
#ifdef __SSE2__
                                              {"without_subnormals", FE_TONEAREST, true},
                                              {"trapping", FE_TONEAREST, false, true}
#endif
  };
  return all;
}

// The caller's arithmetic, while it lives.
class Arithmetic_in_use
{
public:
  explicit Arithmetic_in_use(const Arithmetic& arithmetic)
  {
    std::fegetenv(&m_ours);
    std::fesetround(arithmetic.rounding);
#ifdef __SSE2__
    constexpr unsigned flush_subnormals = 0x8040, masked_exceptions = 0x0680;
    _mm_setcsr((_mm_getcsr() | (arithmetic.flushes_subnormals ? flush_subnormals : 0)) &
               ~(arithmetic.traps ? masked_exceptions : 0));
#endif
    m_state = state();
  }
  Arithmetic_in_use(const Arithmetic_in_use&) = delete;
  Arithmetic_in_use& operator=(const Arithmetic_in_use&) = delete;
  ~Arithmetic_in_use()
  {
    std::fesetenv(&m_ours);
  }

  // Whether it is still what was set.
  bool is_kept() const
  {
    return state() == m_state;
  }

private:
  static unsigned state()
  {
#ifdef __SSE2__
    constexpr unsigned raised_exceptions = 0x3f;
    return _mm_getcsr() & ~raised_exceptions;
#else
    return static_cast<unsigned>(std::fegetround());
#endif
  }

  std::fenv_t m_ours;
  unsigned m_state = 0;
};

} // namespace random_operations

#endif // RANDOM_OPERATIONS_ARITHMETIC_H
