// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_PICTURES_H
#define SCENARIO_RUNNER_PICTURES_H

#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Output_file.h"
#include "scenario_runner/Scenario_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
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

// Of all points; the origin if there are none.
inline Bounds bounds_of(const std::vector<scenario::Point>& points)
{
  if (points.empty()) {
    return {{0.0, 0.0}, {0.0, 0.0}};
  }
  Bounds bounds{points.front(), points.front()};
  for (const scenario::Point& point : points) {
    bounds.low = {(std::min)(bounds.low.x, point.x), (std::min)(bounds.low.y, point.y)};
    bounds.high = {(std::max)(bounds.high.x, point.x), (std::max)(bounds.high.y, point.y)};
  }
  return bounds;
}

// The box of the scenario, if it has one, or else of all points of the frame.
inline Bounds frame_bounds(const std::optional<scenario::Box>& box,
                           const std::vector<scenario::Point>& points)
{
  return box ? Bounds{{0.0, 0.0}, {box->width, box->height}} : bounds_of(points);
}

// Programs that look at a cell divide by its sides. One without a length reaches from the origin
// then, and at the origin it is 1.
inline void widen(double& low, double& high)
{
  if (low == high) {
    low = (std::min)(low, 0.0);
    high = low == 0.0 && high == 0.0 ? 1.0 : (std::max)(high, 0.0);
  }
}

inline Bounds cell_bounds(const std::optional<scenario::Box>& box,
                          const std::vector<scenario::Point>& points)
{
  Bounds bounds = frame_bounds(box, points);
  widen(bounds.low.x, bounds.high.x);
  widen(bounds.low.y, bounds.high.y);
  return bounds;
}

// The sets of thesis 4.1.3, by the numbers that files have for them.
enum class Vertex_set : std::uint8_t { none, border, padded, classified };

// Of each vertex of a run's frame. A rebuild gives vertices other numbers than those under which
// they were classified; then all are in none.
template <class Run>
std::vector<Vertex_set> sets_of_vertices(const Run& run)
{
  const auto& triangulation = run.triangulation();
  std::vector<Vertex_set> sets(triangulation.number_of_vertices() + 1, Vertex_set::none);
  if (run.record().update.rebuilt()) {
    return sets;
  }
  for (const auto v : triangulation.border_vertices()) {
    sets[v] = Vertex_set::border;
  }
  for (const auto v : triangulation.padded_vertices()) {
    sets[v] = Vertex_set::padded;
  }
  for (const auto v : triangulation.classified_vertices()) {
    sets[v] = Vertex_set::classified;
  }
  return sets;
}

// Of each point, in the order of the motion, as numbers.
template <class Run>
std::vector<unsigned> sets_of_points(const Run& run)
{
  const std::vector<Vertex_set> sets_of_its_vertices = sets_of_vertices(run);
  std::vector<unsigned> sets;
  for (std::size_t place = 0; place != run.motion().points().size(); ++place) {
    sets.push_back(static_cast<unsigned>(sets_of_its_vertices[run.vertex(place)]));
  }
  return sets;
}

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

// As many as a person looks at.
inline Frame_choice about_thirty(std::size_t frames)
{
  return {frames, frames / 30 + 1};
}

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

// A picture in the directory of the page.
struct Listed_picture
{
  std::string file;
  std::size_t frame;
  double time;
};

inline std::string html_text(const std::string& text)
{
  std::string html;
  for (const char c : text) {
    if (c == '<') {
      html += "&lt;";
    } else if (c == '&') {
      html += "&amp;";
    } else {
      html += c;
    }
  }
  return html;
}

// The controls stand above the pictures, whose heights may differ, so that they stay where they
// are.
constexpr const char* picture_page_style = R"(
body { margin: 0 auto; padding: 8px; max-width: 1000px; font: 16px sans-serif; }
h1 { margin: 4px 0; font-size: 20px; overflow-wrap: anywhere; }
#controls { display: flex; gap: 8px; align-items: center; }
#controls[hidden] { display: none; }
#controls button { min-width: 44px; height: 44px; font-size: 18px; }
#slider { flex: 1; min-width: 0; height: 44px; }
#picture { display: block; width: 100%; max-height: calc(100vh - 130px); min-height: 200px; }
i { display: inline-block; width: 12px; height: 12px; border-radius: 6px; }
)";

