// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Csv_header.h"

#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <utility>

namespace scenario {

namespace {

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
  static constexpr std::array<std::string_view, 28> units = {
      "",    "m",  "dm",  "cm", "mm",  "um",   "\xC2\xB5m", "\xCE\xBCm", "micron", "microns",
      "nm",  "km", "ft",  "in", "inm", "incm", "px",        "au",        "pixel",  "pixels",
      "deg", "s",  "sec", "ms", "us",  "ns",   "min",       "h"};

  bool has_known_unit() const
  {
    return std::find(units.begin(), units.end(), lower_case(m_unit)) != units.end();
  }

  std::string m_name;
  std::string m_unit;
};

// The names of this package, which are those of pandas, R, PeTrack and others as well; of trackpy,
// of TrackMate, of MTrackJ's table of points, and of Viswalk. Each of the others has a name for the
// id that nobody else has.
const std::vector<Csv_dialect>& dialects()
{
  static const std::vector<Csv_dialect> all = {
      {{"frame", "time", "id", "x", "y", "z"}},
      {{"frame", "time", "particle", "x", "y", "z"}},
      {{"frame", "position_t", "track_id", "position_x", "position_y", "position_z"}, 3},
      {{"", "t", "tid", "x", "y", "z"}},
      {{"", "simsec", "$pedestrian:no", "coordcentx", "coordcenty", "coordcentz"}}};
  return all;
}

constexpr const char* const other_names =
    "FR, PersID, particle, TRACK_ID, POSITION_X, POSITION_Y, TID, t, $PEDESTRIAN:NO, SIMSEC, "
    "COORDCENTX, COORDCENTY";

// The positions of the titles that name a column; none if the column has no name.
std::vector<std::size_t> positions_of(const std::string& name,
                                      const std::vector<std::string>& titles)
{
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i != titles.size(); ++i) {
    if (!name.empty() && (Csv_title(titles[i]).names(name) || lower_case(titles[i]) == name)) {
      positions.push_back(i);
    }
  }
  return positions;
}

Csv_column column_named(const std::string& name)
{
  const auto found = std::find(csv_column_names.begin(), csv_column_names.end(), name);
  return static_cast<Csv_column>(found - csv_column_names.begin());
}

// How wide a text is in a message, where control characters are written as \x1B.
std::size_t width_in_message(const std::string& text)
{
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  return text.size() +
         3 * static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_control));
}

} // namespace

Csv_header::Csv_header(const std::string& file, std::string_view line, std::size_t line_number,
                       const std::vector<Separator>& separators, const Table_columns& columns)
  : m_file(file)
  , m_line_number(line_number)
  , m_columns(columns)
{
  for (const Separator separator : separators) {
    const Split split = split_at(separator, line);
    if (m_split.titles.empty() || is_better(split, m_split)) {
      m_split = split;
    }
  }
}

bool Csv_header::has_numbers() const
{
  double ignored{};
  return std::any_of(m_split.titles.begin(), m_split.titles.end(),
                     [&](const std::string& title) { return is_number(title, ignored); });
}

Csv_layout Csv_header::layout() const
{
  if (!m_split.problem.empty()) {
    fail("field " + std::to_string(m_split.titles.size() + 1) + " " + m_split.problem);
  }
  check_given_titles();
  Csv_layout layout{m_split.separator, m_split.titles.size()};
  for (const Csv_column column : {frame, time, id, x, y, z}) {
    layout.positions[column] = position_of(column);
  }
  if (!m_split.is_complete) {
    fail_missing();
  }
  layout.more_header_lines = m_split.dialect.more_header_lines;
  check_units(m_split.titles[layout.positions[x]], m_split.titles[layout.positions[y]]);
  if (m_split.dialect.names[id] == "tid") { // the tracks of each cluster begin at 1
    for (const char* const name : {"aid", "cid"}) {
      const auto positions = positions_of(name, m_split.titles);
      layout.constant.insert(layout.constant.end(), positions.begin(), positions.end());
    }
  }
  return layout;
}

Csv_header::Split Csv_header::split_at(Separator separator, std::string_view line) const
{
  Split split{separator};
  std::vector<std::string_view> fields;
  Field_splitter splitter(separator);
  split.problem = splitter.split(line, fields);
  split.titles.assign(fields.begin(), fields.end());
  choose_dialect(split);
  return split;
}

void Csv_header::choose_dialect(Split& split) const
{
  for (const Csv_dialect& usual : dialects()) {
    const Csv_dialect dialect = renamed(usual);
    const auto is_there = [&](const std::string& name) {
      return !positions_of(name, split.titles).empty();
    };
    const auto known = static_cast<std::size_t>(
        std::count_if(dialect.names.begin(), dialect.names.end(), is_there));
    const bool is_first = &usual == &dialects().front();
    if (is_first || (known > split.known && is_there(dialect.names[id]))) {
      split.dialect = dialect;
      split.known = known;
    }
    if (is_complete(dialect, split.titles)) {
      split.dialect = dialect;
      split.known = known;
      split.is_complete = true;
      return;
    }
  }
}

