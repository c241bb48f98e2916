// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_TRANSLATIONS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_TRANSLATIONS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Message_exchange_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_image_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Converts the shifts of edges from one frame of a periodic space to the next: finds the shifts by
// which points were wrapped, and the cell's last vectors in multiples of its present ones.
//
// As in one process, a point is taken to have gone the shortest way, in multiples of the cell's
// vectors; the rest of its step is a shift. A rank compares positions of points that it owned then
// and owns now; those of another point are both sent to one rank. So the shifts depend on given
// positions alone. All ranks hear of the points that were wrapped. Cost: a pass over the own
// points; messages about points that were wrapped or have another owner now.
class Distributed_translations_2
{
public:
  using Id = Distributed_id_2;
  using Entry = Distributed_entry_2;

  // Compares own points, as they were given, with those of the last call. Collective.
  void compute(Distributed_ranks_2& ranks, const Periodic_cell_2& cell, std::vector<Entry> own)
  {
    std::sort(own.begin(), own.end(), [](const Entry& e, const Entry& f) { return e.id < f.id; });
    const Torus_2 last(m_cell), now(cell);
    const bool is_same = cell == m_cell;
    m_multiples = is_same ? unit_multiples : multiples_in_new_cell(last, now);
    const std::vector<Translation> found =
        translations(ranks, own, [&](const Entry& from, const Entry& to) {
          return is_same ? step_in_cell(now, from, to) : step_to_new_cell(last, now, from, to);
        });
    m_translations.clear();
    for (const Translation& t : ranks.gather(found).values)
      m_translations[t.id] = t.shift;
    m_cell = cell;
    m_own = std::move(own);
  }

  // The present shift of an edge from i to j that had this shift before the last `compute()`.
  Periodic_shift_2 renamed(Id i, Id j, const Periodic_shift_2& shift) const
  {
    const Periodic_shift_2 of_i = translation(i), of_j = translation(j);
    Periodic_shift_2 s;
    for (std::size_t k = 0; k < 2; ++k)
      s[k] = shift[0] * m_multiples[0][k] + shift[1] * m_multiples[1][k] + of_i[k] - of_j[k];
    return s;
  }

private:
  struct Translation
  {
    Id id;
    Periodic_shift_2 shift;
  };
  struct Sighting // of a point that the sender owned then, or owns now
  {
    Entry entry;
    std::uint64_t is_now;
  };

  Periodic_shift_2 translation(Id id) const
  {
    const auto found = m_translations.find(id);
    return found != m_translations.end() ? found->second : no_shift;
  }

  static Periodic_shift_2 step_in_cell(const Torus_2& now, const Entry& from, const Entry& to)
  {
    const Position_2 step = now.multiples({to.x - from.x, to.y - from.y});
    const bool is_short = std::abs(step.x) <= 0.5 && std::abs(step.y) <= 0.5;
    return is_short ? no_shift : now.nearest_shift(step);
  }

  Periodic_shift_2 step_to_new_cell(const Torus_2& last, const Torus_2& now, const Entry& from,
                                    const Entry& to) const
  {
    const Position_2 s = last.multiples({from.x, from.y}), t = now.multiples({to.x, to.y});
    return now.nearest_shift({t.x - (s.x * m_multiples[0][0] + s.y * m_multiples[1][0]),
                              t.y - (s.x * m_multiples[0][1] + s.y * m_multiples[1][1])});
  }

  template <class Step>
  std::vector<Translation> translations(Distributed_ranks_2& ranks, const std::vector<Entry>& own,
                                        const Step& step) const
  {
    std::vector<Translation> found;
    const auto compare = [&](const Entry& from, const Entry& to) {
      const Periodic_shift_2 shift = step(from, to);
      if (!are_equal(shift, no_shift))
        found.push_back({to.id, shift});
    };
    std::vector<Message_2> messages = ranks.empty_messages();
    const auto tell = [&](const Entry& entry, bool is_now) {
      messages[std::uint64_t(entry.id) % ranks.size()].write(Sighting{entry, is_now});
    };
    auto then = m_own.begin();
    for (const Entry& entry : own) {
      for (; then != m_own.end() && then->id < entry.id; ++then)
        tell(*then, false);
      if (then != m_own.end() && then->id == entry.id)
        compare(*then++, entry);
      else
        tell(entry, true);
    }
    for (; then != m_own.end(); ++then)
      tell(*then, false);
    std::map<Id, Entry> left, arrived;
    for (Message_2& message : ranks.send(std::move(messages)))
      while (!message.is_read()) {
        const auto sighting = message.template read<Sighting>();
        (sighting.is_now != 0 ? arrived : left).emplace(sighting.entry.id, sighting.entry);
      }
    for (const auto& [id, entry] : left) {
      const auto to = arrived.find(id);
      if (to != arrived.end())
        compare(entry, to->second);
    }
    return found;
  }

  Periodic_cell_2 m_cell = Periodic_cell_2(1, 1);
  std::vector<Entry> m_own; // ascending by ids
  std::array<Periodic_shift_2, 2> m_multiples = unit_multiples;
  std::map<Id, Periodic_shift_2> m_translations; // of all ranks' points, those that were wrapped
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_TRANSLATIONS_2_H