constexpr const char* picture_page_script = R"(
const element = id => document.getElementById(id);
const links = [...document.querySelectorAll("#list a")];
let shown = 0, timer = null;
function show(number) {
  shown = number < 0 ? 0 : number < links.length ? number : links.length - 1;
  element("slider").value = shown;
  element("slider").setAttribute("aria-valuetext", links[shown].textContent);
  element("picture").src = links[shown].getAttribute("href");
  element("picture").alt = element("shown").textContent = links[shown].textContent;
  new Image().src = links[(shown + 1) % links.length].getAttribute("href");
}
function play(on) {
  clearInterval(timer);
  timer = on ? setInterval(() => show((shown + 1) % links.length), 400) : null;
  element("play").textContent = on ? "Stop" : "Play";
}
function go(number) {
  play(false);
  show(number);
}
element("slider").max = links.length - 1;
element("slider").oninput = () => go(Number(element("slider").value));
element("back").onclick = () => go(shown - 1);
element("next").onclick = () => go(shown + 1);
element("play").onclick = () => play(timer === null);
document.onkeydown = event => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const steps = { ArrowLeft: () => go(shown - 1), ArrowRight: () => go(shown + 1),
                  Home: () => go(0), End: () => go(links.length - 1),
                  " ": () => play(timer === null) };
  if (!(event.key in steps)) return;
  event.preventDefault();
  steps[event.key]();
};
element("controls").hidden = false;
element("frames").open = false;
show(0);
)";

// Of the colors.
inline void write_picture_legend(std::ostream& out)
{
  for (auto entry = set_legends.rbegin(); entry != set_legends.rend(); ++entry) {
    out << "<li><i style=\"background:" << entry->color << "\"></i> " << entry->name << ": "
        << entry->meaning << "</li>\n";
  }
}

// A page that shows pictures one after another, by itself: it needs no network and no server, and
// without scripts it still lists them.
inline void write_picture_page(std::ostream& out, const std::string& name,
                               const std::vector<Listed_picture>& pictures)
{
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
      << html_text(name) << "</title>\n<style>" << picture_page_style
      << "</style>\n</head>\n<body>\n<h1>" << html_text(name) << ": <span id=\"shown\">"
      << pictures.size() << " pictures</span></h1>\n"
      << "<div id=\"controls\" hidden>\n"
         "<button id=\"back\" aria-label=\"previous picture\">&lsaquo;</button>\n"
         "<input id=\"slider\" type=\"range\" min=\"0\" value=\"0\" aria-label=\"picture\">\n"
         "<button id=\"next\" aria-label=\"next picture\">&rsaquo;</button>\n"
         "<button id=\"play\">Play</button>\n</div>\n<img id=\"picture\" src=\""
      << pictures.front().file << "\" alt=\"\">\n<ul>\n";
  write_picture_legend(out);
  out << "<li>Keys: left and right, home and end, space to play</li>\n</ul>\n"
         "<details id=\"frames\" open><summary>All pictures</summary>\n<ol id=\"list\">\n";
  for (const Listed_picture& picture : pictures) {
    out << "<li><a href=\"" << picture.file << "\">frame " << picture.frame << ", time "
        << Rounded_number{picture.time} << "</a></li>\n";
  }
  out << "</ol>\n</details>\n<script>" << picture_page_script << "</script>\n</body>\n</html>\n";
}

// A frame, with its number and time above and a legend below. It has no size of its own, and fills
// what it is shown in.
template <class Dynamic>
class Svg_picture
{
public:
  Svg_picture(const Dynamic& triangulation, const Picture_view& view)
    : m_triangulation(triangulation)
    , m_view(view)
  {
  }

  // `sets`: of each vertex.
  void write(std::ostream& out, const Frame_record& record,
             const std::vector<Vertex_set>& sets) const
  {
    out << std::fixed << std::setprecision(2);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width() << ' ' << height()
        << "\" font-family=\"sans-serif\" font-size=\"" << font_size << "\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    write_caption(out, record);
    out << "<g transform=\"translate(" << 0.5 * (width() - m_view.width()) << ' ' << line_height
        << ")\">\n";
    write_edges(out);
    write_points(out, sets);
    out << "</g>\n";
    write_legend(out);
    out << "</svg>\n";
  }

private:
  // Letters that can still be read on a phone, where the picture is 390 wide.
  static constexpr double font_size = 28.0;
  static constexpr double line_height = 44.0;
  static constexpr double least_width = 1000.0; // that of the legend

  double width() const { return (std::max)(m_view.width(), least_width); }
  double height() const { return m_view.height() + 2.0 * line_height; }

