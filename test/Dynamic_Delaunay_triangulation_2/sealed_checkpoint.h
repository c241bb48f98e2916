// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Changed checkpoints with the right checksum: otherwise readers would refuse all for the checksum.

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

// The lines, followed by the line of their checksum.
inline std::string sealed(const std::string& lines)
{
  CGAL::Dynamic_Delaunay_triangulations_2::internal::Checkpoint_sum_2 sum;
  sum.add(lines);
  return lines + "checksum " + sum.text() + '\n';
}

// A changed file with the checksum of its lines in place of the old one.
inline std::string resealed(const std::string& text)
{
  return sealed(text.substr(0, text.rfind("checksum ")));
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SEALED_CHECKPOINT_H
