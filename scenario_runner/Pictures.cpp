// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Pictures.h"

#include "scenario_runner/Number_text.h"
#include "scenario_runner/Picture_geometry.h"

#include <cmath>

namespace run {

namespace {

// Omits the last digits, in which a product like 154 * 0.3 differs from 46.2.
std::string readable_time(double time)
{
  return number_text(time, 12);
}

// The controls stand above the pictures, whose heights may differ, so that they stay where they
// are.
constexpr const char* const picture_page_style = R"(
body { margin: 0 auto; padding: 8px; max-width: 1000px; font: 16px sans-serif; }
h1 { margin: 4px 0; font-size: 20px; overflow-wrap: anywhere; }
#controls { display: flex; gap: 8px; align-items: center; }
#controls[hidden] { display: none; }
#controls button { min-width: 44px; height: 44px; font-size: 18px; }
#slider { flex: 1; min-width: 0; height: 44px; }
#picture { display: block; width: 100%; max-height: calc(100vh - 130px); min-height: 200px; }
i { display: inline-block; width: 12px; height: 12px; border-radius: 6px; }
)";

constexpr const char* const picture_page_script = R"(
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

// Writes the legend of the colors.
void write_picture_legend(std::ostream& out)
{
  for (auto entry = set_legends.rbegin(); entry != set_legends.rend(); ++entry) {
    out << "<li><i style=\"background:" << entry->color << "\"></i> " << entry->name << ": "
        << entry->meaning << "</li>\n";
  }
}

// A frame, with its number and time above and a legend below. It has no size of its own, and fills
// what it is shown in.
class Svg_picture
{
public:
  Svg_picture(std::ostream& out, const Run_view& run, const Picture_geometry& geometry,
              const Picture_view& view)
    : m_out(out)
    , m_run(run)
    , m_geometry(geometry)
    , m_view(view)
  {
  }

  void write() const
  {
    m_out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << number(width()) << ' '
          << number(height()) << "\" font-family=\"sans-serif\" font-size=\"" << number(font_size)
          << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    write_caption();
    m_out << "<g transform=\"translate(" << number(0.5 * (width() - m_view.width())) << ' '
          << number(line_height) << ")\">\n";
    write_outline();
    write_edges();
    write_points();
    m_out << "</g>\n";
    write_legend();
    m_out << "</svg>\n";
  }

private:
  // Letters that can still be read on a phone, where the picture is 390 wide.
  static constexpr double font_size = 28.0;
  static constexpr double line_height = 44.0;
  static constexpr double least_width = 1000.0; // that of the legend

  static std::string number(double value) { return fixed_text(value, 2); }
  double width() const { return (std::max)(m_view.width(), least_width); }
  double height() const { return m_view.height() + 2.0 * line_height; }

  void write_caption() const
  {
    const Frame_record& record = m_run.record();
    m_out << "<text x=\"20\" y=\"" << number(font_size + 4.0) << "\">frame " << record.number
          << ", time " << readable_time(record.time)
          << (record.update.rebuilt() ? ", triangulated anew" : "") << "</text>\n";
  }

  // The sets, from left to right, and edges.
  void write_legend() const
  {
    const double y = height() - 0.5 * line_height;
    double x = 30.0;
    for (auto entry = set_legends.rbegin(); entry != set_legends.rend(); ++entry) {
      m_out << "<g><title>" << entry->meaning << "</title>";
      write_circle({x, y}, 8.0, " fill=\"" + std::string(entry->color) + '"');
      write_label(x + 18.0, y, entry->name);
      x += 210.0;
    }
    m_out << "<g><title>edges of the triangulation</title><path d=\"M" << number(x - 10.0) << ' '
          << number(y) << "h30\" stroke=\"" << edge_color << "\" stroke-width=\"3\"/>";
    write_label(x + 30.0, y, "edge");
  }

  void write_label(double x, double y, const char* text) const
  {
    m_out << "<text x=\"" << number(x) << "\" y=\"" << number(y + 0.35 * font_size) << "\">" << text
          << "</text></g>\n";
  }

  void write_circle(const scenario::Point& center, double radius, const std::string& fill) const
  {
    m_out << "<circle cx=\"" << number(center.x) << "\" cy=\"" << number(center.y) << "\" r=\""
          << number(radius) << '"' << fill << "/>";
  }

