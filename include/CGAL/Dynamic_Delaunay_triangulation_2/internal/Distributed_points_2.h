// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_POINTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_POINTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distributed_zone_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

using Distributed_id_2 = std::int64_t;

// A point as it is sent.
struct Distributed_entry_2
{
  Distributed_id_2 id;
  double x, y;
};

// The points that a rank holds, its own and ghosts, and their triangulation. All of them have
// places, which are the ids of that triangulation.
//
// Each rank keeps the list of the points that it has sent to each other one, its *exports* there;
// the other one keeps the list of their places, its *imports*, in the same order. A frame sends the
// positions of exports, tells which of them are no longer sent, and adds all own points that are
// now in the zone of the other one. So after each frame a rank holds all points in its zone.
template <class Kernel>
class Distributed_points_2
{
public:
  using Id = Distributed_id_2;
  using Entry = Distributed_entry_2;
  using Point = typename Kernel::Point_2;
  using Dynamic = Dynamic_Delaunay_triangulation_2<Kernel>;

  explicit Distributed_points_2(Distributed_ranks_2& ranks)
    : m_ranks(ranks)
    , m_links(ranks.size())
    , m_zones(ranks.size())
  {
  }

  const Dynamic& dt() const { return m_dt; }
  // Of the own points, in the order of updates.
  const std::vector<Index>& owned() const { return m_owned; }
  std::size_t number_of_ghosts() const { return m_places.size() - m_owned.size(); }
  // By places.
  Id id(Index place) const { return m_ids[place]; }
  const Point& point(Index place) const { return m_points[place]; }
  bool is_owned(Index place) const { return m_is_owned[place]; }
  bool is_exported(Index place, std::size_t rank) const
  {
    const std::vector<bool>& are_exported = m_links[rank].are_exported;
    return place < are_exported.size() && are_exported[place];
  }
  bool holds(Id id) const { return m_places.count(id) > 0; }
  // \pre `holds(id)`
  Index place(Id id) const { return m_places.at(id); }

  // By places: where the own points are in their order.
  std::vector<Index> order() const
  {
    std::vector<Index> order(m_points.size(), no_index);
    for (std::size_t k = 0; k < m_owned.size(); ++k)
      order[m_owned[k]] = Index(k);
    return order;
  }

  template <class Function>
  void for_each_held(const Function& f) const
  {
    for (Index place = 0; place < m_points.size(); ++place)
      if (m_dt.has_id(place))
        f(place);
  }

  bool certify() { return m_dt.certify(); }

  // Vertices of the triangulation, by their numbers.
  std::vector<std::uint8_t> owned_vertices() const
  {
    const auto frame = m_dt.frame();
    std::vector<std::uint8_t> are_owned(frame.number_of_vertices() + std::size_t(1), 0);
    for (const Index place : m_owned)
      are_owned[frame.vertex(place)] = 1;
    return are_owned;
  }

  // Forgets all points, and owns these.
  Update_report_2 reset(const std::vector<Entry>& owned)
  {
    m_dt = Dynamic();
    m_ids.clear();
    m_points.clear();
    m_is_owned.clear();
    m_places.clear();
    m_owned.clear();
    m_links.assign(m_ranks.size(), Link());
    m_zones.assign(m_ranks.size(), Distributed_zone_2());
    return insert(owned);
  }

  Update_report_2 insert(const std::vector<Entry>& owned)
  {
    std::vector<Point> points;
    for (const Entry& entry : owned)
      points.push_back(Point(entry.x, entry.y));
    std::vector<Index> places;
    const Update_report_2 report = m_dt.insert(points, std::back_inserter(places));
    for (std::size_t k = 0; k < owned.size(); ++k)
      note(places[k], owned[k], true);
    m_owned.insert(m_owned.end(), places.begin(), places.end());
    return report;
  }

  // Removes own points. Other ranks hear of that in the next frame.
  Update_report_2 remove(const std::vector<Index>& places)
  {
    for (const Index place : places) {
      m_places.erase(m_ids[place]);
      m_is_owned[place] = false;
      for (Link& link : m_links)
        if (place < link.are_exported.size() && link.are_exported[place]) {
          link.are_exported[place] = false;
          *std::find(link.exports.begin(), link.exports.end(), place) = no_index;
        }
    }
    m_owned.erase(std::remove_if(m_owned.begin(), m_owned.end(),
                                 [&](Index place) { return !m_is_owned[place]; }),
                  m_owned.end());
    return m_dt.remove(places);
  }

  // `positions` are those of the own points, in their order.
  void move(const std::vector<Point>& positions)
  {
    for (std::size_t k = 0; k < m_owned.size(); ++k)
      m_points[m_owned[k]] = positions[k];
  }

