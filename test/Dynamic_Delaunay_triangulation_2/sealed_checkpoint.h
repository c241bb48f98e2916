// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checkpoints that somebody has changed, with the right checksum: else nothing would get past that.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SEALED_CHECKPOINT_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SEALED_CHECKPOINT_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>

#include <sstream>
#include <string>

// The checkpoint of a triangulation or a population.
template <class Subject>
std::string checkpoint_of(const Subject& subject)
{
  std::ostringstream out;
  subject.write_checkpoint(out);
  return out.str();
}

// These lines, and that of their checksum.
inline std::string sealed(const std::string& lines)
{
  CGAL::Dynamic_Delaunay_triangulations_2::internal::Checkpoint_sum_2 sum;
  sum.add(lines);
  return lines + "checksum " + sum.text() + '\n';
}

// What the file would be if its lines were meant.
inline std::string resealed(const std::string& text)
{
  return sealed(text.substr(0, text.rfind("checksum ")));
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SEALED_CHECKPOINT_H
