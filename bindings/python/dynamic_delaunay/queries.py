# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What queries of many query points return: nearest points, points within a radius, weights; and alpha shapes."""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import InputTypeError, InputValueError


class NearestPoints(NamedTuple):
    """The nearest point of each query point. In periodic space it is an image: the point, moved by a shift."""

    rows: NDArray[np.int32]
    """int32 (m,): the row of the nearest point, the smallest one of several that are equally near; -1 if there are
    no points"""
    distances: NDArray[np.float64]
    """float64 (m,): how far it is; infinite if there are no points"""
    shifts: NDArray[np.int32]
    """int32 (m, 2), in space (m, 3): the shift of its image, relative to the query point as it is given; 0 where space
    is not periodic"""


class PointsWithin(NamedTuple):
    """The points within a radius of each query point, one list after the other, as in SciPy's CSR matrices:
    ``scipy.sparse.csr_array((found.distances, found.indices, found.indptr), found.shape)``. Those of query point ``i``
    are the entries from ``indptr[i]`` to before ``indptr[i + 1]``, by ascending rows."""

    indptr: NDArray[np.int32]
    """int32 (m + 1,): where the list of each query point begins"""
    indices: NDArray[np.int32]
    """int32 (found,): the rows of the points"""
    distances: NDArray[np.float64]
    """float64 (found,): how far they are"""
    shifts: NDArray[np.int32]
    """int32 (found, 2), in space (found, 3): the shifts of their images, relative to the query point as it is given; 0
    where space is not periodic"""
    shape: tuple[int, int]
    """the numbers of query points and of rows"""


class InterpolationWeights(NamedTuple):
    """Weights by which values at the points are interpolated at query points, one list after the other:
    ``scipy.sparse.csr_array((weights.weights, weights.indices, weights.indptr), weights.shape)`` is the matrix. In
    periodic space a point has an entry for each of its images.

    The weights of a query point are from 0 to 1, add up to 1, and reproduce linear functions. One outside of all
    triangles has none."""

    indptr: NDArray[np.int32]
    """int32 (m + 1,): where the list of each query point begins"""
    indices: NDArray[np.int32]
    """int32 (k,): the rows of the points, ascending in each list"""
    weights: NDArray[np.float64]
    """float64 (k,): their weights, off by 1e-12 at most"""
    shifts: NDArray[np.int32]
    """int32 (k, 2): the shifts of their images, relative to the query point as it is given; 0 in the plane"""
    shape: tuple[int, int]
    """the numbers of query points and of rows"""

    def interpolate(self, values: ArrayLike) -> NDArray[np.float64]:
        """float64 (m,) for values (rows,), float64 (m, k) for values (rows, k): the weighted sums; NaN for
        query points without weights."""
        try:
            array = np.asarray(values, dtype=np.float64)
        except TypeError as error:
            raise InputTypeError(f"values must be real numbers: {error}") from None
        except ValueError as error:
            raise InputValueError(f"values must be real numbers: {error}") from None
        if array.ndim == 0 or len(array) != self.shape[1]:
            raise InputValueError(f"values have the shape {array.shape}: it must begin with {self.shape[1]}, the rows")
        counts = np.diff(self.indptr)
        sums = np.full((len(counts), *array.shape[1:]), np.nan)
        sums[counts > 0] = 0
        terms = (array[self.indices].T * self.weights).T
        np.add.at(sums, np.repeat(np.arange(len(counts)), counts), terms)
        return sums


class AlphaClass(IntEnum):
    """What an element of a triangulation is to an alpha shape."""

    EXTERIOR = 0
    """not in the alpha complex"""
    SINGULAR = 1
    """in the complex, in the boundary of the shape, but at no triangle of the complex"""
    REGULAR = 2
    """in the boundary of the shape, and at a triangle of the complex"""
    INTERIOR = 3
    """in the complex, and not in the boundary"""


class AlphaShape(NamedTuple):
    """The ``AlphaClass`` of each point, edge and triangle, in the order of these arrays of the triangulation. So
    ``edges[shape.edges == AlphaClass.REGULAR]`` is the boundary of the shape's area."""

    points: NDArray[np.int32]
    """int32 (rows,): of each point; EXTERIOR for removed ids"""
    edges: NDArray[np.int32]
    """int32 (edges,): of each of the ``edges``"""
    triangles: NDArray[np.int32]
    """int32 (triangles,): of each of the ``triangles``: INTERIOR or EXTERIOR"""
