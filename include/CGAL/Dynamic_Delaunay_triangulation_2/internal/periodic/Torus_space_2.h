// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_SPACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_SPACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_slacks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_visitor_calls_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_cover_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Writable_positions_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Writable_halfedge_arrays_2.h>

#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <class State>
class Torus_editing_2;
template <class State>
class Torus_builder_2;

// The exact predicates on sites.
template <class Space>
class Site_predicates_2
{
public:
  using Site = Periodic_site_2;

  explicit Site_predicates_2(const Space& space)
    : m_space(space)
  {
  }

  Orientation orientation(const Site& a, const Site& b, const Site& c) const
  {
    return m_space.torus().orientation(m_space.image(a), m_space.image(b), m_space.image(c));
  }

  // The side of d of the circle through a, b and c, which must be counterclockwise.
  Oriented_side side_of_circle(const Site& a, const Site& b, const Site& c, const Site& d) const
  {
    return m_space.torus().side_of_circle(m_space.image(a), m_space.image(b), m_space.image(c),
                                          m_space.image(d));
  }

  bool coincide(const Site& a, const Site& b) const
  {
    return m_space.torus().coincide(m_space.image(a), m_space.image(b));
  }

private:
  const Space& m_space;
};

// A flat torus, or a slab: the topology of a triangulation of it, the positions of its vertices,
// and what the kernel asks about them. The faces are those in one sheet, however few the points
// are.
//
// Each corner of a face, a half-edge with its apex, has a *shift*. Translated by the shifts of a
// face, its three vertices are the corners of one triangle in the plane. Each face has a chart of
// its own: its first corner has no shift. Along an edge, the charts of both faces differ by a
// translation, which follows from their shifts.
//
// An edge may go from a vertex to an image of the same vertex, and several may connect two
// vertices. There is no infinite vertex. If the four corners of an edge have the same shift, the
// arrays show the edge as in the plane, and the pass over the edges can test it there. Otherwise
// the arrays show only infinite vertices, and the pass of the plane never proves the edge.
template <class Point_>
class Torus_space_2
{
public:
  using Point = Point_;
  using Positions = Positions_2<Point>;
  using Argument = Periodic_cell_2; // from what an empty space is made

  using Predicates = Site_predicates_2<Torus_space_2>;
  using Edge_test = Periodic_edge_test_2<Torus_space_2>;
  using Slacks = Periodic_slacks_2;
  template <class State>
  using Editing = Torus_editing_2<State>;
  template <class State>
  using Builder = Torus_builder_2<State>;
  using Visitor_calls = Periodic_visitor_calls_2;

  static constexpr bool is_periodic = true;
  static constexpr Vertex_index first_vertex = infinite_index + 1; // in the arrays

  static constexpr bool has_hull = false;
  static constexpr bool can_splice = false;          // a region may meet images of itself
  static constexpr bool can_locate_anywhere = false; // only where all is Delaunay

  static constexpr std::size_t min_vertices = 1;
  // The number of vertices in the plane whose rebuild costs as much, where mending costs the same.
  // A rebuild takes twice the plane's time, but mending is dearer, too. In a slab a rebuild takes
  // five times as long as on a torus, and far longer where points are few.
  std::size_t rebuilt_vertices() const
  {
    const std::size_t vertices = number_of_vertices();
    return m_torus.cell().is_slab() ? 7 * vertices : vertices * 4 / 3;
  }

  // A star may have many images of few vertices, as across the gap of a slab, where flips may be
  // impossible.
  static constexpr std::size_t max_degree_to_divide = std::size_t(-1);

  static constexpr bool coordinates_are_doubles = true;
  static constexpr bool predicates_are_exact = true;

  explicit Torus_space_2(const Periodic_cell_2& cell)
    : m_torus(cell)
    , m_points(1)
    , m_positions(m_points)
  {
  }
  Torus_space_2(const Torus_space_2&) = delete;
  Torus_space_2& operator=(const Torus_space_2&) = delete;

