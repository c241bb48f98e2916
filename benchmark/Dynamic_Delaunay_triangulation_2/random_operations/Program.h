// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_PROGRAM_H
#define RANDOM_OPERATIONS_PROGRAM_H

#include "Base_clouds.h"
#include "Motions.h"
#include "Named.h"
#include "scenario_runner/Command_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace random_operations {

enum class Choice {
  RANDOM, // others in every frame
  FIXED,  // those that were chosen in the first frame, as far as they are still there
  DISC    // the nearest ones to some point, another in every frame
};

// How many points a step moves.
struct Amount
{
  double share = 1.0;
  std::size_t count = 0; // if it is not 0, so many instead

  std::size_t of(std::size_t points) const
  {
    const double wanted = std::round(share * static_cast<double>(points));
    return (std::min)(points, count != 0 ? count : static_cast<std::size_t>(wanted));
  }
};

// In each frame, or every so many frames, some points do some motion.
struct Step
{
  std::string motion;
  Amount amount{};
  double size = 1.0;
  Choice choice = Choice::RANDOM;
  std::size_t every = 1;
};

// A kind of frames in one line:
//
//   BASE [SCALE_X SCALE_Y]; MOTION AMOUNT SIZE [fixed|disc] [every N]; ...
//
// as in "square; brownian 1 0.01; fresh #3". An amount is a share of the points, or a number of
// points behind '#'. The scales are those that the coordinates are multiplied by in the end.
struct Program
{
  std::string base = "square";
  double scale_x = 1.0, scale_y = 1.0;
  std::vector<Step> steps{};
};

inline double number_in(const std::string& text)
{
  double value = 0.0;
  if (!run::is_number(text, value) || !std::isfinite(value)) {
    throw std::invalid_argument("'" + text + "' is not a number");
  }
  return value;
}

inline Amount amount_in(const std::string& text)
{
  Amount amount;
  if (!text.empty() && text.front() == '#') {
    amount.count = run::count_argument(text.substr(1), 1, (std::numeric_limits<unsigned>::max)());
    return amount;
  }
  amount.share = number_in(text);
  if (!(amount.share >= 0.0 && amount.share <= 1.0)) {
    throw std::invalid_argument("'" + text + "' is not a share from 0 to 1");
  }
  return amount;
}

inline Step step_in(const std::string& text)
{
  constexpr std::size_t least_words = 2, max_period = 1000;
  const std::vector<std::string> words = words_in(text);
  if (words.size() < least_words) {
    throw std::invalid_argument("'" + text + "' is not MOTION AMOUNT SIZE");
  }
  Step step{motion_named(words[0]).name, amount_in(words[1])};
  std::size_t i = least_words;
  if (i < words.size() && words[i] != "fixed" && words[i] != "disc" && words[i] != "every") {
    step.size = number_in(words[i++]);
  }
  if (i < words.size() && words[i] != "every") {
    if (words[i] != "fixed" && words[i] != "disc") {
      throw std::invalid_argument("'" + words[i] + "' is neither fixed, disc nor every");
    }
    step.choice = words[i++] == "fixed" ? Choice::FIXED : Choice::DISC;
  }
  if (i + 1 < words.size() && words[i] == "every") {
    step.every = run::count_argument(words[i + 1], 1, max_period);
    i += 2;
  }
  if (i != words.size()) {
    throw std::invalid_argument("'" + text + "' has too many or too few words");
  }
  return step;
}

// \throws std::invalid_argument if it is none.
inline Program program_in(const std::string& text)
{
  constexpr std::size_t words_with_scales = 3;
  std::istringstream stream(text);
  std::string part;
  std::getline(stream, part, ';');
  const std::vector<std::string> words = words_in(part);
  if (words.size() != 1 && words.size() != words_with_scales) {
    throw std::invalid_argument("'" + part + "' is not BASE, nor BASE SCALE_X SCALE_Y");
  }
  Program program;
  program.base = named(all_base_clouds(), words[0], "base cloud").name;
  if (words.size() == words_with_scales) {
    program.scale_x = number_in(words[1]);
    program.scale_y = number_in(words[2]);
  }
  while (std::getline(stream, part, ';')) {
    program.steps.push_back(step_in(part));
  }
  return program;
}

inline std::string text_of(const Step& step)
{
  std::ostringstream text;
  text << step.motion << ' ';
  if (step.amount.count != 0) {
    text << '#' << step.amount.count;
  } else {
    text << step.amount.share;
  }
  text << ' ' << step.size;
  if (step.choice != Choice::RANDOM) {
    text << (step.choice == Choice::FIXED ? " fixed" : " disc");
  }
  if (step.every != 1) {
    text << " every " << step.every;
  }
  return text.str();
}

inline std::string text_of(const Program& program)
{
  std::ostringstream text;
  text << program.base;
  if (program.scale_x != 1.0 || program.scale_y != 1.0) {
    text << ' ' << program.scale_x << ' ' << program.scale_y;
  }
  for (const Step& step : program.steps) {
    text << "; " << text_of(step);
  }
  return text.str();
}

} // namespace random_operations

#endif // RANDOM_OPERATIONS_PROGRAM_H
