// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_TRIAL_H
#define RANDOM_OPERATIONS_TRIAL_H

#include "Counts.h"
#include "Decisions.h"
#include "Families.h"
#include "Motions.h"
#include "Operations.h"
#include "Subject.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <utility>
#include <vector>

namespace random_operations {

// The conditions of a trial.
struct Surroundings
{
  Field field{};
  std::size_t max_points = 0;
  bool constructs_exactly = false; // the kernel is EPECK
  // A test watches the subject's triangulation, so the object is kept: it starts with an insertion,
  // and is never handed over.
  bool is_watched = false;
  bool moves_singly = false; // moves no two points in one call, but for whole frames
};

// A row of operations on one triangulation. Everything about it comes from `decisions`.
class Trial
{
public:
  Trial(const Family& family, const Surroundings& surroundings, Subject& subject,
        Decisions& decisions, Counts& counts, const Circumstances& circumstances = {})
    : m_family(family)
    , m_surroundings(surroundings)
    , m_subject(subject)
    , m_decisions(decisions)
    , m_counts(counts)
    , m_operations(subject, counts, circumstances)
  {
    ++m_counts.trials;
  }

  std::size_t operations_done() const { return m_operations.number_done(); }
  const Model& model() const { return m_operations.model(); }

  // Makes up to `operations` operations, fewer if there is nothing left to decide. Calls `before()`
  // before each. Throws a Finding if something is wrong.
  template <class Before>
  void run(std::size_t operations, const Before& before)
  {
    try {
      before();
      start();
      for (std::size_t i = 1; i < operations && m_decisions.has_more(); ++i) {
        before();
        step();
      }
    } catch (const Finding& finding) {
      m_counts.add(finding.fault());
      throw;
    } catch (const std::exception& error) {
      m_counts.add(Fault::CRASHED);
      throw Finding(Fault::CRASHED, error.what());
    }
  }

  void start()
  {
    const std::size_t points =
        m_decisions.one_in(8)
            ? 0
            : m_surroundings.max_points - m_decisions.below(m_surroundings.max_points);
    Places places;
    while (places.size() < points) {
      places.push_back(any_place(places));
    }
    m_operations.perform({m_surroundings.is_watched ? Operation::INSERT_RANGE : Operation::START,
                          with_keys(places, {})});
  }

  void step()
  {
    if (!m_subject.is_certified() && m_decisions.one_in(8)) {
      return perform(m_decisions.one_in(2) ? Operation::MEND : Operation::CERTIFY);
    }
    if (m_decisions.one_in(64)) {
      return rare_step();
    }
    const Shares& shares = m_family.shares;
    const std::vector<unsigned> all = {shares.insert,       shares.insert_range, shares.remove,
                                       shares.remove_range, shares.move,         shares.update};
    std::size_t drawn = m_decisions.below(100), choice = 0;
    while (choice + 1 < all.size() && drawn >= all[choice]) {
      drawn -= all[choice++];
    }
    do_one(choice);
  }

private:
  // Entries for places, with new names, or numbered where the subject names the points itself.
  // `model` has the existing points.
  Entries with_keys(const Places& places, Model model)
  {
    Entries entries;
    for (const Place& place : places) {
      entries.emplace_back(m_subject.names().is_empty() ? Key(entries.size()) : new_name(model),
                           place);
      model.insert(entries.back());
    }
    return entries;
  }

  // A random name that is free in `model`.
  Key new_name(const Model& model)
  {
    const Key_range names = m_subject.names();
    const Key most = m_decisions.one_in(2) ? names.lowest + 255 : names.highest;
    Key name =
        names.lowest +
        static_cast<Key>(m_decisions.below(static_cast<std::size_t>(most - names.lowest) + 1));
    while (model.count(name) > 0) {
      name = name < names.highest ? name + 1 : names.lowest;
    }
    return name;
  }

  Place any_place(const Places& others)
  {
    return m_decisions.any_of(m_family.sources)->place(m_surroundings.field, others, m_decisions);
  }

  void do_one(std::size_t choice)
  {
    const bool has_room = model().size() < m_surroundings.max_points;
    switch (choice) {
    case 0:
      return has_room ? insert() : remove();
    case 1:
      return has_room ? insert_range() : remove_range();
    case 2:
      return model().empty() ? insert() : remove();
    case 3:
      return remove_range();
    case 4:
      return move();
    default:
      return update();
    }
  }

  void rare_step()
  {
    switch (m_decisions.below(4)) {
    case 0:
      return perform(Operation::CERTIFY);
    case 1:
      return perform(Operation::MEND);
    case 2:
      return perform(m_surroundings.is_watched ? Operation::CERTIFY : Operation::HAND_OVER);
    default:
      return misuse();
    }
  }

  void perform(Operation operation) { m_operations.perform({operation}); }

  void misuse()
  {
    const Misuse misuse = static_cast<Misuse>(m_decisions.below(5));
    const bool is_broken_point =
        misuse == Misuse::NAN_COORDINATE || misuse == Misuse::INFINITE_COORDINATE;
    m_operations.perform(
        {Operation::MISUSE, entries(),
         m_surroundings.constructs_exactly && is_broken_point ? Misuse::UNKNOWN_ID : misuse});
  }

