// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_checkpoint_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_proof_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_image_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What distributed triangulations in the plane and in a periodic space have in common; their public
// classes document the functions. After each change faces are proved, and points are distributed
// anew if a rank has too many of them.
//
// `Space` is `Distributed_plane_2` or `Distributed_torus_2`.
template <class Space>
class Distributed_triangulation_2
{
  using Ranks = Distributed_ranks_2;
  using Proof = Distributed_proof_2<Space>;
  using Checkpoint = Distributed_checkpoint_2<Space>;
  using Order = Distributed_order_2;
  using Entry = Distributed_entry_2;

public:
  using Points = Distributed_points_2<Space>;
  using Cells = Distributed_cells_2<Points>;
  using Id = Distributed_id_2;
  using size_type = std::size_t;

  explicit Distributed_triangulation_2(MPI_Comm communicator)
    : m_ranks(communicator)
    , m_points(m_ranks)
    , m_proof(m_ranks, m_points)
  {
  }

  // All functions but const ones and `ranks()` are collective, under `Default_floating_point`.
  // Whatever is to be the same on all ranks is compared before it is used.

  // Begins with these points, in the space that `make_space()` returns, if it does not throw.
  template <class MakeSpace, class InputIterator>
  void begin(const MakeSpace& make_space, InputIterator first, InputIterator beyond,
             double load_factor)
  {
    Space space;
    std::vector<Entry> entries;
    m_ranks.agree(Space::constructor, [&] {
      if (!(load_factor >= 1))
        throw Parameter_error_2("the load factor", load_factor, 1, infinity);
      space = make_space();
      entries = read(space, first, beyond);
    });
    if (!m_ranks.is_same(load_factor))
      throw Parameter_error_2("the load factor", load_factor, "the same on all ranks");
    space.agree(m_ranks);
    refuse_repeated(seen_here(ids_of(entries)));
    m_load_factor = load_factor;
    m_order.stay(m_ranks, entries.size());
    reset(space, std::move(entries));
  }