// Frames may be given by times if the program, or the person, has times alone.
bool Csv_header::is_complete(const Csv_dialect& dialect,
                             const std::vector<std::string>& titles) const
{
  const auto is_there = [&](Csv_column column) {
    return !positions_of(dialect.names[column], titles).empty();
  };
  const auto is_given = [this](const char* column) {
    return std::any_of(m_columns.by_title.begin(), m_columns.by_title.end(),
                       [column](const auto& pair) { return pair.first == column; });
  };
  const bool has_times_alone =
      dialect.names[frame].empty() || (is_given("time") && !is_given("frame"));
  return is_there(id) && is_there(x) && is_there(y) &&
         (is_there(frame) || (has_times_alone && is_there(time)));
}

bool Csv_header::is_better(const Split& split, const Split& than)
{
  if (split.separator == Separator::blanks && than.known >= 2) {
    return false;
  }
  return std::pair(split.known, split.titles.size()) > std::pair(than.known, than.titles.size());
}

// A dialect with the titles that a person has given.
Csv_dialect Csv_header::renamed(Csv_dialect dialect) const
{
  for (const auto& [column, title] : m_columns.by_title) {
    dialect.names[column_named(column)] = lower_case(title);
  }
  return dialect;
}

std::size_t Csv_header::position_of(Csv_column column) const
{
  const auto positions = positions_of(m_split.dialect.names[column], m_split.titles);
  if (positions.size() > 1) {
    fail("column '" + m_split.dialect.names[column] + "' is there twice, as " +
         in_quotes(m_split.titles[positions[0]]) + " and " +
         in_quotes(m_split.titles[positions[1]]));
  }
  return positions.empty() ? Csv_layout::none : positions.front();
}

void Csv_header::check_given_titles() const
{
  for (const auto& [column, title] : m_columns.by_title) {
    if (positions_of(lower_case(title), m_split.titles).empty()) {
      fail("there is no column " + in_quotes(title) + ", which was to be " + in_quotes(column) +
           "; the header has " + what_it_has());
    }
  }
}

void Csv_header::check_units(const std::string& x_title, const std::string& y_title) const
{
  if (Csv_title(x_title).unit() != Csv_title(y_title).unit()) {
    fail("the columns " + in_quotes(x_title) + " and " + in_quotes(y_title) +
         " have different units, allowed are equal ones");
  }
}

void Csv_header::fail_missing() const
{
  std::vector<std::string> names;
  const Csv_column order = m_split.dialect.names[frame].empty() ? time : frame;
  for (const Csv_column column : {order, id, x, y}) {
    const std::string& name = m_split.dialect.names[column];
    if (positions_of(name, m_split.titles).empty()) {
      names.push_back(in_quotes(name));
    }
  }
  std::string text = names.size() == 1 ? "column " : "columns ";
  for (std::size_t i = 0; i != names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  fail(text + (names.size() == 1 ? " is" : " are") +
       " missing, needed are frame, id, x and y; known too are " + other_names +
       "; --columns frame,id,x,y names others; the header has " + what_it_has());
}

// A description of the header, short enough for a message.
std::string Csv_header::what_it_has() const
{
  constexpr std::size_t max_width = 80;
  const auto& titles = m_split.titles;
  if (titles.size() == 1) {
    return "one column, " + in_quotes(titles.front()) +
           ", as separators are commas, semicolons, tabs or blanks";
  }
  std::string list;
  for (const std::string& title : titles) {
    if (width_in_message(list) + width_in_message(title) > max_width && !list.empty()) {
      list += ", ...";
      break;
    }
    list += (list.empty() ? "" : ", ") + in_quotes(title);
  }
  return std::to_string(titles.size()) + " columns, split at " + place_of(m_split.separator) +
         ": " + list;
}

void Csv_header::fail(const std::string& message) const
{
  throw Scenario_error(m_file, message, m_line_number);
}

Csv_layout layout_in_order(const std::string& file, std::string_view row, std::size_t line_number,
                           const Table_columns& columns)
{
  Csv_layout layout;
  for (std::size_t i = 0; i != columns.in_order.size(); ++i) {
    if (columns.in_order[i] != "-") {
      layout.positions[column_named(columns.in_order[i])] = i;
    }
  }
  std::vector<std::string_view> fields;
  for (const Separator separator :
       {Separator::comma, Separator::semicolon, Separator::tab, Separator::blanks}) {
    Field_splitter(separator).split(row, fields);
    layout.separator = separator;
    layout.number_of_fields = fields.size();
    if (fields.size() >= columns.in_order.size()) {
      constexpr std::size_t most_header_lines = 4; // as TrackMate has them
      layout.more_header_lines = most_header_lines;
      return layout;
    }
  }
  throw Scenario_error(file,
                       "the row has " + std::to_string(fields.size()) + " fields, " +
                           std::to_string(columns.in_order.size()) + " columns were named",
                       line_number);
}

std::optional<Csv_layout> layout_of_jupedsim(std::string_view row)
{
  std::vector<std::string_view> fields;
  split_at_blanks(row, fields);
  double ignored{};
  if (fields.size() < 4 || !is_number(fields[3], ignored)) {
    return std::nullopt;
  }
  Csv_layout layout{Separator::blanks, fields.size()};
  layout.positions = {1, Csv_layout::none, 0, 2, 3, Csv_layout::none};
  return layout;
}

} // namespace scenario
