// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_JSON_OBJECT_READER_H
#define SCENARIO_RUNNER_JSON_OBJECT_READER_H

#include "scenario_runner/Text_input.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace scenario {

// The range of lengths, masses and stiffnesses. Beyond it quotients could overflow.
constexpr Range magnitude{1e-6, 1e6};

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

  // A number of things, at least one.
  std::size_t count(const std::string& key, std::size_t high) const
  {
    return static_cast<std::size_t>(integer(key, 1, high));
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
    const auto [first, second] = numbers<2>(key, range, "an array of two numbers");
    return {first, second};
  }
  std::array<double, 3> triple(const std::string& key, const Range& range) const
  {
    return numbers<3>(key, range, "an array of three numbers");
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

  template <std::size_t size>
  std::array<double, size> numbers(const std::string& key, const Range& range,
                                   const char* wanted) const
  {
    const Json& value = required(key);
    if (!value.is_array() || value.size() != size) {
      fail_type(value, path(key), wanted);
    }
    std::array<double, size> numbers{};
    for (std::size_t i = 0; i != size; ++i) {
      numbers[i] = number_in(value[i], path(key) + "[" + std::to_string(i) + "]", range);
    }
    return numbers;
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

} // namespace scenario

#endif // SCENARIO_RUNNER_JSON_OBJECT_READER_H
