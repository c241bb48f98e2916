// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_RECORDED_MOTION_H
#define SCENARIO_RUNNER_RECORDED_MOTION_H

#include "scenario_runner/Motion.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <initializer_list>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace scenario {

// Ids ascending, each once; points in the same order.
struct Recorded_frame
{
  double time = 0.0;
  std::vector<std::int64_t> ids;
  std::vector<Point> points;
  bool is_periodic = false; // its box is, in x or y
};

using Recording = std::vector<Recorded_frame>;

class Recorded_motion : public Motion
{
public:
  Recorded_motion(std::string name, Recording recording)
    : Motion(std::move(name))
    , m_recording(std::move(recording))
  {
    if (m_recording.empty()) {
      throw std::invalid_argument("a recorded motion needs at least one frame");
    }
  }

  const std::vector<std::int64_t>& ids() const override { return frame().ids; }
  const std::vector<Point>& points() const override { return frame().points; }
  double time() const override { return frame().time; }
  bool has_fixed_population() const override
  {
    return std::all_of(m_recording.begin(), m_recording.end(), [this](const Recorded_frame& frame) {
      return frame.ids == m_recording.front().ids;
    });
  }
  bool population_changed() const override { return m_population_changed; }
  std::size_t frames() const override { return m_recording.size() - 1; }

  std::string remark() const override
  {
    const bool is_periodic =
        std::any_of(m_recording.begin(), m_recording.end(),
                    [](const Recorded_frame& frame) { return frame.is_periodic; });
    return is_periodic ? "the box is periodic, and is taken for an open one: points that leave it "
                         "on one side jump to the other, and nobody has neighbors across its sides"
                       : "";
  }

  bool advance(const Neighbor_edges&) override
  {
    if (m_current + 1 == m_recording.size()) {
      return false;
    }
    m_population_changed = m_recording[m_current].ids != m_recording[m_current + 1].ids;
    ++m_current;
    return true;
  }

private:
  const Recorded_frame& frame() const { return m_recording[m_current]; }

  Recording m_recording;
  std::size_t m_current = 0;
  bool m_population_changed = false;
};

enum class Motion_format { scenario, csv, lammps_dump };

inline const std::string motion_extensions = ".json, .csv, .tsv, .txt, .lammpstrj or .dump";

// The path that stands for standard input, which is CSV.
inline bool is_standard_input(const std::string& path)
{
  return path == "-";
}

inline std::filesystem::path without_gz(const std::filesystem::path& file)
{
  return lower_case(file.extension().string()) == ".gz" ? file.parent_path() / file.stem() : file;
}

// What a file has to hold, by its name alone; nothing if the name does not say it.
inline std::optional<Motion_format> motion_format(const std::filesystem::path& file)
{
  const std::string extension = lower_case(without_gz(file).extension().string());
  if (extension == ".json") {
    return Motion_format::scenario;
  }
  if (extension == ".csv" || extension == ".tsv" || extension == ".txt") {
    return Motion_format::csv;
  }
  if (extension == ".lammpstrj" || extension == ".dump") {
    return Motion_format::lammps_dump;
  }
  return std::nullopt;
}

// What a recording is called after its file.
inline std::string recording_name(const std::string& path)
{
  return is_standard_input(path) ? "standard_input" : without_gz(path).stem().string();
}

// Ids for points that have names: 0, 1, 2 and so on, in the order in which the names first appear.
class Point_names
{
public:
  std::int64_t id(std::string_view name)
  {
    const auto [place, is_new] = m_ids.emplace(name, static_cast<std::int64_t>(m_names.size()));
    if (is_new) {
      m_names.push_back(&place->first);
    }
    return place->second;
  }

  const std::string& name(std::int64_t id) const { return *m_names[static_cast<std::size_t>(id)]; }

private:
  std::unordered_map<std::string, std::int64_t> m_ids;
  std::vector<const std::string*> m_names;
};

// Of the fields of a line. Blanks are spaces and tabs, any number of them.
enum class Separator : char { comma = ',', semicolon = ';', tab = '\t', blanks = ' ' };

