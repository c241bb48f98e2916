// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_GUIBAS_STOLFI_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_GUIBAS_STOLFI_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Parallel_parts.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The Delaunay triangulation by divide and conquer (thesis 3.2; L. Guibas and J. Stolfi, ACM
// Transactions on Graphics 4(2), 1985), cut across both axes in turn (R. Dwyer, Algorithmica 2,
// 1987), based on triangles rather than edges (J. Shewchuk's Triangle, 1996).
//
// Each part of the points is a triangulated sphere of its own. It has an infinite face at every
// edge of its hull; if the part lies on a line, one at each side of every edge. So n points have
// 2n - 2 faces at any time. Merging two parts adds two faces, at the common tangents; all others
// keep their places. The half-edge of an infinite face that is opposite to infinity, here called a
// hull edge, runs clockwise along the hull.
//
// Threads share stretches of the order. A stretch in which all cuts have lower ranks than the two
// around it becomes a part of its own before it is merged with another one. Until then the points
// from the i-th to before the j-th have the faces from 2i to before 2j - 2. So stretches touch no
// data of each other, and the result is bit by bit that of a single thread. Small stretches come
// first, then large ones, made of the small ones: the last merges are few, but have long borders.
//
// Cost: O(n log n).
template <class Predicates, class Parts = Parallel_parts<Sequential_tag>>
class Guibas_stolfi_2
{
  using Halfedge = Flat_halfedge_index;

public:
  Guibas_stolfi_2(const Predicates& predicates, Flat_faces_2& faces)
    : m_predicates(predicates)
    , m_faces(faces)
  {
  }

  // Triangulates vertices that are in a spatial order. No two of them may coincide. If threads
  // share the work, one of them calls `companion()`.
  template <class Companion>
  void run(const Spatial_order_2& order, const Companion& companion)
  {
    const std::size_t n = order.size();
    m_has_finite_faces = false;
    const std::size_t faces = n < 2 ? 0 : 2 * n - 2;
    m_faces.reserve(faces);
    m_faces.resize(faces);
    m_stretches.clear();
    if (Parts::are_shared(Parts::number(n)))
      triangulate_stretches(order, companion);
    triangulate(order, 0, n, m_stretches);
    if (!m_has_finite_faces)
      m_faces.resize(0);
  }
  void run(const Spatial_order_2& order)
  {
    run(order, [] {});
  }

private:
  // A single vertex, or two hull edges: after a merge, those at the two tangents.
  struct Part
  {
    Vertex_index vertex;
    Halfedge first_hull_edge, last_hull_edge;

    bool is_single() const { return first_hull_edge == null_index; }
  };

  struct Waiting_part
  {
    Part part;
    Cut_2 cut; // between this part and the next one
    std::size_t beyond;
  };

  struct Stretch
  {
    std::size_t first, beyond;
    Part part;
  };

  // Makes the part of the points from `first` to before `beyond`: all points or a stretch. These
  // stretches have their parts already.
  Part triangulate(const Spatial_order_2& order, std::size_t first, std::size_t beyond,
                   const std::vector<Stretch>& stretches)
  {
    Part part{null_index, null_index, null_index};
    auto stretch = std::lower_bound(stretches.begin(), stretches.end(), first,
                                    [](const Stretch& s, std::size_t i) { return s.first < i; });
    m_waiting.clear();
    for (std::size_t i = first; i < beyond;) {
      if (stretch != stretches.end() && stretch->first == i) {
        part = stretch->part;
        i = stretch++->beyond;
      } else
        part = make_part(order, i);
      while (!m_waiting.empty() && m_waiting.back().cut.rank < rank(order, i)) {
        const Waiting_part& before = m_waiting.back();
        part = merge(before.part, part, before.cut, Face_index(2 * before.beyond - 2));
        m_waiting.pop_back();
      }
      if (i < beyond)
        m_waiting.push_back({part, order.cut(i), i});
    }
    return part;
  }

  // STRETCHES -----------------------------------------------------------------------------------

  template <class Companion>
  void triangulate_stretches(const Spatial_order_2& order, const Companion& companion)
  {
    const std::vector<Index> cuts = high_cuts(order);
    triangulate_stretches(order, find_stretches(order, cuts, order.size() / 64), companion);
    triangulate_stretches(order, find_stretches(order, cuts, order.size() / 8), [] {});
  }

