// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_RANDOM_PROGRAMS_H
#define RANDOM_OPERATIONS_RANDOM_PROGRAMS_H

#include "Program.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace random_operations {

// Draws programs, and changes them a little; some motions may be left out. All numbers have two
// digits, so that a program is the same when it is read from its text.
class Random_programs
{
public:
  Random_programs(std::uint64_t seed, const std::vector<std::string>& left_out)
    : m_decisions(seed)
  {
    for (const Motion& motion : all_motions()) {
      if (std::find(left_out.begin(), left_out.end(), motion.name) == left_out.end()) {
        m_motions.push_back(motion.name);
      }
    }
  }

  Decisions& decisions() { return m_decisions; }

  Program any()
  {
    Program program;
    program.base = m_decisions.any_of(all_base_clouds()).name;
    if (m_decisions.one_in(rarely)) {
      program.scale_x = any_scale();
      program.scale_y = m_decisions.one_in(2) ? program.scale_x : any_scale();
    }
    do {
      program.steps.push_back(any_step());
    } while (program.steps.size() < max_steps && m_decisions.one_in(2));
    return program;
  }

  Program changed(Program program)
  {
    do {
      change(program);
    } while (m_decisions.one_in(2));
    return program;
  }

private:
  static constexpr std::size_t max_steps = 4, rarely = 8;

  static double rounded(double number)
  {
    std::ostringstream text;
    text.precision(2);
    text << number;
    return number_in(text.str());
  }

  // Each order of magnitude is as likely as the others.
  double any_magnitude(double low, double high)
  {
    return rounded(std::exp(m_decisions.real(std::log(low), std::log(high))));
  }

  double any_scale() { return m_decisions.one_in(2) ? 1.0 : any_magnitude(1e-150, 1e140); }

  Amount any_amount()
  {
    constexpr double max_counted = 100.0;
    Amount amount;
    if (m_decisions.one_in(4)) {
      amount.count = static_cast<std::size_t>(std::ceil(any_magnitude(1.0, max_counted)));
    } else {
      amount.share = m_decisions.one_in(4) ? 1.0 : any_magnitude(1e-3, 1.0);
    }
    return amount;
  }

  Choice any_choice()
  {
    static const std::vector<Choice> choices = {Choice::RANDOM, Choice::RANDOM, Choice::FIXED,
                                                Choice::DISC};
    return m_decisions.any_of(choices);
  }

  std::size_t any_period() { return m_decisions.one_in(4) ? 2 + m_decisions.below(2) : 1; }
  double any_size()
  {
    return m_decisions.one_in(rarely) ? any_magnitude(1e-9, 1e9) : any_magnitude(1e-3, 10.0);
  }

  Step any_step()
  {
    Step step;
    step.motion = m_decisions.any_of(m_motions);
    step.amount = any_amount();
    step.size = any_size();
    step.choice = any_choice();
    step.every = any_period();
    return step;
  }

  void change(Program& program)
  {
    switch (m_decisions.below(6)) {
    case 0:
      program.base = m_decisions.any_of(all_base_clouds()).name;
      break;
    case 1:
      if (program.steps.size() < max_steps) {
        program.steps.push_back(any_step());
      }
      break;
    case 2:
      if (program.steps.size() > 1) {
        program.steps.erase(program.steps.begin() +
                            static_cast<std::ptrdiff_t>(m_decisions.below(program.steps.size())));
      }
      break;
    default:
      change(program.steps[m_decisions.below(program.steps.size())]);
    }
  }

  void change(Step& step)
  {
    switch (m_decisions.below(6)) {
    case 0:
      step.motion = m_decisions.any_of(m_motions);
      break;
    case 1:
      step.choice = any_choice();
      break;
    case 2:
      step.every = any_period();
      break;
    case 3:
      step.size = m_decisions.one_in(2) ? any_size() : rounded(step.size * any_magnitude(0.3, 3.0));
      break;
    default:
      change(step.amount);
    }
  }

  void change(Amount& amount)
  {
    if (m_decisions.one_in(2)) {
      amount = any_amount();
    } else if (amount.count != 0) {
      const double count = static_cast<double>(amount.count) * any_magnitude(0.3, 3.0);
      amount.count = static_cast<std::size_t>(std::ceil(count));
    } else {
      amount.share = (std::min)(1.0, rounded(amount.share * any_magnitude(0.3, 3.0)));
    }
  }

  Normal_decisions m_decisions;
  std::vector<std::string> m_motions; // names
};

} // namespace random_operations

#endif // RANDOM_OPERATIONS_RANDOM_PROGRAMS_H