// As a message says where a line is split.
inline std::string place_of(Separator separator)
{
  switch (separator) {
  case Separator::comma:
    return "commas";
  case Separator::semicolon:
    return "semicolons";
  case Separator::tab:
    return "tabs";
  default:
    return "blanks";
  }
}

// Splits a line into fields. One that begins with a double quote ends with the next single one, and
// may hold separators; two of them stand for one. Blanks around the content of fields are no part
// of it, quoted or not.
class Field_splitter
{
public:
  explicit Field_splitter(Separator separator)
    : m_separator(separator)
  {
  }

  Separator separator() const { return m_separator; }

  // Says what is wrong with the field that follows those in `fields`, or nothing if all is well.
  // The fields live as long as the line, those with two quotes in them until the next call.
  std::string_view split(std::string_view line, std::vector<std::string_view>& fields)
  {
    fields.clear();
    m_unescaped.clear();
    if (line.find('"') == std::string_view::npos) {
      split_unquoted(line, fields);
      return {};
    }
    return split_quoted(line, fields);
  }

private:
  void split_unquoted(std::string_view line, std::vector<std::string_view>& fields) const
  {
    if (m_separator == Separator::blanks) {
      split_at_blanks(line, fields);
      return;
    }
    std::size_t end = 0;
    while ((end = line.find(static_cast<char>(m_separator))) != std::string_view::npos) {
      fields.push_back(trimmed(line.substr(0, end)));
      line.remove_prefix(end + 1);
    }
    fields.push_back(trimmed(line));
  }

  std::string_view split_quoted(std::string_view line, std::vector<std::string_view>& fields)
  {
    skip_blanks(line);
    do {
      if (line.empty() || line.front() != '"') {
        take_unquoted(line, fields);
      } else if (const auto problem = take_quoted(line, fields); !problem.empty()) {
        return problem;
      }
    } while (take_separator(line));
    return {};
  }

  // Both leave the line from the next separator on.
  void take_unquoted(std::string_view& line, std::vector<std::string_view>& fields) const
  {
    const std::size_t end = separator_in(line);
    fields.push_back(trimmed(line.substr(0, end)));
    line.remove_prefix(end);
  }

  std::string_view take_quoted(std::string_view& line, std::vector<std::string_view>& fields)
  {
    line.remove_prefix(1);
    bool is_escaped = false;
    std::size_t length = line.find('"');
    while (length != std::string_view::npos && line.substr(length, 2) == "\"\"") {
      is_escaped = true;
      length = line.find('"', length + 2);
    }
    if (length == std::string_view::npos) {
      return "begins with a quote that does not end in its line";
    }
    const std::string_view content = line.substr(0, length);
    line.remove_prefix(length + 1);
    const std::size_t end = separator_in(line);
    if (!trimmed(line.substr(0, end)).empty()) {
      return "goes on after its closing quote";
    }
    line.remove_prefix(end);
    fields.push_back(trimmed(is_escaped ? unescaped(content) : content));
    return {};
  }

  std::string_view unescaped(std::string_view content)
  {
    std::string& text = m_unescaped.emplace_back();
    for (std::size_t i = 0; i != content.size(); ++i) {
      text += content[i];
      i += content[i] == '"' ? 1 : 0;
    }
    return text;
  }

  // The end of the line stands for one, too.
  std::size_t separator_in(std::string_view line) const
  {
    const std::size_t place = m_separator == Separator::blanks
                                  ? line.find_first_of(" \t")
                                  : line.find(static_cast<char>(m_separator));
    return (std::min)(place, line.size());
  }

  // Whether there is one, and a field behind it.
  bool take_separator(std::string_view& line) const
  {
    if (line.empty()) {
      return false;
    }
    if (m_separator != Separator::blanks) {
      line.remove_prefix(1);
    }
    skip_blanks(line);
    return m_separator != Separator::blanks || !line.empty();
  }

  // A tab that separates is none.
  void skip_blanks(std::string_view& line) const
  {
    while (!line.empty() && is_blank(line.front()) &&
           (m_separator != Separator::tab || line.front() != '\t')) {
      line.remove_prefix(1);
    }
  }

  Separator m_separator;
  std::deque<std::string> m_unescaped;
};

