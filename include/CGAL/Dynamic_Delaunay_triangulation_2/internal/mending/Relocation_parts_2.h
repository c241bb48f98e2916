// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_RELOCATION_PARTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_RELOCATION_PARTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Point_location_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Spatial_parts_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Divided_list.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_polygon_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Takes vertices out of a Delaunay triangulation, and puts others in, in parts that threads share.
// A vertex is left if its faces, or those that it replaces, are not all inside of its part, or if
// it is not known how to keep everything Delaunay. The next round has other parts. What few are
// left is for one thread. The result depends on the triangulation and the vertices alone.
template <class State>
class Relocation_parts_2
{
  using Parts = typename State::Parts;
  using Spatial_parts = Spatial_parts_2<State>;
  using Editor = Topology_editor_2<State>;
  using Edit = typename Editor::Edit_of_part;
  using Slot = typename Editor::Slot;
  using Location = Location_2<State>;

public:
  Relocation_parts_2(const State& state, Editor& editor)
    : m_state(state)
    , m_editor(editor)
  {
  }

  // Whether threads would gain by sharing so many vertices.
  bool are_worth(std::size_t vertices) const
  {
    const std::size_t parts = number();
    return State::predicates_are_exact && parts >= Parts::least_shared &&
           vertices > parts * (Parts::usual_size / 1024);
  }

  // Takes vertices out, and keeps in the list those that are left: take_out(edit, polygon) does it
  // for one. Appends to `taken`, which must have the memory.
  template <class Take_out>
  void take_out(std::vector<Vertex_index>& vertices, std::vector<Slot>& taken,
                const Take_out& take_out)
  {
    const auto position = [this](Vertex_index v) {
      return m_state.position_in_order(m_state.positions()[v]);
    };
    const auto work = [&](const Spatial_parts& parts, std::size_t part, Edit& edit,
                          Vertex_index v) {
      Part& mine = m_parts[part];
      if (!parts.has_star(part, v) || !mine.polygon.read(m_state, v))
        return false;
      m_editor.prefetch(mine.polygon);
      if (!mine.polygon.triangulate_as_delaunay(m_state))
        return false;
      mine.taken.push_back(take_out(edit, mine.polygon));
      return true;
    };
    run(
        vertices, taken, position, [](const Spatial_parts&) {}, work);
  }

  // Puts in the vertices of slots, and keeps in the list the numbers of those that are left. `slot`
  // (null if another is to put it in) and `position`, as in State::position_in_order(), are
  // functions of these numbers, which are sorted along the curve; put(edit, i, polygon) puts one
  // in. `anywhere` is any vertex in a face. Returns the steps of all walks.
  template <class Slot_of, class Position_of, class Put>
  std::size_t put_in(std::vector<Index>& numbers, const Slot_of& slot, const Position_of& position,
                     Vertex_index anywhere, const Put& put)
  {
    Index spread = 0;
    const auto begin = [&](const Spatial_parts& parts) {
      spread = Index(4 * m_state.number_of_vertices() / numbers.size());
      Parts::run(number(), [&](std::size_t part) {
        m_parts[part].steps += find_start(parts, part, numbers, slot, anywhere);
      });
    };
    const auto put_in = [&](const Spatial_parts& parts, std::size_t part, Edit& edit, Index i) {
      Part& mine = m_parts[part];
      const auto is_free = [&](Vertex_index w) { return parts.has_vertex(part, w); };
      const Slot* const s = slot(i);
      if (mine.nearby == null_index || s == nullptr)
        return false;
      const Location_hint_2 hint = nearer_hint(m_state, s->vertex, {mine.nearby, spread}, is_free);
      const Location location = locate_vertex(m_state, s->vertex, hint, is_free);
      mine.steps += location.steps;
      if (location.face == null_index || !location.is_inside ||
          !mine.polygon.find_as_delaunay(m_state, location.face, location.chart, s->vertex,
                                         most_faces, is_free))
        return false;
      mine.nearby = m_state.arrays().apex(Halfedge_arrays_2::halfedge_in(location.face, 0));
      mine.polygon.add(*s);
      m_editor.prefetch(mine.polygon);
      put(edit, i, mine.polygon);
      return true;
    };
    std::vector<Slot> none;
    run(numbers, none, position, begin, put_in);
    std::size_t steps = 0;
    for (const Part& part : m_parts)
      steps += part.steps;
    return steps;
  }

private:
  static constexpr unsigned max_rounds = 3;
  static constexpr std::size_t most_faces = 64; // that a vertex replaces