  const Argument& argument() const { return m_torus.cell(); }
  const Torus_2& torus() const { return m_torus; }
  const Halfedge_arrays_2& arrays() const { return m_arrays; }
  const Position_vector& positions() const { return m_positions.positions(); }
  Index number_of_vertices() const { return Index(m_points.size()) - 1; }
  // There are faces as soon as there is a vertex.
  bool spans_plane() const { return number_of_vertices() > 0; }

  const Periodic_shift_2& shift(Halfedge_index corner) const { return m_shifts[corner]; }
  Image_2 image(Halfedge_index corner) const { return image(corner, positions()); }
  // The image if the vertices have these positions.
  Image_2 image(Halfedge_index corner, const Position_vector& positions) const
  {
    return {positions[m_arrays.apex(corner)], m_shifts[corner]};
  }

  // Returns the shift of corner `other` as seen from `corner`, in the same face.
  Periodic_shift_2 shift_between(Halfedge_index corner, Halfedge_index other) const
  {
    return m_shifts[other] - m_shifts[corner];
  }
  bool are_across(Halfedge_index corner, Halfedge_index other) const
  {
    return m_torus.are_across(m_shifts[corner], m_shifts[other]);
  }
  // Whether there is a gap, beside a slab, and whether a face is in it, between the slab's sides.
  bool has_gap() const { return m_torus.cell().is_slab(); }
  bool is_in_gap(Face_index f) const
  {
    const auto [h, i, k] = Halfedge_arrays_2::halfedges_of(f);
    return are_across(h, i) || are_across(h, k);
  }

  // None: also the faces in the gap have an orientation.
  static bool is_infinite_face(Face_index) { return false; }

  // Whether h is on a side of a slab, and its face is not in the gap.
  bool is_hull_edge(Halfedge_index h) const
  {
    using Arrays = Halfedge_arrays_2;
    return has_gap() && !is_in_gap(Arrays::face_of(h)) &&
           is_in_gap(Arrays::face_of(m_arrays.twin(h)));
  }

  // Returns what must be added to a shift in the face beyond h to get it in the face of h.
  Periodic_shift_2 transition(Halfedge_index h) const
  {
    using Arrays = Halfedge_arrays_2;
    return m_shifts[Arrays::next(h)] - m_shifts[Arrays::previous(m_arrays.twin(h))];
  }

  // The corners of the faces at half-edge h, in the chart of its face.
  Edge_images_2 corners_at(Halfedge_index h) const { return corners_at(h, positions()); }
  Edge_images_2 corners_at(Halfedge_index h, const Position_vector& positions) const
  {
    using Arrays = Halfedge_arrays_2;
    Image_2 right = image(m_arrays.twin(h), positions);
    right.shift = right.shift + transition(h);
    return {image(h, positions), image(Arrays::next(h), positions),
            image(Arrays::previous(h), positions), right};
  }

  // SITES, as in the plane. A chart is what is added to the shifts of a face.

  using Site = Periodic_site_2;
  using Chart = Periodic_shift_2;
  using Shifts = Uninitialized_column<Halfedge_index, Periodic_shift_2>;