  void write_caption(std::ostream& out, const Frame_record& record) const
  {
    out << "<text x=\"20\" y=\"" << font_size + 4.0 << "\">frame " << record.frame << ", time "
        << Rounded_number{record.time} << (record.update.rebuilt() ? ", triangulated anew" : "")
        << "</text>\n";
  }

  // The sets, from left to right, and edges.
  void write_legend(std::ostream& out) const
  {
    const double y = height() - 0.5 * line_height;
    double x = 30.0;
    for (auto entry = set_legends.rbegin(); entry != set_legends.rend(); ++entry) {
      out << "<g><title>" << entry->meaning << "</title><circle cx=\"" << x << "\" cy=\"" << y
          << "\" r=\"8\" fill=\"" << entry->color << "\"/>";
      write_label(out, x + 18.0, y, entry->name);
      x += 210.0;
    }
    out << "<g><title>edges of the triangulation</title><path d=\"M" << x - 10.0 << ' ' << y
        << "h30"
        << "\" stroke=\"" << edge_color << "\" stroke-width=\"3\"/>";
    write_label(out, x + 30.0, y, "edge");
  }

  static void write_label(std::ostream& out, double x, double y, const char* text)
  {
    out << "<text x=\"" << x << "\" y=\"" << y + 0.35 * font_size << "\">" << text
        << "</text></g>\n";
  }

  void write_edges(std::ostream& out) const
  {
    out << "<path stroke=\"" << edge_color << "\" stroke-width=\""
        << (std::min)(0.8, 0.5 * radius()) << "\" fill=\"none\" d=\"";
    m_triangulation.for_each_edge([&](std::size_t i, std::size_t j) {
      write_place(out << 'M', place(i));
      write_place(out << 'L', place(j));
    });
    out << "\"/>\n";
  }

  void write_place(std::ostream& out, const scenario::Point& point) const
  {
    out << m_view.x(point) << ' ' << m_view.y(point) << '\n';
  }

  scenario::Point place(std::size_t id) const
  {
    const auto& point = m_triangulation.point(id);
    return {point.x(), point.y()};
  }

  void write_points(std::ostream& out, const std::vector<Vertex_set>& sets) const
  {
    const auto frame = m_triangulation.frame();
    using Index = typename Dynamic::Frame::Index;
    for (const Set_legend& legend : set_legends) {
      out << "<g fill=\"" << legend.color << "\">\n";
      for (Index id = 0; id != frame.number_of_ids(); ++id) {
        if (frame.has_id(id) && sets[frame.vertex(id)] == legend.set) {
          out << "<circle cx=\"" << m_view.x(place(id)) << "\" cy=\"" << m_view.y(place(id))
              << "\" r=\"" << radius() << "\"/>\n";
        }
      }
      out << "</g>\n";
    }
  }

  // As large as room between the points allows.
  double radius() const
  {
    const double room = std::sqrt(m_view.width() * m_view.height() /
                                  static_cast<double>(m_triangulation.number_of_points() + 1));
    return std::clamp(0.1 * room, 0.5, 4.0);
  }

  const Dynamic& m_triangulation;
  const Picture_view& m_view;
};

// Pictures of some frames of a run, in a directory, and a page that shows them.
class Picture_series
{
public:
  // `name`: of what runs.
  Picture_series(const std::string& directory, const std::string& name, const Frame_choice& choice,
                 const std::optional<scenario::Box>& box)
    : m_directory(directory)
    , m_name(name)
    , m_choice(choice)
    , m_box(box)
    , m_page(m_directory.path_of("index.html"))
  {
  }

  template <class Run>
  void write(const Run& run)
  {
    const Frame_record& record = run.record();
    if (!m_choice.has(record.frame)) {
      return;
    }
    const Picture_view view(frame_bounds(m_box, run.motion().points()));
    const std::string file_name = frame_file_name(record.frame, ".svg");
    Output_file file(m_directory.path_of(file_name));
    const Svg_picture picture(run.triangulation(), view);
    picture.write(file.stream(), record, sets_of_vertices(run));
    file.finish();
    m_pictures.push_back({file_name, record.frame, record.time});
  }

  void finish()
  {
    write_picture_page(m_page.stream(), m_name, m_pictures);
    m_page.finish();
  }

private:
  Output_directory m_directory;
  std::string m_name;
  Frame_choice m_choice;
  std::optional<scenario::Box> m_box;
  Output_file m_page;
  std::vector<Listed_picture> m_pictures;
};

} // namespace run

#endif // SCENARIO_RUNNER_PICTURES_H
