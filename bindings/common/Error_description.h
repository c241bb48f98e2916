// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_ERROR_DESCRIPTION_H
#define BINDINGS_ERROR_DESCRIPTION_H

#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bindings {

struct Digits // of an integer of any size
{
  std::string text;
};

struct Error_field
{
  const char* name;
  std::variant<std::size_t, double, Digits> value;
};

// What another language throws instead.
struct Error_description
{
  const char* name;
  std::string message;
  std::vector<Error_field> fields{};
};

// Of an exception of the package; none of any other one.
inline std::optional<Error_description> error_description(const std::exception_ptr& exception)
{
  using Description = Error_description;
  try {
    std::rethrow_exception(exception);
  } catch (const CGAL::Non_finite_coordinate_error_2& e) {
    return Description{
        "NonFiniteCoordinateError", e.what(), {{"id", e.id()}, {"x", e.x()}, {"y", e.y()}}};
  } catch (const CGAL::Coordinate_range_error_2& e) {
    return Description{"CoordinateRangeError",
                       e.what(),
                       {{"id", e.id()}, {"x", e.x()}, {"y", e.y()}, {"limit", e.limit()}}};
  } catch (const CGAL::Non_finite_coordinate_error_3& e) {
    return Description{"NonFiniteCoordinateError",
                       e.what(),
                       {{"id", e.id()}, {"x", e.x()}, {"y", e.y()}, {"z", e.z()}}};
  } catch (const CGAL::Coordinate_range_error_3& e) {
    return Description{
        "CoordinateRangeError",
        e.what(),
        {{"id", e.id()}, {"x", e.x()}, {"y", e.y()}, {"z", e.z()}, {"limit", e.limit()}}};
  } catch (const CGAL::Point_count_error_2& e) {
    return Description{
        "PointCountError", e.what(), {{"expected", e.expected()}, {"given", e.given()}}};
  } catch (const CGAL::Point_limit_error_2& e) {
    return Description{"PointLimitError", e.what(), {{"number", e.number()}, {"limit", e.limit()}}};
  } catch (const CGAL::Unknown_id_error_2& e) {
    return Description{
        "UnknownIdError", e.what(), {{"id", e.id()}, {"number_of_ids", e.number_of_ids()}}};
  } catch (const CGAL::Unknown_user_id_error_2& e) {
    return Description{"UnknownIdError", e.what(), {{"id", Digits{e.id()}}}};
  } catch (const CGAL::Repeated_id_error_2& e) {
    return Description{"RepeatedIdError", e.what(), {{"id", Digits{e.id()}}}};
  } catch (const CGAL::Uncertified_triangulation_error_2&) {
    // that of C++ names what other languages have not
    return Description{
        "UncertifiedTriangulationError",
        "the triangulation is not certified, as after a heuristic update: call mend() to make "
        "it Delaunay, or certify() to find out whether it is; points, edges, triangles and "
        "indices can be read as they are"};
  } catch (const CGAL::Parameter_error_2& e) {
    return Description{"ParameterError", e.what(), {{"value", e.value()}}};
  } catch (const CGAL::Domain_error_2& e) {
    return Description{"DomainError", e.what(), {{"corner", e.corner()}}};
  } catch (const CGAL::Periodic_cell_error_2& e) {
    return Description{"PeriodicCellError",
                       e.what(),
                       {{"ax", e.ax()}, {"ay", e.ay()}, {"bx", e.bx()}, {"by", e.by()}}};
  } catch (const CGAL::Periodic_cell_error_3& e) {
    return Description{"PeriodicCellError", e.what()};
  } catch (const CGAL::Periodic_range_error_2& e) {
    return Description{"PeriodicRangeError", e.what(), {{"id", e.id()}}};
  } catch (const CGAL::Periodic_range_error_3& e) {
    return Description{"PeriodicRangeError", e.what(), {{"id", e.id()}}};
  } catch (const CGAL::Checkpoint_error_2& e) {
    return Description{"CheckpointError", e.what(), {{"line", e.line()}}};
  } catch (const CGAL::Dynamic_Delaunay_triangulation_error_2& e) {
    return Description{"DynamicDelaunayError", e.what()};
  } catch (...) {
    return std::nullopt;
  }
}

} // namespace bindings

#endif // BINDINGS_ERROR_DESCRIPTION_H
