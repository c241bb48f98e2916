// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_TRANSLATIONS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_TRANSLATIONS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_shift_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>

#include <array>
#include <cstddef>
#include <map>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

inline Periodic_shift_3 sum(const Periodic_shift_3& s, const Periodic_shift_3& t)
{
  return {s[0] + t[0], s[1] + t[1], s[2] + t[2]};
}
inline Periodic_shift_3 difference(const Periodic_shift_3& s, const Periodic_shift_3& t)
{
  return {s[0] - t[0], s[1] - t[1], s[2] - t[2]};
}

// How shifts are named anew since begin(): points may be given at other images, as by wrapping them
// into the cell, and other vectors may stand for the same lattice. What had the shift s then, an
// image of point i, has the shift s L + t(i) now; the rows of L are what the former vectors are in
// the present ones; of a slab the third one is (0, 0, 1).
class Torus_translations_3
{
public:
  using Rows = std::array<Periodic_shift_3, 3>;

  bool is_on() const { return m_is_on; }
  void begin()
  {
    m_of_points.clear();
    m_rows = unit_rows();
    m_is_on = true;
  }
  void end()
  {
    m_of_points.clear();
    m_is_on = false;
  }

  // The cell of one torus has given way to that of another one, with the basis in its place.
  void exchange_cell(const Torus_3& from, const Torus_3& to)
  {
    Rows rows = unit_rows();
    for (std::size_t k = 0; k < std::size_t(from.dimension()); ++k) {
      const std::array<double, 3>& v = from.cell().vector(k);
      rows[k] = to.in_vectors_of_cell(Torus_3::nearest(from.fractions({v[0], v[1], v[2]})));
    }
    for (Periodic_shift_3& row : m_rows)
      row = product(row, rows);
    for (auto& [id, translation] : m_of_points)
      translation = product(translation, rows);
  }
  void translate(Point_id id, const Periodic_shift_3& translation)
  {
    if (translation != Periodic_shift_3{0, 0, 0}) {
      Periodic_shift_3& all = m_of_points[id];
      all = sum(all, translation);
    }
  }

  Periodic_shift_3 now(Point_id id, const Periodic_shift_3& shift) const
  {
    const Periodic_shift_3 turned = product(shift, m_rows);
    const auto at = m_of_points.find(id);
    return at == m_of_points.end() ? turned : sum(turned, at->second);
  }

  bool has_exchanged_cell() const { return m_rows != unit_rows(); }
  const Rows& rows() const { return m_rows; }
  // By ids, after the exchange of the cell.
  const std::map<Point_id, Periodic_shift_3>& of_points() const { return m_of_points; }

private:
  static Rows unit_rows() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }
  static Periodic_shift_3 product(const Periodic_shift_3& s, const Rows& rows)
  {
    Periodic_shift_3 result{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        result[i] += s[k] * rows[k][i];
    return result;
  }

  bool m_is_on = false;
  Rows m_rows = unit_rows();
  std::map<Point_id, Periodic_shift_3> m_of_points;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_TRANSLATIONS_3_H
