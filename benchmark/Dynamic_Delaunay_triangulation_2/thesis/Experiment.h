// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_EXPERIMENT_H
#define THESIS_EXPERIMENT_H

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace thesis {

// A part of an experiment that has to be run as a whole.
struct Job
{
  double seconds; // about
  std::function<void()> work;
};

// Jobs, and what came out of all of them.
class Experiment
{
public:
  explicit Experiment(std::string name)
    : m_name(std::move(name))
  {
  }
  Experiment(const Experiment&) = delete;
  Experiment& operator=(const Experiment&) = delete;
  virtual ~Experiment() = default;

  const std::string& name() const { return m_name; }

  // They refer to the experiment.
  virtual std::vector<Job> jobs() = 0;

  // After all jobs. `remarks` go to the top of each file.
  virtual void write(const std::filesystem::path& directory,
                     const std::vector<std::string>& remarks) const = 0;

private:
  std::string m_name;
};

} // namespace thesis

#endif // THESIS_EXPERIMENT_H
