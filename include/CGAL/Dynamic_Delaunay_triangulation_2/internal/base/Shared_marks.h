// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_SHARED_MARKS_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_SHARED_MARKS_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <boost/endian/conversion.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Marks on indices, which threads set at the same time, and take away later. Each is a byte: to set
// a bit, a thread would have to lock the word that it shares with others.
template <class Index_of_kind>
class Shared_marks
{
public:
  Shared_marks() = default;
  // There are no marks between calls, so a copy has none.
  Shared_marks(const Shared_marks&) {}
  Shared_marks& operator=(const Shared_marks&)
  {
    clear();
    return *this;
  }

  // Makes room for the marks below a bound.
  void reserve(std::size_t bound)
  {
    const std::size_t words = bound / bits + 1;
    if (words > m_words) {
      m_marks = std::make_unique<Mark[]>(words * bits);
      m_words = words;
    }
  }

  void mark(Index_of_kind i) { m_marks[i].store(1, std::memory_order_relaxed); }

  // Takes away the marks of the indices from 64 * word on, and returns them as bits.
  std::uint64_t take(std::size_t word)
  {
    Mark* const marks = &m_marks[bits * word];
    std::uint64_t taken = 0;
    for (std::size_t i = 0; i < bits; i += 8) {
      const std::uint64_t eight =
          boost::endian::load_little_u64(reinterpret_cast<const unsigned char*>(marks + i));
      taken |= eight * 0x0102040810204080 >> 56 << i; // bit 8 * k of the eight goes to bit i + k
    }
    if (taken != 0)
      std::memset(static_cast<void*>(marks), 0, bits);
    return taken;
  }

  // Takes all marks away, and frees the memory.
  void clear()
  {
    m_marks.reset();
    m_words = 0;
  }

private:
  using Mark = std::atomic<std::uint8_t>;
  static_assert(sizeof(Mark) == 1);
  static constexpr std::size_t bits = 64;

  std::unique_ptr<Mark[]> m_marks;
  std::size_t m_words = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_SHARED_MARKS_H
