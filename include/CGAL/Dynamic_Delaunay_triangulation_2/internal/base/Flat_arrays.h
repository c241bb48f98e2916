// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_FLAT_ARRAYS_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_FLAT_ARRAYS_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Index_of.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <boost/core/noinit_adaptor.hpp>
#include <boost/sort/pdqsort/pdqsort.hpp>
#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Makes room for `more` further elements, so that appending them cannot throw. Grows by doubling,
// which `reserve()` alone does not.
template <class Vector>
void reserve_extra(Vector& data, std::size_t more)
{
  if (data.capacity() < data.size() + more)
    data.reserve(2 * data.size() + more);
}

// A vector whose resize() leaves new elements uninitialized. The operating system then gives each
// page of memory to the thread that writes it first, and not all pages to the thread that resizes.
template <class T>
using Uninitialized_vector = std::vector<T, boost::noinit_adaptor<std::allocator<T>>>;
template <class Index_of_kind, class T>
using Uninitialized_column = Column<Index_of_kind, T, Uninitialized_vector<T>>;

// A list that keeps its memory. Appending to it is one comparison and one store, which compilers
// inline; std::vector's push_back() is a function that they call.
template <class T>
class Kept_list
{
public:
  void clear() { m_size = 0; }

  void push_back(const T& element)
  {
    if (m_size == m_elements.size())
      m_elements.resize(2 * m_size + 8);
    m_elements[m_size++] = element;
  }
  void pop_back() { --m_size; }

  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }
  const T& back() const { return m_elements[m_size - 1]; }
  const T& operator[](std::size_t i) const { return m_elements[i]; }
  T& operator[](std::size_t i) { return m_elements[i]; }
  const T* begin() const { return m_elements.data(); }
  const T* end() const { return m_elements.data() + m_size; }

private:
  std::vector<T> m_elements;
  std::size_t m_size = 0;
};

// Replaces the elements of a list from the i-th on by the indices of bits, ascending: the lowest
// bit of count_word(w) is that of 64 * w, the next one that of 64 * w + 1. Then write_word(w) has
// to return the same bits; it is called after everything that may throw. Threads share the words.
template <class Parts, class Index_of_kind, class Count_word, class Write_word>
void list_bits(std::size_t words, const Count_word& count_word, const Write_word& write_word,
               std::size_t i, std::vector<Index_of_kind>& list)
{
  constexpr std::size_t bits = 64, least = Parts::size_for(bits);
  std::array<std::size_t, Parts::max_parts> numbers;
  Parts::for_each(words, least, [&](std::size_t part, std::size_t w, std::size_t beyond) {
    numbers[part] = 0;
    for (; w < beyond; ++w)
      numbers[part] += std::bitset<bits>(count_word(w)).count();
  });
  for (std::size_t part = 0; part < Parts::number(words, least); ++part)
    i += std::exchange(numbers[part], i);
  list.resize(i); // nothing throws from here on
  Parts::for_each(words, least, [&](std::size_t part, std::size_t w, std::size_t beyond) {
    for (; w < beyond; ++w)
      for (std::uint64_t word = write_word(w); word != 0; word &= word - 1)
        list[numbers[part]++] = Index_of_kind(w * bits + lowest_bit(word));
  });
}

// A set of indices below a bound, in the order of insertion. Membership is stored as bits, so that
// random look-ups stay in the cache. Clearing takes time proportional to the number of members, at
// most to the bound. After the first frames nothing is allocated.
template <class Index_of_kind>
class Index_set
{
public:
  void clear(std::size_t bound)
  {
    if (m_members.size() > m_words.size())
      std::fill(m_words.begin(), m_words.end(), 0);
    else
      for (const Index_of_kind i : m_members)
        m_words[i / bits] = 0;
    if (!m_members.empty())
      m_former.swap(m_members);
    m_members.clear();
    m_words.resize((bound + bits - 1) / bits, 0);
  }

  bool contains(Index_of_kind i) const { return m_words[i / bits] >> i % bits & 1; }