  void insert()
  {
    const Place place = any_place(places_of(model()));
    m_operations.perform({Operation::INSERT, with_keys({place}, model())});
  }

  void insert_range()
  {
    const std::size_t room = m_surroundings.max_points - model().size();
    const std::size_t most = m_decisions.one_in(8) ? room : std::min<std::size_t>(room, 8);
    const std::size_t number = m_decisions.below(most + 1);
    Places others = places_of(model()), places;
    while (places.size() < number) {
      places.push_back(any_place(others));
      others.push_back(places.back());
    }
    m_operations.perform({Operation::INSERT_RANGE, with_keys(places, model())});
  }

  void remove() { m_operations.perform({Operation::REMOVE, entries({some_key()})}); }

  void remove_range()
  {
    const Keys keys = somebodies(m_decisions.one_in(16) ? model().size() : 8);
    m_operations.perform({Operation::REMOVE_RANGE, entries(keys)});
  }

  void move()
  {
    const std::size_t most = m_surroundings.moves_singly ? 1
                             : m_decisions.one_in(4)     ? model().size()
                                                         : 4;
    Entries moves = entries(somebodies(most));
    change(m_family.moves, moves);
    m_operations.perform({Operation::MOVE, moves});
  }

  void update()
  {
    Entries moved = entries();
    change(m_family.motions, moved);
    if (!m_subject.names().is_empty()) {
      moved = changed_population(Model(moved.begin(), moved.end()));
    }
    m_operations.perform({Operation::UPDATE, moved});
  }

  // The population, half of the time after some points have left and others have come.
  Entries changed_population(Model next)
  {
    if (m_decisions.one_in(2)) {
      return Entries(next.begin(), next.end());
    }
    const std::size_t most = m_decisions.one_in(8) ? next.size() : 3;
    for (const Key key : somebodies(most)) {
      next.erase(key);
    }
    const std::size_t room = m_surroundings.max_points - next.size();
    for (std::size_t i = m_decisions.below((std::min)(room, most) + 1); i > 0; --i) {
      const Place place = any_place(places_of(next));
      next[new_name(next)] = place;
    }
    return Entries(next.begin(), next.end());
  }

  void change(const std::vector<Family_motion>& motions, Entries& entries)
  {
    const Places all = places_of(model());
    Cloud cloud;
    cloud.field = m_surroundings.field;
    // around a middle in whole units, so that turning takes whole numbers to whole numbers
    const double middle = m_surroundings.field.extent / 2, half = 0.5 * m_surroundings.field.extent;
    cloud.low = {middle - half, middle - half};
    cloud.high = {middle + half, middle + half};
    cloud.fresh = [&, source = m_decisions.any_of(m_family.sources)](Decisions& decisions) {
      return source->place(m_surroundings.field, all, decisions);
    };
    const Family_motion& chosen = m_decisions.any_of(motions);
    if (entries.empty()) {
      return;
    }
    Indices indices;
    for (const auto& [key, place] : entries) {
      indices.push_back(cloud.size());
      cloud.add(place);
    }
    Memory memory;
    const bool keeps_together = chosen.motion->is_own && m_decisions.one_in(2);
    chosen.motion->move(
        {cloud, indices, all, chosen.size, m_decisions, memory, chosen.rarity, keeps_together});
    for (const std::size_t i : indices) {
      entries[i].second = cloud.points[i];
    }
  }

  static Places places_of(const Model& model)
  {
    Places places;
    for (const auto& [key, place] : model) {
      places.push_back(place);
    }
    return places;
  }

  Keys keys() const
  {
    Keys keys;
    for (const auto& [key, place] : model()) {
      keys.push_back(key);
    }
    return keys;
  }

  Entries entries() const { return Entries(model().begin(), model().end()); }

  Entries entries(const Keys& keys) const
  {
    Entries entries;
    for (const Key key : keys) {
      entries.emplace_back(key, model().at(key));
    }
    return entries;
  }

  // A random point, one with a preference for the hull or for few neighbors, or the last one.
  Key some_key()
  {
    const Keys all = keys();
    const std::size_t wanted = m_decisions.below(5);
    if (wanted == 0) {
      return all.back();
    }
    Key chosen = m_decisions.any_of(all);
    for (int tries = 0; tries < 4 && wanted > 2; ++tries) {
      const Key other = m_decisions.any_of(all);
      const bool is_better = wanted == 3 ? m_subject.is_at_hull(other)
                                         : m_subject.number_of_neighbors(other) <
                                               m_subject.number_of_neighbors(chosen);
      chosen = is_better ? other : chosen;
    }
    return chosen;
  }

  // Up to `most` random points, in random order.
  Keys somebodies(std::size_t most)
  {
    Keys all = keys();
    const std::size_t number = m_decisions.below((std::min)(most, all.size()) + 1);
    for (std::size_t i = 0; i < number; ++i) {
      std::swap(all[i], all[i + m_decisions.below(all.size() - i)]);
    }
    all.resize(number);
    return all;
  }

  const Family& m_family;
  const Surroundings& m_surroundings;
  Subject& m_subject;
  Decisions& m_decisions;
  Counts& m_counts;
  Operations m_operations;
};

} // namespace random_operations

#endif // RANDOM_OPERATIONS_TRIAL_H
