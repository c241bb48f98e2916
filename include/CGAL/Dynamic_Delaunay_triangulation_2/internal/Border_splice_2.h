// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BORDER_SPLICE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BORDER_SPLICE_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Index_set_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Patch_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Static_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Topology_editor_2.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

enum class Splice_result_2 { DONE, TOO_LARGE, COINCIDENCE };

// The border splice (thesis 4.1.3 and 4.1.4): the Triangulation set, which is the Classified set,
// its padding and one layer of border, is triangulated alone, and the faces of that triangulation
// around Classified and Padded replace the old ones.
//
// That is right only if both sets of faces have the same boundary, edge for edge (the thesis's open
// problem: an edge could go missing). It is checked before anything is written; where the
// boundaries differ, their vertices join the padding and the region is triangulated again. All
// clusters of classified vertices go into one triangulation.
template <class Maintained>
class Border_splice_2
{
  using Mirror = Neighborhood_mirror_2;
  using Static_triangulation = Static_triangulation_2<typename Maintained::Traits>;

public:
  explicit Border_splice_2(const typename Maintained::Traits& traits)
    : m_static(traits)
  {
  }

  // Splices around `classified` with `padding` layers. `growths` counts the times that the region
  // grew.
  Splice_result_2 run(const Maintained& maintained, Topology_editor_2<Maintained>& editor,
                      const std::vector<Index>& classified, unsigned padding, std::size_t& growths)
  {
    m_inner.clear(maintained.vertices.size());
    for (const Index v : classified)
      m_inner.insert(v);
    m_number_of_classified = m_inner.size();
    for (unsigned layer = 0; layer < padding; ++layer)
      add_layer(maintained);
    for (;; ++growths) {
      find_border(maintained);
      // from half of all points on, a fresh triangulation of the whole costs less
      if (2 * (m_inner.size() + m_border.size()) > maintained.number_of_vertices())
        return Splice_result_2::TOO_LARGE;
      collect_old_faces(maintained);
      if (!triangulate(maintained))
        return Splice_result_2::COINCIDENCE;
      collect_new_faces();
      if (boundaries_agree() && !doubles_an_edge(maintained.mirror)) {
        find_outside(maintained);
        editor.replace(m_old_faces, m_new, m_outside);
        return Splice_result_2::DONE;
      }
      grow();
    }
  }

  // The sets of the last run, the padding with all that it grew.
  std::size_t number_of_padded() const { return m_inner.size() - m_number_of_classified; }
  std::size_t number_of_border() const { return m_border.size(); }
  const Index_set_2& border() const { return m_border; }
  Index padded(std::size_t i) const { return m_inner[m_number_of_classified + i]; }

  // Calls f(e) for every edge of the spliced region, its boundary included.
  template <class Function>
  void for_each_edge(const Mirror& mirror, Function&& f) const
  {
    for (const Index face : m_old_faces)
      for (Index h = 3 * face; h < 3 * face + 3; ++h)
        if (h < mirror.twin(h) || !m_old_faces.contains(mirror.twin(h) / 3))
          f(mirror.edge_of(h));
  }

private:
  // SETS ----------------------------------------------------------------------------------------

  void add_layer(const Maintained& maintained)
  {
    const std::size_t size = m_inner.size();
    for (std::size_t i = 0; i < size; ++i)
      maintained.mirror.for_each_neighbor(m_inner[i], [&](Index w) {
        if (w != infinite_index)
          m_inner.insert(w);
      });
  }

  void find_border(const Maintained& maintained)
  {
    m_border.clear(maintained.vertices.size());
    for (const Index v : m_inner)
      maintained.mirror.for_each_neighbor(v, [&](Index w) {
        if (w != infinite_index && !m_inner.contains(w))
          m_border.insert(w);
      });
  }

  // The vertices where the two boundaries differ join the padding; if the boundaries have the same
  // edges and yet do not fit, the whole border does.
  void grow()
  {
    const std::size_t size = m_inner.size();
    for (const Index v : m_disagreeing)
      if (v != infinite_index)
        m_inner.insert(v);
    if (m_inner.size() == size)
      for (const Index v : m_border)
        m_inner.insert(v);
  }

  // FACES ---------------------------------------------------------------------------------------

  void collect_old_faces(const Maintained& maintained)
  {
    const Mirror& mirror = maintained.mirror;
    m_old_faces.clear(mirror.number_of_faces());
    for (const Index v : m_inner)
      mirror.for_each_corner(v, [&](Index h) { m_old_faces.insert(h / 3); });
    m_old.clear();
    // of an old face among the old faces: not initialized, as few of the others are ever touched
    const std::unique_ptr<Index[]> place(new Index[mirror.number_of_faces()]);
    for (Index k = 0; k < Index(m_old_faces.size()); ++k)
      place[m_old_faces[k]] = k;
    for (const Index f : m_old_faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = mirror.twin(h);
        m_old.apexes.push_back(mirror.apex(h));
        m_old.twins.push_back(m_old_faces.contains(g / 3) ? 3 * place[g / 3] + g % 3 : no_index);
      }
    m_old.find_boundary();
  }

