// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_ROW_ITERATOR_H
#define BINDINGS_ROW_ITERATOR_H

#include "bindings/common/Subject.h"

#include <CGAL/Dimension.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace bindings {

// Random access to values that are made from the rows of arrays when they are asked for.
template <class Read>
class Row_iterator
{
public:
  using iterator_category = std::random_access_iterator_tag;
  using value_type = decltype(std::declval<const Read&>()(std::size_t()));
  using difference_type = std::ptrdiff_t;
  using pointer = const value_type*;
  using reference = value_type;

  Row_iterator(const Read& read, difference_type row)
    : m_read(read)
    , m_row(row)
  {
  }

  reference operator*() const { return m_read(std::size_t(m_row)); }
  reference operator[](difference_type rows) const { return m_read(std::size_t(m_row + rows)); }
  Row_iterator& operator++()
  {
    ++m_row;
    return *this;
  }
  Row_iterator operator+(difference_type rows) const { return Row_iterator(m_read, m_row + rows); }
  difference_type operator-(const Row_iterator& other) const { return m_row - other.m_row; }
  bool operator==(const Row_iterator& other) const { return m_row == other.m_row; }
  bool operator!=(const Row_iterator& other) const { return m_row != other.m_row; }

private:
  Read m_read;
  difference_type m_row;
};

template <class Read>
class Row_range
{
public:
  Row_range(std::size_t size, const Read& read)
    : m_read(read)
    , m_size(std::ptrdiff_t(size))
  {
  }
  Row_iterator<Read> begin() const { return {m_read, 0}; }
  Row_iterator<Read> end() const { return {m_read, m_size}; }

private:
  Read m_read;
  std::ptrdiff_t m_size;
};

template <class Read>
Row_range<Read> row_range(std::size_t size, const Read& read)
{
  return {size, read};
}

template <class Point>
inline constexpr int dimension_of = CGAL::Ambient_dimension<Point>::value;

template <class Point>
struct Read_point
{
  Point operator()(std::size_t i) const
  {
    if constexpr (dimension_of<Point> == 3) {
      return Point(rows.at<double>(i, 0), rows.at<double>(i, 1), rows.at<double>(i, 2));
    } else {
      return Point(rows.at<double>(i, 0), rows.at<double>(i, 1));
    }
  }
  Rows rows;
};

// The rows as points, if they are as those are in memory: one after the other, and aligned.
template <class Point>
const Point* points_in_memory(const Rows& rows)
{
  static_assert(sizeof(Point) == dimension_of<Point> * sizeof(double),
                "a point is its coordinates");
  const bool are_points = rows.to_next_row == std::ptrdiff_t(sizeof(Point)) &&
                          rows.to_next_column == std::ptrdiff_t(sizeof(double)) &&
                          reinterpret_cast<std::uintptr_t>(rows.data) % alignof(Point) == 0;
  return are_points ? reinterpret_cast<const Point*>(rows.data) : nullptr;
}

struct Read_id
{
  std::int64_t operator()(std::size_t i) const { return rows.at<std::int64_t>(i, 0); }
  Rows rows;
};

template <class Point>
struct Read_identified_point
{
  std::pair<std::int64_t, Point> operator()(std::size_t i) const
  {
    return {Read_id{ids}(i), Read_point<Point>{points}(i)};
  }
  Rows ids, points;
};

} // namespace bindings

#endif // BINDINGS_ROW_ITERATOR_H
