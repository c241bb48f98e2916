// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_PLANE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_PLANE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_deformation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_image_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The convex hull of all points of all ranks, which every rank knows.
//
// A corner of that hull is a corner of the hull of each subset that contains it. So it is on the
// hull of the triangulation of the rank that owns it, and it is enough that each rank gives its own
// points on that hull, without those in the middle of an edge. A rank inside gives none once it
// holds ghosts on all sides. Cost: sorting the points that all ranks give.
template <class Points>
class Distributed_outline_2
{
  using Kernel = typename Points::Kernel;
  using Point = typename Kernel::Point_2;

public:
  // Collective.
  void gather(Distributed_ranks_2& ranks, const Points& points)
  {
    const auto all = ranks.gather(own_corners(points));
    std::vector<Point> corners;
    for (const Position_2& p : all.values)
      corners.push_back(Point(p.x, p.y));
    std::sort(corners.begin(), corners.end(), comes_first);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    m_corners.clear();
    add_chain(corners.begin(), corners.end());
    add_chain(corners.rbegin(), corners.rend());
    if (m_corners.empty())
      m_corners = corners;
    m_box = Box_2();
    for (const Point& p : m_corners)
      m_box.add({p.x(), p.y()});
  }

  // A box around all points that may be in the region of a question.
  const Box_2& box_for(const Distributed_question_2&) const { return m_box; }
  // The corners of the hull, counterclockwise, without points in the middle of an edge.
  const std::vector<Point>& corners() const { return m_corners; }

  // Whether a point is strictly left of the line from p to q.
  bool is_any_beyond(const Point& p, const Point& q) const
  {
    const auto orientation = Kernel().orientation_2_object();
    return std::any_of(m_corners.begin(), m_corners.end(),
                       [&](const Point& r) { return orientation(p, q, r) == LEFT_TURN; });
  }

  // Whether an edge of the hull proves that there are no points in the box.
  bool excludes(const Box_2& box) const
  {
    const std::size_t n = m_corners.size();
    if (n < 3)
      return false;
    const Point corners[] = {Point(box.x_low, box.y_low), Point(box.x_high, box.y_low),
                             Point(box.x_high, box.y_high), Point(box.x_low, box.y_high)};
    const auto orientation = Kernel().orientation_2_object();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t e = (m_latest + k) % n; // boxes in turn are mostly beyond the same edge
      const Point &p = m_corners[e], &q = m_corners[(e + 1) % n];
      if (std::all_of(corners, corners + 4,
                      [&](const Point& r) { return orientation(p, q, r) == RIGHT_TURN; })) {
        m_latest = e;
        return true;
      }
    }
    return false;
  }

  // Tests what `excludes()` tests, in rounded arithmetic, which is quicker.
  bool excludes_about(const Box_2& box) const
  {
    const std::size_t n = m_corners.size();
    for (std::size_t k = 0; k < n && n > 2; ++k) {
      const Point &p = m_corners[k], &q = m_corners[(k + 1) % n];
      const double x = q.x() - p.x(), y = q.y() - p.y();
      const double to_left_x = (y > 0 ? box.x_low : box.x_high) - p.x();
      const double to_left_y = (x > 0 ? box.y_high : box.y_low) - p.y();
      if (x * to_left_y - y * to_left_x < 0)
        return true;
    }
    return false;
  }