enum Csv_column : std::size_t { frame, time, id, x, y };
constexpr std::array<std::string_view, 5> csv_column_names = {"frame", "time", "id", "x", "y"};

// What a column is called: `x`, or `X/m`, `x [m]`, `x (m)`. A name with something else behind it,
// as in the quotient `x/y`, is the name of something else.
class Csv_title
{
public:
  explicit Csv_title(std::string_view title)
    : m_name(lower_case(std::string(trimmed(title.substr(0, title.find_first_of("/[("))))))
    , m_unit(title.substr((std::min)(title.find_first_of("/[("), title.size())))
  {
    m_unit.erase(std::remove_if(m_unit.begin(), m_unit.end(),
                                [](char c) { return is_blank(c) || is_one_of(c, "/[]()"); }),
                 m_unit.end());
    const auto alias = std::find_if(aliases.begin(), aliases.end(),
                                    [this](const auto& names) { return m_name == names.first; });
    m_name = alias == aliases.end() ? m_name : alias->second;
  }

  bool names(std::string_view column) const { return m_name == column && has_known_unit(); }
  const std::string& unit() const { return m_unit; }

private:
  // Those of PeTrack and JuPedSim.
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 2> aliases = {
      {{"persid", "id"}, {"fr", "frame"}}};
  static constexpr std::array<std::string_view, 24> units = {
      "",   "m",  "dm",    "cm",     "mm",  "um", "\xC2\xB5m", "\xCE\xBCm", "nm", "km", "ft",  "in",
      "px", "au", "pixel", "pixels", "deg", "s",  "sec",       "ms",        "us", "ns", "min", "h"};

  static bool is_one_of(char c, std::string_view characters)
  {
    return characters.find(c) != std::string_view::npos;
  }

  bool has_known_unit() const
  {
    return std::find(units.begin(), units.end(), lower_case(m_unit)) != units.end();
  }

  std::string m_name;
  std::string m_unit;
};

// The line that names the columns, and the separator at which it and all rows are split.
class Csv_header
{
public:
  // `separators`: those that may be, the preferred ones first. Blanks, at which anything can be
  // split, are taken where no other one finds two columns.
  Csv_header(const std::string& file, std::string_view line, std::size_t line_number,
             std::initializer_list<Separator> separators)
    : m_file(file)
    , m_line_number(line_number)
  {
    for (const Separator separator : separators) {
      const Split split = split_at(separator, line);
      if (m_split.titles.empty() || is_better(split, m_split)) {
        m_split = split;
      }
    }
  }

  Separator separator() const { return m_split.separator; }
  std::size_t number_of_fields() const { return m_split.titles.size(); }

  // Whether it can be one.
  bool names_any_column() const { return m_split.known != 0; }
  bool has_numbers() const
  {
    return std::any_of(m_split.titles.begin(), m_split.titles.end(), is_number);
  }

  // Where the fields of the columns are; that of `time` is none if it is not there.
  static constexpr std::size_t none = std::string::npos;
  std::array<std::size_t, csv_column_names.size()> positions() const
  {
    if (!m_split.problem.empty()) {
      fail("field " + std::to_string(m_split.titles.size() + 1) + " " + m_split.problem);
    }
    std::array<std::size_t, csv_column_names.size()> positions{};
    std::vector<std::string> missing;
    for (std::size_t column = 0; column != csv_column_names.size(); ++column) {
      positions[column] = position_of(csv_column_names[column]);
      if (positions[column] == none && column != Csv_column::time) {
        missing.push_back(in_quotes(csv_column_names[column]));
      }
    }
    if (!missing.empty()) {
      fail_missing(missing);
    }
    check_units(m_split.titles[positions[Csv_column::x]], m_split.titles[positions[Csv_column::y]]);
    return positions;
  }

private:
  struct Split
  {
    Separator separator = Separator::comma;
    std::vector<std::string> titles{};
    std::size_t known = 0; // how many titles name a column
    std::string problem{};
  };

  static Split split_at(Separator separator, std::string_view line)
  {
    Split split{separator};
    std::vector<std::string_view> fields;
    Field_splitter splitter(separator);
    split.problem = splitter.split(line, fields);
    split.titles.assign(fields.begin(), fields.end());
    for (const std::string_view name : csv_column_names) {
      split.known += std::any_of(fields.begin(), fields.end(), [&](std::string_view title) {
        return Csv_title(title).names(name);
      });
    }
    return split;
  }

