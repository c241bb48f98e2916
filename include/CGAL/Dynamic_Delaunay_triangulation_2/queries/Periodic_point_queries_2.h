// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_PERIODIC_POINT_QUERIES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_PERIODIC_POINT_QUERIES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/check_certified_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Image_distances_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Query_parts_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/enum.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

Finds the images of points that are nearest to a place or to a point, or within a radius of it, in a
periodic cell or slab. It uses the triangulation as it is, without another search structure and
without copies of points.

An answer is an image: the id of a point and a shift. The image is at `point(id)` plus `shift[0]`
times the cell's first vector plus `shift[1]` times its second one, relative to the place as it is
given, wrapped or not. The answers are exact for these images, which are never rounded. One point
can have several images in a circle, or none.

Points that coincide have the same distance, and each of them counts.

An object refers to the triangulation, which must keep its address, but may change. Queries change
nothing visible, but they share memory of the object: several threads must not use the same object
at once, even if it is constant. Threads that query at the same time need one object each. Queries
for many places at once need only one call, whose work threads share if the triangulation has the
`Parallel_tag`.

The images of all points have a Delaunay triangulation of the plane, or of the strip of a slab, of
which the periodic triangulation is one sheet. So the proof of `Delaunay_point_queries_2` holds
here, too: from every image but the nearest ones a neighbor is nearer, and the images in a disk are
connected by edges between them.

\tparam Dynamic a `Dynamic_periodic_Delaunay_triangulation_2`.

\sa `Delaunay_point_queries_2`
*/
template <class Dynamic>
class Periodic_point_queries_2
{
  using Distances = Dynamic_Delaunay_triangulations_2::internal::Image_distances_2;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point_2;
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;
  using Torus = Dynamic_Delaunay_triangulations_2::internal::Torus_2;
  using Exact_image = Dynamic_Delaunay_triangulations_2::internal::Image_2;

public:
  /// \name Types
  /// @{

  /// the triangulation.
  using Triangulation = Dynamic;
  /// a point.
  using Point = typename Dynamic::Point;
  /// the type of ids.
  using size_type = std::size_t;
  /// an id and a shift.
  using Image = std::pair<size_type, Periodic_shift_2>;

  /// @}
  /// \name Creation
  /// @{

  /// creates queries for a triangulation, which need not have any points yet.
  explicit Periodic_point_queries_2(const Dynamic& pt)
    : m_pt(&pt)
  {
  }

  /// @}
  /// \name Queries
  /// All of them throw `Uncertified_triangulation_error_2` unless the triangulation is certified.
  /// If points coincide, each query also takes time proportional to the number of ids.
  /// @{

  /// the image that is nearest to `p`; of several, that with the smallest id, and of these that
  /// with the smallest shift, by its first number, then by its second one. No value if there are no
  /// points.
  ///
  /// Cost: O(n<sup>1/3</sup>) expected for evenly spread points in a cell that is not thin, less if
  /// the answer is near the last one.
  /// \throws Non_finite_coordinate_error_2 if a coordinate of `p` is NaN or infinite.
  /// \throws Periodic_range_error_2 if `p` is 2<sup>20</sup> cells or more from the origin.
  std::optional<Image> nearest(const Point& p) const { return find_nearest(p, 0); }

