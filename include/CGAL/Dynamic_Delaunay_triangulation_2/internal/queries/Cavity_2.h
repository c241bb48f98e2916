// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_CAVITY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_CAVITY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The faces whose circles contain a place, and the border around them: a point inserted there
// would replace these faces. The place must be inside of the hull, and at no vertex. Then the faces
// form a tree, and all of their corners are on the border.
template <class State>
class Cavity_2
{
  using Arrays = Halfedge_arrays_2;
  using Frame = typename State::Frame;

public:
  using Corner = typename State::Corner;

  // `places` are those of the corners in the border; the border's size can stand for 0.
  struct Face
  {
    std::array<Corner, 3> corners;
    std::array<std::size_t, 3> places;
  };

  const Kept_list_2<Face>& faces() const { return m_faces; }
  // Counterclockwise.
  const Kept_list_2<Corner>& border() const { return m_border; }

  // Begins with face f, which contains the place, boundary included; `frame` is as seen from there.
  void find(const State& state, Face_index f, const Frame& frame)
  {
    m_faces.clear();
    m_border.clear();
    Face face;
    for (Index i = 0; i < 3; ++i) {
      const Halfedge_index side = Arrays::halfedge_in(f, (i + 2) % 3); // begins at corner i
      face.corners[i] = state.corner_in(Arrays::halfedge_in(f, i), frame);
      face.places[i] = m_border.size();
      go_around(state, side, frame);
    }
    m_faces.push_back(face);
  }

private:
  // A face that was entered across `halfedge`, one of its own, from a face with `outer_frame`.
  struct Entry
  {
    Halfedge_index halfedge;
    Frame frame, outer_frame;
    std::size_t begin, middle; // the places of the half-edge's target and apex
  };

  // Lists the border beyond half-edge h of a face in the cavity, from its source to before its
  // target, and the faces up to there.
  void go_around(const State& state, Halfedge_index h, Frame frame)
  {
    for (;;) {
      const Halfedge_index entry = state.arrays().twin(h);
      const Frame beyond = state.frame_beyond(h, frame);
      if (is_in_cavity(state, entry, beyond)) {
        m_entries.push_back({entry, beyond, frame, m_border.size(), 0});
        h = Arrays::next(entry);
        frame = beyond;
        continue;
      }
      m_border.push_back(state.corner_in(Arrays::next(h), frame));
      while (!m_entries.empty() && h == Arrays::previous(m_entries.back().halfedge)) {
        h = state.arrays().twin(m_entries.back().halfedge);
        frame = m_entries.back().outer_frame;
        leave(state, m_entries.back());
        m_entries.pop_back();
      }
      if (m_entries.empty())
        return;
      m_entries[m_entries.size() - 1].middle = m_border.size();
      h = Arrays::previous(m_entries.back().halfedge);
    }
  }

  void leave(const State& state, const Entry& entry)
  {
    const Halfedge_index h = entry.halfedge;
    m_faces.push_back(
        {{state.corner_in(h, entry.frame), state.corner_in(Arrays::next(h), entry.frame),
          state.corner_in(Arrays::previous(h), entry.frame)},
         {entry.middle, m_border.size(), entry.begin}});
  }

  static bool is_in_cavity(const State& state, Halfedge_index h, const Frame& frame)
  {
    const Face_index f = Arrays::face_of(h);
    if (state.is_outside(f))
      return false;
    const auto corner = [&](Index i) { return state.corner_in(Arrays::halfedge_in(f, i), frame); };
    return state.side_of_circle(corner(0), corner(1), corner(2), State::corner_of(null_index)) ==
           ON_POSITIVE_SIDE;
  }

  Kept_list_2<Face> m_faces;
  Kept_list_2<Corner> m_border;
  Kept_list_2<Entry> m_entries;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_CAVITY_2_H
