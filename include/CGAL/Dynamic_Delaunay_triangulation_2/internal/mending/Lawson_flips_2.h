// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_LAWSON_FLIPS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_LAWSON_FLIPS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Spatial_parts_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Divided_list.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_parts_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Lawson's flips, started from some edges. Every edge that a flip touches is examined again. So an
// edge that is not returned as open was examined after the last change around it, and is proved.
class Lawson_flips_2
{
public:
  // Flips from the edges of `open`, and leaves in `open` the edges that it could not prove. Returns
  // the number of flips, at most `most`. If the faces tile the convex hull, or the torus
  // (`faces_tile_hull`), flips of illegal edges preserve that, and need no search for doubled
  // edges: no edge crosses the inside of a flip's quadrilateral. The search takes a sixth of the
  // time of a flip; on a torus of 100,000 points that go 0.01 spacings, a quarter of an update.
  template <class State, class Editor>
  std::size_t run(const State& state, Editor& editor, std::vector<Edge_index>& open,
                  bool faces_tile_hull, std::size_t most)
  {
    // Lawson's proof of termination needs counterclockwise faces; with inverted ones, flips can
    // cycle. Recorded motion took at most 3 flips per initial edge.
    const std::size_t limit = (std::min)(100 + 20 * open.size(), most);
    m_work.not_flippable.clear();
    std::size_t flips = 0;
    const auto vertex = [&](std::size_t i) {
      const Edge_2& edge = state.arrays().edge(open[i]);
      return edge.source == infinite_index ? edge.target : edge.source;
    };
    work_in_divisions(
        state, [&] { return open.size(); }, vertex,
        [&](const Topology_parts_2& topology) {
          flips += run_in_parts(state, editor, topology, open, faces_tile_hull, limit - flips);
        });
    flips += run_in_series(state, editor, open, faces_tile_hull, limit - flips);
    if (!m_work.not_flippable.empty()) {
      open.insert(open.end(), m_work.not_flippable.begin(), m_work.not_flippable.end());
      keep_unproved(state, open);
    }
    return flips;
  }

  // Flips from a few edges whose data are in the cache and whose test may have changed, where the
  // faces tile the convex hull or the torus. Appends to `open` the edges that it could not prove.
  template <class State, class Editor>
  std::size_t run_nearby(const State& state, Editor& editor, const std::vector<Edge_index>& edges,
                         std::vector<Edge_index>& open, std::size_t most)
  {
    m_work.clear();
    const auto flip = [&](Halfedge_index h) {
      editor.flip(h);
      return true;
    };
    typename State::Edge_test(state).append_unproved(edges, m_work.touched);
    flip_touched(state, (std::min)(100 + 20 * m_work.touched.size(), most), flip, m_work);
    return collect(m_work, open, open);
  }

  // Calls work(part, flip) for all parts, which threads share. It may move vertices whose stars are
  // inside of the part, if all faces stay counterclockwise; then it calls flip(edges) with the
  // edges whose test that may have changed. Appends to `open` what flips inside of parts did not
  // prove. Returns the number of flips.
  template <class State, class Editor, class Function>
  std::size_t run_beside(const State& state, Editor& editor, const Topology_parts_2& topology,
                         std::size_t most, const Function& work, std::vector<Edge_index>& open)
  {
    clear_parts(topology.number());
    const std::size_t share = most / topology.number();
    editor.flip_in_parts(topology, true, most, [&](std::size_t part, const auto& try_flip) {
      work(part, [&](const std::vector<Edge_index>& edges) {
        typename State::Edge_test(state).append_unproved(edges, m_parts[part].touched);
        flip_touched(state, share, try_flip, m_parts[part]);
      });
    });
    return collect_parts(topology.number(), open, open);
  }