  /// writes `nearest(p)` for each place p of a range, in their order.
  ///
  /// Cost: that of the queries, which threads share, but those for places that follow each other in
  /// space are faster.
  /// \param first, beyond the range of places.
  /// \param images where to write; nothing is written if this throws.
  /// \tparam ForwardIterator has the value type `Point`.
  /// \tparam OutputIterator takes values of `std::optional<Image>`.
  /// \return where the next image would be written.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Periodic_range_error_2 if a place is 2<sup>20</sup> cells or more from the origin.
  /// Both say which place of the range that is.
  template <class ForwardIterator, class OutputIterator>
  OutputIterator nearest(ForwardIterator first, ForwardIterator beyond, OutputIterator images) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const std::vector<Point> places(first, beyond);
    std::vector<std::optional<Image>> found(places.size());
    query_in_parts<Parts>(*this, places.size(),
                          [&](const Periodic_point_queries_2& queries, std::size_t i) {
                            found[i] = queries.find_nearest(places[i], i);
                          });
    return std::copy(found.begin(), found.end(), images);
  }

  /// the image that is nearest to the point `id`, other than the point itself: of another point, or
  /// of the same one. Of several, that with the smallest id and shift, as above. There is one
  /// always.
  ///
  /// Cost: proportional to the number of its neighbors.
  /// \throws Unknown_id_error_2 if no point has this id.
  Image nearest_neighbor(size_type id) const
  {
    const Query query(*m_pt, m_pt->point(id));
    const Image self(id, {0, 0}), v = query.image_of_representative(self);
    if (const auto other = smallest(query, {v}, self))
      return *other;
    std::set<Image> nearest;
    for_each_neighbor(v, [&](const Image& w) {
      const Comparison_result result =
          nearest.empty() ? EQUAL
                          : query.distances.compare(query.exact(w), query.exact(*nearest.begin()));
      if (result == SMALLER)
        nearest.clear();
      if (result != LARGER)
        nearest.insert(w);
    });
    return *smallest(query, nearest);
  }

  /// writes all images within a radius of `p`, including those on the circle, to `images`, in no
  /// particular order.
  ///
  /// Cost: that of `nearest()`, plus O(k log k) for k images found.
  /// \param p the center of the circle.
  /// \param squared_radius the square of its radius.
  /// \param images where to write.
  /// \tparam OutputIterator takes values of `Image`.
  /// \return where the next image would be written.
  /// \throws Parameter_error_2 if the squared radius is negative or not a finite number.
  /// \throws Non_finite_coordinate_error_2 if a coordinate of `p` is NaN or infinite.
  /// \throws Periodic_range_error_2 if `p` is 2<sup>20</sup> cells or more from the origin.
  template <class OutputIterator>
  OutputIterator within(const Point& p, double squared_radius, OutputIterator images) const
  {
    return find_within(p, 0, squared_radius, images);
  }

  /// lists all images within a radius of each place of a range. Those of the i-th place are
  /// `images[begins[i]]` to `images[begins[i + 1] - 1]`, in ascending order of ids, then of shifts.
  ///
  /// Cost: that of the queries, which threads share.
  /// \param first, beyond the range of places.
  /// \param squared_radius the square of the radius.
  /// \param images the images for all places; replaced, and not changed if this throws.
  /// \param begins where those of each place begin, and in the end the number of all of them;
  /// replaced, and not changed if this throws.
  /// \tparam ForwardIterator has the value type `Point`.
  /// \throws Parameter_error_2 if the squared radius is negative or not a finite number.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Periodic_range_error_2 if a place is 2<sup>20</sup> cells or more from the origin.
  /// Both say which place of the range that is.
  template <class ForwardIterator>
  void within(ForwardIterator first, ForwardIterator beyond, double squared_radius,
              std::vector<Image>& images, std::vector<size_type>& begins) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    check(squared_radius);
    const std::vector<Point> places(first, beyond);
    list_in_parts<Parts>(*this, places.size(), images, begins,
                         [&](const Periodic_point_queries_2& queries, std::size_t i, auto found) {
                           queries.find_within(places[i], i, squared_radius, found);
                         });
  }

  /// the same, but around the point `id`, which is not written itself. Other images of it are.
  ///
  /// Cost: O(k log k) for k images found.
  /// \param id the id of the point at the center.
  /// \param squared_radius the square of the radius.
  /// \param images where to write.
  /// \tparam OutputIterator takes values of `Image`.
  /// \return where the next image would be written.
  /// \throws Unknown_id_error_2 if no point has this id.
  /// \throws Parameter_error_2 if the squared radius is negative or not a finite number.
  template <class OutputIterator>
  OutputIterator neighbors_within(size_type id, double squared_radius, OutputIterator images) const
  {
    const Query query(*m_pt, m_pt->point(id));
    check(squared_radius);
    const Image self(id, {0, 0});
    return write_within(query, query.image_of_representative(self), squared_radius, self, images);
  }

  /// @}

