// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_SPATIAL_ORDER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_SPATIAL_ORDER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Parallel_parts.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The Hilbert curve through 2^16 by 2^16 cells, from the largest quadrants to the smallest. In each
// quadrant it is the whole curve with its axes exchanged, or rotated by 180 degrees, or both.
class Hilbert_curve_2
{
public:
  Hilbert_curve_2()
  {
    for (unsigned state = 0; state < 4; ++state)
      for (unsigned cell = 0; cell < 16; ++cell)
        m_steps[state][cell] = two_digits(state, cell / 4, cell % 4);
  }

  // The place of the cell (x, y) on the curve, computed by two of its 16 digits at a time.
  std::uint32_t place(std::uint32_t x, std::uint32_t y) const
  {
    std::uint32_t place = 0;
    unsigned state = 0;
    for (int i = 14; i >= 0; i -= 2) {
      const unsigned step = m_steps[state][(x >> i & 3) << 2 | (y >> i & 3)];
      place = place << 4 | step >> 2;
      state = step & 3;
    }
    return place;
  }

private:
  // Returns two digits and, in the two bits below them, the next state: whether the axes are
  // exchanged (upper bit), and whether the curve is rotated.
  static std::uint8_t two_digits(unsigned state, unsigned x, unsigned y)
  {
    unsigned digits = 0, are_exchanged = state >> 1, is_turned = state & 1;
    for (int i = 1; i >= 0; --i) {
      const unsigned x_bit = x >> i & 1, y_bit = y >> i & 1;
      const unsigned exchange = (x_bit ^ y_bit) & are_exchanged;
      const unsigned right = x_bit ^ exchange ^ is_turned, upper = y_bit ^ exchange ^ is_turned;
      digits = digits << 2 | ((3 * right) ^ upper);
      is_turned ^= right & ~upper;
      are_exchanged ^= 1 ^ upper;
    }
    return std::uint8_t(digits << 2 | are_exchanged << 1 | is_turned);
  }

  std::uint8_t m_steps[4][16];
};

// The line between two consecutive points of a spatial order. It separates the longest stretches of
// the order on both sides of it in which no line has a higher rank.
struct Cut_2
{
  std::int16_t rank;
  bool is_horizontal; // separates by y; else by x
  bool is_descending; // the later points have the smaller coordinates
};

// The line between two cells, given by their places on the Hilbert curve, `before` the earlier one.
// At the first digit in which the places differ, the upper bit of the digit belongs to one axis,
// the lower bit to the other. Of the digits above, each 0 or 3 exchanges the axes, each 3 rotates.
inline Cut_2 hilbert_cut(std::uint32_t before, std::uint32_t after)
{
  const auto parity = [](std::uint32_t bits) {
    bits ^= bits >> 16, bits ^= bits >> 8, bits ^= bits >> 4;
    return (0x6996u >> (bits & 15) & 1) != 0;
  };
  const int bit = int(highest_bit(before ^ after));
  const std::uint32_t digits_above = bit < 30 ? ~std::uint32_t(0) << (bit / 2 * 2 + 2) : 0;
  const std::uint32_t low_bits = 0x55555555u & digits_above;
  const bool are_exchanged = parity(~(after ^ after >> 1) & low_bits);
  const bool is_turned = parity(after & after >> 1 & low_bits);
  const bool is_lower_bit = bit % 2 == 0;
  // the third quadrant is the upper right one, the fourth the lower right one
  const bool goes_down = is_lower_bit && (after >> (bit + 1) & 1) != 0;
  return Cut_2{std::int16_t(bit), is_lower_bit != are_exchanged, is_turned != goes_down};
}

// Sorts points along a Hilbert curve, by the cells of a grid over them, and finds the lines between
// consecutive points. Dividing along these lines divides as a quadtree does, each half across the
// other axis. Points that share a cell are sorted by a finer grid over these points, or, if they
// are few or too close together, by x, then y. So coincident points are consecutive. The result
// depends only on the points and their numbers.
class Spatial_order_2
{
public:
  // Sorts the points with the numbers in [first, beyond), iterators with random access. Threads
  // share the passes over many points.
  template <class Parts = Parallel_parts<Sequential_tag>, class Positions, class Iterator>
  void sort(const Positions& positions, Iterator first, Iterator beyond)
  {
    m_positions = positions.data();
    m_places.resize(std::size_t(beyond - first));
    m_cuts.resize(m_places.size());
    Parts::for_each_element(m_places.size(), [&](std::size_t i) {
      m_places[i] = first[typename std::iterator_traits<Iterator>::difference_type(i)];
    });
    sort_by_grid<Parts>(0, m_places.size(), 0);
  }

  // Sorts by x, then y, then number, where positions are rounded and only comparisons are exact.
  // All lines are vertical.
  template <class Iterator, class Less>
  void sort_by_comparisons(Iterator first, Iterator beyond, const Less& less)
  {
    m_places.assign(first, beyond);
    m_cuts.resize(m_places.size());
    sort_by_coordinates(less, 0, m_places.size(), 0);
  }

