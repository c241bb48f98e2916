// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_RANGE_ARGUMENTS_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_RANGE_ARGUMENTS_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A valid type if Range has begin().
template <class Range>
using If_range = decltype(std::begin(std::declval<const Range&>()));

// A valid type if Map is a property map.
template <class Map>
using If_map = typename boost::property_traits<Map>::key_type;

template <class Iterator>
constexpr bool is_random_access =
    std::is_convertible_v<typename std::iterator_traits<Iterator>::iterator_category,
                          std::random_access_iterator_tag>;

// Whether an iterator is known to point to values in memory. Others may be costly to read twice.
template <class Iterator, class Value = typename std::iterator_traits<Iterator>::value_type>
constexpr bool is_in_memory = std::is_pointer_v<Iterator> ||
                              std::is_same_v<Iterator, typename std::vector<Value>::iterator> ||
                              std::is_same_v<Iterator, typename std::vector<Value>::const_iterator>;
// iterators over bool: std::vector<bool> has no values to point to
template <class Iterator>
constexpr bool is_in_memory<Iterator, bool> = false;

// Maps that read the parts of the pairs to which an iterator points.
template <class Iterator>
using First_of = First_of_pair_property_map<typename std::iterator_traits<Iterator>::value_type>;
template <class Iterator>
using Second_of = Second_of_pair_property_map<typename std::iterator_traits<Iterator>::value_type>;

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_RANGE_ARGUMENTS_H
