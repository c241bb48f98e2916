// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of files that are refused.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SCENARIO_ERRORS_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SCENARIO_ERRORS_H

#include "scenario_runner/Open_motion.h"
#include "temporary_files.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

using Words = std::vector<std::string>;

inline void expect_words(const scenario::Scenario_error& error, const Words& words)
{
  for (const std::string& word : words) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
        << "'" << word << "' is not in: " << error.what();
  }
}

inline scenario::Scenario_error error_of_call(const std::function<void()>& call)
{
  try {
    call();
  } catch (const scenario::Scenario_error& error) {
    return error;
  }
  ADD_FAILURE() << "accepted";
  return scenario::Scenario_error("", "");
}

inline scenario::Scenario_error error_of(const std::string& path,
                                         const scenario::Overrides& overrides = {})
{
  SCOPED_TRACE(path);
  return error_of_call([&] { scenario::open_motion(path, overrides); });
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SCENARIO_ERRORS_H
