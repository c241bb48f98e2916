// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POPULATION_EDITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POPULATION_EDITOR_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Planar_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Topology_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Topology_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vertex_order_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Points that come, go, meet and part. A few of them are edited into the triangulation, which has
// to be repaired where its edges are new then. Where they are many, or the plane is not spanned
// before or after, everything is triangulated anew: what can do so returns whether it has.
//
// If memory runs out on the way, each point has either come or gone, or it has not.
template <class Maintained>
class Population_editor_2
{
  using Editor = Topology_editor_2<Maintained>;
  using Builder = Topology_builder_2<Maintained>;
  using Removal_series = typename Editor::Removal_series;
  using Point = typename Maintained::Point;

public:
  Population_editor_2(Maintained& maintained, Editor& editor, Builder& builder)
    : m_maintained(maintained)
    , m_editor(editor)
    , m_builder(builder)
    , m_order(maintained)
  {
  }

  // The first points, where nobody is yet.
  void build(std::vector<Index> ids, std::vector<Point> points)
  {
    const Index number_of_ids = Index(ids.size()); // arguments come in any order
    m_builder.build(std::move(ids), std::move(points), number_of_ids);
  }

  // `ids` are the next ids.
  bool insert(const std::vector<Index>& ids, const std::vector<Point>& points)
  {
    if (has_to_rebuild(points.size(), 0)) {
      insert_all(ids, points);
      return true;
    }
    Index near = 1;
    for (std::size_t i = 0; i < points.size(); ++i)
      near = m_editor.insert(ids[i], points[i], near);
    return false;
  }

  // No id twice.
  bool remove(const std::vector<Index>& ids)
  {
    auto& known = m_maintained.ids;
    const auto hosts = std::size_t(
        std::count_if(ids.begin(), ids.end(), [&](Index id) { return known.is_host(id); }));
    if (has_to_rebuild(ids.size(), hosts)) {
      remove_all(ids);
      return true;
    }
    known.provide_for_removals(ids.size());
    Removal_series series(m_editor, hosts);
    for (const Index id : ids)
      remove(id, series);
    series.finish();
    return false;
  }

  // Of the vertices in the list that have come to the same place one stays, that of the smallest
  // id, and the points of the others become guests there. Returns how many vertices went; none do
  // if they are so many that a rebuild costs less.
  std::size_t merge(const std::vector<Index>& vertices)
  {
    auto& ids = m_maintained.ids;
    m_order.sort(vertices.begin(), vertices.end());
    std::vector<std::pair<Index, Index>> pairs; // of ids: vertices will change their numbers
    m_order.for_each_coincident_pair(
        [&](Index v, Index w) { pairs.emplace_back(ids.host(v), ids.host(w)); });
    if (has_to_rebuild(pairs.size(), pairs.size()))
      return 0;
    ids.provide_for_guests(pairs.size());
    Removal_series series(m_editor, pairs.size());
    for (const auto& [i, j] : pairs) {
      Index stays = ids.vertex(i), goes = ids.vertex(j);
      if (ids.host(goes) < ids.host(stays))
        std::swap(stays, goes);
      const Point p = m_maintained.point(goes);
      series.remove(goes, [&] { merge(goes, stays, p); });
    }
    series.finish();
    return pairs.size();
  }

  // Gives points other positions. If none of a vertex's points stays, it goes with its host; else
  // one that stays becomes the host. Who is then no longer where its vertex is has to part.
  // Whether the faces of a vertex are still counterclockwise is not looked at.
  void move_all(const std::vector<Index>& ids, const std::vector<Point>& points)
  {
    move(ids, points, [this](Index v, const Point& p) { m_maintained.move_vertex(v, p); });
  }

  // The same, but vertices that leave their faces are taken out and put in again; the faces then
  // tile the hull if they did so before. Points that come to where others are become guests there.
  // Returns how many vertices went by that.
  std::size_t move_few(const std::vector<Index>& ids, const std::vector<Point>& points)
  {
    const std::size_t vertices = m_maintained.number_of_vertices();
    Removal_series series(m_editor, ids.size());
    move(ids, points, [&](Index v, const Point& p) {
      if (m_maintained.number_of_vertices() <= 3)
        return m_maintained.move_vertex(v, p);
      const Point place = m_maintained.point(v);
      m_maintained.move_vertex(v, p);
      if (is_in_its_faces(v))
        return;
      m_maintained.move_vertex(v, place);
      series.reinsert(v, p, [&](Index w) { merge(v, w, p); });
    });
    series.finish();
    return vertices - m_maintained.number_of_vertices();
  }

  // Whether one of these points goes to where another one of them is. To move one after the other
  // would let them share a vertex on the way, and they would come out with others than before.
  bool trade_places(const std::vector<Index>& ids, const std::vector<Point>& points) const
  {
    if (ids.size() < 2)
      return false;
    std::vector<Point> places = points_of(ids);
    const auto is_before = [this](const Point& p, const Point& q) {
      return compare_xy(m_maintained.traits(), p, q) == SMALLER;
    };
    std::sort(places.begin(), places.end(), is_before);
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (!are_together(points[i], m_maintained.point_of_id(ids[i])) &&
          std::binary_search(places.begin(), places.end(), points[i], is_before))
        return true;
    return false;
  }

  // The guests that are no longer where their vertex is.
  std::vector<Index> parted_guests() const
  {
    std::vector<Index> parted;
    for (const auto& guest : m_maintained.ids.guests())
      if (!are_together(guest.point, m_maintained.point(m_maintained.ids.vertex(guest.id))))
        parted.push_back(guest.id);
    return parted;
  }

  bool are_too_many(std::size_t number) const { return has_to_rebuild(number, 0); }