  void write_outline() const
  {
    if (m_geometry.outline.empty()) {
      return;
    }
    m_out << "<polygon stroke=\"black\" stroke-width=\"2\" fill=\"none\" points=\"";
    for (const scenario::Point& corner : m_geometry.outline) {
      const scenario::Point at = seen(corner);
      m_out << number(at.x) << ',' << number(at.y) << '\n';
    }
    m_out << "\"/>\n";
  }

  void write_edges() const
  {
    m_out << "<path stroke=\"" << edge_color << "\" stroke-width=\""
          << number((std::min)(0.8, 0.5 * radius())) << "\" fill=\"none\" d=\"";
    for (const Segment& edge : m_geometry.edges) {
      const scenario::Point from = seen(edge.from), to = seen(edge.to);
      m_out << 'M' << number(from.x) << ' ' << number(from.y) << "\nL" << number(to.x) << ' '
            << number(to.y) << '\n';
    }
    m_out << "\"/>\n";
  }

  void write_points() const
  {
    const std::vector<Vertex_set> sets = m_run.sets();
    for (const Set_legend& legend : set_legends) {
      m_out << "<g fill=\"" << legend.color << "\">\n";
      for (std::size_t i = 0; i != sets.size(); ++i) {
        if (sets[i] == legend.set) {
          write_circle(seen(m_geometry.points[i]), radius(), "");
          m_out << '\n';
        }
      }
      m_out << "</g>\n";
    }
  }

  scenario::Point seen(const scenario::Point& point) const
  {
    return {m_view.x(point), m_view.y(point)};
  }

  // A radius as large as the room between points allows.
  double radius() const
  {
    const double room = std::sqrt(m_view.width() * m_view.height() /
                                  static_cast<double>(m_run.motion().points().size() + 1));
    return std::clamp(0.1 * room, 0.5, 4.0);
  }

  std::ostream& m_out;
  const Run_view& m_run;
  const Picture_geometry& m_geometry;
  const Picture_view& m_view;
};

// The bounds of all that is drawn in periodic space; elsewhere those that files have.
Bounds picture_bounds(const Picture_geometry& geometry, const std::optional<scenario::Box>& box)
{
  if (geometry.outline.empty()) {
    return frame_bounds(box, geometry.points);
  }
  std::vector<scenario::Point> all = geometry.outline;
  all.insert(all.end(), geometry.points.begin(), geometry.points.end());
  for (const Segment& edge : geometry.edges) {
    all.push_back(edge.to);
  }
  return bounds_of(all);
}

} // namespace

std::string html_text(const std::string& text)
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

Bounds bounds_of(const std::vector<scenario::Point>& points)
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

Bounds frame_bounds(const std::optional<scenario::Box>& box,
                    const std::vector<scenario::Point>& points)
{
  return box ? Bounds{{0.0, 0.0}, {box->width, box->height}} : bounds_of(points);
}

void write_picture_page(std::ostream& out, const std::string& name,
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
    out << "<li><a href=\"" << picture.file << "\">frame " << picture.number << ", time "
        << readable_time(picture.time) << "</a></li>\n";
  }
  out << "</ol>\n</details>\n<script>" << picture_page_script << "</script>\n</body>\n</html>\n";
}

Picture_series::Picture_series(const std::string& directory, const std::string& name,
                               const Frame_choice& choice, const std::optional<scenario::Box>& box)
  : Frame_output(choice)
  , m_directory(directory)
  , m_name(name)
  , m_box(box)
  , m_page(m_directory.path_of("index.html"))
{
}

void Picture_series::write(const Run_view& run)
{
  const Frame_record& record = run.record();
  const Picture_geometry geometry = picture_geometry(run);
  const Picture_view view(picture_bounds(geometry, m_box));
  const std::string file_name = frame_file_name(record.number, ".svg");
  Output_file file(m_directory.path_of(file_name));
  Svg_picture(file.stream(), run, geometry, view).write();
  file.finish();
  m_pictures.push_back({file_name, record.number, record.time});
}

void Picture_series::finish()
{
  write_picture_page(m_page.stream(), m_name, m_pictures);
  m_page.finish();
}

} // namespace run