  // Makes the parts of these stretches, which replace those in `m_stretches`.
  template <class Companion>
  void triangulate_stretches(const Spatial_order_2& order, std::vector<Stretch> stretches,
                             const Companion& companion)
  {
    std::atomic<bool> have_finite_faces{m_has_finite_faces};
    Parts::run(stretches.size() + 1, [&](std::size_t i) {
      if (i == 0)
        return companion();
      Stretch& stretch = stretches[i - 1];
      Guibas_stolfi_2 other(m_predicates, m_faces);
      stretch.part = other.triangulate(order, stretch.first, stretch.beyond, m_stretches);
      if (other.m_has_finite_faces)
        have_finite_faces.store(true, std::memory_order_relaxed);
    });
    m_has_finite_faces = have_finite_faces;
    m_stretches.swap(stretches);
  }

  // The points between two cuts, while find_stretches() may still merge them with others.
  struct Open_stretch
  {
    std::size_t first;
    int rank;        // of the cut before the points
    int rank_inside; // the highest rank of a cut at which open stretches were merged to this one
    bool is_divided; // whether the points are too many for a stretch, or some are one already
  };

  // Divides points into stretches of at most about `most` points, at those of the cuts at which
  // parts are merged. As a stretch has at least `least` points, make_part() never joins points on
  // both sides of its borders.
  static std::vector<Stretch> find_stretches(const Spatial_order_2& order,
                                             const std::vector<Index>& cuts, std::size_t most)
  {
    constexpr std::size_t least = 16;
    constexpr int lowest = (std::numeric_limits<int>::min)();
    std::vector<Stretch> stretches;
    const auto close = [&](const Open_stretch& s, std::size_t beyond) {
      if (!s.is_divided && beyond - s.first >= least && s.rank_inside < s.rank)
        stretches.push_back({s.first, beyond, Part()});
    };
    std::vector<Open_stretch> open{{0, rank(order, 0), lowest, false}};
    for (const std::size_t i : cuts) {
      const int next_rank = rank(order, i);
      while (open.back().rank < next_rank) { // the last two are merged
        const Open_stretch right = open.back();
        open.pop_back();
        Open_stretch& left = open.back();
        if (left.is_divided || right.is_divided || i - left.first > most) {
          close(left, right.first);
          close(right, i);
          left.is_divided = true;
        }
        left.rank_inside = right.rank;
      }
      open.push_back({i, next_rank, lowest, false});
    }
    std::sort(stretches.begin(), stretches.end(),
              [](const Stretch& s, const Stretch& t) { return s.first < t.first; });
    return stretches;
  }

  // The cuts between the points at which stretches may begin, and that behind the last point: skips
  // the many of low ranks.
  static std::vector<Index> high_cuts(const Spatial_order_2& order)
  {
    const int least_rank = usually_highest_rank(order);
    std::vector<Index> cuts;
    append_by_parts<Parts>(order.size(), Parts::usual_size, cuts,
                           [&](std::size_t first, std::size_t beyond, std::vector<Index>& some) {
                             for (std::size_t i = first + 1; i <= beyond; ++i)
                               if (rank(order, i) >= least_rank)
                                 some.push_back(Index(i));
                           });
    return cuts;
  }

  // Returns a rank that only about one cut in 128 reaches.
  static int usually_highest_rank(const Spatial_order_2& order)
  {
    std::array<int, 1024> sample;
    for (std::size_t i = 0; i < sample.size(); ++i)
      sample[i] = rank(order, 1 + i * (order.size() - 1) / sample.size());
    const auto place = sample.end() - sample.size() / 128;
    std::nth_element(sample.begin(), place, sample.end());
    return *place;
  }

  // PARTS ---------------------------------------------------------------------------------------

  static Halfedge first_halfedge(Face_index face) { return Flat_faces_2::first_halfedge(face); }
  static Halfedge next(Halfedge h) { return Flat_faces_2::next(h); }
  static Halfedge previous(Halfedge h) { return Flat_faces_2::previous(h); }

  // The hull edge after h in this direction.
  Halfedge clockwise(Halfedge h) const { return next(m_faces.twin(next(h))); }
  Halfedge counterclockwise(Halfedge h) const { return previous(m_faces.twin(previous(h))); }

  static int rank(const Spatial_order_2& order, std::size_t i)
  {
    return i > 0 && i < order.size() ? order.cut(i).rank : (std::numeric_limits<int>::max)();
  }

  static Vertex_index vertex(const Spatial_order_2& order, std::size_t i)
  {
    return Vertex_index(order[i]);
  }

  // Makes a part of the i-th point, and of the next one or two if the cuts between them have lower
  // ranks than the cuts around them. Advances i behind the part.
  Part make_part(const Spatial_order_2& order, std::size_t& i)
  {
    const std::size_t first = i++;
    const int before = rank(order, first), inner = rank(order, i);
    if (i == order.size() || inner > before)
      return Part{vertex(order, first), null_index, null_index};
    const Face_index face(2 * first);
    const int second = rank(order, i + 1);
    if (i + 1 < order.size() &&
        (std::max)(inner, second) < (std::min)(before, rank(order, i + 2)) &&
        make_triangle(vertex(order, first), vertex(order, first + 1), vertex(order, first + 2),
                      face)) {
      i = first + 3;
      return Part{null_index, first_halfedge(face + 1), first_halfedge(face + 3)};
    }
    if (inner > second)
      return Part{vertex(order, first), null_index, null_index};
    i = first + 2;
    return make_edge(vertex(order, first), vertex(order, first + 1), face);
  }

