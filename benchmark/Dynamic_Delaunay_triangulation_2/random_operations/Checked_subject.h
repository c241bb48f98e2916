// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_CHECKED_SUBJECT_H
#define RANDOM_OPERATIONS_CHECKED_SUBJECT_H

#include "Subject.h"
#include "test/Dynamic_Delaunay_triangulation_2/stamps.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/delaunay_agreement.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace random_operations {

// CGAL's own triangulation of the same points, which a certified one has to equal.
template <class Dynamic>
class Fresh_triangulation
{
  using Kernel = typename Dynamic::Geom_traits;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Tds = CGAL::Triangulation_data_structure_2<Vertex>;
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, Tds>;
  using Point = typename Kernel::Point_2;
  using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

public:
  // `ids` are those of all points.
  Fresh_triangulation(const Dynamic& dynamic, const std::vector<std::size_t>& ids)
    : m_dynamic(dynamic)
    , m_vertex_of_id(dynamic.number_of_ids())
  {
    typename Triangulation::Face_handle near;
    for (const std::size_t id : ids) {
      const std::size_t vertices = m_fresh.number_of_vertices();
      const auto vertex = m_fresh.insert(dynamic.point(id), near);
      if (m_fresh.number_of_vertices() > vertices) {
        vertex->info() = vertices;
      }
      near = vertex->face();
      m_vertex_of_id[id] = vertex->info();
    }
  }

  void check() const
  {
    require(m_fresh.number_of_vertices() == m_dynamic.number_of_vertices(), Fault::WRONG,
            "another number of vertices than a fresh triangulation");
    require(m_fresh.dimension() == m_dynamic.triangulation().dimension(), Fault::WRONG,
            "another dimension than a fresh triangulation");
    if (edges() != dynamic_edges()) { // where points are cocircular, both may be right
      const CGAL::Delaunay_agreement agreement = CGAL::delaunay_agreement(m_dynamic, m_fresh);
      require(agreement.is_perfect(), Fault::WRONG, "certified, but not Delaunay");
    }
  }

private:
  static void add(std::size_t v, std::size_t w, Edges& edges)
  {
    edges.emplace_back((std::min)(v, w), (std::max)(v, w));
  }

