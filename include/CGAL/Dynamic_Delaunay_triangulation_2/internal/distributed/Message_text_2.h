// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_MESSAGE_TEXT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_MESSAGE_TEXT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Decimal_number_2.h>

#include <string>
#include <type_traits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <class Part>
void append_part(std::string& text, const Part& part)
{
  if constexpr (std::is_arithmetic_v<Part>)
    append_number(text, part);
  else
    text += part;
}

// Joins texts and numbers. A stream would write numbers in the global locale, and bring all locales
// of the standard library into a program that is loaded over a network.
template <class... Parts>
std::string message_text(const Parts&... parts)
{
  std::string text;
  (append_part(text, parts), ...);
  return text;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_MESSAGE_TEXT_2_H
