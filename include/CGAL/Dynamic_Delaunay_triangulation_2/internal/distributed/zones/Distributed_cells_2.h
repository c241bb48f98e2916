// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_CELLS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_CELLS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_image_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The cells of the Delaunay complex of all points that have an owned corner. The corners of a cell
// are all points on one empty circle; the rank holds all of them. Each cell is cut by diagonals
// from the corner with the smallest id; of several images of that point, from the leftmost, lowest
// one. So all ranks cut a cell alike, wherever it is in a periodic space. Of points that coincide,
// the one with the smallest id, their *label*, stands for all of them.
template <class Points>
class Distributed_cells_2
{
  using Arrays = Halfedge_arrays_2;

public:
  using Id = Distributed_id_2;

  explicit Distributed_cells_2(const Points& points)
    : m_points(points)
    , m_frame(points.dt().frame())
    , m_are_owned(points.owned_vertices())
  {
    find_labels();
    find_inner_edges();
  }

  // The place of the label of a held point.
  Index label(Index place) const { return m_labels[m_frame.vertex(place)]; }

  // Calls f(i, j) with the places of the labels at both ends, that of the smaller id first: once
  // for each edge with an owned end, and at most once for other edges of these cells.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    if (m_frame.number_of_faces() == 0) {
      m_points.dt().for_each_edge([&](std::size_t i, std::size_t j) {
        const auto [first, second] = ordered(label(Index(i)), label(Index(j)));
        f(first, second);
      });
      return;
    }
    for_each_cell([&](const std::vector<Corner>& corners, std::size_t apex) {
      const std::size_t n = corners.size();
      for (std::size_t k = 0; k < n; ++k) {
        const Index a = corners[k].label, b = corners[(k + 1) % n].label;
        const auto [first, second] = ordered(a, b);
        if (a == first || corners[k].is_on_hull)
          f(first, second);
        if (k >= 2 && k + 1 < n)
          f(corners[apex].label, corners[(apex + k) % n].label);
      }
    });
  }

  // Calls f(i, j, k) with the places of the labels of each face of these cells, counterclockwise,
  // the one with the smallest id of the cell first.
  template <class Function>
  void for_each_face(const Function& f) const
  {
    for_each_cell([&](const std::vector<Corner>& corners, std::size_t apex) {
      const std::size_t n = corners.size();
      for (std::size_t k = 1; k + 1 < n; ++k)
        f(corners[apex].label, corners[(apex + k) % n].label, corners[(apex + k + 1) % n].label);
    });
  }

private:
  struct Corner
  {
    Index label;
    bool is_on_hull; // whether the edge to the next corner is on the hull
  };

  bool comes_first(Index a, Index b) const
  {
    const auto key = [&](Index place) {
      return std::make_tuple(m_points.id(place), m_points.point(place).x(),
                             m_points.point(place).y());
    };
    return key(a) < key(b);
  }
  std::pair<Index, Index> ordered(Index a, Index b) const
  {
    return comes_first(a, b) ? std::make_pair(a, b) : std::make_pair(b, a);
  }

  void find_labels()
  {
    m_labels.assign(m_frame.number_of_vertices() + std::size_t(1), null_index);
    m_points.for_each_held([&](Index place) {
      Index& label = m_labels[m_frame.vertex(place)];
      if (label == null_index || m_points.id(place) < m_points.id(label))
        label = place;
    });
  }

  // An edge is inner if its ends and the corners to its left and right are on one circle.
  void find_inner_edges()
  {
    m_are_inner.assign(m_frame.number_of_edges(), false);
    std::vector<Edge_index> unproved;
    m_frame.append_unproved(0, m_frame.number_of_edges(), unproved);
    const Vertex_predicates_2<std::decay_t<decltype(m_frame.state())>> predicates(m_frame.state());
    for (const Edge_index e : unproved)
      if (!m_frame.is_at_infinity(e)) {
        const auto& edge = m_frame.edge(e);
        m_are_inner[e] = predicates.side_of_circle(edge.left, edge.source, edge.target,
                                                   edge.right) == ON_ORIENTED_BOUNDARY;
      }
  }

  // Calls f(corners, apex) for each cell: its corners, counterclockwise, and the index of the one
  // from which the cell is cut.
  template <class Function>
  void for_each_cell(const Function& f) const
  {
    const Arrays& arrays = m_frame.state().arrays();
    std::vector<bool> are_seen(m_frame.number_of_faces(), false);
    std::vector<Corner> corners;
    for (Face_index face(0); face < m_frame.number_of_faces(); ++face) {
      const std::array<Vertex_index, 3> v = m_frame.face(face);
      if (are_seen[face] || std::find(v.begin(), v.end(), infinite_index) != v.end())
        continue;
      const auto outward = [&](Halfedge_index h) {
        are_seen[Arrays::face_of(h)] = true;
        while (m_are_inner[arrays.edge_of(h)]) {
          h = Arrays::next(arrays.twin(h));
          are_seen[Arrays::face_of(h)] = true;
        }
        return h;
      };
      corners.clear();
      bool has_owned = false;
      const Halfedge_index first = outward(Arrays::halfedge_in(face, 0));
      Halfedge_index h = first;
      do {
        const Vertex_index a = arrays.source(h);
        has_owned = has_owned || m_are_owned[a];
        corners.push_back({m_labels[a], arrays.apex(arrays.twin(h)) == infinite_index});
        h = outward(Arrays::next(h));
      } while (h != first);
      if (!has_owned)
        continue;
      const auto apex =
          std::min_element(corners.begin(), corners.end(), [&](const Corner& a, const Corner& b) {
            return comes_first(a.label, b.label);
          });
      f(corners, std::size_t(apex - corners.begin()));
    }
  }

  const Points& m_points;
  typename Points::Dynamic::Frame m_frame;
  std::vector<std::uint8_t> m_are_owned; // by vertices
  Column<Vertex_index, Index> m_labels;
  std::vector<bool> m_are_inner; // by edges
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_CELLS_2_H