  // False if two of the points coincide: then a vertex would be lost.
  bool triangulate(const Maintained& maintained)
  {
    m_order.assign(m_inner.begin(), m_inner.end());
    m_order.insert(m_order.end(), m_border.begin(), m_border.end());
    std::sort(m_order.begin(), m_order.end()); // the vertices are numbered along the plane
    m_static.clear();
    m_static_inner.clear();
    bool are_apart = true;
    for_each_in_rounds(m_order.size(), [&](std::size_t i) {
      const Index v = m_order[i];
      const auto [vertex, is_new] = m_static.insert(maintained.point(v), v);
      are_apart = are_apart && is_new;
      if (m_inner.contains(v))
        m_static_inner.push_back(vertex);
    });
    return are_apart;
  }

  void collect_new_faces()
  {
    m_new.clear();
    m_new_faces.clear();
    const auto& triangulation = m_static.triangulation();
    if (triangulation.dimension() < 2)
      return;
    for (auto f = m_static.faces().begin(); f != m_static.faces().end(); ++f)
      f->info() = no_index;
    for (const auto& v : m_static_inner) {
      auto f = triangulation.incident_faces(v);
      const auto first = f;
      do
        if (f->info() == no_index) {
          f->info() = Index(m_new_faces.size());
          m_new_faces.push_back(f);
        }
      while (++f != first);
    }
    for (const auto& f : m_new_faces)
      for (int i = 0; i < 3; ++i) {
        const auto g = f->neighbor(i);
        m_new.apexes.push_back(f->vertex(i)->info());
        m_new.twins.push_back(g->info() == no_index ? no_index
                                                    : 3 * g->info() + Index(g->index(f)));
      }
    m_new.find_boundary();
  }

  // BOUNDARIES ----------------------------------------------------------------------------------

  // Equal boundary edges, and at each boundary vertex equal fans of faces between them, make the
  // result a closed surface; an equal number of faces makes it a sphere again.
  bool boundaries_agree()
  {
    find_disagreeing();
    return m_disagreeing.empty() && m_old.number_of_faces() == m_new.number_of_faces() &&
           std::equal(m_old.boundary.begin(), m_old.boundary.end(), m_new.boundary.begin(),
                      [this](const Boundary_edge_2& a, const Boundary_edge_2& b) {
                        return m_old.other_end_of_fan(a) == m_new.other_end_of_fan(b);
                      });
  }

  void find_disagreeing()
  {
    m_disagreeing.clear();
    const auto note = [this](const Boundary_edge_2& edge) {
      m_disagreeing.push_back(edge.source);
      m_disagreeing.push_back(edge.target);
    };
    auto a = m_old.boundary.begin(), b = m_new.boundary.begin();
    while (a != m_old.boundary.end() || b != m_new.boundary.end())
      if (b == m_new.boundary.end() || (a != m_old.boundary.end() && *a < *b))
        note(*a++);
      else if (a == m_old.boundary.end() || *b < *a)
        note(*b++);
      else
        ++a, ++b;
  }

  // Whether the new faces join two vertices of the border, across the region, that are joined
  // outside already: possible only where old faces overlap. Those vertices then count as
  // disagreeing.
  bool doubles_an_edge(const Mirror& mirror)
  {
    for (Index h = 0; h < Index(m_new.twins.size()); ++h) {
      const Index v = m_new.apexes[Mirror::next(h)], w = m_new.apexes[Mirror::previous(h)];
      if (m_new.twins[h] != no_index && v < w && !m_inner.contains(v) && !m_inner.contains(w) &&
          is_edge_outside(mirror, w, v)) {
        m_disagreeing.push_back(v);
        m_disagreeing.push_back(w);
      }
    }
    return !m_disagreeing.empty();
  }

  // Walks around v, which must be finite.
  bool is_edge_outside(const Mirror& mirror, Index v, Index w) const
  {
    bool is_outside = false;
    mirror.for_each_corner(v, [&](Index h) {
      const Index beyond = mirror.twin(Mirror::previous(h));
      is_outside =
          is_outside || (mirror.apex(Mirror::next(h)) == w &&
                         !(m_old_faces.contains(h / 3) && m_old_faces.contains(beyond / 3)));
    });
    return is_outside;
  }

  void find_outside(const Maintained& maintained)
  {
    m_outside.clear();
    for (const Boundary_edge_2& edge : m_old.boundary) {
      const Index h = 3 * m_old_faces[edge.halfedge / 3] + edge.halfedge % 3;
      m_outside.push_back(maintained.mirror.twin(h));
    }
  }

  Static_triangulation m_static;
  std::vector<typename Static_triangulation::Vertex_handle> m_static_inner;
  std::vector<typename Static_triangulation::Face_handle> m_new_faces;
  Index_set_2 m_inner; // Classified, then Padded
  Index_set_2 m_border;
  std::size_t m_number_of_classified = 0;
  std::vector<Index> m_order;
  Index_set_2 m_old_faces;
  Patch_2 m_old, m_new;
  std::vector<Index> m_outside;
  std::vector<Index> m_disagreeing;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BORDER_SPLICE_2_H