  static bool is_better(const Split& split, const Split& than)
  {
    if (split.separator == Separator::blanks && than.known >= 2) {
      return false;
    }
    return std::pair(split.known, split.titles.size()) > std::pair(than.known, than.titles.size());
  }

  static bool is_number(std::string_view text)
  {
    double value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
  }

  std::size_t position_of(std::string_view name) const
  {
    const auto is_it = [name](const std::string& title) { return Csv_title(title).names(name); };
    const auto& titles = m_split.titles;
    const auto found = std::find_if(titles.begin(), titles.end(), is_it);
    if (found == titles.end()) {
      return none;
    }
    const auto again = std::find_if(found + 1, titles.end(), is_it);
    if (again != titles.end()) {
      fail("column '" + std::string(name) + "' is there twice, as " + in_quotes(*found) + " and " +
           in_quotes(*again));
    }
    return static_cast<std::size_t>(found - titles.begin());
  }

  void check_units(const std::string& x_title, const std::string& y_title) const
  {
    if (Csv_title(x_title).unit() != Csv_title(y_title).unit()) {
      fail("the columns " + in_quotes(x_title) + " and " + in_quotes(y_title) +
           " have different units, allowed are equal ones");
    }
  }

  [[noreturn]] void fail_missing(const std::vector<std::string>& names) const
  {
    std::string text = names.size() == 1 ? "column " : "columns ";
    for (std::size_t i = 0; i != names.size(); ++i) {
      text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    }
    fail(text + (names.size() == 1 ? " is" : " are") +
         " missing, needed are frame, id, x and y; the header has " + what_it_has());
  }

  // As much of it as a message can hold.
  std::string what_it_has() const
  {
    constexpr std::size_t max_characters = 80;
    const auto& titles = m_split.titles;
    if (titles.size() == 1) {
      return "one column, " + in_quotes(titles.front()) +
             ", as separators are commas, semicolons, tabs or blanks";
    }
    std::string list;
    for (const std::string& title : titles) {
      if (list.size() + title.size() > max_characters && !list.empty()) {
        list += ", ...";
        break;
      }
      list += (list.empty() ? "" : ", ") + in_quotes(title);
    }
    return std::to_string(titles.size()) + " columns, split at " + place_of(m_split.separator) +
           ": " + list;
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw Scenario_error(m_file, message, m_line_number);
  }

  std::string m_file;
  std::size_t m_line_number;
  Split m_split;
};

// Reads tables of positions, a row for a point in a frame, in the dialects of R, pandas, PeTrack
// and others. `frame`, `id`, `x`, `y` and, if it is there, `time` are looked up by name in a
// header, further columns are ignored. Rows come in any order; lines that begin with # are
// comments.
class Csv_parser
{
public:
  Csv_parser(const std::string& file, std::string_view text)
    : m_scanner(file, text)
  {
  }

  Recording parse()
  {
    std::string_view line = read_header();
    while (!line.empty()) {
      read_row(line);
      line = next_row();
    }
    if (m_rows.empty()) {
      throw Scenario_error(m_scanner.file(), "has a header but no rows");
    }
    sort_rows();
    return recording();
  }

private:
  struct Row
  {
    std::int64_t frame;
    std::int64_t id;
    double time;
    Point point;
    std::size_t line;
  };

  // Returns the first row of data, or nothing if there is none. The header is the first row, or,
  // where that has numbers, the last comment before it.
  std::string_view read_header()
  {
    const std::string_view first = next_row();
    if (first.empty()) {
      throw Scenario_error(m_scanner.file(),
                           std::string(m_comment.empty() ? "is empty" : "has comments alone") +
                               ", expected the header frame,time,id,x,y");
    }
    const Csv_header header(
        m_scanner.file(), first, m_scanner.line_number(),
        {Separator::comma, Separator::semicolon, Separator::tab, Separator::blanks});
    if (header.names_any_column() || !header.has_numbers()) {
      take(header);
      const std::string_view row = next_row();
      skip_row_names(row);
      return row;
    }
    take(header_in_comment());
    return first;
  }

