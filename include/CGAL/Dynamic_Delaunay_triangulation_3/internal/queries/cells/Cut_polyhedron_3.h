// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_CUT_POLYHEDRON_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_CUT_POLYHEDRON_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Cell_measures_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_sites_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The area of a facet, and that area times its centroid.
struct Measured_facet_3
{
  double area;
  Position_3 moment;
};

// A convex polyhedron that planes cut. Its facets are cycles of corners; each edge is in two of
// them, in opposite directions. A cut decides once for each corner whether it stays, takes what
// stays of each cycle, and closes the surface with facets around the gap. So the surface is closed
// after every cut, however corners near to the plane are rounded: they are off the plane by a few
// roundings of the extent, and so are the volumes.
class Cut_polyhedron_3
{
public:
  static constexpr std::size_t walls = 6; // labels from 0 on

  // Makes it a box; walls have the labels 2i and 2i + 1 at the lower and upper end of axis i.
  void start_box(const Position_3& low, const Position_3& high)
  {
    m_corners.clear();
    for (int i = 0; i < 8; ++i)
      m_corners.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    static constexpr Index cycles[walls][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                               {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    m_cycles.clear();
    m_facets.clear();
    for (std::size_t wall = 0; wall < walls; ++wall) {
      m_cycles.insert(m_cycles.end(), cycles[wall], cycles[wall] + 4);
      m_facets.push_back({wall, m_cycles.size()});
    }
  }

  bool is_empty() const { return m_facets.empty(); }
  void clear() { m_facets.clear(); }

  // Keeps what is not beyond the plane, in the direction of its normal.
  void cut(const Plane_3& plane, std::size_t label)
  {
    if (is_empty())
      return;
    m_heights.clear();
    for (const Position_3& p : m_corners)
      m_heights.push_back(dot(plane.normal, p) - plane.distance);
    const auto goes = [](double height) { return height > 0; };
    if (std::none_of(m_heights.begin(), m_heights.end(), goes))
      return;
    if (std::all_of(m_heights.begin(), m_heights.end(), goes))
      return clear();
    renumber_corners();
    cut_facets();
    close(label);
    m_corners.swap(m_new_corners);
    m_cycles.swap(m_new_cycles);
    m_facets.swap(m_new_facets);
  }

  // Measures a polyhedron that is not empty. Adds the area of each facet to facets[label], and that
  // area times its centroid.
  Cell_measures_3 measure(std::vector<Measured_facet_3>& facets) const
  {
    Cell_measures_3 sum;
    const Position_3& origin = m_corners.front();
    Position_3 moment{0, 0, 0}; // 24 times the volume times the vector from that corner
    for_each_facet([&](std::size_t label, const Index* first, const Index* beyond) {
      const Position_3 apex = m_corners[*first] - origin;
      for (const Index* i = first + 1; i + 1 < beyond; ++i) {
        const Position_3 p = m_corners[i[0]] - origin, q = m_corners[i[1]] - origin;
        const double volume = dot(apex, cross(p, q));
        sum.volume += volume;
        moment = moment + volume * (apex + p + q);
      }
      const Measured_facet_3 facet = measured_facet(first, beyond);
      facets[label].area += facet.area;
      facets[label].moment = facets[label].moment + facet.moment;
      sum.surface += facet.area;
    });
    if (sum.volume > 0)
      sum.centroid = clamped(origin + (0.25 / sum.volume) * moment);
    sum.volume = (std::max)(sum.volume / 6, 0.0);
    return sum;
  }

private:
  struct Facet
  {
    std::size_t label, end; // its cycle ends there, where the next one begins
  };
  // A corner that a cut makes on an edge.
  struct Crossing
  {
    Index stays, goes, corner, next; // next in the cycle around the gap
  };

  template <class Function>
  void for_each_facet(const Function& f) const
  {
    std::size_t begin = 0;
    for (const Facet& facet : m_facets) {
      f(facet.label, m_cycles.data() + begin, m_cycles.data() + facet.end);
      begin = facet.end;
    }
  }

  // A polygon is the sum of triangles with signs.
  Measured_facet_3 measured_facet(const Index* first, const Index* beyond) const
  {
    const Position_3& apex = m_corners[*first];
    const auto for_each_triangle = [&](const auto& f) {
      for (const Index* i = first + 1; i + 1 < beyond; ++i)
        f(m_corners[i[0]] - apex, m_corners[i[1]] - apex);
    };
    Position_3 doubled{0, 0, 0}; // a vector
    for_each_triangle(
        [&](const Position_3& p, const Position_3& q) { doubled = doubled + cross(p, q); });
    const double length = std::sqrt(squared_length(doubled));
    Measured_facet_3 facet{length / 2, (length / 2) * apex};
    if (length > 0)
      for_each_triangle([&](const Position_3& p, const Position_3& q) {
        facet.moment = facet.moment + (dot(cross(p, q), doubled) / (6 * length)) * (p + q);
      });
    return facet;
  }

  void renumber_corners()
  {
    m_numbers.assign(m_corners.size(), null_index);
    m_new_corners.clear();
    for (std::size_t i = 0; i < m_corners.size(); ++i)
      if (m_heights[i] <= 0) {
        m_numbers[i] = Index(m_new_corners.size());
        m_new_corners.push_back(m_corners[i]);
      }
  }
  bool stays(Index corner) const { return m_numbers[corner] != null_index; }

  void cut_facets()
  {
    m_crossings.clear();
    m_new_cycles.clear();
    m_new_facets.clear();
    for_each_facet([this](std::size_t label, const Index* first, const Index* beyond) {
      const std::size_t before = m_new_cycles.size();
      Index open = null_index, unmatched = null_index; // crossings
      for (const Index* i = first; i != beyond; ++i) {
        const Index from = *i, to = i + 1 != beyond ? i[1] : *first;
        if (stays(from))
          m_new_cycles.push_back(m_numbers[from]);
        if (stays(from) == stays(to))
          continue;
        const Index n = stays(from) ? crossing(from, to) : crossing(to, from);
        m_new_cycles.push_back(m_crossings[n].corner);
        if (stays(from))
          open = n;
        else if (open == null_index)
          unmatched = n;
        else
          m_crossings[n].next = std::exchange(open, null_index);
      }
      if (unmatched != null_index)
        m_crossings[unmatched].next = open;
      if (m_new_cycles.size() > before)
        m_new_facets.push_back({label, m_new_cycles.size()});
    });
  }

  // The number of the crossing between two corners. Few edges cross a plane.
  Index crossing(Index staying, Index going)
  {
    for (Index n = 0; n < m_crossings.size(); ++n)
      if (m_crossings[n].stays == staying && m_crossings[n].goes == going)
        return n;
    const double s = -m_heights[staying], t = m_heights[going];
    m_crossings.push_back({staying, going, Index(m_new_corners.size()), null_index});
    m_new_corners.push_back(m_corners[staying] +
                            (s / (s + t)) * (m_corners[going] - m_corners[staying]));
    return Index(m_crossings.size() - 1);
  }

  // Closes each cycle of the gap by a facet.
  void close(std::size_t label)
  {
    for (Crossing& start : m_crossings) {
      if (start.next == null_index)
        continue;
      for (Crossing* crossing = &start; crossing->next != null_index;) {
        m_new_cycles.push_back(crossing->corner);
        crossing = &m_crossings[std::exchange(crossing->next, null_index)];
      }
      m_new_facets.push_back({label, m_new_cycles.size()});
    }
  }

  // The closest place in the range of the corners: that of a centroid, but for rounding.
  Position_3 clamped(const Position_3& p) const
  {
    Position_3 low = m_corners.front(), high = low;
    for (const Position_3& q : m_corners) {
      low = {(std::min)(low.x, q.x), (std::min)(low.y, q.y), (std::min)(low.z, q.z)};
      high = {(std::max)(high.x, q.x), (std::max)(high.y, q.y), (std::max)(high.z, q.z)};
    }
    return {(std::min)((std::max)(p.x, low.x), high.x), (std::min)((std::max)(p.y, low.y), high.y),
            (std::min)((std::max)(p.z, low.z), high.z)};
  }

  std::vector<Position_3> m_corners, m_new_corners;
  std::vector<Index> m_cycles, m_new_cycles; // of all facets, one after the other
  std::vector<Facet> m_facets, m_new_facets;
  std::vector<double> m_heights; // of the corners above the plane
  std::vector<Index> m_numbers;  // of the corners that stay
  std::vector<Crossing> m_crossings;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_CUT_POLYHEDRON_3_H