  // Exchanges what has changed with the other ranks, and updates the triangulation.
  Update_report_2 exchange()
  {
    std::vector<Message_2> messages = m_ranks.empty_messages();
    const Owned_boxes boxes = owned_boxes();
    for (std::size_t r = 0; r < m_links.size(); ++r)
      if (r != std::size_t(m_ranks.rank()))
        write_frame(r, boxes, messages[r]);
    m_ranks.start(std::move(messages));
    std::vector<std::size_t> gone;
    std::vector<Coming> coming;
    for (Message_2& message : m_ranks.finish())
      read_frame(message, gone, coming);
    std::vector<Point> points;
    for (const Coming& one : coming)
      points.push_back(Point(one.entry.x, one.entry.y));
    std::vector<std::size_t> places;
    const Update_report_2 report =
        m_dt.update_population(m_points.begin(), m_points.end(), gone, points, places);
    note_ghosts(coming, places);
    return report;
  }

  void export_to(std::size_t rank, Index place)
  {
    Link& link = m_links[rank];
    link.exports.push_back(place);
    link.idle_frames.push_back(0);
    if (link.are_exported.size() <= place)
      link.are_exported.resize(m_points.size(), false);
    link.are_exported[place] = true;
  }

  // What other ranks have sent as answers: pairs of the rank and the point.
  Update_report_2 import(const std::vector<std::pair<std::size_t, Entry>>& entries)
  {
    std::vector<Coming> coming;
    std::vector<Point> points;
    for (const auto& [rank, entry] : entries) {
      coming.push_back({rank, entry});
      points.push_back(Point(entry.x, entry.y));
    }
    std::vector<std::size_t> places;
    const Update_report_2 report = m_dt.insert(points, std::back_inserter(places));
    note_ghosts(coming, places);
    return report;
  }

  // Tells all ranks the zones of those that have a new one, and `zone` is that of this rank. From
  // the next frame on they are sent all points in these zones.
  void publish(const Distributed_zone_2* zone)
  {
    const auto all = m_ranks.gather(zone ? zone->to_words() : std::vector<std::uint64_t>());
    for (std::size_t r = 0; r < m_zones.size(); ++r)
      if (all.offsets[r] < all.offsets[r + 1] && r != std::size_t(m_ranks.rank()))
        m_zones[r] =
            Distributed_zone_2::of_words(all.values.begin() + std::ptrdiff_t(all.offsets[r]),
                                         all.values.begin() + std::ptrdiff_t(all.offsets[r + 1]));
  }

  // Whether both sides of each link hold the same points at the same positions. Collective.
  bool links_are_valid()
  {
    std::vector<Message_2> messages = m_ranks.empty_messages();
    for (std::size_t r = 0; r < m_links.size(); ++r)
      for (const Index place : m_links[r].exports)
        messages[r].write(Entry{m_ids[place], m_points[place].x(), m_points[place].y()});
    bool are_valid = true;
    std::size_t imports = 0;
    for (Message_2& message : m_ranks.send(std::move(messages))) {
      const Link& link = m_links[std::size_t(message.rank())];
      imports += link.imports.size();
      for (const Index place : link.imports) {
        const Entry entry = message.is_read() ? Entry{} : message.template read<Entry>();
        are_valid = are_valid && m_ids[place] == entry.id && m_points[place].x() == entry.x &&
                    m_points[place].y() == entry.y && !m_is_owned[place];
      }
      are_valid = are_valid && message.is_read();
    }
    return are_valid && imports == number_of_ghosts();
  }

private:
  struct Link
  {
    std::vector<Index> exports;            // `no_index` where the point was removed
    std::vector<std::uint8_t> idle_frames; // how long each of them has been outside of the zone
    std::vector<bool> are_exported;        // by places
    std::vector<Index> imports;
  };
  struct Coming
  {
    std::size_t rank;
    Entry entry;
  };

  // Around all own points, and around each stretch of them, which are mostly close together. Few
  // zones of many ranks are near: without boxes each point would be looked at for each rank.
  struct Owned_boxes
  {
    Box_2 all;
    std::vector<Box_2> stretches;
  };
  static constexpr std::size_t stretch = 64;

  // So many frames outside of the zone a point is still sent: it may come back, and what was asked
  // for in one frame is often needed in the next ones.
  static constexpr std::uint8_t patience = 8;

  void note(Index place, const Entry& entry, bool is_own)
  {
    if (m_points.size() <= place) {
      m_ids.resize(place + std::size_t(1));
      m_points.resize(place + std::size_t(1));
      m_is_owned.resize(place + std::size_t(1));
    }
    m_ids[place] = entry.id;
    m_points[place] = Point(entry.x, entry.y);
    m_is_owned[place] = is_own;
    m_places[entry.id] = place;
  }

