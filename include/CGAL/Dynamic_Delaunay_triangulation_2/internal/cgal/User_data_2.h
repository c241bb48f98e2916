// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_USER_DATA_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_USER_DATA_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A property: one value for each vertex, or for each face.
class Property_base_2
{
public:
  using Pointer = std::unique_ptr<Property_base_2>;

  explicit Property_base_2(std::string name)
    : m_name(std::move(name))
  {
  }
  virtual ~Property_base_2() = default;
  const std::string& name() const { return m_name; }

  virtual Pointer clone() const = 0;
  // Returns a property with the values of these elements, where `null_index` is a new one.
  virtual Pointer values_of(const std::vector<Index>& elements) const = 0;
  // Exchanges the values with a property of the same type. Pointers to both stay valid.
  virtual void swap_values(Property_base_2& other) noexcept = 0;
  virtual void grow(std::size_t number) = 0;
  virtual void shrink(std::size_t number) noexcept = 0;
  virtual void copy(Index from, Index to) = 0;
  virtual void move(Index from, Index to) = 0;

private:
  std::string m_name;
};

// The value of a new element: always the same one, or one of its own, made by default.
template <class T>
struct Same_value_2
{
  const T& operator()() const { return value; }
  T value;
};
template <class T>
struct Own_value_2
{
  T operator()() const { return T(); }
};

template <class T, class Value_of_new = Same_value_2<T>>
class Property_2 : public Property_base_2
{
public:
  using reference = typename std::vector<T>::reference;

  explicit Property_2(std::string name = std::string(), const Value_of_new& value_of_new = {})
    : Property_base_2(std::move(name))
    , m_value_of_new(value_of_new)
  {
  }
  reference operator[](Index i) { return m_values[i]; }

  Pointer clone() const override { return std::make_unique<Property_2>(*this); }
  Pointer values_of(const std::vector<Index>& elements) const override
  {
    auto result = std::make_unique<Property_2>(name(), m_value_of_new);
    result->grow(elements.size());
    for (Index i = 0; i < Index(elements.size()); ++i)
      if (elements[i] != null_index)
        result->m_values[i] = m_values[elements[i]];
    return result;
  }
  void swap_values(Property_base_2& other) noexcept override
  {
    m_values.swap(static_cast<Property_2&>(other).m_values);
  }
  void grow(std::size_t number) override
  {
    while (m_values.size() < number)
      m_values.push_back(m_value_of_new());
  }
  void shrink(std::size_t number) noexcept override
  {
    m_values.erase(m_values.begin() + std::ptrdiff_t(number), m_values.end());
  }
  void copy(Index from, Index to) override
  {
    if (from == null_index)
      m_values[to] = m_value_of_new();
    else
      m_values[to] = m_values[from];
  }
  void move(Index from, Index to) override { m_values[to] = std::move(m_values[from]); }

private:
  std::vector<T> m_values;
  Value_of_new m_value_of_new;
};

// A property map from handles to values, which the storage owns.
template <class Handle, class T>
class Indexed_property_map_2
{
public:
  using key_type = Handle;
  using value_type = T;
  using reference = typename Property_2<T>::reference;
  using category = boost::lvalue_property_map_tag;

  explicit Indexed_property_map_2(Property_2<T>* property = nullptr)
    : m_property(property)
  {
  }

  reference operator[](const Handle& h) const { return (*m_property)[h.index()]; }

  friend reference get(const Indexed_property_map_2& map, const Handle& h) { return map[h]; }
  friend void put(const Indexed_property_map_2& map, const Handle& h, const T& value)
  {
    map[h] = value;
  }

private:
  Property_2<T>* m_property;
};

// All that users keep at vertices or faces: properties, and the values of `info()`, if there are.
template <class Handle, class Info>
class User_data_2
{
  static_assert(!std::is_same_v<Info, bool>, "take char: there are no references to single bits");
  static constexpr bool has_infos = !std::is_void_v<Info>;

public:
  using Values = std::vector<Property_base_2::Pointer>;

  User_data_2() = default;
  User_data_2(const User_data_2& other)
    : m_infos(other.m_infos)
    , m_size(other.m_size)
  {
    for (const auto& property : other.m_properties)
      m_properties.push_back(property->clone());
  }
  User_data_2& operator=(const User_data_2&) = delete;

  auto& info(Index i) { return m_infos[i]; }
  bool empty() const { return !has_infos && m_properties.empty(); }

  // Returns the property with this name, and whether it is new. A new one has `value` everywhere.
  template <class T>
  std::pair<Indexed_property_map_2<Handle, T>, bool> add(const std::string& name, const T& value)
  {
    using Map = Indexed_property_map_2<Handle, T>;
    for (const auto& property : m_properties)
      if (auto* const found = dynamic_cast<Property_2<T>*>(property.get()))
        if (found->name() == name)
          return {Map(found), false};
    auto added = std::make_unique<Property_2<T>>(name, Same_value_2<T>{value});
    added->grow(m_size);
    const Map map(added.get());
    m_properties.push_back(std::move(added));
    return {map, true};
  }

  // Makes the values of elements up to this number, behind the present ones. Then resize() throws
  // nothing. It never throws where the number gets smaller.
  void reserve(std::size_t number) { for_each(&Property_base_2::grow, number); }
  void resize(std::size_t number)
  {
    if (number < m_size)
      for_each(&Property_base_2::shrink, number);
    else
      reserve(number);
    m_size = number;
  }

  // Copies the values of element `from` to element `to`; those of a new one from `null_index`.
  void copy(Index from, Index to) { for_each(&Property_base_2::copy, from, to); }
  void reset(Index i) { copy(null_index, i); }
  void move_last_to(Index i)
  {
    const Index last = Index(m_size) - 1;
    if (i != last)
      for_each(&Property_base_2::move, last, i);
    resize(last);
  }

  // Returns the values for renumber(): the element with number i had the number before[i], or is
  // new if that is `null_index`.
  template <class Number>
  Values prepare(const std::vector<Number>& before)
  {
    Values values;
    if (empty())
      return values;
    const std::vector<Index> elements(before.begin(), before.end());
    for_each([&](Property_base_2& p) { values.push_back(p.values_of(elements)); });
    return values;
  }
  template <class Number>
  void renumber(const Values& values, const std::vector<Number>& before) noexcept
  {
    auto next = values.begin();
    for_each([&](Property_base_2& p) { p.swap_values(**next++); });
    m_size = before.size();
  }
  void swap(User_data_2& other) noexcept
  {
    if constexpr (has_infos)
      m_infos.swap_values(other.m_infos);
    m_properties.swap(other.m_properties);
    std::swap(m_size, other.m_size);
  }

private:
  struct Nothing
  {
  };

  // Calls f(property, arguments...) for all properties.
  template <class Function, class... Arguments>
  void for_each(const Function& f, Arguments... arguments)
  {
    if constexpr (has_infos)
      std::invoke(f, m_infos, arguments...);
    for (const auto& property : m_properties)
      std::invoke(f, *property, arguments...);
  }

  std::conditional_t<has_infos, Property_2<Info, Own_value_2<Info>>, Nothing> m_infos;
  Values m_properties;
  std::size_t m_size = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_USER_DATA_2_H
