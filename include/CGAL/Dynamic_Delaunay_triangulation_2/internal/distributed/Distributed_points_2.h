// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_POINTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_POINTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/Dynamic_triangulation_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_image_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_zone_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The points that a rank holds, its own and ghosts, and their triangulation. The *place* of a held
// point is its id in that triangulation. In a periodic space a rank holds images of points: one of
// each own point, and ghosts, which are images of points of any rank.
//
// For each receiving rank, and each shift by which images are sent there, a rank lists the points
// that it has sent, its *exports*; the receiver lists the places of these points, its *imports*, in
// the same order. A frame sends the positions of exports first, and tells which of them are no
// longer sent. While these messages are under way the rank moves all its other points, and sends
// all further images of own points that are now in the receiver's zone. So after each frame a rank
// holds all points in its zone.
//
// `Space` is `Distributed_plane_2` or `Distributed_torus_2`.
template <class Space_>
class Distributed_points_2
{
public:
  using Space = Space_;
  using Kernel = typename Space::Kernel;
  using Shift = typename Space::Shift;
  using Image = typename Space::Image;
  using Id = Distributed_id_2;
  using Entry = Distributed_entry_2;
  using Point = typename Kernel::Point_2;
  using Dynamic = Dynamic_Delaunay_triangulation_2<Kernel>;

  // An image as it is sent, and as it is received from a rank.
  struct Sent
  {
    Id id;
    Image image;
  };
  struct Coming
  {
    std::size_t rank;
    Shift shift;
    Sent sent;
  };

  explicit Distributed_points_2(Distributed_ranks_2& ranks)
    : m_ranks(ranks)
    , m_links(ranks.size())
    , m_zones(ranks.size())
  {
  }

  const Space& space() const { return m_space; }
  const Dynamic& dt() const { return m_dt; }
  // The places of the own points, in the order of updates.
  const std::vector<Index>& owned() const { return m_owned; }
  std::size_t number_of_ghosts() const { return m_places.size() - m_owned.size(); }
  // The id, position, shift and image of the held point at a place.
  Id id(Index place) const { return m_ids[place]; }
  const Point& point(Index place) const { return m_points[place]; }
  Position_2 position(Index place) const { return {m_points[place].x(), m_points[place].y()}; }
  const Shift& shift(Index place) const { return m_shifts[place]; }
  Image image(Index place) const
  {
    return {m_shifts[place], m_points[place].x(), m_points[place].y()};
  }
  // The id and the position that the user gave.
  Entry entry(Index place) const
  {
    const Position_2 given = m_space.given(image(place));
    return {m_ids[place], given.x, given.y};
  }
  bool is_owned(Index place) const { return m_is_owned[place]; }
  bool holds(Id id) const { return m_places.count(id) > 0; }
  // The place of the image that this rank owns, or else of a ghost. \pre `holds(id)`
  Index place(Id id) const
  {
    CGAL_precondition(holds(id));
    const auto [first, beyond] = m_places.equal_range(id);
    const auto own = std::find_if(first, beyond, [&](const auto& p) { return is_owned(p.second); });
    return own != beyond ? own->second : first->second;
  }

  // Whether the images of own points by `shift`, on `rank`, are the own points themselves.
  bool is_own_image(std::size_t rank, const Shift& shift) const
  {
    return rank == std::size_t(m_ranks.rank()) && m_space.is_none(shift);
  }

  // Whether `rank` holds the image of an own point by `shift`, as a ghost or as its own.
  bool is_held_by(std::size_t rank, Index place, const Shift& shift) const
  {
    if (is_own_image(rank, shift))
      return true;
    const auto link = m_links[rank].find(shift);
    return link != m_links[rank].end() && link->second.exports_place(place);
  }

