// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_PICTURE_PAGE_H
#define RUN_PICTURE_PAGE_H

#include "Picture_legend.h"
#include "Rounded_number.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace run {

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

} // namespace run

#endif // RUN_PICTURE_PAGE_H
