// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_LAWSON_FLIPS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_LAWSON_FLIPS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/accepts_inexact_predicates_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Processor_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Lawson's flips, started from some edges. Every edge that a flip touches is examined again. So an
// edge that is not returned as open was examined after the last change around it, and is proved.
class Lawson_flips_2
{
public:
  // Flips from the edges of `open`, and leaves those in `open` that it could not prove. Returns the
  // number of flips, at most `most`. If the faces tile the convex hull (`faces_tile_hull`), flips
  // of illegal edges preserve that, and need no search for doubled edges, which takes a sixth of
  // their time.
  template <class Maintained, class Editor>
  std::size_t run(const Maintained& maintained, Editor& editor, std::vector<Index>& open,
                  bool faces_tile_hull, std::size_t most)
  {
    // Lawson's proof of termination needs counterclockwise faces; with inverted ones, flips can
    // cycle. Recorded motion took at most 3 flips per initial edge.
    const std::size_t limit = (std::min)(100 + 20 * open.size(), most);
    const bool prefetches = maintained.positions().size() >= min_vertices_to_prefetch;
    std::size_t flips = 0;
    m_touched.clear(); // an exception may have ended the last run
    editor.flip_in_series([&](const auto& flip) {
      const auto try_flip = [&](Index h) {
        const bool is_right = faces_tile_hull || editor.can_flip(h);
        if (is_right)
          flip(h);
        return is_right;
      };
      for (std::size_t before = limit; !open.empty() && flips != before;) {
        before = flips;
        m_seeds.swap(open);
        open.clear();
        for (std::size_t i = 0; i < m_seeds.size(); ++i) {
          if (prefetches && i % stretch == 0)
            prefetch_stretch(maintained, i);
          flips += flip_from(maintained, m_seeds[i], limit - flips, try_flip, open);
        }
        keep_unproved(maintained, open);
      }
    });
    return flips;
  }

  // Flips around vertex v, which was put into a face of a Delaunay triangulation. Returns whether
  // everything is Delaunay again, and adds the number of flips, at most `most`. If not, nothing is
  // known of the edges around v: it is not strictly inside of a finite face, or `most` was reached.
  //
  // Only edges opposite to v can be illegal (C. Lawson 1977; Guibas and Stolfi 1985). An edge from
  // v to w comes into being when a face with corner w that was Delaunay before is divided or
  // flipped away, and v is strictly inside of its circle: inside of that face, or beyond an illegal
  // edge. The circle through v that touches this one in w from inside contains no other vertex, so
  // the edge is Delaunay in every triangulation with v. All other faces stay Delaunay. Faces are
  // counterclockwise all the time, and those around v surround it once, so no two edges go from v
  // in the same direction, and no flip doubles an edge. Predicates that are rounded promise
  // nothing.
  template <class Maintained, class Editor>
  bool run_around(const Maintained& maintained, Editor& editor, Index v, std::size_t most,
                  std::size_t& flips)
  {
    const auto& mirror = maintained.mirror();
    const typename Maintained::Edge_test test(maintained);
    bool is_inside = true;
    m_touched.clear();
    mirror.for_each_corner(v, [&](Index h) {
      const Index e = mirror.edge_of(h);
      const bool is_finite =
          mirror.source(h) != infinite_index && mirror.target(h) != infinite_index;
      const Edge_state_2 state = is_finite ? test.state(e) : Edge_state_2::TWISTED;
      is_inside &= state == Edge_state_2::DELAUNAY || state == Edge_state_2::ILLEGAL;
      if (state == Edge_state_2::ILLEGAL)
        m_touched.push_back(e);
    });
    if (!is_inside)
      return false;
    constexpr bool is_rounded = Are_known_to_be_inexact_2<typename Maintained::Traits>::value;
    const auto can_flip = [&](Index e) {
      return !is_rounded || editor.can_flip(mirror.halfedge(e));
    };
    editor.flip_in_series([&](const auto& flip) {
      for (; !m_touched.empty() && most > 0 && can_flip(m_touched.back()); --most, ++flips) {
        const Index h = mirror.halfedge(m_touched.back());
        const Index beyond = mirror.apex(h) == v ? mirror.twin(h) : h;
        m_touched.pop_back();
        const std::array<Index, 2> opposite{
            mirror.edge_of(Neighborhood_mirror_2::next(beyond)),
            mirror.edge_of(Neighborhood_mirror_2::previous(beyond))};
        flip(h);
        for (const Index e : opposite)
          if (test.state(e) == Edge_state_2::ILLEGAL)
            m_touched.push_back(e);
      }
    });
    return m_touched.empty();
  }

private:
  // Examines touched edges at once, while they are in the cache. Does at most `limit` flips.
  template <class Maintained, class Try_flip>
  std::size_t flip_from(const Maintained& maintained, Index seed, std::size_t limit,
                        const Try_flip& try_flip, std::vector<Index>& open)
  {
    std::size_t flips = 0;
    m_touched.push_back(seed);
    while (!m_touched.empty() && flips < limit) {
      const Index e = m_touched.back();
      m_touched.pop_back();
      flips += examine(maintained, e, try_flip, open);
    }
    open.insert(open.end(), m_touched.begin(), m_touched.end());
    m_touched.clear();
    return flips;
  }