  static Vertex_index vertex_of(const Site& site) { return site.vertex; }
  static Site site_of(Vertex_index v) { return {v, no_shift}; }
  Site site_in(Halfedge_index h, const Chart& chart) const
  {
    return {m_arrays.apex(h), m_shifts[h] + chart};
  }
  Chart chart_at(Halfedge_index h) const { return no_shift - m_shifts[h]; }
  Chart chart_beyond(Halfedge_index h, const Chart& chart) const { return chart + transition(h); }
  // Whether an image of a point is where vertex v is.
  bool is_at(const Point& p, Vertex_index v) const
  {
    return m_torus.coincide(approximation(p), positions()[v]);
  }
  // Returns the chart of the face of h in which the apex of h is near v.
  Chart chart_seen_from(Vertex_index v, Halfedge_index h) const
  {
    return chart_at(h) + shift_of_step(positions()[m_arrays.apex(h)], positions()[v]);
  }
  // Returns the shift of the lattice that is nearest to a step.
  Periodic_shift_2 shift_of_step(const Position_2& from, const Position_2& to) const
  {
    const Position_2 step = to - from;
    return m_torus.is_short(step) ? no_shift : m_torus.nearest_shift(m_torus.multiples(step));
  }
  // The squared distance between images that are near each other.
  double rounded_squared_distance(Vertex_index v, Vertex_index w) const
  {
    return rounded_squared_distance(positions()[v], positions()[w]);
  }
  double rounded_squared_distance(const Position_2& p, const Position_2& q) const
  {
    return squared_distance(nearest_image(p, q), q);
  }
  // Returns the position one frame ago of the image of v that is at `now`.
  Position_2 previous_position_at(Vertex_index v, const Position_2& now) const
  {
    return now - (positions()[v] - previous_position(v));
  }
  // Returns the image of p in the cell, by which p is sorted in space.
  Position_2 position_in_order(const Position_2& p) const { return m_torus.wrapped(p); }
  Image_2 image(const Site& site) const { return {positions()[site.vertex], site.shift}; }
  // NaNs beyond the gap beside a slab.
  Position_2 rounded_position(const Site& site) const
  {
    return m_torus.are_across(site.shift, no_shift) ? nan_point() : m_torus.rounded(image(site));
  }
  // Whether an edge goes from a to b. Walks around both in step, because one of them may have many
  // neighbors.
  bool are_neighbors(const Site& a, const Site& b) const
  {
    const Periodic_shift_2 way = b.shift - a.shift;
    const Halfedge_index first = m_arrays.corner(a.vertex), other_first = m_arrays.corner(b.vertex);
    Halfedge_index i = first, k = other_first;
    do {
      if (leads(i, b.vertex, way) || leads(k, a.vertex, no_shift - way))
        return true;
      i = m_arrays.next_corner(i);
      k = m_arrays.next_corner(k);
    } while (i != first && k != other_first);
    return false;
  }
  // Calls f(w, shift) for every neighbor w of vertex v, counterclockwise.
  template <class Function>
  void for_each_finite_neighbor(Vertex_index v, const Function& f) const
  {
    if (m_arrays.is_outside(v))
      return;
    m_arrays.for_each_corner(v, [&](Halfedge_index h) {
      const Halfedge_index end = Halfedge_arrays_2::next(h);
      if (!are_across(h, end))
        f(m_arrays.apex(end), shift_between(h, end));
    });
  }
  // Whether the edge from the apex of h to that of next(h) leads to v, shifted by `way`.
  bool leads(Halfedge_index h, Vertex_index v, const Periodic_shift_2& way) const
  {
    const Halfedge_index end = Halfedge_arrays_2::next(h);
    return m_arrays.apex(end) == v && are_equal(m_shifts[end] - m_shifts[h], way);
  }

  // Whether the corners of a face have different shifts.
  bool crosses_border(Face_index f) const
  {
    const auto [h, i, k] = Halfedge_arrays_2::halfedges_of(f);
    return !are_equal(m_shifts[h], m_shifts[i]) || !are_equal(m_shifts[h], m_shifts[k]);
  }
  // Whether the four corners of an edge have the same shift, as seen from one of them.
  bool is_in_one_chart(Edge_index e) const
  {
    using Arrays = Halfedge_arrays_2;
    const Halfedge_index h = m_arrays.halfedge(e);
    return !crosses_border(Arrays::face_of(h)) &&
           !crosses_border(Arrays::face_of(m_arrays.twin(h)));
  }
  // Whether the arrays show the edge rightly: its vertices if it is in one chart, and else none.
  bool is_shown_right(Edge_index e) const
  {
    const Edge_2& shown = m_arrays.edge(e);
    const bool has_no_vertices = shown.target == infinite_index && shown.left == infinite_index &&
                                 shown.right == infinite_index;
    return is_in_one_chart(e) != is_shifted(e) && (!is_shifted(e) || has_no_vertices);
  }
  bool is_shifted(Edge_index e) const { return m_arrays.is_hidden(e); }

