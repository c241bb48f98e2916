// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_TRIAL_H
#define ROBUSTNESS_TRIAL_H

#include "Counts.h"
#include "Decisions.h"
#include "Families.h"
#include "Finding.h"
#include "Model.h"
#include "Motions.h"
#include "Operations.h"
#include "Place_sources.h"
#include "Setup.h"
#include "Subject.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <utility>
#include <vector>

namespace robustness {

// A row of operations on one triangulation. Everything about it comes from `decisions`.
class Trial
{
public:
  Trial(const Family& family, const Setup& setup, Subject& subject, Decisions& decisions,
        Counts& counts)
    : m_family(family)
    , m_setup(setup)
    , m_subject(subject)
    , m_decisions(decisions)
    , m_counts(counts)
    , m_operations(subject, decisions, counts)
  {
    ++m_counts.trials;
  }

  std::size_t operations_done() const { return m_operations.number_done(); }
  const Model& model() const { return m_operations.model(); }

  // Stops before that if there is nothing left to decide. Calls `before()` before each operation.
  // Throws a Finding.
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

private:
  void start()
  {
    const std::size_t points =
        m_decisions.one_in(8) ? 0 : m_setup.max_points - m_decisions.below(m_setup.max_points);
    Places places;
    while (places.size() < points) {
      places.push_back(any_place(places));
    }
    m_operations.start(places);
  }

  Place any_place(const Places& others)
  {
    return new_place(m_decisions.any_of(m_family.sources), m_setup.field, others, m_decisions);
  }

  void step()
  {
    if (!m_subject.is_certified() && m_decisions.one_in(8)) {
      return m_decisions.one_in(2) ? m_operations.mend() : m_operations.certify();
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

  void do_one(std::size_t choice)
  {
    const bool has_room = model().size() < m_setup.max_points;
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
      return m_operations.certify();
    case 1:
      return m_operations.mend();
    case 2:
      return m_operations.hand_over();
    default:
      return misuse();
    }
  }

  void misuse()
  {
    const Misuse misuse = static_cast<Misuse>(m_decisions.below(5));
    const bool is_broken_point =
        misuse == Misuse::NAN_COORDINATE || misuse == Misuse::INFINITE_COORDINATE;
    m_operations.misuse(m_setup.constructs_exactly && is_broken_point ? Misuse::UNKNOWN_ID
                                                                      : misuse);
  }

  void insert() { m_operations.insert(any_place(places_of(model()))); }

  void insert_range()
  {
    const std::size_t room = m_setup.max_points - model().size();
    const std::size_t most = m_decisions.one_in(8) ? room : std::min<std::size_t>(room, 8);
    const std::size_t number = m_decisions.below(most + 1);
    Places others = places_of(model()), places;
    while (places.size() < number) {
      places.push_back(any_place(others));
      others.push_back(places.back());
    }
    m_operations.insert(places);
  }

  void remove() { m_operations.remove({somebody()}, Operation::REMOVE); }

  void remove_range()
  {
    Keys keys = somebodies(m_decisions.one_in(16) ? model().size() : 8);
    m_operations.remove(keys, Operation::REMOVE_RANGE);
  }

  void move()
  {
    const Keys keys = somebodies(m_decisions.one_in(4) ? model().size() : 4);
    Places places;
    for (const Key key : keys) {
      places.push_back(model().at(key));
    }
    change(m_family.moves, places);
    Moves moves;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      moves.emplace_back(keys[i], places[i]);
    }
    m_operations.move(moves);
  }

  void update()
  {
    Places places = places_of(model());
    change(m_family.motions, places);
    Model next = model();
    auto place = places.begin();
    for (auto& entry : next) {
      entry.second = *place++;
    }
    if (!m_subject.names().is_empty()) {
      change_population(next);
    }
    m_operations.update(std::move(next));
  }

  // Some go and some come in the same frame.
  void change_population(Model& next)
  {
    if (m_decisions.one_in(2)) {
      return;
    }
    const std::size_t most = m_decisions.one_in(8) ? next.size() : 3;
    for (const Key key : somebodies(most)) {
      next.erase(key);
    }
    const std::size_t room = m_setup.max_points - next.size();
    for (std::size_t i = m_decisions.below((std::min)(room, most) + 1); i > 0; --i) {
      next[m_operations.new_name(next)] = any_place(places_of(next));
    }
  }

  void change(const std::vector<Motion>& motions, Places& places)
  {
    const Places all = places_of(model());
    Mover mover(m_setup.field, m_decisions.any_of(m_family.sources), all, m_decisions);
    mover.move(m_decisions.any_of(motions), places);
  }

  // Anybody, or who is at the hull, has few neighbors, or came last.
  Key somebody()
  {
    const Keys keys = keys_of(model());
    const std::size_t wanted = m_decisions.below(5);
    if (wanted == 0) {
      return keys.back();
    }
    Key chosen = m_decisions.any_of(keys);
    for (int tries = 0; tries < 4 && wanted > 2; ++tries) {
      const Key other = m_decisions.any_of(keys);
      const bool is_better = wanted == 3 ? m_subject.is_at_hull(other)
                                         : m_subject.number_of_neighbors(other) <
                                               m_subject.number_of_neighbors(chosen);
      chosen = is_better ? other : chosen;
    }
    return chosen;
  }

  // Up to `most`, in any order.
  Keys somebodies(std::size_t most)
  {
    Keys keys = keys_of(model());
    const std::size_t number = m_decisions.below((std::min)(most, keys.size()) + 1);
    for (std::size_t i = 0; i < number; ++i) {
      std::swap(keys[i], keys[i + m_decisions.below(keys.size() - i)]);
    }
    keys.resize(number);
    return keys;
  }

  const Family& m_family;
  const Setup& m_setup;
  Subject& m_subject;
  Decisions& m_decisions;
  Counts& m_counts;
  Operations m_operations;
};

} // namespace robustness

#endif // ROBUSTNESS_TRIAL_H
