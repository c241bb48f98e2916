// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_BENCHMARK_OPTIONS_H
#define SPEED_BENCHMARK_OPTIONS_H

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

namespace speed {

// Google Benchmark's options. Unless told otherwise it writes its JSON into the usual output file.
class Benchmark_options
{
public:
  Benchmark_options(int argc, char** argv, const std::string& usual_output_file)
    : m_options(argv, argv + argc)
  {
    if (!is_given(out) && !is_given("--benchmark_list_tests")) {
      m_options.push_back(out + usual_output_file);
    }
  }

  // False if there is one that Google Benchmark does not know.
  bool initialize()
  {
    std::vector<char*> arguments;
    for (std::string& option : m_options) {
      arguments.push_back(option.data());
    }
    int number = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    benchmark::Initialize(&number, arguments.data());
    return !benchmark::ReportUnrecognizedArguments(number, arguments.data());
  }

  // A format that somebody asks for is Google Benchmark's business.
  bool wants_own_table() const { return !is_given("--benchmark_format="); }

  std::string output_file() const
  {
    const auto option = find(out);
    return option == m_options.end() ? "" : option->substr(out.size());
  }

private:
  std::vector<std::string>::const_iterator find(const std::string& start) const
  {
    return std::find_if(m_options.begin(), m_options.end(), [&](const std::string& option) {
      return option.compare(0, start.size(), start) == 0;
    });
  }

  bool is_given(const std::string& start) const { return find(start) != m_options.end(); }

  inline static const std::string out = "--benchmark_out=";
  std::vector<std::string> m_options;
};

} // namespace speed

#endif // SPEED_BENCHMARK_OPTIONS_H
