// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_OPERATIONS_H
#define ROBUSTNESS_OPERATIONS_H

#include "Counts.h"
#include "Decisions.h"
#include "Finding.h"
#include "Model.h"
#include "Subject.h"

#include <cstddef>
#include <utility>

namespace robustness {

// Does what is asked for to the triangulation and to the model, and holds the one against the other
// after each operation.
class Operations
{
public:
  Operations(Subject& subject, Decisions& decisions, Counts& counts)
    : m_subject(subject)
    , m_decisions(decisions)
    , m_counts(counts)
  {
  }

  const Model& model() const { return m_model; }
  std::size_t number_done() const { return m_done; }

  void start(const Places& places)
  {
    begin(Operation::START);
    m_model.clear();
    for (const Place& place : places) {
      m_model[m_subject.names().is_empty() ? Key(m_model.size()) : new_name(m_model)] = place;
    }
    m_subject.start(m_model);
    end();
  }

  void insert(const Place& place)
  {
    if (!m_subject.names().is_empty()) {
      return insert(Places{place}, Operation::INSERT);
    }
    begin(Operation::INSERT);
    const bool was_certified = m_subject.is_certified();
    m_model[m_subject.insert(place)] = place;
    require(m_subject.is_certified() || !was_certified, Fault::WRONG, "no longer certified");
    end();
  }

  void insert(const Places& places, Operation operation = Operation::INSERT_RANGE)
  {
    begin(operation);
    Keys keys;
    Model next = m_model;
    if (!m_subject.names().is_empty()) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        keys.push_back(new_name(next));
        next[keys.back()] = places[i];
      }
    }
    const auto report = keep_certified([&] { return m_subject.insert(keys, places); });
    for (std::size_t i = 0; i < places.size(); ++i) {
      m_model[keys[i]] = places[i];
    }
    require(report.inserted == places.size() && report.removed == 0, Fault::WRONG,
            "the report counts other insertions");
    end();
  }

  void remove(const Keys& keys, Operation operation)
  {
    begin(operation);
    const auto report = keep_certified([&] { return m_subject.remove(keys); });
    for (const Key key : keys) {
      m_model.erase(key);
    }
    require(report.removed == keys.size() && report.inserted == 0, Fault::WRONG,
            "the report counts other removals");
    end();
  }

  void move(const Moves& moves)
  {
    begin(Operation::MOVE);
    keep_certified([&] { return m_subject.move(moves); });
    for (const auto& [key, place] : moves) {
      m_model[key] = place;
    }
    end();
  }

  void update(Model next)
  {
    begin(Operation::UPDATE);
    take(m_subject.update(next));
    m_model = std::move(next);
    end();
  }

  void mend()
  {
    begin(Operation::MEND);
    take(m_subject.mend());
    require(m_subject.is_certified(), Fault::WRONG, "mended, but not certified");
    end();
  }

  void certify()
  {
    begin(Operation::CERTIFY);
    const bool is_certain = m_subject.certify();
    require(m_subject.is_certified() == is_certain, Fault::WRONG,
            "certify() says something else than is_certified()");
    end();
  }

  void hand_over()
  {
    begin(Operation::HAND_OVER);
    m_subject.hand_over();
    end();
  }

  void misuse(Misuse misuse)
  {
    begin(Operation::MISUSE);
    const bool was_certified = m_subject.is_certified();
    require(m_subject.refuses(misuse, m_model), Fault::WRONG, "bad input was taken");
    require(m_subject.is_certified() == was_certified, Fault::WRONG,
            "bad input has changed whether it is certified");
    end();
  }

  // One that nobody in `model` has.
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

private:
  void begin(Operation operation) { m_counts.add(operation); }

  void take(const CGAL::Update_report_2& report)
  {
    m_counts.add(report);
    require(report.certified == m_subject.is_certified(), Fault::WRONG,
            "the report says something else than is_certified()");
  }

  // What was certified stays so.
  template <class Change>
  CGAL::Update_report_2 keep_certified(const Change& change)
  {
    const bool was_certified = m_subject.is_certified();
    const CGAL::Update_report_2 report = change();
    take(report);
    require(report.certified || !was_certified, Fault::WRONG, "no longer certified");
    return report;
  }

  void end()
  {
    ++m_done;
    m_counts.points += m_model.size();
    m_counts.certified += m_subject.is_certified();
    m_subject.check(m_model);
  }

  Subject& m_subject;
  Decisions& m_decisions;
  Counts& m_counts;
  Model m_model;
  std::size_t m_done = 0;
};

} // namespace robustness

#endif // ROBUSTNESS_OPERATIONS_H