  bool insert(Index_of_kind i)
  {
    if (contains(i))
      return false;
    m_members.push_back(i); // may throw
    m_words[i / bits] |= std::uint64_t(1) << i % bits;
    return true;
  }

  // Inserts, in ascending order, the indices whose bits `take(w)` returns for all w, as list_bits()
  // has them. Threads share the work. They write over former members: a list that grows from none
  // is set to zero by one thread, which was a quarter of what it did alone in rough frames.
  template <class Parts, class Take>
  void insert_words(const Take& take)
  {
    const std::size_t before = size();
    Uninitialized_vector<std::uint64_t> inserted(m_words.size());
    if (before == 0)
      m_members.swap(m_former);
    try {
      list_bits<Parts>(
          m_words.size(), [&](std::size_t w) { return inserted[w] = take(w) & ~m_words[w]; },
          [&](std::size_t w) { return m_words[w] |= inserted[w], inserted[w]; }, before, m_members);
    } catch (...) {
      m_members.resize(before);
      throw;
    }
  }

  // Replaces the content by these indices.
  void assign(const std::vector<Index_of_kind>& indices, std::size_t bound)
  {
    clear(bound);
    for (const Index_of_kind i : indices)
      insert(i);
  }

  // Replaces the content by all indices from `first` to below `bound`.
  void fill(Index first, Index bound)
  {
    clear(bound);
    m_members.resize(bound - first);
    std::iota(m_members.begin(), m_members.end(), Index_of_kind(first));
    for (const Index_of_kind i : m_members)
      m_words[i / bits] |= std::uint64_t(1) << i % bits;
  }

  std::size_t size() const { return m_members.size(); }
  bool empty() const { return m_members.empty(); }
  Index_of_kind operator[](std::size_t i) const { return m_members[i]; }
  const std::vector<Index_of_kind>& members() const { return m_members; }
  auto begin() const { return m_members.begin(); }
  auto end() const { return m_members.end(); }

private:
  static constexpr Index bits = 64;

  std::vector<Index_of_kind> m_members;
  std::vector<Index_of_kind> m_former; // those before the last clear(): memory for insert_words()
  std::vector<std::uint64_t> m_words;
};

// Sorts the indices and removes repeated ones, by one bit per number from smallest to largest.
// Returns false and changes nothing if scanning the bits would take longer than sorting.
template <class Index_of_kind>
bool make_distinct_by_bits(std::vector<Index_of_kind>& indices)
{
  constexpr std::size_t few = 64, words_per_index = 8;
  constexpr Index bits = 64;
  if (indices.size() < few)
    return false;
  const auto [smallest, largest] = std::minmax_element(indices.begin(), indices.end());
  const Index first = *smallest;
  const std::size_t words = (*largest - first) / bits + std::size_t(1);
  if (words / words_per_index > indices.size())
    return false;
  std::vector<std::uint64_t> are_there(words);
  for (const Index i : indices)
    are_there[(i - first) / bits] |= std::uint64_t(1) << (i - first) % bits;
  auto place = indices.begin();
  for (std::size_t w = 0; w < words; ++w)
    for (std::uint64_t word = are_there[w]; word != 0; word &= word - 1)
      *place++ = Index_of_kind(first + Index(w) * bits + lowest_bit(word));
  indices.erase(place, indices.end());
  return true;
}