  // For each place, the index in `owned()`, or `null_index`.
  std::vector<Index> order() const
  {
    std::vector<Index> order(m_points.size(), null_index);
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

  // For each vertex of the triangulation, 1 if an own point is there, the k-th one, for which
  // `is_meant(k)` holds, else 0.
  template <class Predicate>
  std::vector<std::uint8_t> owned_vertices(const Predicate& is_meant) const
  {
    const auto frame = m_dt.frame();
    std::vector<std::uint8_t> are_meant(frame.number_of_vertices() + std::size_t(1), 0);
    for (std::size_t k = 0; k < m_owned.size(); ++k) // no branches, which could not be predicted
      are_meant[frame.vertex(m_owned[k])] |= std::uint8_t(is_meant(k));
    return are_meant;
  }
  std::vector<std::uint8_t> owned_vertices() const
  {
    return owned_vertices([](std::size_t) { return true; });
  }

  // Replaces all points by these, which this rank owns.
  Update_report_2 reset(const Space& space, const std::vector<Entry>& owned)
  {
    m_space = space;
    m_dt = Dynamic();
    m_ids.clear();
    m_points.clear();
    m_shifts.clear();
    m_is_owned.clear();
    m_export_counts.clear();
    m_places.clear();
    m_owned.clear();
    m_links.assign(m_ranks.size(), {});
    m_zones.assign(m_ranks.size(), Distributed_zone_2());
    return insert(owned);
  }

  Update_report_2 insert(const std::vector<Entry>& owned)
  {
    std::vector<Sent> images;
    std::vector<Point> points;
    for (const Entry& entry : owned) {
      images.push_back({entry.id, m_space.first_image({entry.x, entry.y})});
      points.push_back(Point(images.back().image.x, images.back().image.y));
    }
    std::vector<Index> places;
    const Update_report_2 report = m_dt.insert(points, std::back_inserter(places));
    for (std::size_t k = 0; k < owned.size(); ++k)
      note(places[k], images[k], true);
    m_owned.insert(m_owned.end(), places.begin(), places.end());
    return report;
  }

  // Removes own points. The next exchange tells the other ranks.
  Update_report_2 remove(const std::vector<Index>& places)
  {
    for (const Index place : places) {
      forget(place);
      m_is_owned[place] = false;
      for (Links& links : m_links)
        for (auto& [shift, link] : links)
          if (link.exports_place(place)) {
            end_export(link, place);
            *std::find(link.exports.begin(), link.exports.end(), place) = null_index;
          }
    }
    m_owned.erase(std::remove_if(m_owned.begin(), m_owned.end(),
                                 [&](Index place) { return !m_is_owned[place]; }),
                  m_owned.end());
    return m_dt.remove(places);
  }

  // Moves the own points to `positions`, in the order of `owned()`, in a space that continues the
  // last one, and starts to send the changes to the other ranks.
  void start_exchange(const Space& space, const std::vector<Position_2>& positions)
  {
    const Space last = std::exchange(m_space, space);
    if (has_exports())
      move(true, positions, last);
    m_ranks.exchange().start();
    send_known();
    move(false, positions, last);
    for (Distributed_zone_2& zone : m_zones)
      zone.follow(m_space.basis());
    send_new();
  }

  // Starts to send the changes if points were inserted or removed, and none has moved.
  void start_exchange()
  {
    m_ranks.exchange().start();
    send_known();
    send_new();
  }

  // Waits for the messages of the other ranks, and updates the triangulation.
  Update_report_2 finish_exchange()
  {
    std::vector<std::size_t> gone;
    std::vector<Coming> coming;
    for (Message_2& message : m_ranks.exchange().finish())
      while (!message.is_read())
        read_part(message, gone, coming);
    std::vector<std::size_t> places;
    const Update_report_2 report =
        Triangulation_access::update_population(m_dt, m_points, gone, points_of(coming), places);
    note_ghosts(coming, places);
    return report;
  }

  // The zone of this rank, as the other ranks know it.
  const Distributed_zone_2& own_zone() const { return m_zones[std::size_t(m_ranks.rank())]; }

  // Calls f(place) for each ghost.
  template <class Function>
  void for_each_ghost(const Function& f) const
  {
    for (const Links& links : m_links)
      for (const auto& [shift, link] : links)
        std::for_each(link.imports.begin(), link.imports.end(), f);
  }

  // The id of an own point, and its image by `shift`, as another rank is sent them.
  Sent sent(Index place, const Shift& shift) const
  {
    return {m_ids[place], m_space.translated(image(place), shift)};
  }
  void export_to(std::size_t rank, Index place, const Shift& shift)
  {
    export_by(m_links[rank][shift], place);
  }

  // Inserts the ghosts that other ranks have sent as answers.
  Update_report_2 import(const std::vector<Coming>& coming)
  {
    std::vector<std::size_t> places;
    const Update_report_2 report = m_dt.insert(points_of(coming), std::back_inserter(places));
    note_ghosts(coming, places);
    return report;
  }

  // Tells all ranks the new zone of this rank, unless `zone` is null, and learns those of the
  // others. From the next frame on each rank is sent all points in its new zone. Collective.
  void publish(const Distributed_zone_2* zone)
  {
    const auto all = m_ranks.gather(zone ? zone->to_words() : std::vector<std::uint64_t>());
    for (std::size_t r = 0; r < m_zones.size(); ++r)
      if (all.offsets[r] < all.offsets[r + 1])
        m_zones[r] =
            Distributed_zone_2::of_words(all.values.begin() + std::ptrdiff_t(all.offsets[r]),
                                         all.values.begin() + std::ptrdiff_t(all.offsets[r + 1]));
  }

  // Whether both sides of each link hold the same points at the same positions. Collective.
  bool links_are_valid()
  {
    std::vector<Message_2> messages = m_ranks.empty_messages();
    for (std::size_t r = 0; r < m_links.size(); ++r)
      for (const auto& [shift, link] : m_links[r])
        for (const Index place : link.exports)
          messages[r].write(sent(place, shift));
    bool are_valid = true;
    std::size_t imports = 0;
    for (Message_2& message : m_ranks.send(std::move(messages))) {
      for (const auto& [shift, link] : m_links[std::size_t(message.rank())]) {
        imports += link.imports.size();
        for (const Index place : link.imports)
          are_valid = are_valid && !message.is_read() && !m_is_owned[place] &&
                      is_the_same(message.template read<Sent>(), place);
      }
      are_valid = are_valid && message.is_read();
    }
    return are_valid && imports == number_of_ghosts();
  }

private:
  struct Link
  {
    std::vector<Index> exports;            // `null_index` where the point was removed
    std::vector<std::uint8_t> idle_frames; // how long each of them has been outside of the zone
    std::vector<bool> are_exported;        // by places
    std::size_t known = 0; // how many exports, the first ones, had their positions sent this frame
    std::vector<Index> imports;

    bool exports_place(Index place) const
    {
      return place < are_exported.size() && are_exported[place];
    }
  };
  using Links = std::map<Shift, Link>;

  // The header of the part of a message about one shift, which follows: the numbers of exports that
  // end (their indices follow), stay (their images follow), and begin (ids and images follow).
  struct Part
  {
    std::uint64_t ending, staying, beginning;
  };

  // Boxes around all own points, and around each stretch of them, whose points are mostly close
  // together. Few ranks have zones near them: boxes save comparing each point with each zone.
  struct Owned_boxes
  {
    Box_2 all;
    std::vector<Box_2> stretches;
  };
  static constexpr std::size_t stretch = 64;

  // For how many frames a point outside of the zone is still sent: it may come back, and a point
  // that a rank has asked for in one frame is often needed in the next ones.
  static constexpr std::uint8_t patience = 8;

  // How many points are moved between two calls of `progress()`.
  static constexpr std::size_t moves_at_once = 2048;

  bool is_the_same(const Sent& other, Index place) const
  {
    return other.id == m_ids[place] && other.image.x == m_points[place].x() &&
           other.image.y == m_points[place].y() &&
           !(static_cast<const Shift&>(other.image) < m_shifts[place]) &&
           !(m_shifts[place] < static_cast<const Shift&>(other.image));
  }

  void export_by(Link& link, Index place)
  {
    link.exports.push_back(place);
    link.idle_frames.push_back(0);
    if (link.are_exported.size() <= place)
      link.are_exported.resize(m_points.size(), false);
    link.are_exported[place] = true;
    ++m_export_counts[place];
  }

  void end_export(Link& link, Index place)
  {
    link.are_exported[place] = false;
    --m_export_counts[place];
  }

  bool has_exports() const
  {
    return std::any_of(m_links.begin(), m_links.end(), [](const Links& links) {
      return std::any_of(links.begin(), links.end(),
                         [](const auto& link) { return !link.second.exports.empty(); });
    });
  }

  // Moves the own points that are exports, or all other own points.
  void move(bool are_exports, const std::vector<Position_2>& positions, const Space& last)
  {
    for (std::size_t k = 0; k < m_owned.size(); ++k) {
      const Index place = m_owned[k];
      if (k % moves_at_once == 0)
        m_ranks.exchange().progress();
      if ((m_export_counts[place] > 0) != are_exports)
        continue;
      put(place, m_space.next_image(positions[k], position(place), last));
    }
  }

  void note(Index place, const Sent& sent, bool is_own)
  {
    if (m_points.size() <= place) {
      m_ids.resize(place + std::size_t(1));
      m_points.resize(place + std::size_t(1));
      m_shifts.resize(place + std::size_t(1));
      m_is_owned.resize(place + std::size_t(1));
      m_export_counts.resize(place + std::size_t(1));
    }
    m_ids[place] = sent.id;
    put(place, sent.image);
    m_is_owned[place] = is_own;
    m_places.emplace(sent.id, place);
  }

  void put(Index place, const Image& image)
  {
    m_points[place] = Point(image.x, image.y);
    m_shifts[place] = image;
  }

  void forget(Index place)
  {
    const auto [first, beyond] = m_places.equal_range(m_ids[place]);
    m_places.erase(std::find_if(first, beyond, [&](const auto& p) { return p.second == place; }));
  }

  static std::vector<Point> points_of(const std::vector<Coming>& coming)
  {
    std::vector<Point> points;
    for (const Coming& one : coming)
      points.push_back(Point(one.sent.image.x, one.sent.image.y));
    return points;
  }

  void note_ghosts(const std::vector<Coming>& coming, const std::vector<std::size_t>& places)
  {
    for (std::size_t k = 0; k < coming.size(); ++k) {
      note(Index(places[k]), coming[k].sent, false);
      m_links[coming[k].rank][coming[k].shift].imports.push_back(Index(places[k]));
    }
  }

  Owned_boxes owned_boxes() const
  {
    Owned_boxes boxes;
    boxes.stretches.resize((m_owned.size() + stretch - 1) / stretch);
    for (std::size_t k = 0; k < m_owned.size(); ++k)
      boxes.stretches[k / stretch].add(position(m_owned[k]));
    for (const Box_2& box : boxes.stretches) {
      boxes.all.add({box.x_low, box.y_low});
      boxes.all.add({box.x_high, box.y_high});
    }
    return boxes;
  }

  // Whether any rank, or in a periodic space this one itself, may want images of own points.
  bool has_any_zone() const
  {
    for (std::size_t r = 0; r < m_zones.size(); ++r)
      if (!m_zones[r].is_empty() && (Space::has_other_images || r != std::size_t(m_ranks.rank())))
        return true;
    return false;
  }

  void export_to_zone(std::size_t r, const Owned_boxes& boxes)
  {
    const Distributed_zone_2& zone = m_zones[r];
    m_space.for_each_shift(boxes.all, zone.bounds(), [&](const Shift& shift) {
      const Position_2 v = m_space.vector(shift);
      if (!is_own_image(r, shift) && zone.may_meet(boxes.all.moved(v)))
        export_to_zone(zone, v, boxes, m_links[r][shift]);
    });
  }

  // Exports the images, moved by `v`, that are in the zone.
  void export_to_zone(const Distributed_zone_2& zone, const Position_2& v, const Owned_boxes& boxes,
                      Link& link)
  {
    for (std::size_t s = 0; s < boxes.stretches.size(); ++s) {
      if (!zone.may_meet(boxes.stretches[s].moved(v)))
        continue;
      const std::size_t beyond = (std::min)((s + 1) * stretch, m_owned.size());
      for (std::size_t k = s * stretch; k < beyond; ++k) {
        const Index place = m_owned[k];
        if (!link.exports_place(place) && is_in(zone, place, v))
          export_by(link, place);
      }
    }
  }

  bool is_in(const Distributed_zone_2& zone, Index place, const Position_2& v) const
  {
    return zone.contains(m_points[place].x() + v.x, m_points[place].y() + v.y);
  }

  // Sends the positions of exports, which the other ranks hold already.
  void send_known()
  {
    for (std::size_t r = 0; r < m_links.size(); ++r) {
      Message_2 message{int(r)};
      for (auto& [shift, link] : m_links[r])
        write_known(shift, link, message);
      m_ranks.exchange().send(std::move(message));
    }
  }

  // Sends images of own points that are in the zones of ranks that do not hold them yet.
  void send_new()
  {
    Owned_boxes boxes;
    if (has_any_zone())
      boxes = owned_boxes();
    for (std::size_t r = 0; r < m_links.size(); ++r) {
      m_ranks.exchange().progress();
      for (auto& [shift, link] : m_links[r])
        note_idle_exports(m_zones[r], m_space.vector(shift), link);
      export_to_zone(r, boxes);
      Message_2 message{int(r)};
      for (const auto& [shift, link] : m_links[r])
        write_new(shift, link, message);
      m_ranks.exchange().send(std::move(message));
      erase_unused(m_links[r]);
    }
  }

  void write_known(const Shift& shift, Link& link, Message_2& message)
  {
    if (link.exports.empty())
      return;
    const std::vector<std::uint64_t> ending = drop_exports(link);
    link.known = link.exports.size();
    message.write(Part{ending.size(), link.known, 0});
    message.write(shift);
    for (const std::uint64_t k : ending)
      message.write(k);
    for (const Index place : link.exports)
      message.write(sent(place, shift).image);
  }

  void write_new(const Shift& shift, const Link& link, Message_2& message) const
  {
    if (link.known == link.exports.size())
      return;
    message.write(Part{0, 0, link.exports.size() - link.known});
    message.write(shift);
    for (std::size_t k = link.known; k < link.exports.size(); ++k)
      message.write(sent(link.exports[k], shift));
  }

  static void erase_unused(Links& links)
  {
    for (auto link = links.begin(); link != links.end();)
      link = link->second.exports.empty() && link->second.imports.empty() ? links.erase(link)
                                                                          : std::next(link);
  }

  // Drops exports that were removed, or outside of the zone for long. Returns their indices.
  std::vector<std::uint64_t> drop_exports(Link& link)
  {
    std::vector<std::uint64_t> ending;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < link.exports.size(); ++k) {
      const Index place = link.exports[k];
      if (place != null_index && link.idle_frames[k] <= patience) {
        link.exports[kept] = place;
        link.idle_frames[kept++] = link.idle_frames[k];
        continue;
      }
      ending.push_back(k);
      if (place != null_index)
        end_export(link, place);
    }
    link.exports.resize(kept);
    link.idle_frames.resize(kept);
    return ending;
  }

