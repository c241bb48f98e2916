// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <array>
#include <deque>
#include <initializer_list>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace scenario {

namespace {

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

// What separates the fields of a line. Blanks are spaces and tabs, any number of them.
enum class Separator : char { comma = ',', semicolon = ';', tab = '\t', blanks = ' ' };

// How messages call the separators of a line.
std::string place_of(Separator separator)
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

// Splits a line into fields. A field that begins with a double quote ends with the next single
// one, and may contain separators; two double quotes in it stand for one. Blanks around the content
// of fields are not part of it, quoted or not.
class Field_splitter
{
public:
  explicit Field_splitter(Separator separator)
    : m_separator(separator)
  {
  }

  Separator separator() const { return m_separator; }

  // Returns what is wrong with the field that follows those in `fields`, or an empty text if all is
  // well. Fields refer to the line; those with doubled quotes are valid until the next call.
  std::string_view split(std::string_view line, std::vector<std::string_view>& fields)
  {
    fields.clear();
    m_unescaped.clear();
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

private:
  // Both functions remove the field from the line, which then begins with the next separator.
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

  // The place of the next separator, or the end of the line.
  std::size_t separator_in(std::string_view line) const
  {
    const std::size_t place = m_separator == Separator::blanks
                                  ? line.find_first_of(" \t\r")
                                  : line.find(static_cast<char>(m_separator));
    return (std::min)(place, line.size());
  }

  // Removes a separator. True if there was one and a field follows it.
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

  // Where tabs separate fields they are not blanks.
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

// The title of a column: `x`, or `X/m`, `x [m]`, `x (m)`. A title that goes on in another way, as
// the quotient `x/y`, does not name the column `x`.
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
  // Names of columns in files of PeTrack and JuPedSim.
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
  // `separators`: the possible ones, the preferred ones first. Blanks, at which any text can be
  // split, are chosen only if no other separator finds two columns.
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

  // Whether the line can be a header.
  bool names_any_column() const { return m_split.known != 0; }
  bool has_numbers() const
  {
    double ignored{};
    return std::any_of(m_split.titles.begin(), m_split.titles.end(),
                       [&](const std::string& title) { return is_number(title, ignored); });
  }

  // The position of each column in a row; `none` for `time` if there is no such column.
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

  // A description of the header, short enough for a message.
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

  // The header in the last comment. Tabs between its words count as blanks, however rows are split.
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

  // Skips the column of row names that R writes, in quotes and without a title.
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

  // To be called at the first id that is text: all ids, also numbers, are then names.
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
    return m_scanner.coordinate(text, name, id_text(id));
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

} // namespace

Recording parse_csv(const std::string& file, std::string_view text)
{
  return Csv_parser(file, text).parse();
}

} // namespace scenario