  void note_ghosts(const std::vector<Coming>& coming, const std::vector<std::size_t>& places)
  {
    for (std::size_t k = 0; k < coming.size(); ++k) {
      note(Index(places[k]), coming[k].entry, false);
      m_links[coming[k].rank].imports.push_back(Index(places[k]));
    }
  }

  Owned_boxes owned_boxes() const
  {
    Owned_boxes boxes;
    boxes.stretches.resize((m_owned.size() + stretch - 1) / stretch);
    for (std::size_t k = 0; k < m_owned.size(); ++k) {
      const Point& p = m_points[m_owned[k]];
      boxes.stretches[k / stretch].add(p.x(), p.y());
      boxes.all.add(p.x(), p.y());
    }
    return boxes;
  }

  void export_to_zone(std::size_t r, const Owned_boxes& boxes)
  {
    const Distributed_zone_2& zone = m_zones[r];
    if (!zone.may_meet(boxes.all))
      return;
    for (std::size_t s = 0; s < boxes.stretches.size(); ++s) {
      if (!zone.may_meet(boxes.stretches[s]))
        continue;
      const std::size_t beyond = (std::min)((s + 1) * stretch, m_owned.size());
      for (std::size_t k = s * stretch; k < beyond; ++k) {
        const Index place = m_owned[k];
        if (!is_exported(place, r) && zone.contains(m_points[place].x(), m_points[place].y()))
          export_to(r, place);
      }
    }
  }

  // Numbers of exports that end and that begin; the places in the list of those that end; positions
  // of those that stay; and the new points.
  void write_frame(std::size_t r, const Owned_boxes& boxes, Message_2& message)
  {
    Link& link = m_links[r];
    const std::vector<std::uint64_t> ending = drop_exports(r);
    const std::size_t staying = link.exports.size();
    export_to_zone(r, boxes);
    const std::size_t beginning = link.exports.size() - staying;
    if (link.exports.empty() && ending.empty())
      return;
    message.write(std::uint64_t(ending.size()));
    message.write(std::uint64_t(beginning));
    for (const std::uint64_t k : ending)
      message.write(k);
    for (std::size_t k = 0; k < staying; ++k) {
      const Point& p = m_points[link.exports[k]];
      message.write(Position_2{p.x(), p.y()});
    }
    for (std::size_t k = staying; k < link.exports.size(); ++k) {
      const Index place = link.exports[k];
      message.write(Entry{m_ids[place], m_points[place].x(), m_points[place].y()});
    }
  }

  // Those that were removed, or have been outside of the zone for long.
  std::vector<std::uint64_t> drop_exports(std::size_t r)
  {
    Link& link = m_links[r];
    std::vector<std::uint64_t> ending;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < link.exports.size(); ++k) {
      const Index place = link.exports[k];
      if (place == no_index) {
        ending.push_back(k);
        continue;
      }
      const bool is_inside = m_zones[r].contains(m_points[place].x(), m_points[place].y());
      const auto idle = std::uint8_t(is_inside ? 0 : link.idle_frames[k] + 1);
      if (idle > patience) {
        ending.push_back(k);
        link.are_exported[place] = false;
        continue;
      }
      link.exports[kept] = place;
      link.idle_frames[kept++] = idle;
    }
    link.exports.resize(kept);
    link.idle_frames.resize(kept);
    return ending;
  }

  void read_frame(Message_2& message, std::vector<std::size_t>& gone, std::vector<Coming>& coming)
  {
    const auto r = std::size_t(message.rank());
    std::vector<Index>& imports = m_links[r].imports;
    auto ending = message.template read<std::uint64_t>();
    const auto beginning = message.template read<std::uint64_t>();
    for (; ending > 0; --ending) {
      Index& place = imports.at(message.template read<std::uint64_t>());
      gone.push_back(place);
      m_places.erase(m_ids[place]);
      place = no_index;
    }
    imports.erase(std::remove(imports.begin(), imports.end(), no_index), imports.end());
    for (const Index place : imports) {
      const auto p = message.template read<Position_2>();
      m_points[place] = Point(p.x, p.y);
    }
    for (std::uint64_t k = 0; k < beginning; ++k)
      coming.push_back({r, message.template read<Entry>()});
  }

  Distributed_ranks_2& m_ranks;
  Dynamic m_dt;
  std::vector<Id> m_ids;
  std::vector<Point> m_points;
  std::vector<bool> m_is_owned;
  std::unordered_map<Id, Index> m_places;
  std::vector<Index> m_owned;
  std::vector<Link> m_links;               // by ranks
  std::vector<Distributed_zone_2> m_zones; // by ranks
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_POINTS_2_H