  std::size_t number_of_cell_changes() const { return m_cell_changes; }

  // FRAMES, as Dynamic_frame_2 shows them. Empty edges and faces have infinite vertices.

  static constexpr bool positions_are_exact() { return true; }
  bool have_points_moved() const { return m_positions.have_moved(); }
  bool is_frame_at_rest() const { return !m_deformation && m_positions.is_frame_at_rest(); }
  decltype(auto) point(Vertex_index v) const { return m_positions.point(v); }
  // Returns the position one frame ago, or before the vertex moved alone in this call: its image
  // that is nearest to the present position.
  Position_2 previous_position(Vertex_index v) const
  {
    return nearest_image(m_positions.previous_position(v), positions()[v]);
  }
  // The position where the vertex rests: the previous one, moved along with the cell. A deformation
  // of the cell turns no face over.
  Position_2 rest_position(Vertex_index v) const
  {
    if (!m_deformation)
      return previous_position(v);
    const Position_2 s = m_deformation->before.multiples(m_positions.previous_position(v));
    return nearest_image(m_torus.vector(in_new_multiples(s, m_deformation->multiples)),
                         positions()[v]);
  }

  Edge_2 edge(Edge_index e) const
  {
    using Arrays = Halfedge_arrays_2;
    if (!is_shifted(e) || m_arrays.is_empty_edge(e))
      return m_arrays.edge(e);
    const Halfedge_index h = m_arrays.halfedge(e);
    return {m_arrays.apex(Arrays::next(h)), m_arrays.apex(Arrays::previous(h)), m_arrays.apex(h),
            m_arrays.apex(m_arrays.twin(h))};
  }
  std::array<Vertex_index, 3> face(Face_index f) const
  {
    return m_arrays.is_empty_face(f)
               ? std::array<Vertex_index, 3>{infinite_index, infinite_index, infinite_index}
               : m_arrays.face(f);
  }
  static constexpr bool is_along(Edge_index, Halfedge_index)
  {
    return true;
  } // halfedge(e) goes along edge(e)

  // Whether the corners of an edge are on both sides of the gap beside a slab, or it is empty.
  bool is_at_infinity(Edge_index e) const
  {
    if (!is_shifted(e))
      return false;
    if (m_arrays.is_empty_edge(e))
      return true;
    const auto [a, b, c, d] = corners_at(m_arrays.halfedge(e));
    return m_torus.are_across(a.shift, b.shift) || m_torus.are_across(b.shift, c.shift) ||
           m_torus.are_across(c.shift, d.shift);
  }
  // Whether an edge goes across that gap, and so would the one by which a flip replaces it.
  bool flips_across_gap(Edge_index e) const
  {
    if (!is_shifted(e) || m_arrays.is_empty_edge(e))
      return false;
    const auto [a, b, c, d] = corners_at(m_arrays.halfedge(e));
    return m_torus.are_across(b.shift, c.shift) && m_torus.are_across(a.shift, d.shift);
  }
  bool breaks_hull(Edge_index e) const
  {
    return is_at_infinity(e) && Edge_test(*this).state(e) != Edge_state_2::DELAUNAY;
  }
  // Whether the faces cover the torus once. Takes exact arithmetic at all faces.
  bool covers_space() const { return Torus_cover_2<Torus_space_2>(*this).is_single(); }
  static bool is_structure_valid(bool, int) { return true; } // there are the arrays alone
  static bool is_right_on_line() { return true; }            // all points span faces

