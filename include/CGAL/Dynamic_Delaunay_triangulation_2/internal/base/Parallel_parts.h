// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_PARALLEL_PARTS_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_PARALLEL_PARTS_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Part_runner.h>

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Divides a range into parts, which threads share if the tag is `Parallel_tag`. The parts depend on
// the size of the range alone: results that are computed for each part, and joined in the order of
// the parts, are the same for any number of threads and for both tags.
template <class ConcurrencyTag>
class Parallel_parts
{
  using Runner = Part_runner<ConcurrencyTag>;

public:
  static constexpr bool is_parallel = Runner::is_parallel;

  // The usual number of elements of a part, and the least number of parts that threads share:
  // waking a thread up takes 5 to 20 microseconds, and a pass a few nanoseconds for each element.
  // Two threads that share three parts are slower than one. Tests want many parts of few points.
#ifdef CGAL_DYNAMIC_DELAUNAY_POINTS_OF_PART
  static constexpr std::size_t usual_size = CGAL_DYNAMIC_DELAUNAY_POINTS_OF_PART;
  static constexpr std::size_t least_shared = 2;
#else
  static constexpr std::size_t usual_size = 1 << 13;
  static constexpr std::size_t least_shared = 8;
#endif

  static constexpr std::size_t max_parts = 128;

  // The least size of parts whose elements take so many times as long as usual ones.
  static constexpr std::size_t size_for(std::size_t times)
  {
    return (std::max)(usual_size / times, std::size_t(1));
  }

  // Returns the number of parts of a range. Two or more have at least `least` elements each.
  static std::size_t number(std::size_t size, std::size_t least = usual_size)
  {
    return (std::min)((std::max)(size / least, std::size_t(1)), max_parts);
  }

  // Returns where a part begins, which is where the part before it ends.
  static std::size_t begin(std::size_t part, std::size_t parts, std::size_t size)
  {
    return size / parts * part + (std::min)(part, size % parts);
  }

  // Calls f(part, first, beyond) for all parts of the range from 0 to `size`.
  template <class Function>
  static void for_each(std::size_t size, std::size_t least, const Function& f)
  {
    const std::size_t parts = number(size, least);
    run(parts,
        [&](std::size_t part) { f(part, begin(part, parts, size), begin(part + 1, parts, size)); });
  }
  template <class Function>
  static void for_each(std::size_t size, const Function& f)
  {
    for_each(size, usual_size, f);
  }

  // Calls f(i) for all i below `size`.
  template <class Function>
  static void for_each_element(std::size_t size, const Function& f)
  {
    for_each_element(size, usual_size, f);
  }
  template <class Function>
  static void for_each_element(std::size_t size, std::size_t least, const Function& f)
  {
    for_each(size, least, [&](std::size_t, std::size_t first, std::size_t beyond) {
      for (std::size_t i = first; i < beyond; ++i)
        f(i);
    });
  }

  // True if is(first, beyond) is true for all parts. May skip parts once it was false for one.
  template <class Predicate>
  static bool all_of(std::size_t size, const Predicate& is)
  {
    std::atomic<bool> are{true};
    for_each(size, [&](std::size_t, std::size_t first, std::size_t beyond) {
      if (are.load(std::memory_order_relaxed) && !is(first, beyond))
        are.store(false, std::memory_order_relaxed);
    });
    return are;
  }

  // The sum of count(first, beyond) over all parts. Counts are integers.
  template <class Count>
  static std::size_t sum(std::size_t size, std::size_t least, const Count& count)
  {
    std::atomic<std::size_t> total{0};
    for_each(size, least, [&](std::size_t, std::size_t first, std::size_t beyond) {
      total.fetch_add(count(first, beyond), std::memory_order_relaxed);
    });
    return total;
  }
  template <class Count>
  static std::size_t sum(std::size_t size, const Count& count)
  {
    return sum(size, usual_size, count);
  }

  // How many threads may share work.
  static std::size_t most_workers()
  {
    return Runner::most_workers();
  }

  // True if several threads would share this number of parts.
  static bool are_shared(std::size_t parts)
  {
    return number_of_workers(parts) > 1;
  }

  // Calls f(part) for all parts.
  template <class Function>
  static void run(std::size_t parts, const Function& f)
  {
    Runner::run(parts, number_of_workers(parts), f);
  }
  // The same of parts that take so long that even two are worth two threads.
  template <class Function>
  static void run_long(std::size_t parts, const Function& f)
  {
    Runner::run(parts, (std::min)(parts, Runner::most_workers()), f);
  }

private:
  static std::size_t number_of_workers(std::size_t parts)
  {
    return parts < least_shared ? 1 : (std::min)(parts, Runner::most_workers());
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_PARALLEL_PARTS_H
