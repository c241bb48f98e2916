// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_SUBJECT_H
#define BINDINGS_SUBJECT_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace CGAL {
class Bounded_voronoi_gradients_2;
} // namespace CGAL

namespace bindings {

struct Bounded_cells;

// Rows of numbers in memory, with any strides in bytes, also negative ones.
struct Rows
{
  template <class Number>
  Number at(std::size_t i, std::size_t j) const
  {
    Number number; // the array may be unaligned
    std::memcpy(&number,
                data + std::ptrdiff_t(i) * to_next_row + std::ptrdiff_t(j) * to_next_column,
                sizeof number);
    return number;
  }

  const char* data = nullptr;
  std::ptrdiff_t to_next_row = 0;
  std::ptrdiff_t to_next_column = 0;
  std::size_t size = 0;
};

struct Cell
{
  double ax, ay, bx, by; // of a slab, bx and by do not count
  bool is_slab;
};

struct Box
{
  double xmin, ymin, xmax, ymax;
};

// Of Voronoi cells: one for all, or one for each row.
using Radii = std::variant<double, Rows>;

// What becomes an array of the other language, whose rows have this shape: {} of numbers, {2} of
// pairs.
struct Array
{
  std::variant<std::vector<std::int32_t>, std::vector<std::int64_t>, std::vector<double>> numbers;
  std::vector<std::size_t> shape_of_row{};
};

// What is computed together.
enum class Group {
  IDS,
  POINTS,
  DUPLICATES,
  EDGES,
  TRIANGLES,
  NEIGHBOR_LISTS,
  CELLS,
  RIDGES,
  CHANGES,
  SETS,
  BROKEN_EDGES,
  CORNERS // triangles without their neighbors
};

// What is asked of many query points at once, or with a squared radius.
enum class Query { NEAREST, WITHIN, NATURAL_WEIGHTS, LINEAR_WEIGHTS, ALPHA_SHAPE };

struct Question
{
  Query query;
  Rows query_points{};
  double extent = 0; // the radius of WITHIN, the alpha of ALPHA_SHAPE
};

struct Settings
{
  std::string classifier;
  std::string repair; // empty for the usual one
  std::string policy;
  std::uint64_t seed;
  bool records_changes;
  bool is_population;
  std::optional<Cell> cell; // of periodic space
  unsigned padding = 1;
};

// A triangulation as another language uses it, whatever its type is. The ids of a population are
// the user's, and its arrays speak of rows, which are the places in `Group::IDS`. Others have no
// ids of the user, and their rows are the ids.
template <class Its_report>
class Subject_base
{
public:
  using Report = Its_report;

  Subject_base() = default;
  Subject_base& operator=(const Subject_base&) = delete;
  virtual ~Subject_base() = default;

  virtual bool is_population() const = 0;
  virtual Report move(const Rows& ids, const Rows& points) = 0;
  // Tells new ids where they are not the user's.
  virtual Report insert(const Rows& ids, const Rows& points,
                        std::vector<std::int64_t>& new_ids) = 0;
  virtual Report remove(const Rows& ids) = 0;
  virtual Report mend() = 0;
  virtual bool certify() = 0;

  virtual bool is_certified() const = 0;
  virtual bool is_valid() const = 0;
  virtual std::size_t number_of_points() const = 0;
  virtual std::size_t number_of_ids() const = 0;
  virtual std::size_t number_of_vertices() const = 0;
  virtual bool has_id(std::int64_t id) const = 0;

  virtual std::vector<Array> arrays(Group group) const = 0;
  virtual std::vector<Array> answer(const Question& question) const = 0;

  virtual std::string checkpoint() const = 0;
  virtual void restore(const std::string& checkpoint) = 0;

protected:
  Subject_base(const Subject_base&) = default;
};

// In the plane or in periodic space.
class Subject : public Subject_base<CGAL::Update_report_2>
{
public:
  static constexpr int dimension = 2;
  // Whether a population inserts and removes one point at a time.
  static constexpr bool changes_singly = true;

  Subject() = default;
  Subject(const Subject&) = delete;

  virtual Report update(const Rows& ids, const Rows& points, const std::optional<Cell>& cell) = 0;
  virtual std::optional<Cell> cell() const = 0;
  virtual std::vector<Array> clipped_cells(const Box& box) const = 0;
  virtual Array cell_corners(std::int64_t id) const = 0;
  // `bounded` has the domain, if there is one.
  virtual Bounded_cells bounded_cells(Bounded_cells bounded, const Radii& radii) const = 0;
  // Of an energy that depends so on areas, by rows, and on lengths, by pieces.
  virtual CGAL::Bounded_voronoi_gradients_2 bounded_gradients(const Bounded_cells& bounded,
                                                              const Rows& area_weights,
                                                              const Rows& length_weights) const = 0;
};

} // namespace bindings

#endif // BINDINGS_SUBJECT_H
