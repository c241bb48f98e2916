// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_EXPERIMENT_H
#define THESIS_EXPERIMENT_H

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace thesis {

// The options of the command line.
struct Settings
{
  bool is_quick = false;
  std::size_t trials = 0;          // 0: what the experiments say
  std::uint64_t seed = 1;          // of the first trial; the next one has the next seed
  std::vector<std::string> only{}; // experiments; empty: all
  std::filesystem::path output = RESULTS_DIR "/thesis";

  std::size_t number_of_trials(std::size_t usual) const { return trials == 0 ? usual : trials; }
};

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

  // The jobs, which refer to the experiment.
  virtual std::vector<Job> jobs() = 0;

  // Writes the results, after all jobs. `remarks` go to the top of each file.
  virtual void write(const std::filesystem::path& directory,
                     const std::vector<std::string>& remarks) const = 0;

private:
  std::string m_name;
};

// Cases, each in several trials that differ in their seed alone.
template <class Case>
class Repeated_experiment : public Experiment
{
public:
  Repeated_experiment(std::string name, const Settings& settings, std::size_t usual_trials)
    : Experiment(std::move(name))
    , m_trials(settings.number_of_trials(usual_trials))
    , m_first_seed(settings.seed)
  {
  }

  // Trial by trial, not case by case: other work on the machine then disturbs all cases.
  std::vector<Job> jobs() final
  {
    std::vector<Job> jobs;
    for (std::size_t trial = 0; trial != m_trials; ++trial) {
      for (Case& one : m_cases) {
        jobs.push_back(
            {seconds_of(one), [this, &one, seed = m_first_seed + trial] { run(one, seed); }});
      }
    }
    return jobs;
  }

protected:
  void add_case(Case one) { m_cases.push_back(std::move(one)); }
  const std::list<Case>& cases() const { return m_cases; }
  std::size_t number_of_trials() const { return m_trials; }

private:
  // The approximate duration of a trial.
  virtual double seconds_of(const Case& one) const = 0;

  // Runs one trial.
  virtual void run(Case& one, std::uint64_t seed) const = 0;

  std::size_t m_trials;
  std::uint64_t m_first_seed;
  std::list<Case> m_cases; // jobs refer to them
};

} // namespace thesis

#endif // THESIS_EXPERIMENT_H