  // Flips around v, which was put into a face; where only in a Delaunay triangulation the next
  // vertex can be located, as long as that helps. Leaves in `open` the edges that it could not
  // prove.
  template <class State, class Editor>
  std::size_t run_around(const State& state, Editor& editor, Vertex_index v,
                         std::vector<Edge_index>& open, std::size_t most)
  {
    open.clear();
    state.arrays().for_each_edge_that_sees(v, [&](Edge_index e) { open.push_back(e); });
    std::size_t more = run(state, editor, open, false, most), flips = more;
    for (; !State::can_locate_anywhere && more > 0 && !open.empty(); flips += more)
      more = run(state, editor, open, false, most);
    return flips;
  }

private:
  // `touched` are the edges to examine again, `open` and `not_flippable` the edges that were not
  // proved. `not_flippable` edges need no second try: no flip elsewhere makes them flippable, and a
  // flip beside them examines them again.
  struct Work
  {
    std::vector<Edge_index> touched, sides, open, not_flippable;
    std::size_t flips = 0;

    // What an exception has left of the last run goes, too.
    void clear()
    {
      for (std::vector<Edge_index>* edges : {&touched, &open, &not_flippable})
        edges->clear();
      flips = 0;
    }
  };

  template <class State, class Editor>
  std::size_t run_in_series(const State& state, Editor& editor, std::vector<Edge_index>& open,
                            bool faces_tile_hull, std::size_t limit)
  {
    std::size_t flips = 0;
    const auto try_flip = [&](Halfedge_index h) {
      const bool is_right = faces_tile_hull || editor.can_flip(h);
      if (is_right)
        editor.flip(h);
      return is_right;
    };
    for (std::size_t before = limit; !open.empty() && flips != before;) {
      before = flips;
      flip_from_seeds(state, open.data(), open.data() + open.size(), limit - flips, try_flip,
                      m_work);
      open.swap(m_work.open);
      flips += m_work.flips;
      keep_unproved(state, open);
    }
    return flips;
  }

  // Flips edges that are inside of a part; threads share the parts. Leaves all other edges in
  // `open`. The parts, and so the result, depend on the triangulation and `open` alone.
  template <class State, class Editor>
  std::size_t run_in_parts(const State& state, Editor& editor, const Topology_parts_2& topology,
                           std::vector<Edge_index>& open, bool faces_tile_hull, std::size_t limit)
  {
    const std::size_t seeds = open.size();
    divide<typename State::Parts>(topology, open);
    editor.flip_in_parts(topology, faces_tile_hull, limit,
                         [&](std::size_t part, const auto& try_flip) {
                           const std::size_t share = limit * m_seeds.size(part) / seeds;
                           flip_from_seeds(state, m_seeds.begin(part), m_seeds.end(part), share,
                                           try_flip, m_parts[part]);
                         });
    return collect_parts(topology.number(), open, m_work.not_flippable);
  }

  // Begins with empty parts.
  void clear_parts(std::size_t parts)
  {
    m_parts.resize((std::max)(parts, m_parts.size()));
    for (Work& part : m_parts)
      part.clear();
  }

  // Appends what is left open. Return the number of flips.
  static std::size_t collect(const Work& work, std::vector<Edge_index>& open,
                             std::vector<Edge_index>& not_flippable)
  {
    open.insert(open.end(), work.open.begin(), work.open.end());
    not_flippable.insert(not_flippable.end(), work.not_flippable.begin(), work.not_flippable.end());
    return work.flips;
  }
  std::size_t collect_parts(std::size_t parts, std::vector<Edge_index>& open,
                            std::vector<Edge_index>& not_flippable) const
  {
    std::size_t flips = 0;
    for (std::size_t part = 0; part < parts; ++part)
      flips += collect(m_parts[part], open, not_flippable);
    return flips;
  }

  // Moves the edges inside of a part to its seeds; the others remain.
  template <class Parts>
  void divide(const Topology_parts_2& topology, std::vector<Edge_index>& edges)
  {
    const std::size_t none = topology.number();
    clear_parts(none);
    m_seeds.divide<Parts>(edges, none + 1, [&](std::size_t i) {
      topology.prefetch_some(edges, i);
      const std::size_t part = topology.part_of(edges[i]);
      return topology.is_inside(part, edges[i]) ? part : none;
    });
    edges.assign(m_seeds.begin(none), m_seeds.end(none));
  }