  void note_idle_exports(const Distributed_zone_2& zone, const Position_2& v, Link& link)
  {
    for (std::size_t k = 0; k < link.exports.size(); ++k)
      link.idle_frames[k] =
          is_in(zone, link.exports[k], v) ? std::uint8_t(0) : std::uint8_t(link.idle_frames[k] + 1);
  }

  void read_part(Message_2& message, std::vector<std::size_t>& gone, std::vector<Coming>& coming)
  {
    const auto r = std::size_t(message.rank());
    const auto part = message.template read<Part>();
    const auto shift = message.template read<Shift>();
    std::vector<Index>& imports = m_links[r][shift].imports;
    for (std::uint64_t k = 0; k < part.ending; ++k) {
      Index& place = imports.at(message.template read<std::uint64_t>());
      gone.push_back(place);
      forget(place);
      place = null_index;
    }
    imports.erase(std::remove(imports.begin(), imports.end(), null_index), imports.end());
    for (std::uint64_t k = 0; k < part.staying; ++k)
      put(imports.at(k), message.template read<Image>());
    for (std::uint64_t k = 0; k < part.beginning; ++k)
      coming.push_back({r, shift, message.template read<Sent>()});
  }

  Distributed_ranks_2& m_ranks;
  Space m_space;
  Dynamic m_dt;
  std::vector<Id> m_ids;
  std::vector<Point> m_points;
  std::vector<Shift> m_shifts;
  std::vector<bool> m_is_owned;
  std::vector<std::uint32_t> m_export_counts; // by places: how many links export them
  std::unordered_multimap<Id, Index> m_places;
  std::vector<Index> m_owned;
  std::vector<Links> m_links;              // by ranks
  std::vector<Distributed_zone_2> m_zones; // by ranks
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_POINTS_2_H
