// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Point_file.h"

#include <algorithm>
#include <vector>

namespace run {

namespace {

// Whether other programs read a text as one word of a line.
bool is_word(const std::string& text)
{
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) > ' ' && c != '\x7F' && c != '"' && c != '\'';
  });
}

} // namespace

bool are_ids_words(const scenario::Any_motion& motion)
{
  return motion.names() && std::all_of(motion.names()->begin(), motion.names()->end(), is_word);
}

Point_file::Point_file(const std::string& path, Format format)
  : m_path(path)
  , m_file(path)
  , m_format(format)
{
}

void Point_file::name_ids(const scenario::Any_motion& motion)
{
  m_has_words = is_xyz() && are_ids_words(motion);
  if (!motion.names() || m_has_words || m_id_table) {
    return;
  }
  m_id_table.emplace(id_table_of(m_path), std::vector<std::string>{"id", "name"});
  for (std::size_t id = 0; id != motion.names()->size(); ++id) {
    m_id_table->write(id, (*motion.names())[id]);
  }
}

void Point_file::write_id(const scenario::Any_motion& motion, std::size_t place)
{
  const char* const species = is_xyz() ? " X " : " 1 "; // X is an unknown one
  stream() << (m_has_words ? motion.id_text(place) : std::to_string(motion.ids()[place]))
           << species;
}

void Point_file::finish()
{
  m_file.finish();
  if (m_id_table) {
    m_id_table->finish();
  }
}

} // namespace run
