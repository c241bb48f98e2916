// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_SUBJECT_H
#define RANDOM_OPERATIONS_SUBJECT_H

#include "Cloud.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace random_operations {

// The name of a point: its id, or what the user of a population calls it.
using Key = Id;
using Keys = std::vector<Key>;
using Model = std::map<Key, Place>; // where each point has to be
using Entries = std::vector<std::pair<Key, Place>>;

enum class Operation {
  START,
  INSERT,
  INSERT_RANGE,
  REMOVE,
  REMOVE_RANGE,
  MOVE,
  UPDATE,
  MEND,
  CERTIFY,
  HAND_OVER,
  MISUSE
};

inline constexpr std::array<const char*, 11> operation_names = {
    "start",  "insert", "insert_range", "remove",    "remove_range", "move",
    "update", "mend",   "certify",      "hand_over", "misuse"};

inline bool is_insertion(Operation operation)
{
  return operation == Operation::INSERT || operation == Operation::INSERT_RANGE;
}

inline bool is_removal(Operation operation)
{
  return operation == Operation::REMOVE || operation == Operation::REMOVE_RANGE;
}

// Ways to call a triangulation that it has to refuse.
enum class Misuse { NAN_COORDINATE, INFINITE_COORDINATE, WRONG_COUNT, UNKNOWN_ID, REPEATED_ID };

// One public call that changes something, or has to be refused.
struct Call
{
  // Places of points to be removed are ignored. START, UPDATE and MISUSE name all points; the keys
  // of an insertion are ignored where the subject names the points itself.
  Operation operation;
  Entries points{};
  Misuse misuse{};
};

struct Answer
{
  std::optional<CGAL::Update_report_2> report{};
  Keys keys{};        // of those who were inserted
  bool is_yes = true; // what certify() said, or whether a misuse was refused
};

// Names that a user may give.
struct Key_range
{
  Key lowest = 0, highest = -1;

  bool is_empty() const { return highest < lowest; }
};

// The triangulation of a trial, whatever its kernel and classifier are, by itself or in a
// population.
class Subject
{
public:
  Subject() = default;
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;
  virtual ~Subject() = default;

  // The allowed names; empty where the subject names the points itself.
  virtual Key_range names() const = 0;

  // START puts a fresh triangulation in place of the old one, HAND_OVER moves it to another object.
  // Where the user names the points an UPDATE may have any, else the same ones.
  virtual Answer answer(const Call& call) = 0;

  virtual bool is_certified() const = 0;

  // The degree of the point's vertex, the infinite neighbor included; 0 if there are no faces.
  virtual std::size_t number_of_neighbors(Key key) const = 0;
  virtual bool is_at_hull(Key key) const = 0;

  // Throws a Finding unless everything is as it has to be.
  virtual void check(const Model& points) = 0;
};

enum class Fault {
  WRONG,  // not Delaunay, or not what it claims to be
  LOST,   // a point, an id or a vertex is not where it has to be
  CRASHED // an exception that was not asked for
};

class Finding : public std::runtime_error
{
public:
  Finding(Fault fault, const std::string& what)
    : std::runtime_error(what)
    , m_fault(fault)
  {
  }

  Fault fault() const { return m_fault; }

private:
  Fault m_fault;
};

inline void require(bool is_true, Fault fault, const char* what)
{
  if (!is_true) {
    throw Finding(fault, what);
  }
}

} // namespace random_operations

#endif // RANDOM_OPERATIONS_SUBJECT_H
