// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Json_text.h"

#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace scenario {

namespace {

// The parser alone would silently take the last of several members with the same key, and would
// accept any depth of nesting, which overflows the stack of functions that walk through values.
class Structure_check
{
public:
  using Json = nlohmann::json;

  explicit Structure_check(std::string file)
    : m_file(std::move(file))
  {
  }

  bool operator()(int depth, Json::parse_event_t event, Json& value)
  {
    const bool goes_deeper =
        event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
    if (goes_deeper && depth >= deepest) {
      throw Scenario_error(m_file, "is nested too deeply, allowed are " + std::to_string(deepest) +
                                       " levels");
    }
    if (event == Json::parse_event_t::object_start) {
      m_keys.emplace_back();
    } else if (event == Json::parse_event_t::object_end) {
      m_keys.pop_back();
    } else if (event == Json::parse_event_t::key &&
               !m_keys.back().insert(value.get<std::string>()).second) {
      throw Scenario_error(m_file, "key " + in_quotes(value.get<std::string>()) +
                                       " is twice in one object");
    }
    return true;
  }

private:
  static constexpr int deepest = 16;

  std::string m_file;
  std::vector<std::set<std::string>> m_keys;
};

[[noreturn]] void fail_broken_json(const std::string& file, const std::string& text,
                                   std::size_t byte)
{
  const std::size_t offset = (std::min)(byte == 0 ? 0 : byte - 1, text.size());
  const std::string before = text.substr(0, offset);
  const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t line_start = before.rfind('\n');
  const std::size_t column = line_start == std::string::npos ? offset + 1 : offset - line_start;
  const std::string found = offset == text.size() ? "the file ends too early"
                                                  : "unexpected '" + text.substr(offset, 1) + "'";
  throw Scenario_error(file, "is not valid JSON: " + found, line, column);
}

// The parser's own message has the number in single quotes, however long it is.
std::string number_in_quotes(std::string_view message)
{
  const std::size_t begin = (std::min)(message.find('\''), message.size() - 1) + 1;
  return in_quotes(message.substr(begin, message.rfind('\'') - begin));
}

} // namespace

nlohmann::json parse_json(const std::string& file, const std::string& text)
{
  try {
    return nlohmann::json::parse(text, Structure_check(file));
  } catch (const nlohmann::json::parse_error& error) {
    fail_broken_json(file, text, error.byte);
  } catch (const nlohmann::json::out_of_range& error) {
    throw Scenario_error(file, "holds the number " + number_in_quotes(error.what()) +
                                   " that is out of range, allowed are values up to 1.8e308");
  }
}

} // namespace scenario
