// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_RANDOM_PROGRAMS_H
#define ANY_MOTION_RANDOM_PROGRAMS_H

#include "Program.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace any_motion {

// Draws programs, and changes them a little; some motions may be left out. All numbers have two
// digits, so that a program is the same when it is read from its text.
class Random_programs
{
public:
  Random_programs(std::uint64_t seed, const std::vector<std::string>& left_out)
    : m_random(seed)
  {
    for (const Motion& motion : all_motions()) {
      if (std::find(left_out.begin(), left_out.end(), motion.name) == left_out.end()) {
        m_motions.push_back(motion.name);
      }
    }
  }

  Random& random() { return m_random; }

  Program any()
  {
    Program program;
    program.base = any_of(all_base_clouds()).name;
    if (one_in(rarely)) {
      program.scale_x = any_scale();
      program.scale_y = one_in(2) ? program.scale_x : any_scale();
    }
    do {
      program.steps.push_back(any_step());
    } while (program.steps.size() < max_steps && one_in(2));
    return program;
  }

  Program changed(Program program)
  {
    do {
      change(program);
    } while (one_in(2));
    return program;
  }

private:
  static constexpr std::size_t max_steps = 4, rarely = 8;

  bool one_in(std::size_t number) { return any_below(number, m_random) == 0; }

  template <class Value>
  const Value& any_of(const std::vector<Value>& values)
  {
    return values[any_below(values.size(), m_random)];
  }

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
    return rounded(std::exp(m_random.uniform(std::log(low), std::log(high))));
  }

  double any_scale() { return one_in(2) ? 1.0 : any_magnitude(1e-150, 1e140); }

  Amount any_amount()
  {
    constexpr double max_counted = 100.0;
    Amount amount;
    if (one_in(4)) {
      amount.count = static_cast<std::size_t>(std::ceil(any_magnitude(1.0, max_counted)));
    } else {
      amount.share = one_in(4) ? 1.0 : any_magnitude(1e-3, 1.0);
    }
    return amount;
  }

  Choice any_choice()
  {
    static const std::vector<Choice> choices = {Choice::RANDOM, Choice::RANDOM, Choice::FIXED,
                                                Choice::DISC};
    return any_of(choices);
  }

  std::size_t any_period() { return one_in(4) ? 2 + any_below(2, m_random) : 1; }
  double any_size()
  {
    return one_in(rarely) ? any_magnitude(1e-9, 1e9) : any_magnitude(1e-3, 10.0);
  }

  Step any_step()
  {
    Step step;
    step.motion = any_of(m_motions);
    step.amount = any_amount();
    step.size = any_size();
    step.choice = any_choice();
    step.every = any_period();
    return step;
  }

  void change(Program& program)
  {
    switch (any_below(6, m_random)) {
    case 0:
      program.base = any_of(all_base_clouds()).name;
      break;
    case 1:
      if (program.steps.size() < max_steps) {
        program.steps.push_back(any_step());
      }
      break;
    case 2:
      if (program.steps.size() > 1) {
        program.steps.erase(program.steps.begin() +
                            static_cast<std::ptrdiff_t>(any_below(program.steps.size(), m_random)));
      }
      break;
    default:
      change(program.steps[any_below(program.steps.size(), m_random)]);
    }
  }

  void change(Step& step)
  {
    switch (any_below(6, m_random)) {
    case 0:
      step.motion = any_of(m_motions);
      break;
    case 1:
      step.choice = any_choice();
      break;
    case 2:
      step.every = any_period();
      break;
    case 3:
      step.size = one_in(2) ? any_size() : rounded(step.size * any_magnitude(0.3, 3.0));
      break;
    default:
      change(step.amount);
    }
  }

  void change(Amount& amount)
  {
    if (one_in(2)) {
      amount = any_amount();
    } else if (amount.count != 0) {
      const double count = static_cast<double>(amount.count) * any_magnitude(0.3, 3.0);
      amount.count = static_cast<std::size_t>(std::ceil(count));
    } else {
      amount.share = (std::min)(1.0, rounded(amount.share * any_magnitude(0.3, 3.0)));
    }
  }

  Random m_random;
  std::vector<std::string> m_motions; // names
};

} // namespace any_motion

#endif // ANY_MOTION_RANDOM_PROGRAMS_H