  Edges edges() const
  {
    Edges edges;
    for (auto e = m_fresh.finite_edges_begin(); e != m_fresh.finite_edges_end(); ++e) {
      add(e->first->vertex(m_fresh.cw(e->second))->info(),
          e->first->vertex(m_fresh.ccw(e->second))->info(), edges);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  Edges dynamic_edges() const
  {
    Edges edges;
    m_dynamic.for_each_edge(
        [&](std::size_t i, std::size_t j) { add(m_vertex_of_id[i], m_vertex_of_id[j], edges); });
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  const Dynamic& m_dynamic;
  Triangulation m_fresh;
  std::vector<std::size_t> m_vertex_of_id; // numbers of the fresh one
};

// The oracle. A Maker makes empty triangulations, triangulations of ranges, and points at places.
template <class Maker>
class Checked_subject : public Subject
{
public:
  using Dynamic = typename Maker::Dynamic;
  using Point = typename Maker::Point;

  explicit Checked_subject(Maker maker)
    : m_maker(std::move(maker))
  {
  }

  bool is_certified() const override { return dynamic().is_certified(); }

  std::size_t number_of_neighbors(Key key) const override
  {
    std::size_t neighbors = 0;
    for_each_neighbor(key, [&](Vertex_index) { ++neighbors; });
    return neighbors;
  }

  bool is_at_hull(Key key) const override
  {
    bool is_at_hull = false;
    for_each_neighbor(key, [&](Vertex_index v) { is_at_hull = is_at_hull || Frame::is_infinite(v); });
    return is_at_hull;
  }

  void check(const Model& points) override
  {
    const std::vector<std::size_t> ids = checked_ids(points);
    require(dynamic().is_valid(), Fault::WRONG, "is_valid() is false");
    check_vertices(points, ids);
    require(is_certified() || !CGAL::is_classifier_exact(dynamic().classifier()), Fault::WRONG,
            "not certified, though the classifier is exact");
    if (is_certified()) {
      Fresh_triangulation<Dynamic>(dynamic(), ids).check();
    }
  }

protected:
  virtual const Dynamic& dynamic() const = 0;
  // Throws a Finding if there is no such point.
  virtual std::size_t id(Key key) const = 0;

  const Maker& maker() const { return m_maker; }
  Point point(const Place& place) const { return m_maker.point(place); }

  std::vector<Point> points_of(const Entries& entries) const
  {
    std::vector<Point> points;
    for (const auto& [key, place] : entries) {
      points.push_back(point(place));
    }
    return points;
  }

  // Whether what `call` does was refused.
  template <class Function>
  static bool is_refused(const Function& call)
  {
    try {
      call();
      return false;
    } catch (const CGAL::Dynamic_Delaunay_triangulation_error_2&) {
      return true;
    }
  }

  // To be called where points may get other vertices.
  void forget_vertices() { m_stamps.clear(); }

  // Kernels with exact constructions cannot even represent such points.
  static constexpr bool has_nan = std::is_same_v<typename Dynamic::Geom_traits::FT, double>;

  static Point broken_point(Misuse misuse)
  {
    if constexpr (has_nan) {
      using Limits = std::numeric_limits<double>;
      return misuse == Misuse::NAN_COORDINATE ? Point(0, Limits::quiet_NaN())
                                              : Point(-Limits::infinity(), 0);
    } else {
      throw std::logic_error("there is no broken point");
    }
  }

private:
  using Frame = typename Dynamic::Frame;
  using Vertex_index = typename Frame::Vertex_index;
  using Vertex_handle = typename Dynamic::Vertex_handle;

  template <class Function>
  void for_each_neighbor(Key key, const Function& f) const
  {
    const Frame frame = dynamic().frame();
    if (frame.number_of_faces() > 0) {
      frame.for_each_neighbor(frame.vertex(id(key)), f);
    }
  }

  // In the order of the model.
  std::vector<std::size_t> checked_ids(const Model& points) const
  {
    require(dynamic().number_of_points() == points.size(), Fault::LOST, "points are missing");
    std::vector<std::size_t> ids;
    std::vector<bool> is_named(dynamic().number_of_ids());
    for (const auto& [key, place] : points) {
      const std::size_t its_id = id(key);
      require(its_id < is_named.size() && dynamic().has_id(its_id), Fault::LOST, "an id is lost");
      require(!is_named[its_id], Fault::LOST, "two points have the same id");
      is_named[its_id] = true;
      require(dynamic().point(its_id) == point(place), Fault::LOST, "a point is somewhere else");
      ids.push_back(its_id);
    }
    for (std::size_t id = 0; id < is_named.size(); ++id) {
      require(is_named[id] == dynamic().has_id(id), Fault::LOST,
              "there is an id that no point has");
    }
    return ids;
  }

  // A vertex stays the same while its point coincides with no other.
  void check_vertices(const Model& points, const std::vector<std::size_t>& ids)
  {
    std::map<std::pair<double, double>, std::size_t> points_at;
    for (const auto& [key, place] : points) {
      ++points_at[{place.x, place.y}];
    }
    std::map<Key, std::size_t> stamps;
    auto its_id = ids.begin();
    for (const auto& [key, place] : points) {
      const Vertex_handle vertex = dynamic().vertex(*its_id++);
      require(dynamic().point(dynamic().id(vertex)) == point(place), Fault::LOST,
              "a duplicate has a representative somewhere else");
      if constexpr (has_stamps<Dynamic>) {
        if (points_at[{place.x, place.y}] == 1) {
          const auto before = m_stamps.find(key);
          const std::size_t stamp = vertex->info().value;
          require(before == m_stamps.end() || before->second == stamp, Fault::LOST,
                  "a point has another vertex");
          stamps.emplace_hint(stamps.end(), key, stamp);
        }
      }
    }
    m_stamps = std::move(stamps);
  }

  Maker m_maker;
  std::map<Key, std::size_t> m_stamps; // of vertices of points that coincide with no other
};

} // namespace random_operations

#endif // RANDOM_OPERATIONS_CHECKED_SUBJECT_H