private:
  static bool comes_first(const Point& p, const Point& q)
  {
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  }

  static std::vector<Position_2> own_corners(const Points& points)
  {
    std::vector<Position_2> corners;
    const auto frame = points.dt().frame();
    if (frame.number_of_faces() == 0) { // own points on a line, if any: the two outermost
      const auto [first, last] =
          std::minmax_element(points.owned().begin(), points.owned().end(), [&](Index i, Index j) {
            return comes_first(points.point(i), points.point(j));
          });
      if (first != points.owned().end())
        for (const Index place : {*first, *last})
          corners.push_back(points.position(place));
      return corners;
    }
    const std::vector<std::uint8_t> are_owned = points.owned_vertices();
    const auto& arrays = frame.state().arrays();
    std::vector<Vertex_index> hull; // clockwise
    arrays.for_each_neighbor(infinite_index, [&](Vertex_index v) { hull.push_back(v); });
    const auto orientation = Kernel().orientation_2_object();
    const auto at = [&](std::size_t k) {
      const Position_2 p = frame.position(hull[k % hull.size()]);
      return Point(p.x, p.y);
    };
    for (std::size_t k = 0; k < hull.size(); ++k)
      if (are_owned[hull[k]] != 0 &&
          orientation(at(k + hull.size() - 1), at(k), at(k + 1)) != COLLINEAR)
        corners.push_back(frame.position(hull[k]));
    return corners;
  }

  // Appends the chain of the hull on the right of ascending or descending points, without its end:
  // A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions, 1979.
  template <class Iterator>
  void add_chain(Iterator first, Iterator beyond)
  {
    const std::size_t size = m_corners.size();
    const auto orientation = Kernel().orientation_2_object();
    for (; first != beyond; ++first) {
      while (m_corners.size() >= size + 2 &&
             orientation(*(m_corners.end() - 2), m_corners.back(), *first) != LEFT_TURN)
        m_corners.pop_back();
      m_corners.push_back(*first);
    }
    if (!m_corners.empty())
      m_corners.pop_back();
  }

  std::vector<Point> m_corners;
  Box_2 m_box;
  mutable std::size_t m_latest = 0;
};

// The open plane, as a space of distributed points. Each point has one image, itself.
template <class Kernel_>
class Distributed_plane_2
{
public:
  using Kernel = Kernel_;
  using Shift = No_shift_2;
  using Image = Distributed_image_2<Shift>;
  template <class Points>
  using Outline = Distributed_outline_2<Points>;

  static constexpr bool is_periodic = false;
  // The number of vertices, minus edges, plus finite faces: that of a disk.
  static constexpr std::uint64_t euler_characteristic = 1;

  // What a checkpoint stores about the space.
  struct Parameters
  {
  };
  static constexpr std::array<char, 24> file_name = checkpoint_name("distributed Delaunay 1\n");

  Distributed_plane_2() = default;
  explicit Distributed_plane_2(const Parameters&) {}
  Parameters parameters() const { return {}; }
  // Throws unless all ranks were given the same space. Collective.
  void agree(Distributed_ranks_2&) const {}

  // Returns the position that is triangulated for a point of the user. Throws if it is refused.
  template <class Point>
  Position_2 checked(const Point& p, std::size_t place) const
  {
    return checked_position(p, place, point_at_place);
  }

  // The image of a point that its owner holds: of a new point, and of one that has moved.
  Image first_image(const Position_2& given) const { return {{}, given.x, given.y}; }
  Image next_image(const Position_2& given, const Position_2&, const Distributed_plane_2&) const
  {
    return first_image(given);
  }
  // The position that the user gave for the point of such an image.
  Position_2 given(const Image& image) const { return {image.x, image.y}; }

  // The vector of a shift, an image moved by that vector, and whether the vector is 0.
  Position_2 vector(const Shift&) const { return {0, 0}; }
  Image translated(const Image& image, const Shift&) const { return image; }
  bool is_none(const Shift&) const { return true; }
  // Calls f(shift) for each shift that may move a place of the first box into the second one.
  template <class Function>
  void for_each_shift(const Box_2&, const Box_2&, const Function& f) const
  {
    f(Shift());
  }

  // The vectors that are deformed with the space.
  Basis_2 basis() const { return unit_basis; }
  // The size of the smallest cells of a zone, divided by the largest coordinate.
  static constexpr double finest_zone = 0x1p-40;

  // Whether ghosts and zones that ranks have sent each other in the other space stay of use.
  bool continues(const Distributed_plane_2&) const { return true; }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_PLANE_2_H
