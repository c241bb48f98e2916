// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_USER_ID_TABLE_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_USER_ID_TABLE_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Random numbers, unknown to whoever chooses ids. Without them somebody could choose ids that all
// belong into the same slot of a table: each look-up would take time proportional to their number.
class User_id_secret
{
public:
  // The secret of this process.
  static const User_id_secret& of_process()
  {
    static const User_id_secret secret = drawn();
    return secret;
  }

  // All bits of the id and of the secret influence the highest bits of the result.
  std::uint64_t hash(std::uint64_t user_id) const
  {
    const std::uint64_t product = (user_id + m_summand) * m_factor;
    return (product ^ product >> 32) * m_other_factor;
  }

private:
  using Number = std::uint64_t;

  User_id_secret(Number summand, Number factor, Number other_factor)
    : m_summand(summand)
    , m_factor(factor)
    , m_other_factor(other_factor)
  {
  }

  static User_id_secret drawn() noexcept
  {
#ifdef __wasm__ // a module alone has no system to ask; its loader also chooses the ids
    std::mt19937_64 random;
    return drawn_by(random);
#else
    try {
      std::random_device random;
      return drawn_by(random);
    } catch (const std::exception&) { // a machine without a source of random numbers
      std::mt19937_64 random(Number(std::chrono::steady_clock::now().time_since_epoch().count()));
      return drawn_by(random);
    }
#endif
  }

  // Multiplication by odd factors loses no bits.
  template <class Random>
  static User_id_secret drawn_by(Random& random)
  {
    std::uniform_int_distribution<Number> number;
    const Number summand = number(random), factor = number(random);
    return {summand, factor | 1, number(random) | 1};
  }

  Number m_summand, m_factor, m_other_factor;
};

// Maps the user's ids, which are any integers, to ids of points. Open addressing with linear
// probing: a look-up reads one place in memory, where std::unordered_map reads three and allocates
// each entry, which took a fifth of the frame where many of 100,000 points come and go. The secret
// determines the slot of an id. No result depends on it, because entries are never listed.
template <class UserId>
class User_id_table
{
public:
  static constexpr std::size_t no_id = std::size_t(-1);

  User_id_table() = default;
  User_id_table(const User_id_table&) = default;
  User_id_table& operator=(const User_id_table&) = default;
  User_id_table(User_id_table&& other) noexcept
    : m_secret(other.m_secret)
  {
    swap(other);
  }
  User_id_table& operator=(User_id_table&& other) noexcept
  {
    User_id_table taken(std::move(other));
    swap(taken);
    return *this;
  }

  std::size_t size() const { return m_size; }

  // Returns the point's id, or `no_id` if there is none. Most new ids are larger than all others,
  // and are found missing by one comparison.
  std::size_t find(UserId user_id) const
  {
    return m_size == 0 || user_id > m_largest ? no_id : m_slots[slot_of(user_id)].id;
  }

  // How many slots `find()` reads for an id that has an entry.
  std::size_t number_of_probes(UserId user_id) const
  {
    return distance(first_slot(user_id), slot_of(user_id)) + 1;
  }

  // Prefetches the memory that `find()` will read first.
  void prefetch(UserId user_id) const
  {
    if (!m_slots.empty())
      internal::prefetch(&m_slots[first_slot(user_id)]);
  }

  // Reserves memory for so many more entries. Then `set()` throws nothing.
  void reserve_extra(std::size_t number)
  {
    if (2 * (m_size + number) <= m_slots.size())
      return;
    int bits = 4;
    while ((std::size_t(1) << bits) < 2 * (m_size + number))
      ++bits;
    std::vector<Slot> old_slots(std::size_t(1) << bits);
    old_slots.swap(m_slots);
    m_bits = bits;
    for (const Slot& slot : old_slots)
      if (slot.id != no_id)
        m_slots[slot_of(slot.user_id)] = slot;
  }

  // \pre There is memory for the entry.
  void set(UserId user_id, std::size_t id)
  {
    Slot& slot = m_slots[slot_of(user_id)];
    m_largest = m_size == 0 ? user_id : (std::max)(m_largest, user_id);
    m_size += slot.id == no_id;
    slot = Slot{user_id, id};
    CGAL_postcondition(2 * m_size <= m_slots.size());
  }

  // Does nothing if there is no such entry.
  void erase(UserId user_id)
  {
    if (find(user_id) == no_id)
      return;
    --m_size;
    std::size_t hole = slot_of(user_id);
    m_slots[hole].id = no_id;
    // entries that a search would not reach beyond the hole move into it
    for (std::size_t i = next(hole); m_slots[i].id != no_id; i = next(i))
      if (distance(first_slot(m_slots[i].user_id), i) >= distance(hole, i)) {
        m_slots[hole] = m_slots[i];
        m_slots[i].id = no_id;
        hole = i;
      }
  }

  void swap(User_id_table& other) noexcept
  {
    m_slots.swap(other.m_slots);
    std::swap(m_size, other.m_size);
    std::swap(m_largest, other.m_largest);
    std::swap(m_bits, other.m_bits);
    std::swap(m_secret, other.m_secret);
  }

private:
  struct Slot
  {
    UserId user_id = UserId();
    std::size_t id = no_id;
  };

  std::size_t first_slot(UserId user_id) const
  {
    return std::size_t(m_secret.hash(std::uint64_t(user_id)) >> (64 - m_bits));
  }

  std::size_t next(std::size_t slot) const { return (slot + 1) & (m_slots.size() - 1); }

  std::size_t distance(std::size_t from, std::size_t to) const
  {
    return (to - from) & (m_slots.size() - 1);
  }

  // The slot of this id, or the empty one where it belongs.
  std::size_t slot_of(UserId user_id) const
  {
    std::size_t i = first_slot(user_id);
    while (m_slots[i].id != no_id && m_slots[i].user_id != user_id)
      i = next(i);
    return i;
  }

  std::vector<Slot> m_slots; // none or a power of two; at least half are empty
  std::size_t m_size = 0;
  UserId m_largest = UserId(); // the largest id set since the table was last empty
  int m_bits = 0;
  User_id_secret m_secret = User_id_secret::of_process();
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_USER_ID_TABLE_H