  // Its words stand at blanks of any kind, however the rows are aligned.
  Csv_header header_in_comment() const
  {
    const Csv_header header(
        m_scanner.file(),
        m_comment.substr((std::min)(m_comment.find_first_not_of("# \t"), m_comment.size())),
        m_comment_line_number, {Separator::comma, Separator::semicolon, Separator::blanks});
    if (!header.names_any_column()) {
      m_scanner.fail("there is no header: this row has numbers, and no comment right before it "
                     "names the columns frame, id, x and y");
    }
    return header;
  }

  void take(const Csv_header& header)
  {
    m_position = header.positions();
    m_has_time = m_position[Csv_column::time] != Csv_header::none;
    m_number_of_fields = header.number_of_fields();
    m_splitter = Field_splitter(header.separator());
  }

  // R writes the names of rows in quotes before them, and nothing above these.
  void skip_row_names(std::string_view row)
  {
    if (row.empty() || row.front() != '"') {
      return;
    }
    split(row);
    if (m_fields.size() == m_number_of_fields + 1) {
      ++m_number_of_fields;
      for (std::size_t& position : m_position) {
        position += position == Csv_header::none ? 0 : 1;
      }
    }
  }

  // The next line that is no comment, nothing at the end.
  std::string_view next_row()
  {
    std::string_view line;
    while (m_scanner.next_whole_line(line)) {
      if (trimmed(line).front() != '#') {
        return line;
      }
      m_comment = trimmed(line);
      m_comment_line_number = m_scanner.line_number();
    }
    return {};
  }

  void split(std::string_view line)
  {
    const std::string_view problem = m_splitter.split(line, m_fields);
    if (!problem.empty()) {
      m_scanner.fail("field " + std::to_string(m_fields.size() + 1) + " " + std::string(problem));
    }
  }

  void read_row(std::string_view line)
  {
    split(line);
    if (m_fields.size() != m_number_of_fields) {
      m_scanner.fail("the row has " + std::to_string(m_fields.size()) + " fields, the header has " +
                     std::to_string(m_number_of_fields) + ", split at " +
                     place_of(m_splitter.separator()));
    }
    const std::int64_t frame = frame_number();
    const std::int64_t id = point_id();
    const double time = m_has_time ? number(Csv_column::time, id) : static_cast<double>(frame);
    m_rows.push_back({frame, id, time, Point{number(Csv_column::x, id), number(Csv_column::y, id)},
                      m_scanner.line_number()});
  }

  std::int64_t frame_number() const
  {
    const std::string_view text = field(Csv_column::frame);
    const auto number = m_scanner.whole_number(text, "frame");
    if (!number) {
      m_scanner.fail("frame " + in_quotes(text) + " is not an integer");
    }
    return *number;
  }

  std::int64_t point_id()
  {
    const std::string_view text = field(Csv_column::id);
    const auto number = m_scanner.whole_number(text, "id");
    if (number && !m_names) {
      return *number;
    }
    if (number) {
      return m_names->id(std::to_string(*number));
    }
    if (text.empty() || text == "NA" || text == "None" || text == "null") {
      m_scanner.fail("id " + in_quotes(text) + " stands for none, and every point needs one");
    }
    if (!m_names) {
      name_all();
    }
    return m_names->id(text);
  }

  // Where one id is text, all of them are names.
  void name_all()
  {
    m_names.emplace();
    for (Row& row : m_rows) {
      row.id = m_names->id(std::to_string(row.id));
    }
  }

  std::string id_text(std::int64_t id) const
  {
    return m_names ? in_quotes(m_names->name(id)) : std::to_string(id);
  }

  double number(Csv_column column, std::int64_t id) const
  {
    const std::string_view text = field(column);
    const std::string_view name = csv_column_names[column];
    if (m_splitter.separator() != Separator::comma && text.find(',') != std::string_view::npos) {
      m_scanner.fail(std::string(name) + " " + in_quotes(text) +
                     " is not a number: decimal commas are not supported, use points");
    }
    const double value = m_scanner.number(text, name);
    if (!std::isfinite(value)) {
      m_scanner.fail(std::string(name) + " of id " + id_text(id) + " is " + in_quotes(text) +
                     ", not a finite number");
    }
    return value;
  }