  struct Part
  {
    std::vector<Index> left; // places in the list of those that come or go
    std::vector<Slot> taken; // of those that it has taken out
    Star_polygon_2<State> polygon;
    Vertex_index nearby = null_index; // where the next walk starts
    std::size_t steps = 0;
  };

  std::size_t number() const
  {
    const std::size_t faces = m_state.arrays().number_of_faces();
    return (std::min)(Parts::number(faces), Spatial_parts::max_number);
  }

  // Calls work(parts, part, edit, element) for all elements of the list, in parts and some rounds.
  // Keeps those for which it returns false. Calls begin(parts) before each round.
  template <class Element, class Position_of, class Begin, class Work>
  void run(std::vector<Element>& list, std::vector<Slot>& taken, const Position_of& position,
           const Begin& begin, const Work& work)
  {
    m_parts.resize((std::max)(number(), m_parts.size()));
    for (Part& part : m_parts) {
      part.left.clear(); // an exception may have left some
      part.steps = 0;
    }
    // what is left is known to be near borders, and takes longer
    for (unsigned round = 0;
         round < max_rounds && are_worth(round == 0 ? list.size() : 2 * list.size()); ++round) {
      m_positions.resize(list.size());
      Parts::for_each_element(list.size(), Parts::size_for(8),
                              [&](std::size_t i) { m_positions[i] = position(list[i]); });
      const Spatial_parts parts(m_state, m_positions, number(), round);
      m_places.template divide<Parts>(
          list.size(), number(), [](std::size_t i) { return Index(i); },
          [&](std::size_t i) { return parts.part_of(m_positions[i]); });
      begin(parts);
      const auto collect = [&] {
        append_lists<Parts>(
            m_parts.size(), [this](std::size_t i) -> const auto& { return m_parts[i].taken; },
            taken);
        for (Part& part : m_parts)
          part.taken.clear();
      };
      try {
        m_editor.edit_in_parts(number(), list.size(), [&](std::size_t part, Edit& edit) {
          Part& mine = m_parts[part];
          const Index* const places = m_places.begin(part);
          const std::size_t size = m_places.size(part);
          mine.taken.reserve(size);
          for (std::size_t i = 0; i < size; ++i) {
            prefetch_ahead(list, places, i, size);
            if (!work(parts, part, edit, list[places[i]]))
              mine.left.push_back(places[i]);
          }
        });
      } catch (...) {
        collect();
        throw;
      }
      collect();
      keep_left(list);
    }
  }

  void prefetch_ahead(const std::vector<Vertex_index>& vertices, const Index* places,
                      std::size_t first, std::size_t number) const
  {
    prefetch_stars(m_state, first, number, [&](std::size_t i) { return vertices[places[i]]; });
  }
  static void prefetch_ahead(const std::vector<Index>&, const Index*, std::size_t, std::size_t) {}

  // Keeps in the list, in its order, what the parts have left.
  template <class Element>
  void keep_left(std::vector<Element>& list)
  {
    m_left.clear();
    for (Part& part : m_parts) {
      m_left.insert(m_left.end(), part.left.begin(), part.left.end());
      part.left.clear();
    }
    std::sort(m_left.begin(), m_left.end());
    for (std::size_t i = 0; i < m_left.size(); ++i)
      list[i] = list[m_left[i]];
    list.resize(m_left.size());
  }

  // Finds a vertex of the part to start from, near the first of those to put in. Returns the steps.
  template <class Slot_of>
  std::size_t find_start(const Spatial_parts& parts, std::size_t part,
                         const std::vector<Index>& numbers, const Slot_of& slot,
                         Vertex_index anywhere)
  {
    constexpr std::size_t tries = 8;
    Part& mine = m_parts[part];
    mine.nearby = null_index;
    std::size_t steps = 0;
    for (std::size_t i = 0; i < (std::min)(tries, m_places.size(part)); ++i) {
      const Slot* const s = slot(numbers[m_places.begin(part)[i]]);
      if (s == nullptr)
        continue;
      const Location location =
          locate_vertex(m_state, s->vertex,
                        nearer_hint(m_state, s->vertex, {anywhere, m_state.number_of_vertices()}));
      steps += location.steps;
      for (const Vertex_index w : m_state.arrays().face(location.face))
        if (parts.has_vertex(part, w))
          mine.nearby = w;
      if (mine.nearby != null_index)
        break;
    }
    return steps;
  }

  const State& m_state;
  Editor& m_editor;
  std::vector<Part> m_parts;
  Position_vector m_positions;  // of the list
  Divided_list<Index> m_places; // in the list
  std::vector<Index> m_left;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_RELOCATION_PARTS_2_H