  std::size_t size() const { return m_places.size(); }
  // The number of the i-th point.
  Index operator[](std::size_t i) const { return Index(m_places[i]); }
  // The line between the i-th point and the one before; i > 0.
  const Cut_2& cut(std::size_t i) const { return m_cuts[i]; }

  // Whether no points coincide.
  template <class Parts, class Coincide>
  bool are_distinct(const Coincide& coincide) const
  {
    return Parts::all_of(size(), [&](std::size_t first, std::size_t beyond) {
      for (std::size_t i = (std::max)(first, std::size_t(1)); i < beyond; ++i)
        if (coincide((*this)[i - 1], (*this)[i]))
          return false;
      return true;
    });
  }

  // Replaces the number of the i-th point.
  void renumber(std::size_t i, Index number) { m_places[i] = number; }

  // Keeps one number for each stretch of coincident points: `merge(first, beyond)` returns it for
  // the stretch from `first` to below `beyond`.
  template <class Coincide, class Merge>
  void merge_coincident(const Coincide& coincide, const Merge& merge)
  {
    std::size_t kept = 0;
    for (std::size_t i = 0, next; i < size(); i = next) {
      for (next = i + 1; next < size() && coincide((*this)[i], (*this)[next]);)
        ++next;
      m_places[kept] = merge(i, next);
      m_cuts[kept++] = m_cuts[i];
    }
    m_places.resize(kept);
    m_cuts.resize(kept);
  }

  void release()
  {
    Uninitialized_vector<std::uint64_t>().swap(m_places);
    Uninitialized_vector<Cut_2>().swap(m_cuts);
  }

private:
  // At most so many points are sorted by their coordinates without a grid.
  static constexpr std::size_t few = 8;
  // Points of a part: to sort one takes tens of nanoseconds.
  template <class Parts>
  static constexpr std::size_t least = Parts::size_for(8);
  // Ranks per level: the lines of a grid use the upper half, those between few points the lower.
  static constexpr int ranks = 64;

  const Position_2& position(std::size_t i) const { return m_positions[Index(m_places[i])]; }
  std::uint32_t place(std::size_t i) const { return std::uint32_t(m_places[i] >> 32); }

  template <class Parts>
  void sort_by_grid(std::size_t first, std::size_t beyond, int depth)
  {
    if (beyond - first <= few || !find_places<Parts>(first, beyond))
      return sort_by_coordinates(first, beyond, depth);
    sort_places<Parts>(first, beyond);
    // each part begins with a cell, and knows the place of the cell before it: sorting within that
    // cell overwrites the place
    struct Border
    {
      std::size_t begin;
      std::uint32_t last_place;
    };
    std::array<Border, Parts::max_parts + 1> borders;
    const std::size_t size = beyond - first, parts = Parts::number(size, least<Parts>);
    for (std::size_t part = 0; part <= parts; ++part) {
      const std::size_t begin =
          begin_of_cell(first, first + Parts::begin(part, parts, size), beyond);
      borders[part] = {begin, begin > first ? place(begin - 1) : 0};
    }
    Parts::run(parts, [&](std::size_t part) {
      sort_cells<Parts>(first, borders[part].begin, borders[part + 1].begin,
                        borders[part].last_place, depth);
    });
  }

  // Returns where the first cell begins that begins at i or later.
  std::size_t begin_of_cell(std::size_t first, std::size_t i, std::size_t beyond) const
  {
    if (i == first)
      return i;
    const auto begin = m_places.begin();
    return std::size_t(
        std::upper_bound(begin + std::ptrdiff_t(i), begin + std::ptrdiff_t(beyond), place(i - 1),
                         [](std::uint32_t before, std::uint64_t p) { return before < p >> 32; }) -
        begin);
  }

  // Sorts within the cells that begin from i to before `beyond`, and finds the line in front of
  // each of them, except for the first cell of the grid, which begins at `first`.
  template <class Parts>
  void sort_cells(std::size_t first, std::size_t i, std::size_t beyond, std::uint32_t last_place,
                  int depth)
  {
    for (std::size_t next; i < beyond; i = next) {
      const std::uint32_t this_place = place(i);
      for (next = i + 1; next < beyond && place(next) == this_place;)
        ++next;
      if (i > first) {
        m_cuts[i] = hilbert_cut(last_place, this_place);
        m_cuts[i].rank = std::int16_t(m_cuts[i].rank + ranks / 2 - ranks * depth);
      }
      if (next - i > 1)
        sort_by_grid<Parts>(i, next, depth + 1);
      last_place = this_place;
    }
  }