  // Make parts of two and of three points, with an infinite face at every edge.

  Part make_edge(Vertex_index a, Vertex_index b, Face_index face)
  {
    m_faces.set_vertices(face, infinite_index, a, b);
    m_faces.set_vertices(face + 1, infinite_index, b, a);
    const Halfedge h = first_halfedge(face), g = first_halfedge(face + 1);
    m_faces.link(h, g);
    m_faces.link(h + 1, g + 2);
    m_faces.link(h + 2, g + 1);
    return Part{null_index, h, g};
  }

  // False if the points lie on a line.
  bool make_triangle(Vertex_index a, Vertex_index b, Vertex_index c, Face_index face)
  {
    const Orientation turn = m_predicates.orientation(a, b, c);
    if (turn == COLLINEAR)
      return false;
    if (turn == RIGHT_TURN)
      std::swap(b, c);
    const Vertex_index corners[] = {a, b, c};
    m_faces.set_vertices(face, a, b, c);
    for (Index i = 0; i < 3; ++i) {
      const Face_index infinite_face = face + 1 + i, next_infinite_face = face + 1 + (i + 2) % 3;
      m_faces.set_vertices(infinite_face, infinite_index, corners[(i + 2) % 3],
                           corners[(i + 1) % 3]);
      m_faces.link(first_halfedge(face) + i, first_halfedge(infinite_face));
      m_faces.link(first_halfedge(infinite_face) + 1, first_halfedge(next_infinite_face) + 2);
    }
    m_has_finite_faces = true;
    return true;
  }

  // MERGING -------------------------------------------------------------------------------------

  // The gap between two parts. Its lowest edge, `base`, runs from vertex `right` to vertex `left`.
  // The half-edges `left_side`, from `left` to infinity, and `right_side`, from infinity to
  // `right`, have no twins yet. At a horizontal cut, the lower part counts as the left one:
  // everything is turned by a quarter.
  struct Gap
  {
    Vertex_index left, right;
    Halfedge base, left_side, right_side;
  };

  Part merge(Part left, Part right, const Cut_2& cut, Face_index new_face)
  {
    if (cut.is_descending)
      std::swap(left, right);
    Gap gap = open(left, right, cut.is_horizontal, new_face);
    close(gap);
    m_faces.set_vertices(new_face + 1, infinite_index, gap.left, gap.right);
    const Halfedge h = first_halfedge(new_face + 1);
    m_faces.link(h, gap.base);
    m_faces.link(h + 1, gap.right_side);
    m_faces.link(h + 2, gap.left_side);
    return Part{null_index, first_halfedge(new_face), h};
  }

  // Finds the lower tangent, and puts an infinite face below it.
  Gap open(const Part& left, const Part& right, bool is_horizontal, Face_index face)
  {
    Vertex_index l = left.vertex,
                 r = right.vertex; // and from_l, to_r: the hull edges from l and to r
    Halfedge from_l = null_index, to_r = null_index;
    if (!left.is_single()) {
      from_l = extreme(left, is_horizontal, LARGER);
      l = m_faces.source(from_l);
    }
    if (!right.is_single()) {
      to_r = counterclockwise(extreme(right, is_horizontal, SMALLER));
      r = m_faces.target(to_r);
    }
    for (bool has_moved = true; has_moved;) {
      has_moved = false;
      while (from_l != null_index && is_right_turn(l, r, m_faces.target(from_l))) {
        l = m_faces.target(from_l);
        from_l = clockwise(from_l);
        has_moved = true;
      }
      while (to_r != null_index && is_right_turn(l, r, m_faces.source(to_r))) {
        r = m_faces.source(to_r);
        to_r = counterclockwise(to_r);
        has_moved = true;
      }
    }
    m_faces.set_vertices(face, infinite_index, r, l);
    const Halfedge h = first_halfedge(face);
    Gap gap{l, r, h, h + 1, h + 2};
    if (from_l != null_index) {
      gap.left_side = m_faces.twin(previous(from_l));
      m_faces.link(h + 1, previous(from_l));
    }
    if (to_r != null_index) {
      gap.right_side = m_faces.twin(next(to_r));
      m_faces.link(h + 2, next(to_r));
    }
    return gap;
  }

  bool is_right_turn(Vertex_index a, Vertex_index b, Vertex_index c) const
  {
    return m_predicates.orientation(a, b, c) == RIGHT_TURN;
  }

