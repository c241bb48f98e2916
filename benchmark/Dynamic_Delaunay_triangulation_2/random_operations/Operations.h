// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_OPERATIONS_H
#define RANDOM_OPERATIONS_OPERATIONS_H

#include "Arithmetic.h"
#include "Counts.h"
#include "Subject.h"

#include <cstddef>
#include <limits>
#include <ostream>

namespace random_operations {

// How calls are made: with a floating-point mode, which they must restore, and with a stream to
// which each call is written before it is made, if there is one.
struct Circumstances
{
  Arithmetic arithmetic{};
  std::ostream* told = nullptr;
};

// Writes a call, with all numbers to the last digit.
inline void tell(const Call& call, bool has_names, std::ostream& out)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  out << operation_names[static_cast<std::size_t>(call.operation)];
  if (call.operation == Operation::MISUSE) {
    out << ' ' << static_cast<int>(call.misuse) << std::endl;
    return;
  }
  for (const auto& [key, place] : call.points) {
    if (!is_insertion(call.operation) || has_names) {
      out << ' ' << key;
    }
    if (!is_removal(call.operation)) {
      out << " (" << place.x << ", " << place.y << ')';
    }
  }
  out << std::endl;
}

// Performs operations on the triangulation and on the model, and compares both after each.
class Operations
{
public:
  Operations(Subject& subject, Counts& counts, const Circumstances& circumstances)
    : m_subject(subject)
    , m_counts(counts)
    , m_circumstances(circumstances)
  {
  }

  const Model& model() const { return m_model; }
  std::size_t number_done() const { return m_done; }

  void perform(const Call& call)
  {
    m_counts.add(call.operation);
    const bool was_certified = m_subject.is_certified();
    const Answer answer = answer_to(call);
    if (answer.report) {
      m_counts.add(*answer.report);
      require(answer.report->certified == m_subject.is_certified(), Fault::WRONG,
              "the report says something else than is_certified()");
    }
    follow(call, answer);
    check(call, answer, was_certified);
    ++m_done;
    m_counts.points += m_model.size();
    m_counts.certified += m_subject.is_certified();
    m_subject.check(m_model);
  }

private:
  Answer answer_to(const Call& call)
  {
    if (m_circumstances.told != nullptr) {
      tell(call, !m_subject.names().is_empty(), *m_circumstances.told);
    }
    const Arithmetic_in_use in_use(m_circumstances.arithmetic);
    const Answer answer = m_subject.answer(call);
    require(in_use.is_kept(), Fault::WRONG, "the caller's arithmetic was not given back");
    return answer;
  }

  void follow(const Call& call, const Answer& answer)
  {
    if (call.operation == Operation::START || call.operation == Operation::UPDATE) {
      m_model = Model(call.points.begin(), call.points.end());
    } else if (is_removal(call.operation)) {
      for (const auto& [key, place] : call.points) {
        m_model.erase(key);
      }
    } else if (is_insertion(call.operation) || call.operation == Operation::MOVE) {
      for (std::size_t i = 0; i < call.points.size(); ++i) {
        m_model[answer.keys.empty() ? call.points[i].first : answer.keys[i]] =
            call.points[i].second;
      }
    }
  }

  void check(const Call& call, const Answer& answer, bool was_certified) const
  {
    const bool is_certified = m_subject.is_certified();
    const std::size_t number = call.points.size();
    if (is_insertion(call.operation)) {
      check_numbers(answer, number, 0, "the report counts other insertions");
    } else if (is_removal(call.operation)) {
      check_numbers(answer, 0, number, "the report counts other removals");
    }
    switch (call.operation) {
    case Operation::START:
    case Operation::UPDATE:
    case Operation::HAND_OVER:
      return;
    case Operation::MEND:
      return require(is_certified, Fault::WRONG, "mended, but not certified");
    case Operation::CERTIFY:
      return require(is_certified == answer.is_yes, Fault::WRONG,
                     "certify() says something else than is_certified()");
    case Operation::MISUSE:
      require(answer.is_yes, Fault::WRONG, "bad input was taken");
      return require(is_certified == was_certified, Fault::WRONG,
                     "bad input has changed whether it is certified");
    default:
      return require(is_certified || !was_certified, Fault::WRONG, "no longer certified");
    }
  }

  static void check_numbers(const Answer& answer, std::size_t inserted, std::size_t removed,
                            const char* what)
  {
    require(!answer.report ||
                (answer.report->inserted == inserted && answer.report->removed == removed),
            Fault::WRONG, what);
  }

  Subject& m_subject;
  Counts& m_counts;
  Circumstances m_circumstances;
  Model m_model;
  std::size_t m_done = 0;
};

} // namespace random_operations

#endif // RANDOM_OPERATIONS_OPERATIONS_H