  // They get vertices of their own, or become guests elsewhere.
  void part(const std::vector<Index>& guests)
  {
    auto& ids = m_maintained.ids;
    for (const Index id : guests)
      m_editor.insert(id, Point(ids.guest(id).point), ids.vertex(id));
  }

private:
  // An insertion or removal costs about as much as a rebuild of eight vertices, and looks through
  // all guests. Where nothing changes, nothing has to.
  bool has_to_rebuild(std::size_t changes, std::size_t removals) const
  {
    constexpr std::size_t fewest_vertices = 3;
    const std::size_t vertices = m_maintained.number_of_vertices();
    const std::size_t guests = m_maintained.ids.guests().size();
    return changes > 0 &&
           (!m_maintained.is_mirrored() || (8 + guests / 64) * changes > vertices + guests ||
            vertices < fewest_vertices + removals);
  }

  void insert_all(const std::vector<Index>& ids, const std::vector<Point>& points)
  {
    std::vector<Index> all_ids = m_maintained.ids.hosts_and_guests();
    std::vector<Point> all_points = points_of(all_ids);
    Index number_of_ids = m_maintained.ids.number_of_ids();
    for (const Index id : ids)
      number_of_ids = (std::max)(number_of_ids, id + 1);
    all_ids.insert(all_ids.end(), ids.begin(), ids.end());
    all_points.insert(all_points.end(), points.begin(), points.end());
    m_builder.build(std::move(all_ids), std::move(all_points), number_of_ids);
  }

  void remove_all(const std::vector<Index>& ids)
  {
    std::vector<bool> goes(m_maintained.ids.number_of_ids());
    for (const Index id : ids)
      goes[id] = true;
    std::vector<Index> others = m_maintained.ids.hosts_and_guests();
    others.erase(std::remove_if(others.begin(), others.end(), [&](Index id) { return goes[id]; }),
                 others.end());
    std::vector<Point> points = points_of(others);
    m_builder.build(std::move(others), std::move(points), m_maintained.ids.number_of_ids());
  }

  std::vector<Point> points_of(const std::vector<Index>& ids) const
  {
    std::vector<Point> points;
    points.reserve(ids.size());
    for (const Index id : ids)
      points.push_back(m_maintained.point_of_id(id));
    return points;
  }

  // A host leaves the vertex to a guest, if there is one.
  void remove(Index id, Removal_series& series)
  {
    auto& ids = m_maintained.ids;
    const Index v = ids.vertex(id);
    if (ids.is_host(id)) {
      const Index heir = ids.find_guest_at(v, [](const auto&) { return true; });
      if (heir == no_index)
        return series.remove(v, [&] {
          m_maintained.visitor_calls.before_vertex_removal(m_maintained.vertices[v], id);
          ids.remove_host(id);
        });
      hand_over(heir, v, m_maintained.point(v));
    }
    ids.remove_guest(id);
  }

  template <class Move_vertex>
  void move(const std::vector<Index>& ids, const std::vector<Point>& points,
            const Move_vertex& move_vertex)
  {
    auto& known = m_maintained.ids;
    known.provide_for_guests(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (!known.is_host(ids[i]))
        known.guest(ids[i]).point = points[i];
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (known.is_host(ids[i]))
        move_host(ids[i], points[i], move_vertex);
  }

  template <class Move_vertex>
  void move_host(Index id, const Point& p, const Move_vertex& move_vertex)
  {
    auto& ids = m_maintained.ids;
    const Index v = ids.vertex(id);
    const Point place = m_maintained.point(v);
    if (are_together(p, place))
      return m_maintained.move_vertex(v, p); // there may be more to p than where it is
    const Index heir =
        ids.find_guest_at(v, [&](const auto& guest) { return are_together(guest.point, place); });
    if (heir == no_index)
      move_vertex(v, p);
    else
      hand_over(heir, v, p);
  }

  // Lets a guest at v be the host, so that v has its point, and the host a guest at p.
  void hand_over(Index guest, Index v, const Point& p)
  {
    auto& ids = m_maintained.ids;
    const Index host = ids.host(v);
    const Point point = ids.guest(guest).point;
    ids.hand_over(guest, p);
    m_maintained.move_vertex(v, point);
    m_maintained.visitor_calls.after_id_change(m_maintained.vertices[v], host);
  }

  // All points of vertex `goes`, at p, become guests of the other one.
  void merge(Index goes, Index stays, const Point& p)
  {
    auto& ids = m_maintained.ids;
    m_maintained.visitor_calls.before_vertex_merge(m_maintained.vertices[goes], ids.host(goes),
                                                   m_maintained.vertices[stays]);
    ids.merge(goes, stays, p);
  }

  bool are_together(const Point& p, const Point& q) const
  {
    return coincide(m_maintained.traits(), p, q);
  }

  // Whether all its faces are counterclockwise, and the hull convex around it.
  bool is_in_its_faces(Index v) const
  {
    const Certificate_2<Maintained> certificate(m_maintained);
    const auto& mirror = m_maintained.mirror;
    bool is_in = true;
    const auto look = [&](Index e) {
      const Edge_state_2 state = is_in ? certificate.state(e) : Edge_state_2::TWISTED;
      is_in = state == Edge_state_2::DELAUNAY || state == Edge_state_2::ILLEGAL;
    };
    mirror.for_each_corner(v, [&](Index h) {
      look(mirror.edge_of(h));
      look(mirror.edge_of(Neighborhood_mirror_2::previous(h)));
    });
    return is_in;
  }

  Maintained& m_maintained;
  Editor& m_editor;
  Builder& m_builder;
  Vertex_order_2<Maintained> m_order;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POPULATION_EDITOR_2_H