  // Moves the own points, in the same space as before.
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond)
  {
    const auto same = [&] { return space(); };
    Space next = space();
    const auto positions = read_frame("update()", next, same, first, beyond);
    return move(next, positions);
  }

  // Moves the own points, in the space that `make_space()` returns, if it does not throw.
  template <class MakeSpace, class InputIterator>
  Update_report_2 update_in(const MakeSpace& make_space, InputIterator first, InputIterator beyond)
  {
    Space next = space();
    const auto positions = read_frame("update() with a cell", next, make_space, first, beyond);
    next.agree(m_ranks);
    return move(next, positions);
  }

  template <class InputIterator>
  Update_report_2 insert(InputIterator first, InputIterator beyond)
  {
    std::vector<Entry> entries;
    m_ranks.agree("insert()", [&] { entries = read(space(), first, beyond); });
    check_new(ids_of(entries));
    m_is_certified = false;
    const Update_report_2 report = m_points.insert(entries);
    m_points.start_exchange();
    return complete(report);
  }

  template <class InputIterator>
  Update_report_2 remove(InputIterator first, InputIterator beyond)
  {
    std::vector<Id> given;
    m_ranks.agree("remove()", [&] { given.assign(first, beyond); });
    const std::vector<Index> own = own_places(given);
    m_is_certified = false;
    const Update_report_2 report = m_points.remove(own);
    m_points.start_exchange();
    return complete(report);
  }

  void distribute()
  {
    m_ranks.agree("distribute()");
    distribute_anew();
  }

  size_type number_of_distributions() const { return m_distributions; }

  template <class T>
  std::vector<T> carry(const std::vector<T>& data)
  {
    m_ranks.agree("carry() with " + std::to_string(sizeof(T)) + " bytes of each point", [&] {
      if (data.size() != m_order.size_before())
        throw Point_count_error_2(m_order.size_before(), data.size(),
                                  "one for each point that this rank owned before the last "
                                  "distribution");
    });
    return m_order.carry(m_ranks, data);
  }

  const Space& space() const { return m_points.space(); }
  const Points& points() const { return m_points; }
  const Proof& proof() const { return m_proof; }
  const Ranks& ranks() const { return m_ranks; }
  Ranks& ranks() { return m_ranks; }
  bool is_certified() const { return m_is_certified; }

  std::vector<Id> owned_ids() const
  {
    std::vector<Id> ids;
    for (const Index place : m_points.owned())
      ids.push_back(m_points.id(place));
    return ids;
  }

  // The ids and positions of the own points, as they were given.
  std::vector<Entry> owned_entries() const
  {
    std::vector<Entry> entries;
    for (const Index place : m_points.owned())
      entries.push_back(m_points.entry(place));
    return entries;
  }

  // Calls f(i, j) with the places of both ends of each edge whose first end, i, is an own point.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    Cells(m_points).for_each_edge([&](Index i, Index j) {
      if (m_points.is_owned(i))
        f(i, j);
    });
  }

  // Calls f(i, j, k) with the places of the corners of each face whose corner i is an own point.
  template <class Function>
  void for_each_face(const Function& f) const
  {
    Cells(m_points).for_each_face([&](Index i, Index j, Index k) {
      if (m_points.is_owned(i))
        f(i, j, k);
    });
  }

  // Calls f(k, i, j) for each neighbor of each own point: k is the index of the own point, i its
  // place, and j the place of the neighbor.
  template <class Function>
  void for_each_neighbor(const Function& f) const
  {
    const std::vector<Index> order = m_points.order();
    Cells(m_points).for_each_edge([&](Index i, Index j) {
      if (m_points.is_owned(i))
        f(size_type(order[i]), i, j);
      if (m_points.is_owned(j))
        f(size_type(order[j]), j, i);
    });
  }

  // Calls f(k, i, j) for each own point, of index k and place i, and each place j of a point that
  // coincides with it, if i or j is the label of both.
  template <class Function>
  void for_each_duplicate(const Function& f) const
  {
    const Cells cells(m_points);
    const std::vector<Index> order = m_points.order();
    m_points.for_each_held([&](Index i) {
      const Index label = cells.label(i);
      if (label != i && m_points.is_owned(i))
        f(size_type(order[i]), i, label);
      if (label != i && m_points.is_owned(label))
        f(size_type(order[label]), label, i);
    });
  }

  void write_checkpoint(const std::string& path)
  {
    m_ranks.agree("write_checkpoint()");
    Checkpoint(m_ranks, path, 0).write(space().parameters(), owned_entries(), nullptr);
  }

  template <class T>
  void write_checkpoint(const std::string& path, const std::vector<T>& data)
  {
    static_assert(std::is_trivially_copyable_v<T>, "only plain data can be written");
    m_ranks.agree("write_checkpoint()", [&] {
      if (data.size() != m_points.owned().size())
        throw Point_count_error_2(m_points.owned().size(), data.size(), due);
    });
    const auto bytes = reinterpret_cast<const char*>(data.data());
    Checkpoint(m_ranks, path, sizeof(T)).write(space().parameters(), owned_entries(), bytes);
  }

  void read_checkpoint(const std::string& path)
  {
    std::vector<char> data;
    read_checkpoint(path, data, 0);
    m_order.stay(m_ranks, m_points.owned().size());
  }

  template <class T>
  void read_checkpoint(const std::string& path, std::vector<T>& data)
  {
    static_assert(std::is_trivially_copyable_v<T>, "only plain data can be read");
    std::vector<char> bytes;
    read_checkpoint(path, bytes, sizeof(T));
    std::vector<T> read(bytes.size() / sizeof(T));
    if (!read.empty())
      std::memcpy(static_cast<void*>(read.data()), bytes.data(), bytes.size());
    data = m_order.carry(m_ranks, read);
    m_order.stay(m_ranks, m_points.owned().size());
  }

  bool certify()
  {
    m_ranks.agree("certify()");
    m_proof.run(false);
    const bool is_proved = m_points.certify();
    m_is_certified = !m_ranks.is_any(!is_proved);
    return m_is_certified;
  }

  bool is_valid()
  {
    m_ranks.agree("is_valid()");
    std::vector<Id> ids = seen_here(owned_ids());
    std::sort(ids.begin(), ids.end());
    bool is_valid = std::adjacent_find(ids.begin(), ids.end()) == ids.end();
    is_valid = m_points.links_are_valid() && is_valid;
    is_valid = m_points.dt().is_valid() && is_valid;
    std::uint64_t vertices = m_points.owned().size(), edges = 0, faces = 0;
    for_each_duplicate(
        [&](size_type, Index i, Index label) { vertices -= m_points.id(label) < m_points.id(i); });
    for_each_edge([&](Index, Index) { ++edges; });
    for_each_face([&](Index, Index, Index) { ++faces; });
    vertices = m_ranks.sum(vertices);
    edges = m_ranks.sum(edges);
    faces = m_ranks.sum(faces);
    const bool has_right_shape = vertices == 0
                                     ? edges == 0 && faces == 0
                                     : vertices + faces == edges + Space::euler_characteristic;
    return !m_ranks.is_any(!is_valid) && has_right_shape;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  // So many points above a limit are never too many.
  static constexpr double spare_load = 64;
  // Where points move so fast that ranks ask in every frame, they hold many ghosts whatever they
  // own. So distribution because of held points waits for so many calls after the last one.
  static constexpr int calls_between_distributions = 32;

  // How many positions or data a rank has to give.
  static constexpr const char* due = "one for each point that this rank owns";

  using Point = typename Points::Point;

  template <class InputIterator>
  static std::vector<Entry> read(const Space& space, InputIterator first, InputIterator beyond)
  {
    std::vector<Entry> entries;
    for (; first != beyond; ++first) {
      auto&& value = *first;
      const Point& given = value.second;
      const Position_2 p = space.checked(given, entries.size());
      entries.push_back({Id(value.first), p.x, p.y});
    }
    return entries;
  }

  // Sets `next` to the next space, and returns the positions of the own points in it.
  template <class MakeSpace, class InputIterator>
  std::vector<Position_2> read_frame(const std::string& call, Space& next,
                                     const MakeSpace& make_space, InputIterator first,
                                     InputIterator beyond)
  {
    std::vector<Position_2> positions;
    m_ranks.agree(call, [&] {
      next = make_space();
      const size_type n = m_points.owned().size();
      positions.resize(n);
      size_type given = 0;
      for (; first != beyond; ++first, ++given) {
        if (given == n)
          throw Point_count_error_2(n, n + 1, due);
        const Point& p = *first;
        positions[given] = next.checked(p, given);
      }
      if (given != n)
        throw Point_count_error_2(n, given, due);
    });
    return positions;
  }

  Update_report_2 move(const Space& next, const std::vector<Position_2>& positions)
  {
    m_is_certified = false;
    if (!next.continues(space()))
      return begin_anew(next, positions);
    m_points.start_exchange(next, positions);
    return complete(Update_report_2());
  }

  // Moves the own points if no ghosts or zones that ranks have sent each other are of use.
  Update_report_2 begin_anew(const Space& next, const std::vector<Position_2>& positions)
  {
    std::vector<Entry> entries = owned_entries();
    for (std::size_t k = 0; k < positions.size(); ++k)
      entries[k] = {entries[k].id, positions[k].x, positions[k].y};
    const Update_report_2 report = reset(next, std::move(entries));
    m_distributions += m_load_factor < infinity;
    return report;
  }

  // Replaces all points by these, distributed anew unless the load factor is infinite.
  Update_report_2 reset(const Space& space, std::vector<Entry> entries)
  {
    m_is_certified = false;
    if (m_load_factor < infinity)
      entries = m_order.distribute(m_ranks, space, entries);
    return commit(space, entries);
  }

  Update_report_2 commit(const Space& space, const std::vector<Entry>& entries)
  {
    Update_report_2 report = m_points.reset(space, entries);
    m_proof.forget_zone();
    report += prove();
    m_settled_load = double(m_ranks.largest(load())[0]);
    m_calls_since_distribution = 0;
    return report;
  }

  void read_checkpoint(const std::string& path, std::vector<char>& data, size_type size)
  {
    m_ranks.agree("read_checkpoint()");
    typename Checkpoint::Parameters parameters;
    Space space;
    std::vector<Entry> entries;
    Checkpoint checkpoint(m_ranks, path, size);
    checkpoint.read(parameters, entries, data);
    checkpoint.check([&] {
      space = Space(parameters);
      for (size_type k = 0; k < entries.size(); ++k) {
        const Position_2 p = space.checked(Point(entries[k].x, entries[k].y), k);
        entries[k] = {entries[k].id, p.x, p.y};
      }
    });
    const std::vector<Id> ids = seen_here(ids_of(entries));
    checkpoint.check([&] { refuse_repeated(ids); });
    m_order.stay(m_ranks, entries.size());
    reset(space, std::move(entries));
    ++m_distributions;
  }

  static std::vector<Id> ids_of(const std::vector<Entry>& entries)
  {
    std::vector<Id> ids;
    for (const Entry& entry : entries)
      ids.push_back(entry.id);
    return ids;
  }

  // Sends each id to one rank, so that repeated ones meet there. Returns the ids that arrive here.
  std::vector<Id> seen_here(const std::vector<Id>& ids)
  {
    return m_ranks.delivered<Id>([&](const auto& post) {
      for (const Id id : ids)
        post(std::uint64_t(id) % m_ranks.size(), id);
    });
  }

  // Throws on all ranks if any of them sees an id twice.
  void refuse_repeated(std::vector<Id> ids)
  {
    std::sort(ids.begin(), ids.end());
    const auto repeated = std::adjacent_find(ids.begin(), ids.end());
    const bool is_any = m_ranks.is_any(repeated != ids.end());
    const Id none = (std::numeric_limits<Id>::max)();
    const Id lowest = m_ranks.lowest(repeated != ids.end() ? *repeated : none);
    if (is_any)
      throw Repeated_id_error_2(lowest);
  }

  void check_new(const std::vector<Id>& ids)
  {
    std::vector<Id> all = m_ranks.gather(ids).values;
    const std::vector<Id> given = all;
    for (const Id id : given)
      if (is_own(id))
        all.push_back(id);
    refuse_repeated(std::move(all));
  }

  bool is_own(Id id) const { return m_points.holds(id) && m_points.is_owned(m_points.place(id)); }

  // Returns the places of own points whose ids any rank has given.
  std::vector<Index> own_places(const std::vector<Id>& given)
  {
    std::vector<Id> all = m_ranks.gather(given).values;
    refuse_repeated(all);
    std::vector<Index> places;
    std::vector<Id> own;
    for (const Id id : all)
      if (is_own(id)) {
        places.push_back(m_points.place(id));
        own.push_back(id);
      }
    std::vector<Id> known = m_ranks.gather(own).values;
    std::sort(known.begin(), known.end());
    std::sort(all.begin(), all.end());
    const auto first = std::mismatch(known.begin(), known.end(), all.begin()).second;
    if (first != all.end())
      throw Unknown_user_id_error_2(*first);
    return places;
  }

  void distribute_anew()
  {
    m_is_certified = false;
    commit(space(), m_order.distribute(m_ranks, space(), owned_entries()));
    ++m_distributions;
  }

  // Completes a change of own points, after `start_exchange()`.
  Update_report_2 complete(Update_report_2 report)
  {
    m_proof.prepare();
    report += m_points.finish_exchange();
    report += prove();
    balance();
    return report;
  }

  Update_report_2 prove()
  {
    Update_report_2 report = m_proof.run();
    report.certified = m_is_certified = m_points.dt().is_certified();
    return report;
  }

  // Distributes points if a rank has too many of them.
  void balance()
  {
    if (!(m_load_factor < infinity))
      return;
    const std::array<std::uint64_t, 2> most = m_ranks.largest(load());
    const double owned = double(m_ranks.sum(m_points.owned().size())) / double(m_ranks.size());
    const bool holds_many = double(most[0]) > m_load_factor * m_settled_load + spare_load;
    const bool owns_many = double(most[1]) > m_load_factor * owned + spare_load;
    if (owns_many || (holds_many && m_calls_since_distribution >= calls_between_distributions))
      return distribute_anew();
    ++m_calls_since_distribution;
    // the load falls as ghosts that answers have brought are dropped where they are not needed
    m_settled_load = (std::min)(m_settled_load, double(most[0]));
  }

  // The numbers of held points, and of own ones.
  std::array<std::uint64_t, 2> load() const
  {
    const std::uint64_t own = m_points.owned().size();
    return {own + m_points.number_of_ghosts(), own};
  }

  Ranks m_ranks;
  Points m_points;
  Proof m_proof;
  Order m_order;
  double m_load_factor = infinity;
  double m_settled_load = 0; // the most points that a rank holds, at its lowest since distribution
  int m_calls_since_distribution = 0;
  size_type m_distributions = 0;
  bool m_is_certified = false;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_TRIANGULATION_2_H
