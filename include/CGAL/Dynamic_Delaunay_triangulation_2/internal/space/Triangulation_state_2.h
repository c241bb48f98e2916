// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_TRIANGULATION_STATE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_TRIANGULATION_STATE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Parallel_parts.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Space_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Change_log_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>
#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What an update works on: a space, which has the topology and the positions of its vertices, with
// the ids of the points, the log of changes, and the calls of the user's visitor.
//
// Everything can be read. What is written goes through a `Writer`, which takes a state that is not
// constant: only the interface has one, and gives it to the editor, the builder and the input.
template <class Space_, class ConcurrencyTag>
class Triangulation_state_2 : public Space_
{
public:
  using Space = Space_;
  using Point = typename Space::Point;
  using Ids = Point_ids_2<Point>;
  using Editing = typename Space::template Editing<Triangulation_state_2>;
  using Builder = typename Space::template Builder<Triangulation_state_2>;
  using Visitor_calls = typename Space::Visitor_calls;

  // How passes are divided. Passes over lazy numbers, which several points may share, are left to
  // one thread.
  using Parts = Parallel_parts<
      std::conditional_t<Space::coordinates_are_doubles, ConcurrencyTag, Sequential_tag>>;

  explicit Triangulation_state_2(const typename Space::Argument& argument)
    : Space(argument)
  {
    static_assert(is_space<Space>());
    m_ids.reset(0);
  }

  const Ids& ids() const { return m_ids; }
  const Change_log_2& changes() const { return m_changes; }

  // The present point with this id.
  Point point_of_id(Point_id id) const
  {
    return m_ids.is_representative(id) ? this->point(m_ids.vertex(id)) : m_ids.covered_point(id);
  }
  // The id of the point at a corner: of the representative, if points coincide.
  Point_id id_at(Halfedge_index corner) const
  {
    return m_ids.representative(this->arrays().apex(corner));
  }

  // All that can be written.
  class Writer : public Space::Writer
  {
  public:
    explicit Writer(Triangulation_state_2& state)
      : Space::Writer(state)
      , m_state(state)
    {
    }

    Ids& ids() const { return m_state.m_ids; }
    Change_log_2& changes() const { return m_state.m_changes; }
    Visitor_calls& visitor_calls() const { return m_state.m_visitor_calls; }

  private:
    Triangulation_state_2& m_state;
  };

private:
  Ids m_ids;
  Change_log_2 m_changes;
  Visitor_calls m_visitor_calls;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_TRIANGULATION_STATE_2_H
