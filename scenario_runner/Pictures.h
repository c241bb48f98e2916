// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_PICTURES_H
#define SCENARIO_RUNNER_PICTURES_H

#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Output_file.h"
#include "scenario_runner/Scenario_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace run {

// A rectangle.
struct Bounds
{
  scenario::Point low;
  scenario::Point high;

  // A finite number, also where the sides are farther apart than any.
  double width() const { return length(low.x, high.x); }
  double height() const { return length(low.y, high.y); }

private:
  static double length(double from, double to)
  {
    return (std::min)(to - from, (std::numeric_limits<double>::max)());
  }
};

// The bounds of all points; the origin if there are none.
Bounds bounds_of(const std::vector<scenario::Point>& points);

// The box of the scenario, if it has one, or else of all points of the frame.
Bounds frame_bounds(const std::optional<scenario::Box>& box,
                    const std::vector<scenario::Point>& points);

// Which part of the plane a picture shows, and where in it a point is: y goes up, as in the plane.
class Picture_view
{
public:
  explicit Picture_view(const Bounds& bounds)
    : m_low(bounds.low)
    , m_high(bounds.high)
  {
    const double side = (std::max)(m_high.x - m_low.x, m_high.y - m_low.y);
    m_scale = side > 0.0 ? longer_side / side : 1.0;
  }

  double x(const scenario::Point& p) const { return margin + m_scale * (p.x - m_low.x); }
  double y(const scenario::Point& p) const { return margin + m_scale * (m_high.y - p.y); }
  double width() const { return 2.0 * margin + m_scale * (m_high.x - m_low.x); }
  double height() const { return 2.0 * margin + m_scale * (m_high.y - m_low.y); }

private:
  static constexpr double longer_side = 960.0;
  static constexpr double margin = 20.0;

  scenario::Point m_low;
  scenario::Point m_high;
  double m_scale;
};

// How a picture shows the points of a set, and what they are.
struct Set_legend
{
  Vertex_set set;
  const char* color;
  const char* name;
  const char* meaning;
};

// In the colors of figure 4.1 of the thesis; a picture draws the later ones over the others.
constexpr std::array<Set_legend, 4> set_legends = {
    {{Vertex_set::none, "#333333", "other", "all other points"},
     {Vertex_set::border, "cyan", "border", "the layer of neighbors beyond the padded points"},
     {Vertex_set::padded, "green", "padded", "layers of neighbors around the classified points"},
     {Vertex_set::classified, "red", "classified",
      "points that the classifier found, whose edges may be broken"}}};

constexpr const char* edge_color = "#888888";

// Every so many frames of a run, from its first one on, and its last one.
class Frame_choice
{
public:
  Frame_choice(std::size_t frames, std::size_t every)
    : m_frames(frames)
    , m_every(every)
  {
  }

  bool has(std::size_t frame) const { return frame % m_every == 0 || frame == m_frames; }

private:
  std::size_t m_frames;
  std::size_t m_every;
};

// Files of some frames of a run.
class Frame_output
{
public:
  explicit Frame_output(const Frame_choice& choice)
    : m_choice(choice)
  {
  }
  Frame_output(const Frame_output&) = delete;
  Frame_output& operator=(const Frame_output&) = delete;
  virtual ~Frame_output() = default;

  // To be called with every frame, from the first one on.
  void take(const Run_view& run)
  {
    if (m_choice.has(run.record().frame)) {
      write(run);
    }
  }

  // To be called after the last frame: only then single files, and lists of files, have their
  // names.
  virtual void finish() = 0;

private:
  virtual void write(const Run_view& run) = 0;

  Frame_choice m_choice;
};

// A choice of about as many frames as a person looks at.
inline Frame_choice about_thirty(std::size_t frames)
{
  return {frames, frames / 30 + 1};
}

// A picture in the directory of the page.
struct Listed_picture
{
  std::string file;
  std::int64_t number; // of the frame
  double time;
};

// The text with the characters escaped that mean something in HTML.
std::string html_text(const std::string& text);

// A page that shows pictures one after another, by itself: it needs no network and no server, and
// without scripts it still lists them.
void write_picture_page(std::ostream& out, const std::string& name,
                        const std::vector<Listed_picture>& pictures);

// Pictures of some frames of a run, in a directory, and a page that shows them.
class Picture_series : public Frame_output
{
public:
  // `name`: of what runs.
  Picture_series(const std::string& directory, const std::string& name, const Frame_choice& choice,
                 const std::optional<scenario::Box>& box);

  void finish() override;

private:
  void write(const Run_view& run) override;

  Output_directory m_directory;
  std::string m_name;
  std::optional<scenario::Box> m_box;
  Output_file m_page;
  std::vector<Listed_picture> m_pictures;
};

} // namespace run

#endif // SCENARIO_RUNNER_PICTURES_H
