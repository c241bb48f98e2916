// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The functions that the JavaScript beside calls. Those that can fail return 0 if they have, and
// then `dd_error_*` says why. Numbers cross the border in buffers in WebAssembly's memory.

#include "bindings/common/Bounded_cells.h"
#include "bindings/common/Error_description.h"
#include "bindings/common/Report_fields.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/web/wasm/Subjects.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Decimal_number.h>

#include <emscripten/emscripten.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace page {

namespace {

using bindings::Array;
using bindings::Cell;
using bindings::Group;
using bindings::Rows;

struct Triangulation
{
  explicit Triangulation(const Settings& settings)
    : subject(make_subject(settings))
  {
  }

  std::unique_ptr<Subject> subject;
  std::vector<double> points;    // what the next call reads
  std::vector<std::int64_t> ids; // the same, or what the last insertion returned
  std::vector<Array> arrays;     // what was read last
  Subject::Report report;        // of the last change
  bool has_sets = false;         // of a frame that was not rebuilt
};

struct Error
{
  std::string name, message, fields;
};
Error last_error;

std::string text_of(const bindings::Error_field& field)
{
  const auto& value = field.value;
  std::string text = std::string(field.name) + ' ';
  if (const auto* const number = std::get_if<double>(&value)) {
    CGAL::Dynamic_Delaunay_triangulations_2::internal::append_number(text, *number);
  } else if (const auto* const digits = std::get_if<bindings::Digits>(&value)) {
    text += digits->text;
  } else {
    text += std::to_string(std::get<std::size_t>(value));
  }
  return text + '\n';
}

void keep_error(const std::exception_ptr& exception)
{
  if (const auto description = bindings::error_description(exception)) {
    last_error = {description->name, description->message, ""};
    for (const auto& field : description->fields) {
      last_error.fields += text_of(field);
    }
    return;
  }
  try {
    std::rethrow_exception(exception);
  } catch (const std::bad_alloc&) {
    last_error = {"RangeError", "there is not enough memory", ""};
  } catch (const std::length_error&) {
    last_error = {"RangeError", "there are too many points for the memory of WebAssembly", ""};
  } catch (const std::invalid_argument& e) {
    last_error = {"InputValueError", e.what(), ""};
  } catch (const std::exception& e) {
    last_error = {"Error", e.what(), ""}; // a defect, not the user's
  }
}

// Calls the function; the result is 0 if it throws.
template <class Function>
auto guarded(const Function& f) -> decltype(f())
{
  try {
    return f();
  } catch (...) {
    keep_error(std::current_exception());
    return {};
  }
}

// Makes a change; false if that is refused.
template <class Change>
bool change(Triangulation& t, bool is_frame, const Change& make)
{
  return guarded([&] {
    t.has_sets = false;
    t.report = make();
    t.has_sets = is_frame && !t.report.rebuilt();
    return true;
  });
}

// The first `size` points of the buffer.
Rows point_rows(const Triangulation& t, std::size_t size)
{
  return {reinterpret_cast<const char*>(t.points.data()), 2 * sizeof(double), sizeof(double), size};
}
Rows id_rows(const Triangulation& t, std::size_t size)
{
  return {reinterpret_cast<const char*>(t.ids.data()), sizeof(std::int64_t), 0, size};
}

// As JavaScript gives it: four numbers, and whether it is a slab.
std::optional<Cell> cell_of(const double* numbers, bool is_slab)
{
  if (numbers == nullptr) {
    return std::nullopt;
  }
  return Cell{numbers[0], numbers[1], numbers[2], numbers[3], is_slab};
}

} // namespace