  // The hull edge from the part's rightmost vertex (LARGER) or leftmost one (SMALLER); for a
  // horizontal cut, the uppermost or lowest one. The search climbs along the hull, from the farther
  // of the part's two hull edges. A convex curve has one summit, as the other coordinate breaks
  // ties.
  Halfedge extreme(const Part& part, bool is_horizontal, Comparison_result sense) const
  {
    const auto is_farther = [&](Vertex_index v, Vertex_index w) {
      return (is_horizontal ? m_predicates.compare_yx(v, w) : m_predicates.compare_xy(v, w)) ==
             sense;
    };
    Halfedge h = part.first_hull_edge;
    if (is_farther(m_faces.source(part.last_hull_edge), m_faces.source(h)))
      h = part.last_hull_edge;
    if (is_farther(m_faces.target(h), m_faces.source(h))) {
      do
        h = clockwise(h);
      while (is_farther(m_faces.target(h), m_faces.source(h)));
    } else {
      for (Halfedge g = counterclockwise(h); is_farther(m_faces.source(g), m_faces.source(h));
           g = counterclockwise(h))
        h = g;
    }
    return h;
  }

  // Fills the gap with faces, from the base up to the upper tangent.
  void close(Gap& gap)
  {
    for (;;) {
      const bool has_left = is_above(gap, m_faces.apex(gap.left_side));
      const bool has_right = is_above(gap, m_faces.apex(gap.right_side));
      if (has_left)
        remove_left_edges(gap);
      if (has_right)
        remove_right_edges(gap);
      if (!has_left && !has_right)
        return;
      m_has_finite_faces = true;
      if (!has_left ||
          (has_right && is_inside(gap, m_faces.apex(gap.left_side), m_faces.apex(gap.right_side))))
        take_right(gap);
      else
        take_left(gap);
    }
  }

  bool is_above(const Gap& gap, Vertex_index v) const
  {
    return v != gap.left && v != gap.right &&
           m_predicates.orientation(gap.left, gap.right, v) == LEFT_TURN;
  }

  // Whether w is inside the circle through the base and v.
  bool is_inside(const Gap& gap, Vertex_index v, Vertex_index w) const
  {
    return m_predicates.side_of_circle(gap.left, gap.right, v, w) == ON_POSITIVE_SIDE;
  }

  // The face behind the hull edge from v to `left` is (left, v, w). While w is inside the circle
  // through the base and v, removes the edge: both its faces become infinite ones.
  void remove_left_edges(Gap& gap)
  {
    for (;;) {
      const Halfedge h = previous(gap.left_side), g = m_faces.twin(h);
      const Vertex_index v = m_faces.apex(gap.left_side), w = m_faces.apex(g);
      if (w == infinite_index || !is_inside(gap, v, w))
        return;
      m_faces.link(h, m_faces.twin(next(g)));
      m_faces.set_apex(previous(h), w);
      m_faces.set_apex(previous(g), infinite_index);
      m_faces.link(next(g), next(h));
      gap.left_side = g;
    }
  }

  void remove_right_edges(Gap& gap)
  {
    for (;;) {
      const Halfedge h = next(gap.right_side), g = m_faces.twin(h);
      const Vertex_index v = m_faces.apex(gap.right_side), w = m_faces.apex(g);
      if (w == infinite_index || !is_inside(gap, v, w))
        return;
      m_faces.link(h, m_faces.twin(previous(g)));
      m_faces.set_apex(next(h), w);
      m_faces.set_apex(next(g), infinite_index);
      m_faces.link(previous(g), previous(h));
      gap.right_side = g;
    }
  }

  // The infinite face at the hull edge on the left becomes (right, v, left).
  void take_left(Gap& gap)
  {
    const Vertex_index v = m_faces.apex(gap.left_side);
    const Halfedge h = previous(gap.left_side);
    m_faces.set_apex(h, gap.right);
    m_faces.link(gap.left_side, gap.base);
    gap.base = previous(h);
    gap.left_side = m_faces.twin(gap.base);
    gap.left = v;
  }

  void take_right(Gap& gap)
  {
    const Vertex_index v = m_faces.apex(gap.right_side);
    const Halfedge h = next(gap.right_side);
    m_faces.set_apex(h, gap.left);
    m_faces.link(gap.right_side, gap.base);
    gap.base = next(h);
    gap.right_side = m_faces.twin(gap.base);
    gap.right = v;
  }

  Predicates m_predicates;
  Flat_faces_2& m_faces;
  std::vector<Waiting_part> m_waiting;
  std::vector<Stretch> m_stretches;
  bool m_has_finite_faces = false;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_GUIBAS_STOLFI_2_H
