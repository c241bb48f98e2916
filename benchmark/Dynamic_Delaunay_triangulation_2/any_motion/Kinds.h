// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_KINDS_H
#define ANY_MOTION_KINDS_H

#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace any_motion {

// A kind of frames: a program with a name.
struct Kind
{
  std::string name;
  std::string is;      // one sentence
  std::string program; // as in random_operations/Program.h
  // Where all points are on a line, CGAL's insertion takes quadratic time.
  std::size_t max_points = (std::numeric_limits<std::size_t>::max)();
  std::size_t min_points = 0;
  std::string group{};

  bool has(std::size_t points) const { return min_points <= points && points <= max_points; }
};

namespace kinds {

constexpr std::size_t max_on_a_line = 10'000,
                      any_number = (std::numeric_limits<std::size_t>::max)();

inline std::string text(double number)
{
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

inline std::string text_of_share(double percent)
{
  return text(0.01 * percent);
}

// The least number of points of which `percent` percent are at least one.
inline std::size_t min_for(double percent)
{
  return static_cast<std::size_t>(std::ceil(100.0 / percent));
}

inline void add(const char* group, std::vector<Kind>& all, const std::vector<Kind>& kinds)
{
  for (Kind kind : kinds) {
    kind.group = group;
    all.push_back(kind);
  }
}

inline void add_jumps(std::vector<Kind>& all)
{
  for (const std::size_t count : {3u, 10u, 30u, 100u, 300u, 1000u, 3000u}) {
    const std::string number = std::to_string(count);
    add("jumps", all,
        {{"jump_anywhere_" + number + "_points", number + " points go anywhere, the others rest",
          "square; fresh #" + number, any_number, 2 * count + 1}});
  }
  for (const double percent : {0.01, 0.1, 1.0, 2.0, 4.0, 8.0, 16.0, 33.0, 50.0}) {
    add("jumps", all,
        {{"jump_anywhere_" + text(percent) + "_percent",
          text(percent) + " percent go anywhere, the others rest",
          "square; fresh " + text_of_share(percent), any_number, min_for(percent)}});
  }
  for (const double size : {1.0, 10.0}) {
    for (const double percent : {0.1, 1.0, 4.0, 10.0, 30.0, 50.0}) {
      const std::string spacings = size == 1.0 ? "1_spacing" : text(size) + "_spacings";
      add("jumps", all,
          {{"jump_" + spacings + "_" + text(percent) + "_percent",
            text(percent) + " percent jump by " + text(size) +
                " spacings in random directions, the others rest",
            "square; jump " + text_of_share(percent) + ' ' + text(size), any_number,
            min_for(percent)}});
    }
  }
  for (const double step : {0.003, 0.03}) {
    for (const double percent : {0.1, 1.0, 10.0}) {
      add("jumps", all,
          {{"jump_in_brownian_" + text(step) + "_" + text(percent) + "_percent",
            text(percent) + " percent go anywhere, all are in Brownian motion of " + text(step) +
                " spacings",
            "square; brownian 1 " + text(step) + "; fresh " + text_of_share(percent), any_number,
            min_for(percent)}});
    }
  }
  add("jumps", all,
      {{"jump_of_a_patch", "the 1 percent in a disc go anywhere", "square; fresh 0.01 1 disc"}});
  add("jumps", all,
      {{"jump_onto_others", "1 percent go exactly to where others are",
        "square; onto_others 0.01"}});
  add("jumps", all, {{"teleport", "all go anywhere", "square; fresh 1"}});
}

inline void add_calm(std::vector<Kind>& all)
{
  add("calm", all, {{"rest", "no point moves", "square"}});
  for (const double step : {0.001, 0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 1.0}) {
    add("calm", all,
        {{"brownian_" + text(step), "Brownian motion of " + text(step) + " spacings",
          "square; brownian 1 " + text(step)}});
  }
}

inline void add_exchanges(std::vector<Kind>& all)
{
  add("swaps", all,
      {{"swap_on_lattice", "1 percent of a square lattice swap places in pairs",
        "lattice; swap 0.01"},
       {"swap_in_square", "1 percent of a random cloud swap places in pairs", "square; swap 0.01"},
       {"swap_shared_vertices",
        "two groups, 5 percent each, are at one place each and exchange them",
        "square; swap_groups 0.1"},
       {"swap_small_shared_vertices", "the same with two groups of ten points",
        "square; swap_groups #20"},
       {"shuffle", "all exchange their places", "square; shuffle 1"}});
  add("wraps", all,
      {{"wrap_around", "all drift by 0.02 spacings and wrap around in their box",
        "square; drift 1 0.02"},
       {"wrap_around_lattice", "the same on a lattice", "lattice; drift 1 0.02"},
       {"shear_flow", "a shear flow of up to 0.1 spacings that wraps around",
        "square; shear_flow 1 0.1"},
       {"fast_shear_flow", "a shear flow of up to a spacing that wraps around",
        "square; shear_flow 1 1"},
       {"reinject",
        "all drift by 0.02 spacings, and from the right edge to anywhere on the left one",
        "square; reinject 1 0.02"},
       {"crossing", "half of them drift by a tenth of a spacing through the others",
        "square; drift 0.5 0.1 fixed"}});
  add("outliers", all,
      {{"flock_far", "1 percent go near to one far place, and back", "square; flock_far 0.01 10"},
       {"meet_far", "1 percent go exactly to one far place, and back", "square; meet_far 0.01 10"},
       {"gps_outliers", "0.5 percent stray 10 boxes away, each for one frame",
        "square; stray 0.005 10"},
       {"gps_outliers_in_motion", "the same, all in Brownian motion of 0.01 spacings",
        "square; brownian 1 0.01; stray 0.005 10"},
       {"remote_outliers", "0.5 percent stray a million boxes away", "square; stray 0.005 1e6"}});
  add("meetings", all,
      {{"meet_and_part", "pairs, 1 percent, meet in one place and part near to it",
        "square; meet 0.01 0.3"},
       {"meet_and_part_all", "all meet in pairs in one place and part near to it",
        "square; meet 1 0.3"},
       {"meet_and_leave", "pairs, 1 percent, meet in one place and part far from it",
        "square; meet_and_leave 0.01"}});
}

inline void add_changes_of_all(std::vector<Kind>& all)
{
  add("whole", all,
      {{"mirror", "all are mirrored", "square; mirror 1"},
       {"quarter_turn", "all turn by a right angle", "square; quarter_turn 1"},
       {"turn_0.01", "all turn by 0.01 radians", "square; turn 1 0.01"},
       {"turn_0.5", "all turn by 0.5 radians", "square; turn 1 0.5"},
       {"tenth_of_a_line", "all go onto a tenth of a line, and back", "square; flatten 1 0.1",
        max_on_a_line},
       {"onto_a_line", "all go onto a line, and back", "square; flatten 1 1", max_on_a_line},
       {"half_onto_a_line", "half of them go onto a line, and back", "square; flatten 0.5 1"},
       {"onto_one_point", "all go to one place, and back", "square; collapse 1"},
       {"half_onto_one_point", "half of them go to one place, and back", "square; collapse 0.5"},
       {"inside_out", "near goes far, and far goes near", "square; inside_out 1"},
       {"twice_as_large", "all is twice as large, and back", "square; scale 1 2"},
       {"shear_by_one", "x goes to x + y, and back", "square; shear 1 1"},
       {"translate_far", "all go 1000 boxes away, and back", "square; translate 1 1000"},
       {"swirl", "all turn, by an angle that depends on theirs", "square; swirl 1 0.1"}});
}

inline void add_uneven(std::vector<Kind>& all)
{
  add("convex", all,
      {{"parabola_along", "on a parabola, along it by a tenth of their gap",
        "parabola; along 1 0.1"},
       {"parabola_brownian", "on a parabola, and off by a tenth of their gap",
        "parabola; brownian 1 0.1"},
       {"parabola_jump", "1 percent go anywhere on a parabola", "parabola; fresh 0.01"},
       {"circle_along", "on a circle, along it by a tenth of their gap", "circle; along 1 0.1"},
       {"circle_brownian", "on a circle, and off by a hundredth of their gap",
        "circle; brownian 1 0.01"},
       {"circle_jump", "1 percent go anywhere on a circle", "circle; fresh 0.01"},
       {"rings_jump", "1 percent go to others' places on integer circles", "rings; fresh 0.01"},
       {"rings_swap", "1 percent swap places on integer circles", "rings; swap 0.01"}});
  add("lines", all,
      {{"line_along", "on a line, along it by a tenth of their gap", "line; along 1 0.1",
        max_on_a_line},
       {"line_swap", "on a line, along it by half of their gap", "line; along 1 0.5",
        max_on_a_line},
       {"line_leave", "from a line, off by a tenth of their gap", "line; brownian 1 0.1"},
       {"line_hop", "on a line, 3 per mille go next to others, eight spacings away",
        "line; hop 0.003 8 fixed", max_on_a_line},
       {"two_lines", "on two lines, along them by a tenth of their gap", "two_lines; along 1 0.1"},
       {"two_lines_swap", "on two lines, along them by up to their gap", "two_lines; along 1 1"},
       {"spiral_turn", "a spiral that turns by 0.001 radians", "spiral; turn 1 0.001"},
       {"spiral_swirl", "a spiral that turns by up to 0.01 radians", "spiral; swirl 1 0.01"}});
  add("uneven", all,
      {{"clusters_brownian", "small clusters in Brownian motion of 0.03 spacings",
        "clusters; brownian 1 0.03"},
       {"clusters_jump", "the same, and 1 percent go to other clusters",
        "clusters; brownian 1 0.03; fresh 0.01"},
       {"crowd_jump", "most of them in a corner, 1 percent go in and out", "crowd; fresh 0.01"},
       {"ball_jump", "normally distributed, 1 percent go anywhere", "ball; fresh 0.01"},
       {"needles_jump", "x is a millionth of what it was, 1 percent go anywhere",
        "square 1e-6 1; fresh 0.01"},
       {"needles_brownian", "the same in Brownian motion of 0.01 spacings",
        "square 1e-6 1; brownian 1 0.01"},
       {"scales_jump", "coordinates of all scales, 1 percent go anywhere", "scales; fresh 0.01"}});
  add("units", all,
      {{"huge_jump", "coordinates of 1e150, 1 percent go anywhere",
        "square 1e150 1e150; fresh 0.01"},
       {"tiny_jump", "coordinates of 1e-150, 1 percent go anywhere",
        "square 1e-150 1e-150; fresh 0.01"}});
  add("lattices", all,
      {{"lattice_jump", "1 percent of a square lattice go near to other places",
        "lattice; fresh 0.01"},
       {"hexagons_jump", "1 percent of a hexagonal lattice go near to other places",
        "hexagons; fresh 0.01"},
       {"lattice_brownian", "a square lattice in Brownian motion of 0.01 spacings",
        "lattice; brownian 1 0.01"},
       {"lattice_turn", "a square lattice that turns by 0.01 radians", "lattice; turn 1 0.01"}});
}

inline void add_populations(std::vector<Kind>& all)
{
  for (const double percent : {0.1, 1.0, 5.0, 39.0}) {
    const std::string step = "; replace " + text_of_share(percent);
    const std::string who = text(percent) + " percent are replaced";
    const std::string name = "replace_" + text(percent) + "_percent";
    add("populations", all,
        {{name, who + ", the others rest", "square" + step, any_number, min_for(percent)}});
    add("populations", all,
        {{name + "_in_motion", who + ", all are in Brownian motion of 0.01 spacings",
          "square; brownian 1 0.01" + step, any_number, min_for(percent)}});
  }
  add("populations", all,
      {{"stream", "all drift by 0.02 spacings, out and in", "square; stream 1 0.02"},
       {"fast_stream", "all drift by a spacing, out and in", "square; stream 1 1"},
       {"double_and_halve", "as many others come, and half of them go", "square; come_and_leave 1"},
       {"replace_all", "all are replaced", "square; replace 1"},
       {"replace_and_jump", "1 percent are replaced, and 1 percent jump",
        "square; replace 0.01; fresh 0.01"},
       {"leave_2_percent", "2 percent go", "square; leave 0.02"},
       {"come_2_percent", "2 percent come", "square; come 0.02"}});
}

} // namespace kinds

inline std::vector<Kind> all_kinds()
{
  std::vector<Kind> all;
  for (const auto add : {kinds::add_calm, kinds::add_jumps, kinds::add_exchanges,
                         kinds::add_changes_of_all, kinds::add_uneven, kinds::add_populations}) {
    add(all);
  }
  return all;
}

} // namespace any_motion

#endif // ANY_MOTION_KINDS_H