private:
  using Parts = typename Dynamic::Frame::Parts;

  // The place of a query, and the images around it. `number` is that of the place in its range, for
  // errors.
  struct Query
  {
    Query(const Dynamic& triangulation, const Point& p, size_type number = 0)
      : pt(triangulation)
      , torus(pt.cell())
      , place(checked(pt, torus, p, number))
      , distances(torus, place)
    {
    }

    static Position checked(const Dynamic& pt, const Torus& torus, const Point& p, size_type number)
    {
      using namespace Dynamic_Delaunay_triangulations_2::internal;
      check_certified(pt);
      const Position position = checked_position(p, number);
      const Position multiples = torus.periodic(torus.multiples(position));
      if (!(std::abs(multiples.x) < max_shift && std::abs(multiples.y) < max_shift))
        throw Periodic_range_error_2(number, position.x, position.y, max_shift);
      return position;
    }

    Position position(size_type id) const
    {
      const Point p = pt.point(id);
      return {p.x(), p.y()};
    }
    Exact_image exact(const Image& image) const { return {position(image.first), image.second}; }

    // By how much a point must be shifted to be near a position.
    Periodic_shift_2 shift_to(const Position& p, size_type id) const
    {
      const Position q = position(id);
      return torus.nearest_shift(torus.multiples({p.x - q.x, p.y - q.y}));
    }
    // The image of a vertex where an image of one of its points is.
    Image image_of_representative(const Image& image) const
    {
      const size_type id = pt.representative(image.first);
      return {id, sum(image.second, shift_to(position(image.first), id))};
    }

    bool is_within(const Image& image, double squared_radius) const
    {
      return distances.compare_square(exact(image), squared_radius) != LARGER;
    }

    const Floating_point floating_point;
    const Dynamic& pt;
    const Torus torus;
    const Position place;
    const Distances distances;
  };

  std::optional<Image> find_nearest(const Point& p, size_type number) const
  {
    const Query query(*m_pt, p, number);
    if (m_pt->number_of_points() == 0)
      return std::nullopt;
    const Image start = walk(query);
    const Exact_image nearest = query.exact(start);
    return smallest(query, flood(start, [&](const Image& w) {
                      return query.distances.compare(query.exact(w), nearest) == EQUAL;
                    }));
  }

  template <class OutputIterator>
  OutputIterator find_within(const Point& p, size_type number, double squared_radius,
                             OutputIterator images) const
  {
    const Query query(*m_pt, p, number);
    check(squared_radius);
    if (m_pt->number_of_points() == 0)
      return images;
    const Image start = walk(query);
    if (!query.is_within(start, squared_radius))
      return images;
    return write_within(query, start, squared_radius, std::nullopt, images);
  }

  static Periodic_shift_2 sum(const Periodic_shift_2& s, const Periodic_shift_2& t)
  {
    return {s[0] + t[0], s[1] + t[1]};
  }

  static void check(double squared_radius)
  {
    constexpr double largest = (std::numeric_limits<double>::max)();
    if (!(squared_radius >= 0 && squared_radius <= largest))
      throw Parameter_error_2("the squared radius", squared_radius, 0, largest);
  }

  template <class Function>
  void for_each_neighbor(const Image& v, const Function& f) const
  {
    m_pt->for_each_neighbor(v.first, [&](size_type id, const Periodic_shift_2& shift) {
      f(Image(id, sum(v.second, shift)));
    });
  }

  // Returns a nearest image of a vertex. Moves to the nearest neighbor until none is nearer.
  Image walk(const Query& query) const
  {
    Image nearest = start_of_walk(query), last;
    do {
      last = nearest;
      for_each_neighbor(last, [&](const Image& w) {
        if (query.distances.compare(query.exact(w), query.exact(nearest)) == SMALLER)
          nearest = w;
      });
    } while (nearest != last);
    m_last = nearest.first;
    return nearest;
  }

  // The nearest of the last answer and of so many others as the walk is expected to have steps.
  Image start_of_walk(const Query& query) const
  {
    const size_type ids = m_pt->number_of_ids();
    const double step = std::cbrt(double(ids) * double(ids));
    std::optional<Image> nearest;
    double square = 0;
    const auto consider = [&](size_type id) {
      if (!m_pt->has_id(id))
        return;
      const size_type v = m_pt->representative(id);
      const Image image(v, query.shift_to(query.place, v));
      const double other = query.distances.approximate_square(query.exact(image));
      if (!nearest || other < square) {
        nearest = image;
        square = other;
      }
    };
    consider(m_last);
    for (double id = 0; id < double(ids); id += step)
      consider(size_type(id));
    for (size_type id = 0; !nearest; ++id)
      consider(id);
    return *nearest;
  }

  // Finds all images w with `belongs(w)` that are connected with v by such images.
  template <class Predicate>
  std::set<Image> flood(const Image& v, const Predicate& belongs) const
  {
    std::set<Image> found{v};
    std::vector<Image> open{v};
    while (!open.empty()) {
      const Image from = open.back();
      open.pop_back();
      for_each_neighbor(from, [&](const Image& w) {
        if (found.count(w) == 0 && belongs(w)) {
          found.insert(w);
          open.push_back(w);
        }
      });
    }
    return found;
  }

  // Calls f(image) for all points of the vertices whose images were found.
  template <class Function>
  void for_each_found(const Query& query, const std::set<Image>& found, const Function& f) const
  {
    constexpr int least = (std::numeric_limits<int>::min)();
    for (const Image& v : found)
      f(v);
    if (m_pt->number_of_points() == m_pt->number_of_vertices())
      return;
    for (size_type id = 0; id < m_pt->number_of_ids(); ++id) {
      if (!m_pt->has_id(id) || m_pt->representative(id) == id)
        continue;
      const size_type v = m_pt->representative(id);
      auto image = found.lower_bound(Image(v, {least, least}));
      if (image == found.end() || image->first != v)
        continue;
      const Periodic_shift_2 shift = query.shift_to(query.position(v), id);
      for (; image != found.end() && image->first == v; ++image)
        f(Image(id, sum(image->second, shift)));
    }
  }

  std::optional<Image> smallest(const Query& query, const std::set<Image>& found,
                                const std::optional<Image>& asking = std::nullopt) const
  {
    std::optional<Image> least;
    for_each_found(query, found, [&](const Image& image) {
      if (image != asking && (!least || image < *least))
        least = image;
    });
    return least;
  }

  template <class OutputIterator>
  OutputIterator write_within(const Query& query, const Image& start, double squared_radius,
                              const std::optional<Image>& asking, OutputIterator images) const
  {
    const std::set<Image> found =
        flood(start, [&](const Image& w) { return query.is_within(w, squared_radius); });
    for_each_found(query, found, [&](const Image& image) {
      if (image != asking)
        *images++ = image;
    });
    return images;
  }

  const Dynamic* m_pt;
  mutable size_type m_last = 0; // the vertex found by the last walk
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_PERIODIC_POINT_QUERIES_2_H