  std::string_view field(Csv_column column) const { return m_fields[m_position[column]]; }

  void sort_rows()
  {
    const auto before = [](const Row& a, const Row& b) {
      return std::tie(a.frame, a.id, a.line) < std::tie(b.frame, b.id, b.line);
    };
    if (!std::is_sorted(m_rows.begin(), m_rows.end(), before)) {
      std::sort(m_rows.begin(), m_rows.end(), before);
    }
    const auto twice =
        std::adjacent_find(m_rows.begin(), m_rows.end(), [](const Row& a, const Row& b) {
          return a.frame == b.frame && a.id == b.id;
        });
    if (twice != m_rows.end()) {
      throw Scenario_error(m_scanner.file(),
                           "id " + id_text(twice->id) + " is twice in frame " +
                               std::to_string(twice->frame) + ", first in line " +
                               std::to_string(twice->line),
                           (twice + 1)->line);
    }
  }

  Recording recording() const
  {
    Recording frames;
    for (auto row = m_rows.begin(); row != m_rows.end();) {
      const auto end = std::find_if(row, m_rows.end(),
                                    [row](const Row& other) { return other.frame != row->frame; });
      Recorded_frame& frame = frames.emplace_back();
      frame.time = row->time;
      frame.ids.reserve(static_cast<std::size_t>(end - row));
      frame.points.reserve(static_cast<std::size_t>(end - row));
      for (; row != end; ++row) {
        frame.ids.push_back(row->id);
        frame.points.push_back(row->point);
      }
    }
    return frames;
  }

  Text_scanner m_scanner;
  std::string_view m_comment;
  std::size_t m_comment_line_number = 0;
  Field_splitter m_splitter{Separator::comma};
  std::vector<std::string_view> m_fields;
  std::size_t m_number_of_fields = 0;
  std::array<std::size_t, csv_column_names.size()> m_position{};
  bool m_has_time = false;
  std::optional<Point_names> m_names;
  std::vector<Row> m_rows;
};

inline Recording read_csv_motion(const std::string& path)
{
  if (is_standard_input(path)) {
    const std::string name = "standard input";
    return Csv_parser(name, read_standard_input(name)).parse();
  }
  const std::string text = read_text_file(path);
  return Csv_parser(path, text).parse();
}

// Reads the text dumps of the molecular dynamics program LAMMPS. Coordinates are taken from the
// first of the column pairs `x y`, `xu yu`, `xs ys`, `xsu ysu` that is there; the last two are
// fractions of the box. Atoms and columns come in any order, further columns are ignored.
class Lammps_parser
{
public:
  Lammps_parser(const std::string& file, std::string_view text)
    : m_scanner(file, text)
  {
  }

  Recording parse()
  {
    Recording frames;
    std::string_view line;
    while (m_scanner.next_line(line)) {
      read_section(line, frames);
    }
    if (frames.empty() && !m_frame_is_open) {
      throw Scenario_error(m_scanner.file(), "is empty, expected ITEM: TIMESTEP");
    }
    if (m_frame_is_open) {
      fail_truncated("its atoms are missing");
    }
    return frames;
  }

private:
  struct Interval
  {
    double low;
    double high;
  };

  struct Coordinate_pair
  {
    std::string_view x;
    std::string_view y;
    bool scaled;
  };

  static constexpr std::array<Coordinate_pair, 4> coordinate_pairs = {
      {{"x", "y", false}, {"xu", "yu", false}, {"xs", "ys", true}, {"xsu", "ysu", true}}};

  struct Columns
  {
    std::size_t count;
    std::size_t id;
    std::size_t x;
    std::size_t y;
    bool scaled;
  };

