// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_PARTS_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_PARTS_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Many queries at once, which threads share. Each part has its own copy of the caller's `queries`,
// because this object remembers where the last answer was.

// The least number of queries in a part. A query takes about a microsecond.
template <class Parts>
constexpr std::size_t least_queries = Parts::size_for(64);

// Calls f(queries, i, part) for all i below `size`.
template <class Parts, class Queries, class Function>
void query_in_parts(const Queries& queries, std::size_t size, const Function& f)
{
  Parts::for_each(size, least_queries<Parts>,
                  [&](std::size_t part, std::size_t first, std::size_t beyond) {
                    Queries queries_of_part(queries);
                    for (std::size_t i = first; i < beyond; ++i)
                      f(queries_of_part, i, part);
                  });
}

// Calls f(queries, i, iterator), which writes answers, for all i below `size`. The sorted answers
// of the i-th call are listed from `begins[i]` to before `begins[i + 1]`.
template <class Parts, class Queries, class Answer, class Function>
void list_in_parts(const Queries& queries, std::size_t size, std::vector<Answer>& answers,
                   std::vector<std::size_t>& begins, const Function& f)
{
  std::vector<std::vector<Answer>> found(Parts::number(size, least_queries<Parts>));
  std::vector<std::size_t> ends(size + 1);
  query_in_parts<Parts>(queries, size,
                        [&](Queries& queries_of_part, std::size_t i, std::size_t part) {
                          std::vector<Answer>& of_part = found[part];
                          const std::size_t before = of_part.size();
                          f(queries_of_part, i, std::back_inserter(of_part));
                          std::sort(of_part.begin() + std::ptrdiff_t(before), of_part.end());
                          ends[i + 1] = of_part.size() - before;
                        });
  for (std::size_t i = 0; i < size; ++i)
    ends[i + 1] += ends[i];
  std::vector<Answer> all;
  all.reserve(ends[size]);
  for (const std::vector<Answer>& of_part : found)
    all.insert(all.end(), of_part.begin(), of_part.end());
  answers.swap(all);
  begins.swap(ends);
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_PARTS_H