  // Sorts the places. All are different, because they contain the numbers of the points, so there
  // is one order. Threads share groups of places with the same first eight bits.
  template <class Parts>
  void sort_places(std::size_t first, std::size_t beyond)
  {
    using boost::sort::spreadsort::integer_sort;
    const auto begin = m_places.begin() + std::ptrdiff_t(first);
    const std::size_t size = beyond - first, parts = Parts::number(size, least<Parts>);
    if (!Parts::are_shared(parts))
      return integer_sort(begin, begin + std::ptrdiff_t(size));
    constexpr unsigned digits = 256;
    const auto digit = [](std::uint64_t p) { return std::size_t(p >> 56); };
    std::vector<std::array<std::size_t, digits>> next(parts, std::array<std::size_t, digits>{});
    Parts::for_each(size, least<Parts>, [&](std::size_t part, std::size_t i, std::size_t end) {
      for (; i < end; ++i)
        ++next[part][digit(begin[std::ptrdiff_t(i)])];
    });
    std::array<std::size_t, digits + 1> borders;
    std::size_t sum = 0;
    for (std::size_t d = 0; d < digits; ++d) {
      borders[d] = sum;
      for (auto& of_part : next)
        sum += std::exchange(of_part[d], sum);
    }
    borders[digits] = sum;
    Uninitialized_vector<std::uint64_t> sorted(size);
    Parts::for_each(size, least<Parts>, [&](std::size_t part, std::size_t i, std::size_t end) {
      for (; i < end; ++i) {
        const std::uint64_t p = begin[std::ptrdiff_t(i)];
        sorted[next[part][digit(p)]++] = p;
      }
    });
    Parts::run(digits, [&](std::size_t d) {
      const auto low = sorted.begin() + std::ptrdiff_t(borders[d]);
      const auto high = sorted.begin() + std::ptrdiff_t(borders[d + 1]);
      integer_sort(low, high);
      std::copy(low, high, begin + std::ptrdiff_t(borders[d]));
    });
  }

  struct Box
  {
    Position_2 low, high;

    void add(const Box& other)
    {
      low = {(std::min)(low.x, other.low.x), (std::min)(low.y, other.low.y)};
      high = {(std::max)(high.x, other.high.x), (std::max)(high.y, other.high.y)};
    }
  };

  // There must be at least one point.
  template <class Parts>
  Box bounding_box(std::size_t first, std::size_t size) const
  {
    std::array<Box, Parts::max_parts> boxes;
    Parts::for_each(size, least<Parts>, [&](std::size_t part, std::size_t i, std::size_t end) {
      Box box{position(first + i), position(first + i)};
      for (; i < end; ++i)
        box.add({position(first + i), position(first + i)});
      boxes[part] = box;
    });
    for (std::size_t part = 1; part < Parts::number(size, least<Parts>); ++part)
      boxes[0].add(boxes[part]);
    return boxes[0];
  }

  // Finds the places of the points' cells on the curve. False if there is no grid: the extent of
  // the points, or its inverse, is not a finite number. Differences and products are rounded
  // monotonically, so the lines between cells separate the points.
  template <class Parts>
  bool find_places(std::size_t first, std::size_t beyond)
  {
    const auto [low, high] = bounding_box<Parts>(first, beyond - first);
    const double extent = (std::max)(high.x - low.x, high.y - low.y);
    const double scale = 65535 / extent;
    if (!std::isfinite(extent) || !std::isfinite(scale) || scale == 0)
      return false;
    static const Hilbert_curve_2 curve;
    const Position_2 origin = low;
    Parts::for_each(beyond - first, least<Parts>, [&](std::size_t, std::size_t i, std::size_t end) {
      for (i += first, end += first; i < end; ++i) {
        const Position_2& p = position(i);
        const std::uint64_t place = curve.place(std::uint32_t((p.x - origin.x) * scale),
                                                std::uint32_t((p.y - origin.y) * scale));
        m_places[i] = place << 32 | Index(m_places[i]);
      }
    });
    return true;
  }

  void sort_by_coordinates(std::size_t first, std::size_t beyond, int depth)
  {
    const auto is_less = [this](Index a, Index b) {
      const Position_2 &p = m_positions[a], &q = m_positions[b];
      return p.x != q.x ? p.x < q.x : p.y < q.y;
    };
    sort_by_coordinates(is_less, first, beyond, depth);
  }

  // Sorts by x, then y, then number. The ranks bisect the points recursively.
  template <class Less>
  void sort_by_coordinates(const Less& is_less, std::size_t first, std::size_t beyond, int depth)
  {
    const auto begin = m_places.begin() + std::ptrdiff_t(first);
    const auto end = m_places.begin() + std::ptrdiff_t(beyond);
    const auto comes_before = [&](std::uint64_t a, std::uint64_t b) {
      const Index i = Index(a), j = Index(b);
      return is_less(i, j) || (!is_less(j, i) && i < j);
    };
    // coincident points, and points that stayed on a line, often are sorted
    if (!std::is_sorted(begin, end, comes_before))
      std::sort(begin, end, comes_before);
    for (std::size_t i = first + 1; i < beyond; ++i) {
      int rank = 0;
      for (std::size_t k = i - first; k % 2 == 0; k /= 2)
        ++rank;
      m_cuts[i] =
          Cut_2{std::int16_t((std::min)(rank, ranks / 2 - 1) - ranks * depth), false, false};
    }
  }

  const Position_2* m_positions = nullptr;
  // Each is the place in a grid (upper half), and the number of the point (lower half).
  Uninitialized_vector<std::uint64_t> m_places;
  Uninitialized_vector<Cut_2> m_cuts;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_SPATIAL_ORDER_2_H