  bool corners_are_exact(Edge_index e) const { return !is_shifted(e); }
  Edge_corners_2 corners(Edge_index e) const { return corners(e, positions()); }
  Edge_corners_2 corners(Edge_index e, const Position_vector& positions) const
  {
    if (!is_shifted(e))
      return Plane_2::corners(m_arrays.edge(e), positions);
    if (is_at_infinity(e))
      return {nan_point(), nan_point(), nan_point(), nan_point()};
    return m_torus.rounded_corners(corners_at(m_arrays.halfedge(e), positions)).first;
  }
  Position_2 edge_vector(Edge_index e) const
  {
    if (!is_shifted(e))
      return positions()[m_arrays.edge(e).target] - positions()[m_arrays.edge(e).source];
    if (m_arrays.is_empty_edge(e))
      return nan_point();
    const Edge_images_2 corners = corners_at(m_arrays.halfedge(e));
    return rounded_vector(corners.source, corners.target);
  }
  std::array<Position_2, 3> face_corners(Face_index f) const
  {
    if (m_arrays.is_empty_face(f))
      return {nan_point(), nan_point(), nan_point()};
    const auto [h, i, k] = Halfedge_arrays_2::halfedges_of(f);
    return {Position_2{0, 0}, rounded_vector(image(h), image(i)),
            rounded_vector(image(h), image(k))};
  }

  // WRITING -------------------------------------------------------------------------------------

  // The parts of the space that can be written.
  class Writer
  {
  public:
    using Positions = Writable_positions_2<Point>;

    explicit Writer(Torus_space_2& space)
      : m_space(space)
    {
    }

    Writable_halfedge_arrays_2& arrays() const { return m_space.m_arrays; }
    Positions& positions() const { return m_space.m_positions; }
    Shifts& shifts() const { return m_space.m_shifts; }

    void set_torus(const Torus_2& torus) const { m_space.m_torus = torus; }
    // Replaces the cell; `multiples` are the old cell's vectors in multiples of the new ones.
    void change_cell(const Periodic_cell_2& cell,
                     const std::array<Periodic_shift_2, 2>& multiples) const
    {
      ++m_space.m_cell_changes;
      m_space.m_deformation.emplace(Deformation{m_space.m_torus, multiples});
      m_space.m_torus = Torus_2(cell);
    }
    void forget_deformation() const { m_space.m_deformation.reset(); }

    // Copy or exchange everything that is kept between calls, but for the count of cells.
    void copy(const Torus_space_2& other) const
    {
      m_space.m_torus = other.m_torus;
      m_space.m_arrays = other.m_arrays;
      m_space.m_shifts = other.m_shifts;
      m_space.m_points = other.m_points;
      m_space.m_positions.copy(other.m_positions);
    }
    void exchange(Torus_space_2& other) const
    {
      std::swap(m_space.m_torus, other.m_torus);
      std::swap(m_space.m_arrays, other.m_arrays);
      m_space.m_shifts.swap(other.m_shifts);
      m_space.m_points.swap(other.m_points);
      m_space.m_positions.exchange_all_but_points(other.m_positions);
    }
    std::size_t& cell_changes() const { return m_space.m_cell_changes; }

  private:
    Torus_space_2& m_space;
  };

private:
  // How the last call has changed the cell: the cell before, whose vectors have these multiples of
  // the present ones.
  struct Deformation
  {
    Torus_2 before;
    std::array<Periodic_shift_2, 2> multiples;
  };

  // The image of p that is nearest to q, rounded.
  Position_2 nearest_image(const Position_2& p, const Position_2& q) const
  {
    if (m_torus.is_short(q - p))
      return p;
    return m_torus.rounded({p, shift_of_step(p, q)});
  }

  // NaNs across the gap beside a slab.
  Position_2 rounded_vector(const Image_2& from, const Image_2& to) const
  {
    double ignored = 0;
    return m_torus.are_across(from.shift, to.shift) ? nan_point()
                                                    : m_torus.vector(from, to, ignored);
  }

  Torus_2 m_torus;
  Writable_halfedge_arrays_2 m_arrays;
  Shifts m_shifts;
  typename Point_arrays_2<Point>::Stored_points m_points; // indexed by vertices
  Writable_positions_2<Point> m_positions;
  std::size_t m_cell_changes = 0;
  std::optional<Deformation> m_deformation; // until the call ends
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_SPACE_2_H
