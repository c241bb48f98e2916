// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_SPACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_SPACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Vertex_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>
#include <CGAL/Periodic_cell_2.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Compares the distances of images from one place exactly: in doubles, and without rounding where
// that is undecided.
//
// With u = 2^-53, the vector v to an image is computed with errors of at most E = 4u m in each
// coordinate, where m is the largest sum of absolute values in it, as in Torus_2. So |v|^2 is off
// by at most 2 (|x| + |y|) E + 2 E^2, and computed with a further relative error of 2u. `error`
// includes 8u times the value: the remaining 6u cover the sum or difference that makes an end of
// the interval, and the factor 2.1 instead of 2 covers the rounding of `error` itself. Underflow
// takes less than 1e-300. If something overflows, nothing is decided.
class Image_distances_2
{
public:
  Image_distances_2(const Torus_2& torus, const Position_2& from)
    : m_torus(torus)
    , m_from(from)
  {
  }

  // Computed in plain floating point.
  double approximate_square(const Image_2& p) const { return Square(*this, p).value; }

  Comparison_result compare(const Image_2& p, const Image_2& q) const
  {
    const Comparison_result result = filtered(Square(*this, p), Square(*this, q));
    return result != EQUAL ? result : CGAL::compare(exact_square(p), exact_square(q));
  }

  Comparison_result compare_square(const Image_2& p, double square) const
  {
    const Comparison_result result = filtered(Square(*this, p), Square(square));
    return result != EQUAL ? result : CGAL::compare(exact_square(p), Torus_2::Exact(square));
  }

private:
  struct Square
  {
    explicit Square(double exact)
      : value(exact)
    {
    }
    Square(const Image_distances_2& distances, const Image_2& p)
    {
      double m = 0;
      const auto [x, y] = distances.m_torus.vector({distances.m_from, no_shift}, p, m);
      const double e = Torus_2::error_factor * m;
      value = x * x + y * y;
      error = 2.1 * e * (std::abs(x) + std::abs(y) + e) + 0x1p-50 * value + 1e-300;
    }
    double value, error = 0;
  };

  // EQUAL if undecided.
  static Comparison_result filtered(const Square& s, const Square& t)
  {
    return s.value + s.error < t.value - t.error   ? SMALLER
           : t.value + t.error < s.value - s.error ? LARGER
                                                   : EQUAL;
  }

  BOOST_NOINLINE Torus_2::Exact exact_square(const Image_2& p) const
  {
    const Torus_2::Exact_vector v(m_torus, {m_from, no_shift}, p);
    return v.x * v.x + v.y * v.y;
  }

  const Torus_2& m_torus;
  const Position_2 m_from;
};

// A triangulation as seen from the place of a query, by the same functions in plane and periodic
// space. A search moves from *site* to site: vertices in the plane, images of vertices in periodic
// space. An *answer* is a point at a site: an id in the plane, an id and a shift in periodic space.
template <class Dynamic, bool = Dynamic::Frame::is_periodic>
class Query_space_2;

// THE PLANE ---------------------------------------------------------------------------------------

template <class Dynamic>
class Query_space_2<Dynamic, false>
{
public:
  using FT = typename Dynamic::Geom_traits::FT;
  using Answer = std::size_t;
  using Site = Index;
  using Sites = Index_set;

  // Throws unless the triangulation is certified and the place is a valid point: the error calls
  // the place `number`. The place must outlive this object.
  Query_space_2(const Dynamic& dt, const typename Dynamic::Point& place, std::size_t number = 0)
    : m_distances(dt, place, number)
    , m_frame(dt.frame())
  {
  }

  void clear(Sites& sites) const { sites.clear(m_frame.number_of_vertices() + 1); }
  static bool contains(const Sites& sites, Site v) { return sites.contains(v); }

  static Answer answer(std::size_t id) { return id; }
  static Site vertex(Site v) { return v; }
  static Site site(Vertex_index v) { return v; }

  double approximate_square(Site v) const { return m_distances.approximate_square(v); }
  Comparison_result compare(Site v, Site w) const { return m_distances.compare(v, w); }
  Comparison_result compare_square(Site v, const FT& square) const
  {
    return m_distances.compare_square(v, square);
  }

  template <class Function>
  void for_each_neighbor(Site v, const Function& f) const
  {
    m_frame.state().for_each_finite_neighbor(v, f);
  }

  // Calls f(answer) for all points at the sites, coincident ones included.
  template <class Function>
  void for_each_point(const Sites& sites, const Function& f) const
  {
    for (const Site v : sites)
      f(Answer(m_frame.id(v)));
    m_frame.for_each_duplicate([&](Point_id id) {
      if (sites.contains(m_frame.vertex(id)))
        f(Answer(id));
    });
  }

private:
  const Distances_2<Dynamic> m_distances;
  const typename Dynamic::Frame m_frame;
};

// PERIODIC SPACE ----------------------------------------------------------------------------------

template <class Dynamic>
class Query_space_2<Dynamic, true>
{
public:
  using FT = double;
  using Answer = std::pair<std::size_t, Periodic_shift_2>;
  using Site = Answer; // with the id of a representative
  using Sites = std::set<Site>;

