# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Neighbor lists with vectors."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class NeighborList:
    """Pairs of neighbors, each in both directions, as freud names them. Sorted by the first point of a pair.

    The weight of a pair is the length of the edge that its Voronoi cells share, infinite on the hull, or in space the
    area of their facet. So it is what ``freud.locality.Voronoi`` has as ``nlist``, in the plane with vectors of two
    coordinates.
    """

    query_point_indices: NDArray[np.int32]
    """int32 (pairs,): the row of the first point"""
    point_indices: NDArray[np.int32]
    """int32 (pairs,): the row of the second point"""
    vectors: NDArray[np.float64]
    """float64 (pairs, 2), in space (pairs, 3): from the first point to the (image of the) second one, in the unit of the
    coordinates"""
    weights: NDArray[np.float64]
    """float64 (pairs,): length of the shared Voronoi edge, or in space area of the shared facet"""
    neighbor_counts: NDArray[np.int64]
    """int64 (rows,): neighbors of each row"""

    @property
    def distances(self) -> NDArray[np.float64]:
        """float64 (pairs,): lengths of the vectors"""
        distances: NDArray[np.float64] = np.hypot.reduce(self.vectors, axis=1)
        return distances

    @property
    def segments(self) -> NDArray[np.int64]:
        """int64 (rows,): where the pairs of each row begin"""
        return np.concatenate([[0], np.cumsum(self.neighbor_counts)[:-1]])

    def __len__(self) -> int:
        return len(self.point_indices)