  // Does at most `limit` flips. Examines touched edges at once, while they are in the cache.
  template <class State, class Try_flip>
  static void flip_from_seeds(const State& state, const Edge_index* seeds, const Edge_index* beyond,
                              std::size_t limit, const Try_flip& try_flip, Work& work)
  {
    work.open.clear();
    work.touched.clear(); // an exception may have ended the last run
    work.flips = 0;
    for (std::ptrdiff_t i = 0; seeds != beyond; ++seeds, ++i) {
      if (i % stretch == 0)
        prefetch_stretch(state, seeds, seeds + (std::min)(stretch, beyond - seeds));
      work.touched.push_back(*seeds);
      flip_touched(state, limit, try_flip, work);
    }
  }

  // Examines the touched edges, and those that flips touch. What the limit has left is open.
  template <class State, class Try_flip>
  static void flip_touched(const State& state, std::size_t limit, const Try_flip& try_flip,
                           Work& work)
  {
    while (!work.touched.empty() && work.flips < limit) {
      const Edge_index e = work.touched.back();
      work.touched.pop_back();
      work.flips += examine(state, e, try_flip, work);
    }
    work.open.insert(work.open.end(), work.touched.begin(), work.touched.end());
    work.touched.clear();
  }

  // Flips e if that may help and is possible. Otherwise lists e in `work`, unless it is Delaunay.
  template <class State, class Try_flip>
  static bool examine(const State& state, Edge_index e, const Try_flip& try_flip, Work& work)
  {
    const Edge_state_2 verdict = typename State::Edge_test(state).state(e);
    if (verdict == Edge_state_2::DELAUNAY)
      return false;
    const auto& arrays = state.arrays();
    if (verdict == Edge_state_2::NOT_FLIPPABLE || !try_flip(arrays.halfedge(e))) {
      (verdict == Edge_state_2::NOT_FLIPPABLE ? work.not_flippable : work.open).push_back(e);
      return false;
    }
    // An illegal edge has a convex quadrilateral, so the new diagonal is Delaunay. Other diagonals
    // are examined for the repair. The proof does not need this: the determinant is minus that of
    // the old diagonal, so they are Delaunay as soon as their sides and so their faces are proved.
    if (verdict == Edge_state_2::INVERTED)
      work.touched.push_back(e);
    std::size_t sides = 0;
    work.sides.resize(4);
    arrays.for_each_side(e, [&](Edge_index side) { work.sides[sides++] = side; });
    typename State::Edge_test(state).append_unproved(work.sides, work.touched);
    return true;
  }

  // The data of the next seeds are scattered over the memory. They are fetched in steps, each of
  // which reads what the one before has fetched. At 10^5 points this saves two thirds of the time
  // of a flip, at 1,000 with other work between the frames a fifth of it. The last step fetches the
  // positions needed to examine the sides of the new diagonal.
  template <class State>
  static void prefetch_stretch(const State& state, const Edge_index* first,
                               const Edge_index* beyond)
  {
    const auto& arrays = state.arrays();
    const Position_2* const positions = state.positions().data();
    const auto for_each_seed = [&](const auto& f) { std::for_each(first, beyond, f); };
    for_each_seed([&](Edge_index e) { arrays.prefetch_edge(e); });
    for_each_seed([&](Edge_index e) {
      arrays.prefetch_face_at(e);
      prefetch_corners(arrays.edge(e), positions);
    });
    for_each_seed([&](Edge_index e) { arrays.prefetch_face_beyond(e); });
    for_each_seed([&](Edge_index e) { arrays.prefetch_around(e); });
    for_each_seed([&](Edge_index e) {
      arrays.for_each_side(e, [&](Edge_index side) {
        prefetch(positions + arrays.edge(side).left);
        prefetch(positions + arrays.edge(side).right);
      });
    });
  }

  static constexpr std::ptrdiff_t stretch = 16; // seeds that are fetched together

  Work m_work;
  std::vector<Work> m_parts;
  Divided_list<Edge_index> m_seeds; // of the parts
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_LAWSON_FLIPS_2_H