  // Throws as in the plane.
  Query_space_2(const Dynamic& dt, const typename Dynamic::Point& place, std::size_t number = 0)
    : m_dt(dt)
    , m_frame(dt.frame())
    , m_torus(dt.cell())
    , m_place(checked(dt, m_torus, place, number))
    , m_distances(m_torus, m_place)
  {
  }
  Query_space_2(const Query_space_2&) = delete; // distances refer to the torus
  Query_space_2& operator=(const Query_space_2&) = delete;

  static void clear(Sites& sites) { sites.clear(); }
  static bool contains(const Sites& sites, const Site& v) { return sites.count(v) != 0; }

  static Answer answer(std::size_t id) { return {id, no_shift}; }
  Vertex_index vertex(const Site& v) const { return m_frame.vertex(v.first); }
  // The image of a vertex near the place; exactly at the place if one of its images is there.
  Site site(Vertex_index v) const
  {
    return {m_frame.id(v), shift_to(m_place, m_frame.position(v))};
  }

  double approximate_square(const Site& v) const
  {
    return m_distances.approximate_square(image(v));
  }
  Comparison_result compare(const Site& v, const Site& w) const
  {
    return m_distances.compare(image(v), image(w));
  }
  Comparison_result compare_square(const Site& v, double square) const
  {
    return m_distances.compare_square(image(v), square);
  }

  template <class Function>
  void for_each_neighbor(const Site& v, const Function& f) const
  {
    m_dt.for_each_neighbor(v.first, [&](std::size_t id, const Periodic_shift_2& shift) {
      f(Site(id, v.second + shift));
    });
  }

  // A duplicate's point may be another image of its representative's point.
  template <class Function>
  void for_each_point(const Sites& sites, const Function& f) const
  {
    for (const Site& v : sites)
      f(v);
    m_frame.for_each_duplicate([&](Point_id id) {
      const auto p = m_dt.point(id);
      const std::size_t v = m_frame.id(m_frame.vertex(id));
      const Periodic_shift_2 shift = shift_to(position(v), {p.x(), p.y()});
      constexpr int least = (std::numeric_limits<int>::min)();
      for (auto site = sites.lower_bound(Site(v, {least, least}));
           site != sites.end() && site->first == v; ++site)
        f(Answer(id, site->second + shift));
    });
  }

private:
  static Position_2 checked(const Dynamic& dt, const Torus_2& torus,
                            const typename Dynamic::Point& place, std::size_t number)
  {
    check_certified(dt);
    return checked_position(place, number, torus);
  }

  // By how much q must be shifted to be near p.
  Periodic_shift_2 shift_to(const Position_2& p, const Position_2& q) const
  {
    return m_torus.nearest_shift(m_torus.multiples(p - q));
  }

  const Position_2& position(std::size_t id) const { return m_frame.position(m_frame.vertex(id)); }
  Image_2 image(const Site& v) const { return {position(v.first), v.second}; }

  const Default_floating_point m_floating_point; // while distances are compared
  const Dynamic& m_dt;
  const typename Dynamic::Frame m_frame;
  const Torus_2 m_torus;
  const Position_2 m_place;
  const Image_distances_2 m_distances;
};

// Many queries at once, which threads share. Each part has its own copy of the caller's `queries`,
// because this object remembers where the last answer was.

// The least number of queries in a part. A query takes about a microsecond.
template <class Parts>
constexpr std::size_t least_queries = (std::max)(Parts::usual_size / 64, std::size_t(1));

// Calls f(queries, i, part) for all i below `size`.
template <class Parts, class Queries, class Function>
void query_in_parts(const Queries& queries, std::size_t size, const Function& f)
{
  Parts::for_each(size, least_queries<Parts>,
                  [&](std::size_t part, std::size_t first, std::size_t beyond) {
                    Queries queries_of_part(queries);
                    for (std::size_t i = first; i < beyond; ++i)
                      f(queries_of_part, i, part);
                  });
}

// Calls f(queries, i, iterator), which writes answers, for all i below `size`. The sorted answers
// of the i-th call are listed from `begins[i]` to before `begins[i + 1]`.
template <class Parts, class Queries, class Answer, class Function>
void list_in_parts(const Queries& queries, std::size_t size, std::vector<Answer>& answers,
                   std::vector<std::size_t>& begins, const Function& f)
{
  std::vector<std::vector<Answer>> found(Parts::number(size, least_queries<Parts>));
  std::vector<std::size_t> ends(size + 1);
  query_in_parts<Parts>(queries, size,
                        [&](Queries& queries_of_part, std::size_t i, std::size_t part) {
                          std::vector<Answer>& of_part = found[part];
                          const std::size_t before = of_part.size();
                          f(queries_of_part, i, std::back_inserter(of_part));
                          std::sort(of_part.begin() + std::ptrdiff_t(before), of_part.end());
                          ends[i + 1] = of_part.size() - before;
                        });
  for (std::size_t i = 0; i < size; ++i)
    ends[i + 1] += ends[i];
  std::vector<Answer> all;
  all.reserve(ends[size]);
  for (const std::vector<Answer>& of_part : found)
    all.insert(all.end(), of_part.begin(), of_part.end());
  answers.swap(all);
  begins.swap(ends);
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_SPACE_2_H