extern "C" {

// \param cell four numbers, or null in the plane.
EMSCRIPTEN_KEEPALIVE Triangulation* dd_create(const char* classifier, const char* repair,
                                              const char* policy, unsigned padding, double seed,
                                              const double* cell, bool is_slab)
{
  return guarded([&] {
    const Settings settings{classifier,
                            repair,
                            policy,
                            static_cast<std::uint64_t>(seed),
                            true,
                            false,
                            cell_of(cell, is_slab),
                            padding};
    return std::make_unique<Triangulation>(settings).release();
  });
}

EMSCRIPTEN_KEEPALIVE void dd_destroy(Triangulation* t)
{
  delete t;
}

EMSCRIPTEN_KEEPALIVE const char* dd_error_name()
{
  return last_error.name.c_str();
}
EMSCRIPTEN_KEEPALIVE const char* dd_error_message()
{
  return last_error.message.c_str();
}
// Lines of a name, a blank and a number.
EMSCRIPTEN_KEEPALIVE const char* dd_error_fields()
{
  return last_error.fields.c_str();
}

// Where two coordinates of each point are, before a call that reads so many points.
EMSCRIPTEN_KEEPALIVE double* dd_points(Triangulation* t, std::size_t size)
{
  return guarded([&] {
    t->points.reserve(2 * size + 1); // that there is an address also of nothing
    t->points.resize(2 * size);
    return t->points.data();
  });
}
EMSCRIPTEN_KEEPALIVE std::int64_t* dd_ids(Triangulation* t, std::size_t size)
{
  return guarded([&] {
    t->ids.reserve(size + 1);
    t->ids.resize(size);
    return t->ids.data();
  });
}

EMSCRIPTEN_KEEPALIVE bool dd_update(Triangulation* t, std::size_t size, const double* cell,
                                    bool is_slab)
{
  return change(*t, true, [&] {
    return t->subject->update({}, point_rows(*t, size), cell_of(cell, is_slab));
  });
}
EMSCRIPTEN_KEEPALIVE bool dd_move(Triangulation* t, std::size_t size)
{
  return change(*t, false,
                [&] { return t->subject->move(id_rows(*t, size), point_rows(*t, size)); });
}
// The new ids are in the buffer then.
EMSCRIPTEN_KEEPALIVE bool dd_insert(Triangulation* t, std::size_t size)
{
  return change(*t, false, [&] {
    t->ids.clear();
    return t->subject->insert({}, point_rows(*t, size), t->ids);
  });
}
EMSCRIPTEN_KEEPALIVE bool dd_remove(Triangulation* t, std::size_t size)
{
  return change(*t, false, [&] { return t->subject->remove(id_rows(*t, size)); });
}
EMSCRIPTEN_KEEPALIVE bool dd_mend(Triangulation* t)
{
  return change(*t, false, [&] { return t->subject->mend(); });
}

EMSCRIPTEN_KEEPALIVE bool dd_certify(Triangulation* t)
{
  return t->subject->certify();
}
EMSCRIPTEN_KEEPALIVE bool dd_is_certified(const Triangulation* t)
{
  return t->subject->is_certified();
}
EMSCRIPTEN_KEEPALIVE std::size_t dd_number_of_points(const Triangulation* t)
{
  return t->subject->number_of_points();
}
EMSCRIPTEN_KEEPALIVE std::size_t dd_number_of_ids(const Triangulation* t)
{
  return t->subject->number_of_ids();
}
EMSCRIPTEN_KEEPALIVE std::size_t dd_number_of_vertices(const Triangulation* t)
{
  return t->subject->number_of_vertices();
}
EMSCRIPTEN_KEEPALIVE bool dd_has_id(const Triangulation* t, std::size_t id)
{
  return t->subject->has_id(std::int64_t(id));
}

// The counts of the last change, in the order of `counts_of_reports`.
EMSCRIPTEN_KEEPALIVE const double* dd_counts(const Triangulation* t)
{
  static std::array<double, bindings::counts_of_reports.size()> counts;
  std::transform(bindings::counts_of_reports.begin(), bindings::counts_of_reports.end(),
                 counts.begin(), [&](auto count) { return double(t->report.*count); });
  return counts.data();
}
// Why the last change triangulated anew, or null.
EMSCRIPTEN_KEEPALIVE const char* dd_rebuild_reason(const Triangulation* t)
{
  return bindings::rebuild_reason(t->report);
}

// Computes arrays, which stay until the next ones are computed; the result is their number.
EMSCRIPTEN_KEEPALIVE std::size_t dd_read(Triangulation* t, int group)
{
  return guarded([&] {
    t->arrays.clear();
    if (static_cast<Group>(group) == Group::SETS && !t->has_sets) {
      t->arrays = {Array{std::vector<std::int32_t>(t->subject->number_of_ids())}};
    } else {
      t->arrays = t->subject->arrays(static_cast<Group>(group));
    }
    return t->arrays.size();
  });
}
EMSCRIPTEN_KEEPALIVE bool dd_read_clipped_cells(Triangulation* t, double xmin, double ymin,
                                                double xmax, double ymax)
{
  return guarded([&] {
    t->arrays = t->subject->clipped_cells({xmin, ymin, xmax, ymax});
    return true;
  });
}
// Measures and pieces of cells that end at a radius and in a convex domain, whose corners are in
// the buffer of points. Without corners there is none.
EMSCRIPTEN_KEEPALIVE bool dd_read_bounded_cells(Triangulation* t, double radius,
                                                std::size_t corners)
{
  return guarded([&] {
    bindings::Bounded_cells bounded;
    if (corners > 0) {
      bindings::Corners domain;
      const bindings::Read_point<bindings::Corner> corner{point_rows(*t, corners)};
      for (std::size_t i = 0; i < corners; ++i) {
        domain.push_back(corner(i));
      }
      std::get<CGAL::Bounded_voronoi_cells_2>(bounded.cells)
          .set_domain(domain.begin(), domain.end());
    }
    bounded = t->subject->bounded_cells(std::move(bounded), radius);
    t->arrays = bindings::bounded_measure_arrays(bounded);
    for (Array& array : bindings::bounded_piece_arrays(bounded)) {
      t->arrays.push_back(std::move(array));
    }
    return true;
  });
}
EMSCRIPTEN_KEEPALIVE bool dd_read_cell_corners(Triangulation* t, std::size_t id)
{
  return guarded([&] {
    t->arrays = {t->subject->cell_corners(std::int64_t(id))};
    return true;
  });
}

// Where the numbers of an array are, how many, and whether they are 0: integers of 32 bits, 1: of
// 64 bits, or 2: doubles.
EMSCRIPTEN_KEEPALIVE const void* dd_array(const Triangulation* t, std::size_t i)
{
  return std::visit([](const auto& numbers) -> const void* { return numbers.data(); },
                    t->arrays[i].numbers);
}
EMSCRIPTEN_KEEPALIVE std::size_t dd_array_length(const Triangulation* t, std::size_t i)
{
  return std::visit([](const auto& numbers) { return numbers.size(); }, t->arrays[i].numbers);
}
EMSCRIPTEN_KEEPALIVE std::size_t dd_array_type(const Triangulation* t, std::size_t i)
{
  return t->arrays[i].numbers.index();
}

} // extern "C"

} // namespace page
