// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PATCH_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PATCH_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// A directed edge on the boundary of a set of faces, the set on its left.
struct Boundary_edge_2
{
  Index source, target, halfedge;

  bool operator<(const Boundary_edge_2& other) const
  {
    return source != other.source ? source < other.source : target < other.target;
  }
};

// A set of faces on its own: half-edge 3k+i is opposite to vertex i of its k-th face, as in the
// mirror; the half-edges on its boundary have no twin.
struct Patch_2
{
  std::vector<Index> apexes;
  std::vector<Index> twins;
  std::vector<Boundary_edge_2> boundary; // sorted by source, then target

  Index number_of_faces() const { return Index(apexes.size() / 3); }

  void clear()
  {
    apexes.clear();
    twins.clear();
    boundary.clear();
  }

  void find_boundary()
  {
    using Mirror = Neighborhood_mirror_2;
    boundary.clear();
    for (Index h = 0; h < Index(twins.size()); ++h)
      if (twins[h] == no_index)
        boundary.push_back({apexes[Mirror::next(h)], apexes[Mirror::previous(h)], h});
    std::sort(boundary.begin(), boundary.end());
  }

  // Where the patch's faces around the source of a boundary edge end: the source of the boundary
  // edge that comes into the same vertex on the other side of that fan of faces.
  Index other_end_of_fan(const Boundary_edge_2& edge) const
  {
    using Mirror = Neighborhood_mirror_2;
    Index h = Mirror::previous(edge.halfedge);
    while (twins[h] != no_index)
      h = Mirror::previous(twins[h]);
    return apexes[Mirror::next(h)];
  }
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PATCH_2_H
