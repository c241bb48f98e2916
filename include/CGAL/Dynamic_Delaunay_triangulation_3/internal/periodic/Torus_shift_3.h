// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_SHIFT_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_SHIFT_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <boost/config.hpp>

#include <array>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Multiples of the three vectors of a lattice's basis.
using Multiples_3 = Few<int, 3>;

inline Multiples_3 operator+(const Multiples_3& m, const Multiples_3& n)
{
  return {m[0] + n[0], m[1] + n[1], m[2] + n[2]};
}
inline Multiples_3 operator-(const Multiples_3& m, const Multiples_3& n)
{
  return {m[0] - n[0], m[1] - n[1], m[2] - n[2]};
}
inline bool are_zero(const Multiples_3& m)
{
  return (m[0] | m[1] | m[2]) == 0;
}

// A translation of the lattice by few multiples, below 2^9 in absolute value, packed into one
// integer, m[0] + 2^10 m[1] + 2^20 m[2]: so one addition adds all three.
struct Torus_shift_3
{
  int code; // not initialized, so that memory for cells is not written twice

  // Of the point above a slab, or around a wire. A pass takes it for a large shift, and leaves it
  // to exact predicates.
  static constexpr int beyond = 8 * 0x100000;

  static Torus_shift_3 of(const Multiples_3& m) { return {m[0] + 0x400 * m[1] + 0x100000 * m[2]}; }

  Multiples_3 multiples() const
  {
    const int first = low_multiple(code), rest = (code - first) >> 10, second = low_multiple(rest);
    return {first, second, (rest - second) >> 10};
  }

  friend Torus_shift_3 operator+(Torus_shift_3 s, Torus_shift_3 t) { return {s.code + t.code}; }
  friend Torus_shift_3 operator-(Torus_shift_3 s, Torus_shift_3 t) { return {s.code - t.code}; }
  friend Torus_shift_3 operator-(Torus_shift_3 s) { return {-s.code}; }
  friend bool operator==(Torus_shift_3 s, Torus_shift_3 t) { return s.code == t.code; }
  friend bool operator!=(Torus_shift_3 s, Torus_shift_3 t) { return s.code != t.code; }
  // An order that translations keep.
  friend bool operator<(Torus_shift_3 s, Torus_shift_3 t) { return s.code < t.code; }

private:
  static int low_multiple(int n) { return ((n + 512) & 1023) - 512; }
};

using Shifts_3 = Few<Torus_shift_3, 4>;

// The translations by shifts whose multiples are from -4 to 3, nearly all that there are, in a
// table.
class Small_translations_3
{
public:
  // Of the combinations of three vectors, each summed up in this order.
  template <class Vectors>
  void set(const Vectors& vectors)
  {
    for (int i = 0; i < number; ++i)
      m_translations[std::size_t(i)] = double(i % side - side / 2) * vectors[0] +
                                       double(i / side % side - side / 2) * vectors[1] +
                                       double(i / side / side - side / 2) * vectors[2];
  }

  // The bits of a shift that the table has no place for: 0 if it has the translation. Those of
  // several shifts may be joined, and tested once.
  BOOST_FORCEINLINE static int bits_beyond_table(Torus_shift_3 shift)
  {
    return (shift.code + middle) & ~table;
  }
  BOOST_FORCEINLINE static bool has(Torus_shift_3 shift) { return bits_beyond_table(shift) == 0; }
  // The place of one that it has. Without branches, so that several may be found at once.
  BOOST_FORCEINLINE static unsigned place(unsigned code)
  {
    const unsigned c = code + unsigned(middle);
    return (c & low) | (c >> (10 - bits) & low << bits) | (c >> 2 * (10 - bits) & low << 2 * bits);
  }
  BOOST_FORCEINLINE const Position_3& at(unsigned place) const { return m_translations[place]; }
  BOOST_FORCEINLINE const Position_3& of(Torus_shift_3 shift) const
  {
    return at(place(unsigned(shift.code)));
  }

private:
  static constexpr int bits = 3, side = 1 << bits, number = side * side * side;
  static constexpr unsigned low = side - 1;
  // Of codes of shifts, to which `middle` is added, these bits count in the table.
  static constexpr int middle = side / 2 * (1 + (1 << 10) + (1 << 20));
  static constexpr int table = int(low) * (1 + (1 << 10) + (1 << 20));

  std::array<Position_3, number> m_translations;
};

// An image of a vertex; or one of the two points at infinity of a slab, above or below it, which
// are sites of the infinite vertex. A wire has one such point, all around it: that of `above()`.
struct Torus_site_3
{
  static Torus_site_3 above() { return {Vertex_index(infinite_index), {Torus_shift_3::beyond}}; }
  static Torus_site_3 below() { return {Vertex_index(infinite_index), {-Torus_shift_3::beyond}}; }

  Vertex_index vertex;
  Torus_shift_3 shift;

  bool is_infinite() const { return vertex == infinite_index; }
  bool is_above() const { return shift.code > 0; } // if it is infinite

  // The image by a translation, which leaves points at infinity where they are.
  friend Torus_site_3 operator+(const Torus_site_3& s, Torus_shift_3 translation)
  {
    return {s.vertex, s.is_infinite() ? s.shift : s.shift + translation};
  }
  friend Torus_site_3 operator-(const Torus_site_3& s, Torus_shift_3 translation)
  {
    return s + -translation;
  }

  friend bool operator==(const Torus_site_3& a, const Torus_site_3& b)
  {
    return a.vertex == b.vertex && a.shift == b.shift;
  }
  friend bool operator<(const Torus_site_3& a, const Torus_site_3& b)
  {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.shift < b.shift;
  }
};

using Torus_sites_3 = Few<Torus_site_3, 4>;

// The place of the site at infinity, or 4.
inline int infinite_place(const Torus_sites_3& s)
{
  int place = 0;
  while (place < 4 && !s[place].is_infinite())
    ++place;
  return place;
}

// The hull facet of an infinite cell, counterclockwise as seen from the point at infinity.
using Torus_facet_3 = Few<Torus_site_3, 3>;

inline Torus_facet_3 hull_facet(const Torus_sites_3& s, int infinite)
{
  const auto site = [&](int n) { return s[(infinite + n) % 4]; };
  return infinite % 2 == 0 ? Torus_facet_3{site(1), site(3), site(2)}
                           : Torus_facet_3{site(1), site(2), site(3)};
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_SHIFT_3_H
