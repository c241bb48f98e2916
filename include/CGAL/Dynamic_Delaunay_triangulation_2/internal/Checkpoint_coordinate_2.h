// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHECKPOINT_COORDINATE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHECKPOINT_COORDINATE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Checkpoint_file_2.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Lazy_exact_nt.h>

#include <algorithm>
#include <cstddef>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

template <class FT>
const FT& exact_value(const FT& x)
{
  return x;
}
template <class ET>
const ET& exact_value(const Lazy_exact_nt<ET>& x)
{
  return x.exact();
}

// How a coordinate is written, so that exactly the same number is read: a fraction of integers.
template <class FT>
class Checkpoint_coordinate_2
{
  using Exact = std::decay_t<decltype(exact_value(std::declval<const FT&>()))>;
  using Fraction = Fraction_traits<Exact>;
  using Numerator = typename Fraction::Numerator_type;
  using Denominator = typename Fraction::Denominator_type;
  template <class Integer>
  static constexpr bool is_integer =
      std::is_convertible_v<typename Algebraic_structure_traits<Integer>::Algebraic_category,
                            Euclidean_ring_tag>;
  static_assert(Fraction::Is_fraction::value && is_integer<Numerator> && is_integer<Denominator>,
                "a checkpoint needs coordinates that can be written exactly: doubles, or fractions "
                "of integers as in Exact_predicates_exact_constructions_kernel");

public:
  static constexpr const char* kind = "rational";
  static constexpr const char* meaning = "a fraction of integers";

  static std::string text(const FT& x)
  {
    Numerator numerator;
    Denominator denominator;
    typename Fraction::Decompose()(exact_value(x), numerator, denominator);
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << numerator;
    if (denominator != 1)
      out << '/' << denominator;
    return out.str();
  }

  // False if that is not the text of a number.
  static bool read(std::string_view text, FT& x)
  {
    const std::size_t bar = text.find('/');
    const std::string_view above = text.substr(0, bar);
    const std::string_view below = bar == text.npos ? "1" : text.substr(bar + 1);
    const bool is_negative = !above.empty() && above.front() == '-';
    if (!is_natural(above.substr(is_negative)) || !is_natural(below) || below == "0")
      return false;
    x = FT(typename Fraction::Compose()(integer<Numerator>(above), integer<Denominator>(below)));
    return true;
  }

private:
  // Leading zeros would make some number types read octal digits.
  static bool is_natural(std::string_view text)
  {
    return !text.empty() && (text.front() != '0' || text == "0") &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  }

  template <class Integer>
  static Integer integer(std::string_view digits)
  {
    std::istringstream in{std::string(digits)};
    in.imbue(std::locale::classic());
    Integer result;
    in >> result;
    return result;
  }
};

template <>
class Checkpoint_coordinate_2<double>
{
public:
  static constexpr const char* kind = "double";
  static constexpr const char* meaning = "a finite number";

  static double text(double x) { return x; }
  static bool read(std::string_view text, double& x) { return read_finite(text, x); }
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHECKPOINT_COORDINATE_2_H
