// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_COORDINATE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_COORDINATE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

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

// Writes a coordinate as a fraction of integers, so that exactly the same number is read back.
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

  // False if the text is not a number.
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
  // Rejects leading zeros, which would make some number types read octal digits.
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

// Refuses coordinates of a kind that the triangulation's points do not have.
template <class FT>
void check_kind_of_coordinates(Checkpoint_input_2& file)
{
  using Coordinate = Checkpoint_coordinate_2<FT>;
  const std::string_view kind = file.entry("coordinates");
  if (kind != Coordinate::kind)
    file.refuse("the coordinates are of the kind " + Checkpoint_input_2::quoted(kind) +
                ", and those of the triangulation's points of the kind " +
                Checkpoint_input_2::quoted(Coordinate::kind));
}

// Reads a coordinate, whose absolute value as a double has to be smaller than `limit`.
template <class FT>
FT read_coordinate(Checkpoint_input_2& file, const char* name, double limit)
{
  using Coordinate = Checkpoint_coordinate_2<FT>;
  const std::string_view text = file.word(name);
  FT x;
  if (!Coordinate::read(text, x) || !(std::abs(CGAL::to_double(x)) < limit))
    file.refuse(name, text, std::string(Coordinate::meaning) + ", not too large for a double");
  return x;
}

// Reads a coordinate as it was rounded to a double: `is_exact` says that it was not.
template <class FT>
double read_rounded_coordinate(Checkpoint_input_2& file, const char* name, const FT& x,
                               bool is_exact)
{
  constexpr double error = 1e-3; // CGAL promises five correct digits
  const double rounded = file.finite(name), value = CGAL::to_double(x);
  const double most = error * std::abs(value) + (std::numeric_limits<double>::min)();
  if (is_exact ? FT(rounded) != x : !(std::abs(rounded - value) <= most))
    file.refuse(std::string(name) + " is something else than that");
  return rounded;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_COORDINATE_2_H