  void read_section(std::string_view line, Recording& frames)
  {
    if (line == "ITEM: TIMESTEP") {
      begin_frame();
    } else if (line == "ITEM: UNITS") {
      data_line();
    } else if (line == "ITEM: TIME") {
      m_time = finite(data_line(), "time");
    } else if (!m_frame_is_open) {
      m_scanner.fail("expected ITEM: TIMESTEP, found " + in_quotes(line));
    } else if (line == "ITEM: NUMBER OF ATOMS") {
      read_number_of_atoms();
    } else if (starts_with(line, "ITEM: BOX BOUNDS")) {
      read_box(line);
    } else if (starts_with(line, "ITEM: ATOMS")) {
      read_atoms(line, frames);
    } else {
      m_scanner.fail("expected an ITEM: line, found " + in_quotes(line));
    }
  }

  void begin_frame()
  {
    if (m_frame_is_open) {
      fail_truncated("the next one begins before its atoms");
    }
    m_timestep = m_scanner.integer(data_line(), "timestep");
    m_frame_is_open = true;
    m_number_of_atoms.reset();
    m_box.reset();
  }

  void read_number_of_atoms()
  {
    const std::int64_t number = m_scanner.integer(data_line(), "number of atoms");
    if (number < 0) {
      m_scanner.fail("number of atoms " + std::to_string(number) + " is negative");
    }
    m_number_of_atoms = static_cast<std::size_t>(number);
  }

  void read_box(std::string_view header)
  {
    m_box_is_tilted = header.find(" xy ") != std::string_view::npos ||
                      header.find(" abc ") != std::string_view::npos;
    read_boundaries(header);
    m_box.emplace();
    for (Interval& side : *m_box) {
      split_at_blanks(data_line(), m_fields);
      if (m_fields.size() < 2) {
        m_scanner.fail("expected the lower and the upper bound of the box");
      }
      side = {finite(m_fields[0], "lower bound"), finite(m_fields[1], "upper bound")};
    }
  }

  // Of x, y and z: two letters each, p for periodic.
  void read_boundaries(std::string_view header)
  {
    split_at_blanks(header, m_fields);
    const std::size_t planar = m_fields.size() < 3 ? m_fields.size() : m_fields.size() - 1;
    m_box_is_periodic =
        std::find(m_fields.begin(), m_fields.begin() + static_cast<std::ptrdiff_t>(planar), "pp") !=
        m_fields.begin() + static_cast<std::ptrdiff_t>(planar);
  }

  void read_atoms(std::string_view header, Recording& frames)
  {
    if (!m_number_of_atoms) {
      m_scanner.fail("ITEM: NUMBER OF ATOMS is missing in the frame of timestep " +
                     std::to_string(m_timestep));
    }
    const Columns columns = read_columns(header);
    Recorded_frame frame;
    frame.time = m_time.value_or(static_cast<double>(m_timestep));
    frame.is_periodic = m_box && m_box_is_periodic;
    const std::size_t plausible = (std::min)(*m_number_of_atoms, m_scanner.bytes_left() / 2);
    frame.ids.reserve(plausible);
    frame.points.reserve(plausible);
    m_lines.clear();
    for (std::size_t i = 0; i != *m_number_of_atoms; ++i) {
      read_atom(columns, frame);
    }
    sort_by_id(frame);
    frames.push_back(std::move(frame));
    m_frame_is_open = false;
    m_time.reset();
  }

