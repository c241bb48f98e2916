// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_ARRAY_NUMBERS_H
#define BINDINGS_ARRAY_NUMBERS_H

#include "bindings/common/Subject.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bindings {

using Integers = std::vector<std::int32_t>;
using Doubles = std::vector<double>;

// Whether arrays of a triangulation have shifts that mean something.
template <class Dynamic>
constexpr bool is_periodic_triangulation = false;

// As SciPy's, arrays have 32 bits for each number. Checked once, for the longest array.
inline void check_length(std::size_t length)
{
  if (length > std::size_t((std::numeric_limits<std::int32_t>::max)())) {
    throw std::length_error("there are too many neighbors for arrays of 32 bits");
  }
}

// The rows of ids: the id itself, or the number of smaller ids that exist.
class Row_numbers
{
public:
  template <class Dynamic>
  Row_numbers(const Dynamic& dt, bool are_dense)
    : m_size(are_dense ? dt.number_of_points() : dt.number_of_ids())
  {
    check_length(6 * m_size);
    if (m_size == dt.number_of_ids()) {
      return;
    }
    std::int32_t row = 0;
    for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
      m_rows.push_back(row);
      row += dt.has_id(id);
    }
  }

  std::size_t size() const { return m_size; }
  bool are_dense() const { return !m_rows.empty(); }
  std::int32_t operator[](std::size_t id) const
  {
    return m_rows.empty() ? std::int32_t(id) : m_rows[id];
  }

private:
  std::size_t m_size;
  Integers m_rows; // empty if they are the ids
};

template <class Dynamic, class User_id>
Array id_array(const Dynamic& dt, const User_id& user_id)
{
  std::vector<std::int64_t> ids;
  ids.reserve(dt.number_of_points());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (dt.has_id(id)) {
      ids.push_back(std::int64_t(user_id(id)));
    }
  }
  return {std::move(ids)};
}

} // namespace bindings

#endif // BINDINGS_ARRAY_NUMBERS_H