  // Flips e if a flip may help and is possible. Otherwise adds e to `open`, unless it is Delaunay.
  template <class Maintained, class Try_flip>
  bool examine(const Maintained& maintained, Index e, const Try_flip& try_flip,
               std::vector<Index>& open)
  {
    const Edge_state_2 state = typename Maintained::Edge_test(maintained).state(e);
    if (state == Edge_state_2::DELAUNAY)
      return false;
    const auto& mirror = maintained.mirror();
    if (state == Edge_state_2::TWISTED || !try_flip(mirror.halfedge(e))) {
      open.push_back(e);
      return false;
    }
    // Between counterclockwise faces the quadrilateral is convex, and the new diagonal Delaunay.
    // Elsewhere the repair has to know of it. The proof does not: its determinant is minus that of
    // the old diagonal, so it is Delaunay as soon as its faces, and thus its sides, are proved.
    if (state == Edge_state_2::CROSSED)
      m_touched.push_back(e);
    mirror.for_each_side(e, [this](Index side) { m_touched.push_back(side); });
    return true;
  }

  // The data of the next seeds are scattered over the memory. They are fetched in steps, each of
  // which reads what the one before has fetched. At 10^5 points this saves two thirds of the time
  // of a flip. The last step fetches the positions needed to examine the sides of the new diagonal.
  template <class Maintained>
  void prefetch_stretch(const Maintained& maintained, std::size_t first) const
  {
    const auto& mirror = maintained.mirror();
    const Position_2* const positions = maintained.positions().data();
    const auto for_each_seed = [&](const auto& f) {
      const std::size_t beyond = (std::min)(first + stretch, m_seeds.size());
      for (std::size_t i = first; i < beyond; ++i)
        f(m_seeds[i]);
    };
    for_each_seed([&](Index e) { mirror.prefetch_edge(e); });
    for_each_seed([&](Index e) {
      mirror.prefetch_face_at(e);
      prefetch_corners(mirror.edge(e), positions);
    });
    for_each_seed([&](Index e) { mirror.prefetch_face_beyond(e); });
    for_each_seed([&](Index e) { mirror.prefetch_around(e); });
    for_each_seed([&](Index e) {
      mirror.for_each_side(e, [&](Index side) {
        prefetch(positions + mirror.edge(side).left);
        prefetch(positions + mirror.edge(side).right);
      });
    });
  }

  // Removes open edges that a later flip has made Delaunay.
  template <class Maintained>
  static void keep_unproved(const Maintained& maintained, std::vector<Index>& open)
  {
    make_distinct(open);
    const typename Maintained::Edge_test test(maintained);
    open.erase(std::remove_if(open.begin(), open.end(),
                              [&](Index e) { return test.state(e) == Edge_state_2::DELAUNAY; }),
               open.end());
  }

  static constexpr std::size_t stretch = 16; // seeds that are fetched together

  std::vector<Index> m_seeds;   // the edges to start from
  std::vector<Index> m_touched; // to be examined again
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_LAWSON_FLIPS_2_H