  Columns read_columns(std::string_view header)
  {
    split_at_blanks(header, m_fields);
    const std::vector<std::string_view> names(m_fields.begin() + 2, m_fields.end());
    const auto position = [&names](std::string_view name) {
      return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const std::size_t missing = names.size();
    if (position("id") == missing) {
      m_scanner.fail("column 'id' is missing");
    }
    for (const Coordinate_pair& pair : coordinate_pairs) {
      if (position(pair.x) != missing && position(pair.y) != missing) {
        check_scaling(pair.scaled);
        return {names.size(), position("id"), position(pair.x), position(pair.y), pair.scaled};
      }
    }
    m_scanner.fail("column '" + std::string(position("x") == missing ? "x" : "y") +
                   "' is missing; read are the pairs x y, xu yu, xs ys and xsu ysu");
  }

  void check_scaling(bool scaled) const
  {
    if (scaled && !m_box) {
      m_scanner.fail("scaled coordinates need ITEM: BOX BOUNDS before the atoms");
    }
    if (scaled && m_box_is_tilted) {
      m_scanner.fail("scaled coordinates in a tilted box are not supported, dump x y instead");
    }
  }

  void read_atom(const Columns& columns, Recorded_frame& frame)
  {
    std::string_view line;
    if (!m_scanner.next_line(line) || starts_with(line, "ITEM:")) {
      fail_truncated(std::to_string(*m_number_of_atoms) + " atoms expected, " +
                     std::to_string(frame.ids.size()) + " found");
    }
    split_at_blanks(line, m_fields);
    if (m_fields.size() != columns.count) {
      m_scanner.fail("the atom has " + std::to_string(m_fields.size()) + " fields, " +
                     std::to_string(columns.count) + " columns are named");
    }
    const std::int64_t id = m_scanner.integer(m_fields[columns.id], "id");
    Point point{coordinate(m_scanner, m_fields[columns.x], "x", id),
                coordinate(m_scanner, m_fields[columns.y], "y", id)};
    if (columns.scaled) {
      point = {unscaled(point.x, (*m_box)[0]), unscaled(point.y, (*m_box)[1])};
      check_finite(point, id);
    }
    frame.ids.push_back(id);
    frame.points.push_back(point);
    m_lines.push_back(m_scanner.line_number());
  }

  void check_finite(const Point& point, std::int64_t id) const
  {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
      m_scanner.fail("the scaled coordinates of id " + std::to_string(id) +
                     " and the box give no finite number");
    }
  }

  static double unscaled(double fraction, const Interval& side)
  {
    return side.low + fraction * (side.high - side.low);
  }

  void sort_by_id(Recorded_frame& frame) const
  {
    std::vector<std::size_t> order(frame.ids.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&frame](std::size_t a, std::size_t b) {
      return std::pair(frame.ids[a], a) < std::pair(frame.ids[b], b);
    });
    Recorded_frame sorted;
    sorted.time = frame.time;
    sorted.is_periodic = frame.is_periodic;
    for (std::size_t i = 0; i != order.size(); ++i) {
      if (i != 0 && frame.ids[order[i]] == frame.ids[order[i - 1]]) {
        fail_twice(frame.ids[order[i]], m_lines[order[i - 1]], m_lines[order[i]]);
      }
      sorted.ids.push_back(frame.ids[order[i]]);
      sorted.points.push_back(frame.points[order[i]]);
    }
    frame = std::move(sorted);
  }

  [[noreturn]] void fail_twice(std::int64_t id, std::size_t first, std::size_t second) const
  {
    throw Scenario_error(m_scanner.file(),
                         "id " + std::to_string(id) + " is twice in the frame of timestep " +
                             std::to_string(m_timestep) + ", first in line " +
                             std::to_string(first),
                         second);
  }

  [[noreturn]] void fail_truncated(const std::string& how) const
  {
    m_scanner.fail("the frame of timestep " + std::to_string(m_timestep) + " is truncated: " + how);
  }

  std::string_view data_line()
  {
    std::string_view line;
    if (!m_scanner.next_line(line)) {
      m_scanner.fail(m_frame_is_open ? "the frame of timestep " + std::to_string(m_timestep) +
                                           " is truncated in its head"
                                     : "the file ends in the head of a frame");
    }
    return line;
  }

  double finite(std::string_view text, std::string_view what) const
  {
    const double value = m_scanner.number(text, what);
    if (!std::isfinite(value)) {
      m_scanner.fail(std::string(what) + " " + in_quotes(text) + " is not a finite number");
    }
    return value;
  }

  static bool starts_with(std::string_view text, std::string_view start)
  {
    return text.substr(0, start.size()) == start;
  }

  Text_scanner m_scanner;
  std::vector<std::string_view> m_fields;
  std::vector<std::size_t> m_lines;
  std::int64_t m_timestep = 0;
  std::optional<double> m_time;
  std::optional<std::size_t> m_number_of_atoms;
  std::optional<std::array<Interval, 3>> m_box;
  bool m_box_is_tilted = false;
  bool m_box_is_periodic = false;
  bool m_frame_is_open = false;
};

inline Recording read_lammps_dump(const std::string& path)
{
  const std::string text = read_text_file(path);
  return Lammps_parser(path, text).parse();
}

} // namespace scenario

#endif // SCENARIO_RUNNER_RECORDED_MOTION_H
