// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_DYNAMIC_TRIANGULATION_OPTIONS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_DYNAMIC_TRIANGULATION_OPTIONS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Default.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The repair of a triangulation: an option of `Dynamic_Delaunay_triangulation_2` and
`Dynamic_periodic_Delaunay_triangulation_2`, which say what options there are. Options follow the
classifier, in any order, each at most once. With `Default` as its argument, an option is as if it
were not given.

\tparam Repair a model of `DelaunayRepair_2`.
*/
template <class Repair>
struct With_repair_2
{
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The data structure of a triangulation in the plane: an option, as `With_repair_2`.

\tparam Tds an `Indexed_triangulation_data_structure_2` of its traits, with data of the user in its
vertices or faces.
*/
template <class Tds>
struct With_data_structure_2
{
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The update policy of a triangulation: an option, as `With_repair_2`.

\tparam UpdatePolicy a model of `DelaunayUpdatePolicy_2`.
*/
template <class UpdatePolicy>
struct With_policy_2
{
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The visitor of a triangulation: an option, as `With_repair_2`.

\tparam Visitor a model of `DelaunayUpdateVisitor_2`, in periodic space of
`PeriodicUpdateVisitor_2`.
*/
template <class Visitor>
struct With_visitor_2
{
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

How a triangulation shares its work among threads: an option, as `With_repair_2`.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
*/
template <class ConcurrencyTag>
struct With_concurrency_2
{
};

namespace Dynamic_Delaunay_triangulations_2::internal {

// The argument of the option of one kind, or else `Usual`.
template <template <class> class Kind, class Usual, class... Options>
struct Option_2
{
  using type = Usual;
  static constexpr std::size_t number = 0; // of the options of this kind
};
template <template <class> class Kind, class Usual, class Other, class... More>
struct Option_2<Kind, Usual, Other, More...> : Option_2<Kind, Usual, More...>
{
};
template <template <class> class Kind, class Usual, class Argument, class... More>
struct Option_2<Kind, Usual, Kind<Argument>, More...>
{
  using type = typename Default::Get<Argument, Usual>::type;
  static constexpr std::size_t number = 1 + Option_2<Kind, Usual, More...>::number;
};

template <template <class> class Kind, class... Options>
constexpr std::size_t number_of_options = Option_2<Kind, void, Options...>::number;

// Refuses what is no option, and options that are given twice.
template <class... Options>
struct Options_check_2
{
  static constexpr std::size_t numbers[5] = {number_of_options<With_repair_2, Options...>,
                                             number_of_options<With_data_structure_2, Options...>,
                                             number_of_options<With_policy_2, Options...>,
                                             number_of_options<With_visitor_2, Options...>,
                                             number_of_options<With_concurrency_2, Options...>};
  static_assert(numbers[0] + numbers[1] + numbers[2] + numbers[3] + numbers[4] ==
                    sizeof...(Options),
                "after the classifier, a triangulation takes the options With_repair_2<>, "
                "With_data_structure_2<>, With_policy_2<>, With_visitor_2<> and "
                "With_concurrency_2<>, and nothing else");
  static_assert(numbers[0] <= 1 && numbers[1] <= 1 && numbers[2] <= 1 && numbers[3] <= 1 &&
                    numbers[4] <= 1,
                "an option of a triangulation is given twice");
};

} // namespace Dynamic_Delaunay_triangulations_2::internal
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_DYNAMIC_TRIANGULATION_OPTIONS_2_H