// Sorts the indices and removes repeated ones. If they are many, sorting takes some 50 ns each. All
// kinds are sorted as numbers, by code that is compiled once: a WebAssembly module is 3 kB smaller.
template <class Index_of_kind>
void make_distinct(std::vector<Index_of_kind>& indices)
{
  if (make_distinct_by_bits(indices))
    return;
  static_assert(std::is_standard_layout_v<Index_of_kind> && sizeof(Index_of_kind) == sizeof(Index));
  Index* const numbers = reinterpret_cast<Index*>(indices.data());
  boost::sort::spreadsort::integer_sort(numbers, numbers + indices.size());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

// The same, by bits that threads set and read, if the indices are many.
template <class Parts, class Index_of_kind>
void make_distinct_by_parts(std::vector<Index_of_kind>& indices)
{
  constexpr std::size_t bits = 64, words_per_index = 32;
  constexpr std::size_t least = Parts::size_for(words_per_index);
  const std::size_t number = indices.size(), parts = Parts::number(number, least);
  if (!Parts::are_shared(parts))
    return make_distinct(indices);
  std::array<Index, Parts::max_parts> largest;
  Parts::for_each(number, least, [&](std::size_t part, std::size_t i, std::size_t beyond) {
    largest[part] = *std::max_element(indices.begin() + std::ptrdiff_t(i),
                                      indices.begin() + std::ptrdiff_t(beyond));
  });
  const std::size_t words = *std::max_element(largest.begin(), largest.begin() + parts) / bits + 1;
  if (words / words_per_index > number)
    return make_distinct(indices);
  std::vector<std::atomic<std::uint64_t>> are_there(words);
  Parts::for_each(number, least, [&](std::size_t, std::size_t i, std::size_t beyond) {
    for (; i < beyond; ++i)
      are_there[indices[i] / bits].fetch_or(std::uint64_t(1) << indices[i] % bits,
                                            std::memory_order_relaxed);
  });
  const auto word = [&](std::size_t w) { return are_there[w].load(std::memory_order_relaxed); };
  list_bits<Parts>(words, word, word, 0, indices);
}

// Removes the i-th of the indices if is(i, beyond). Threads share the calls: `beyond` is the end of
// the part with i, up to which `is` may fetch ahead.
template <class Parts, class Index_of_kind, class Predicate>
void remove_by_parts(std::vector<Index_of_kind>& indices, std::size_t least, const Predicate& is)
{
  Parts::for_each(indices.size(), least, [&](std::size_t, std::size_t i, std::size_t beyond) {
    for (; i < beyond; ++i)
      if (is(i, beyond))
        indices[i] = null_index;
  });
  indices.erase(std::remove(indices.begin(), indices.end(), null_index), indices.end());
}

// Appends several lists, the k-th of which is list_of(k). Threads copy them if they are long.
template <class Parts, class List_of, class Element>
void append_lists(std::size_t number, const List_of& list_of, std::vector<Element>& list)
{
  if constexpr (Parts::is_parallel) {
    const auto size_before = [&](std::size_t k) {
      std::size_t size = 0;
      for (std::size_t i = 0; i < k; ++i)
        size += list_of(i).size();
      return size;
    };
    const std::size_t first = list.size(), more = size_before(number);
    if (Parts::are_shared(Parts::number(more))) {
      reserve_extra(list, more);
      list.resize(first + more);
      return Parts::run(number, [&](std::size_t k) {
        std::copy(list_of(k).begin(), list_of(k).end(), list.data() + first + size_before(k));
      });
    }
  }
  for (std::size_t k = 0; k < number; ++k)
    list.insert(list.end(), list_of(k).begin(), list_of(k).end());
}

// Appends what append(i, beyond, list) appends for all parts [i, beyond) of a range, in their
// order. Threads share the parts. What is appended may depend on where a part begins, as on a torus
// edges across the border of the cell follow those that are tested in lanes.
template <class Parts, class Element, class Append>
void append_by_parts(std::size_t size, std::size_t least, std::vector<Element>& list,
                     const Append& append)
{
  const std::size_t parts = Parts::number(size, least);
  if (parts == 1)
    return append(std::size_t(0), size, list);
  std::vector<std::vector<Element>> lists(parts);
  Parts::for_each(size, least, [&](std::size_t part, std::size_t first, std::size_t beyond) {
    append(first, beyond, lists[part]);
  });
  append_lists<Parts>(
      parts, [&](std::size_t part) -> const auto& { return lists[part]; }, list);
}

// Throws if an id occurs more than once.
template <class Id>
void check_distinct(const std::vector<Id>& given)
{
  if (given.size() < 2) // most calls move or remove a single point
    return;
  std::vector<Id> ids = given;
  boost::sort::pdqsort(ids.begin(), ids.end()); // many are sorted already
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end())
    throw Repeated_id_error_2(*twice);
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_FLAT_ARRAYS_H
