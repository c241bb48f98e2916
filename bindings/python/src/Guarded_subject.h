// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_GUARDED_SUBJECT_H
#define PYTHON_GUARDED_SUBJECT_H

#include "bindings/common/Subject.h"
#include "bindings/python/src/Errors.h"
#include "bindings/python/src/Numpy.h"
#include "scenario_runner/Threads.h"

#include <pybind11/pybind11.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace python {

// A triangulation that Python holds, and the arrays that were made of it. All work is done without
// the interpreter's lock, and by one thread at a time. The subject is derived from `Subject_base`;
// its `dimension` is that of positions.
template <class Its_subject>
class Guarded_subject
{
public:
  using Report = typename Its_subject::Report;

  // Calls `f(subject)`, which changes nothing, or nothing that arrays show.
  template <class Function>
  auto read(const Function& f)
  {
    check_caller();
    const pybind11::gil_scoped_release release;
    const std::lock_guard<std::mutex> guard(m_mutex);
    const Caller caller(m_caller);
    Its_subject& mine = subject();
    return m_threads->execute([&] { return f(mine); });
  }

  // The arrays of a group: those of the last time if nothing has changed since.
  pybind11::tuple arrays(Group group)
  {
    Cached& cached = m_cache[std::size_t(group)];
    if (!cached.arrays || cached.version != m_version) {
      std::uint64_t version = 0;
      std::vector<Array> arrays = read([&](const Its_subject& its_subject) {
        version = m_version;
        return its_subject.arrays(group);
      });
      cached = {to_numpy(std::move(arrays)), version};
    }
    return cached.arrays;
  }

  bool is_current(const pybind11::object& array) const
  {
    for (const Cached& cached : m_cache) {
      if (cached.arrays && cached.version == m_version) {
        for (const pybind11::handle& its_array : cached.arrays) {
          if (its_array.is(array)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  Report move(const pybind11::object& ids, const pybind11::object& points)
  {
    const Input its_points = positions_input(points);
    const Input its_ids = ids_input(ids, its_points.rows.size);
    check(its_ids.rows);
    return change(
        [&](Its_subject& its_subject) { return its_subject.move(its_ids.rows, its_points.rows); });
  }

  pybind11::array insert(const pybind11::object& points, const pybind11::object& ids)
  {
    const Input its_points = positions_input(points), its_ids = input_of_ids(ids, its_points);
    check_number(its_points.rows);
    std::vector<std::int64_t> new_ids;
    change([&](Its_subject& its_subject) {
      return its_subject.insert(its_ids.rows, its_points.rows, new_ids);
    });
    return to_numpy({std::move(new_ids)});
  }

  Report remove(const pybind11::object& ids)
  {
    const Input its_ids = ids_input(ids);
    check_number(its_ids.rows);
    check(its_ids.rows);
    return change([&](Its_subject& its_subject) { return its_subject.remove(its_ids.rows); });
  }

  Report mend()
  {
    return change([](Its_subject& its_subject) { return its_subject.mend(); });
  }

  void restore(const pybind11::bytes& checkpoint)
  {
    const std::string text = checkpoint;
    change([&](Its_subject& its_subject) {
      its_subject.restore(text);
      Report report;
      report.certified = its_subject.is_certified();
      return report;
    });
  }

  pybind11::tuple answer(Query query, const pybind11::object& query_points, double extent)
  {
    const Input input = points_input(query_points, "query points", Its_subject::dimension);
    return to_numpy(read([&](const Its_subject& its_subject) {
      return its_subject.answer({query, input.rows, extent});
    }));
  }

  Report last_report() const { return m_report; }

protected:
  ~Guarded_subject() = default;

  void check_is_new() const
  {
    if (m_subject) {
      throw Use_error("a triangulation is initialized once");
    }
  }

  void start(unsigned threads, std::unique_ptr<Its_subject> its_subject, const Report& report = {})
  {
    m_threads.emplace(threads);
    m_subject = std::move(its_subject);
    m_report = report;
  }

  Its_subject& subject() const
  {
    if (!m_subject) {
      throw Use_error("the triangulation is not initialized: its __init__() was not called");
    }
    return *m_subject;
  }

  // Grows with each change. To be asked for in `read()`.
  std::uint64_t version() const { return m_version; }

  template <class Function>
  Report change(const Function& f)
  {
    m_report = read([&](Its_subject& its_subject) {
      ++m_version; // also if it throws
      return f(its_subject);
    });
    return m_report;
  }

  static Input positions_input(const pybind11::object& points)
  {
    return points_input(points, "points", Its_subject::dimension);
  }
  Input input_of_ids(const pybind11::object& ids, const Input& points) const
  {
    return subject().is_population() ? ids_input(ids, points.rows.size) : Input{};
  }

  int visit_arrays(visitproc visit, void* arg) const
  {
    for (const Cached& cached : m_cache) {
      Py_VISIT(cached.arrays.ptr());
    }
    return 0;
  }
  void clear_arrays() { m_cache = {}; }

private:
  // Those that are not the user's are not negative.
  void check(const Rows& ids) const
  {
    if (subject().is_population()) {
      return;
    }
    for (std::size_t i = 0; i < ids.size; ++i) {
      const std::int64_t id = ids.at<std::int64_t>(i, 0);
      if (id < 0) {
        throw_unknown_id(id, subject().number_of_ids());
      }
    }
  }

  // Of points that come or go.
  void check_number(const Rows& rows) const
  {
    if (Its_subject::changes_singly && subject().is_population() && rows.size != 1) {
      throw std::invalid_argument("a population inserts and removes one point at a time; update() "
                                  "takes a whole frame");
    }
  }

  struct Cached
  {
    pybind11::tuple arrays{pybind11::reinterpret_steal<pybind11::tuple>(pybind11::handle())};
    std::uint64_t version = 0;
  };

  // Remembers which thread is at work.
  class Caller
  {
  public:
    explicit Caller(std::atomic<std::thread::id>& caller)
      : m_caller(caller)
    {
      m_caller = std::this_thread::get_id();
    }
    Caller(const Caller&) = delete;
    Caller& operator=(const Caller&) = delete;
    ~Caller() { m_caller = std::thread::id(); }

  private:
    std::atomic<std::thread::id>& m_caller;
  };

  void check_caller() const
  {
    if (m_caller == std::this_thread::get_id()) {
      throw Use_error("a triangulation cannot be used by its own classifier, which is "
                      "given all that it may ask for");
    }
  }

  std::unique_ptr<Its_subject> m_subject;
  std::optional<run::Threads> m_threads; // that share its work
  std::mutex m_mutex;
  std::atomic<std::thread::id> m_caller{};
  std::atomic<std::uint64_t> m_version{0};
  std::array<Cached, std::size_t(Group::CHANGES) + 1> m_cache{};
  Report m_report{};
};

} // namespace python

#endif // PYTHON_GUARDED_SUBJECT_H
