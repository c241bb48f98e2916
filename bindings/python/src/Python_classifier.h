// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_PYTHON_CLASSIFIER_H
#define PYTHON_PYTHON_CLASSIFIER_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace python {

// What a classifier in Python can ask for: copies, so that it may keep them.
struct Frame_copies
{
  std::function<std::vector<double>()> positions, previous_positions, corners;
  std::function<std::vector<std::int32_t>()> edges, ids, new_edges;
  bool everything_is_new;
};

// What it answers with.
struct Named
{
  std::vector<std::int64_t> vertices, edges;
};

// A callable of Python, behind an interface that knows nothing of Python. The implementation takes
// the interpreter's lock.
class Python_function
{
public:
  Python_function() = default;
  Python_function(const Python_function&) = delete;
  Python_function& operator=(const Python_function&) = delete;
  virtual ~Python_function() = default;

  virtual Named classify(const Frame_copies& frame) const = 0;
  virtual void after_update(const Frame_copies& frame) const = 0;
};

// A model of `DelaunayClassifier_2` that asks Python.
class Python_classifier
{
public:
  static constexpr bool is_exact = false;

  Python_classifier() = default;
  explicit Python_classifier(std::shared_ptr<const Python_function> function)
    : m_function(std::move(function))
  {
  }

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified) const
  {
    const Named named = m_function->classify(copies_of(frame, true));
    for (const std::int64_t v : named.vertices) {
      classified.add_vertex(index<typename Frame::Vertex_index>(
          v, "vertex", frame.number_of_vertices() + std::int64_t(1)));
    }
    for (const std::int64_t e : named.edges) {
      classified.add_edge(
          index<typename Frame::Edge_index>(e, "edge", frame.number_of_edges()));
    }
  }

  template <class Frame>
  void after_update(const Frame& frame) const
  {
    m_function->after_update(copies_of(frame, false));
  }

private:
  // Numbers of 64 bits could name something else in 32 bits.
  template <class Index>
  static Index index(std::int64_t number, const std::string& what, std::int64_t bound)
  {
    if (number < 0 || number >= bound) {
      throw std::out_of_range("the classifier named " + what + ' ' + std::to_string(number) +
                              ": allowed are numbers from 0 to " + std::to_string(bound - 1));
    }
    return Index(number);
  }

  template <class Position>
  static void append(std::vector<double>& numbers, const Position& p)
  {
    numbers.insert(numbers.end(), {p.x, p.y});
  }

  template <class Frame>
  static Frame_copies copies_of(const Frame& frame, bool is_classifying)
  {
    using Edge_index = typename Frame::Edge_index;
    using Vertex_index = typename Frame::Vertex_index;
    const auto positions = [frame](const auto& position_of) {
      std::vector<double> numbers;
      numbers.reserve(2 * (frame.number_of_vertices() + std::size_t(1)));
      append(numbers, frame.position(Vertex_index(0)));
      for (Vertex_index v(1); v <= frame.number_of_vertices(); ++v) {
        append(numbers, position_of(v));
      }
      return numbers;
    };
    Frame_copies copies;
    copies.positions = [=] {
      return positions([&](Vertex_index v) { return frame.position(v); });
    };
    copies.previous_positions = [=] {
      if (!is_classifying) {
        throw std::invalid_argument("previous positions are there only while classifying");
      }
      return positions([&](Vertex_index v) { return frame.previous_position(v); });
    };
    copies.edges = [=] {
      std::vector<std::int32_t> vertices;
      vertices.reserve(4 * std::size_t(frame.number_of_edges()));
      for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
        const auto edge = frame.edge(e);
        for (const Vertex_index v : {edge.source, edge.target, edge.left, edge.right}) {
          vertices.push_back(std::int32_t(v));
        }
      }
      return vertices;
    };
    copies.corners = [=] {
      std::vector<double> numbers;
      numbers.reserve(8 * std::size_t(frame.number_of_edges()));
      for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
        const auto corners = frame.corners(e);
        for (const auto& p : {corners.source, corners.target, corners.left, corners.right}) {
          append(numbers, p);
        }
      }
      return numbers;
    };
    copies.ids = [=] {
      std::vector<std::int32_t> ids{-1};
      for (Vertex_index v(1); v <= frame.number_of_vertices(); ++v) {
        ids.push_back(std::int32_t(frame.id(v)));
      }
      return ids;
    };
    copies.new_edges = [=] {
      return std::vector<std::int32_t>(frame.new_edges().begin(), frame.new_edges().end());
    };
    copies.everything_is_new = frame.everything_is_new();
    return copies;
  }

  std::shared_ptr<const Python_function> m_function;
};

} // namespace python

#endif // PYTHON_PYTHON_CLASSIFIER_H
