// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_JSON_OBJECT_READER_H
#define SCENARIO_JSON_OBJECT_READER_H

#include "Scenario_error.h"
#include "Text_scanner.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenario {

inline std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

// Positive_range leaves its lower bound 0 out.
struct Range
{
  double low;
  double high;
  bool low_is_allowed = true;

  bool contains(double value) const
  {
    return (low_is_allowed ? value >= low : value > low) && value <= high;
  }

  std::string text() const
  {
    std::ostringstream stream;
    stream << (low_is_allowed ? "from " : "above ") << low << " to " << high;
    return stream.str();
  }
};

inline Range positive_up_to(double high)
{
  return {0.0, high, false};
}

// Reads the members of one JSON object and refuses everything it was not told to expect.
class Json_object_reader
{
public:
  using Json = nlohmann::json;

  // `where` is the path of keys to the object, "" for the outermost.
  Json_object_reader(const Json& object, std::string file, std::string where)
    : m_object(object)
    , m_file(std::move(file))
    , m_where(std::move(where))
  {
    if (!object.is_object()) {
      fail(m_where.empty()
               ? "the scenario is " + kind_of(object) + ", expected an object"
               : "key '" + m_where + "' is " + kind_of(object) + ", expected an object");
    }
  }

  void allow_only(const std::vector<std::string>& keys) const
  {
    for (const auto& member : m_object.items()) {
      if (std::find(keys.begin(), keys.end(), member.key()) == keys.end()) {
        fail("unknown key " + in_quotes(path(member.key())) + ", allowed are " + joined(keys));
      }
    }
  }

  bool has(const std::string& key) const { return m_object.contains(key); }

  double number(const std::string& key, const Range& range) const
  {
    return number_in(required(key), path(key), range);
  }

  std::uint64_t integer(const std::string& key, std::uint64_t low, std::uint64_t high) const
  {
    const Json& value = required(key);
    if (!value.is_number_integer()) {
      fail_type(value, path(key), "an integer");
    }
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() < low ||
        value.get<std::uint64_t>() > high) {
      fail_range(value, path(key), "from " + std::to_string(low) + " to " + std::to_string(high));
    }
    return value.get<std::uint64_t>();
  }

  bool boolean(const std::string& key) const
  {
    const Json& value = required(key);
    if (!value.is_boolean()) {
      fail_type(value, path(key), "true or false");
    }
    return value.get<bool>();
  }

  std::string word(const std::string& key) const
  {
    const Json& value = required(key);
    if (!value.is_string()) {
      fail_type(value, path(key), "a string");
    }
    if (value.get<std::string>().empty()) {
      fail("key '" + path(key) + "' is an empty string");
    }
    return value.get<std::string>();
  }

  std::string choice(const std::string& key, const std::vector<std::string>& choices) const
  {
    const std::string chosen = word(key);
    if (std::find(choices.begin(), choices.end(), chosen) == choices.end()) {
      fail("key '" + path(key) + "' is " + in_quotes(chosen) + ", allowed are " + joined(choices));
    }
    return chosen;
  }

  std::pair<double, double> pair(const std::string& key, const Range& range) const
  {
    const Json& value = required(key);
    if (!value.is_array() || value.size() != 2) {
      fail_type(value, path(key), "an array of two numbers");
    }
    return {number_in(value[0], path(key) + "[0]", range),
            number_in(value[1], path(key) + "[1]", range)};
  }

  std::vector<Json_object_reader> objects(const std::string& key) const
  {
    const Json& value = required(key);
    if (!value.is_array() || value.empty()) {
      fail_type(value, path(key), "an array of at least one object");
    }
    std::vector<Json_object_reader> readers;
    for (std::size_t i = 0; i != value.size(); ++i) {
      readers.emplace_back(value[i], m_file, path(key) + "[" + std::to_string(i) + "]");
    }
    return readers;
  }

  std::string path(const std::string& key) const
  {
    return m_where.empty() ? key : m_where + "." + key;
  }

  const std::string& where() const { return m_where; }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw Scenario_error(m_file, message);
  }

private:
  const Json& required(const std::string& key) const
  {
    if (!has(key)) {
      fail("key '" + path(key) + "' is missing");
    }
    return m_object[key];
  }

  double number_in(const Json& value, const std::string& name, const Range& range) const
  {
    if (!value.is_number()) {
      fail_type(value, name, "a number");
    }
    if (!range.contains(value.get<double>())) {
      fail_range(value, name, range.text());
    }
    return value.get<double>();
  }

  static std::string kind_of(const Json& value)
  {
    return (value.is_array() || value.is_object() ? "an " : "a ") + std::string(value.type_name());
  }

  // Quotes foreign text, so it has to survive bytes that are no UTF-8, and stay short.
  static std::string shown(const Json& value)
  {
    const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() > 40 ? text.substr(0, 40) + "..." : text;
  }

  [[noreturn]] void fail_type(const Json& value, const std::string& name, const char* wanted) const
  {
    fail("key '" + name + "' is " + shown(value) + ", expected " + wanted);
  }

  [[noreturn]] void fail_range(const Json& value, const std::string& name,
                               const std::string& allowed) const
  {
    fail("key '" + name + "' is " + shown(value) + ", allowed are values " + allowed);
  }

  const Json& m_object;
  std::string m_file;
  std::string m_where;
};

// The parser alone would silently take the last of several members with the same key, and values in
// values without end, which overflow the stack of whoever walks through them.
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

[[noreturn]] inline void fail_broken_json(const std::string& file, const std::string& text,
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
inline std::string number_in_quotes(std::string_view message)
{
  const std::size_t begin = (std::min)(message.find('\''), message.size() - 1) + 1;
  return in_quotes(message.substr(begin, message.rfind('\'') - begin));
}

inline nlohmann::json parse_json(const std::string& file, const std::string& text)
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

#endif // SCENARIO_JSON_OBJECT_READER_H
