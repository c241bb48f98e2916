# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What triangulations in the plane and in space have in common."""

from __future__ import annotations

import operator
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ._arguments import as_index
from ._core import Group
from .errors import InputIndexError


class Guarded(Protocol):
    """What the classes of C++ have for them."""

    def _arrays(self, group: Group) -> tuple[NDArray[Any], ...]: ...

    def _is_current(self, array: object) -> bool: ...

    def _has_id(self, id: int) -> bool: ...

    @property
    def is_certified(self) -> bool: ...

    @property
    def number_of_points(self) -> int: ...


class Rows:
    """Arrays with a row for each point.

    They are read-only, and are computed when they are first asked for after a change. They own their numbers: an array
    that is kept stays as it was, and ``is_current()`` says whether it still describes the triangulation.
    """

    def is_current(self: Guarded, array: NDArray[Any]) -> bool:
        """Whether an array is one of this triangulation's, and nothing has changed since it was made. Views of an
        array, such as slices, are not known: ask for the array itself."""
        return self._is_current(array)

    @property
    def ids(self: Guarded) -> NDArray[np.int64]:
        """int64 (n,): the ids of all points; those that the user chose in the order of the rows, others ascending."""
        return self._arrays(Group.IDS)[0]

    @property
    def duplicates(self: Guarded) -> NDArray[np.int32]:
        """int32 (m, 2): rows of points that coincide with another one, and of that one, which represents them. Only
        the other one is in edges, triangles and simplices."""
        return self._arrays(Group.DUPLICATES)[0]

    @property
    def edges(self: Guarded) -> NDArray[np.int32]:
        """int32 (edges, 2): rows of both ends of each edge."""
        return self._arrays(Group.EDGES)[0]

    @property
    def indptr(self: Guarded) -> NDArray[np.int32]:
        """int32 (rows + 1,): where the neighbors of each row begin in ``indices``, as in SciPy's CSR matrices."""
        return self._arrays(Group.NEIGHBOR_LISTS)[0]

    @property
    def indices(self: Guarded) -> NDArray[np.int32]:
        """int32 (pairs,): the neighbors of all rows; of each in the plane counterclockwise, in space ascending."""
        return self._arrays(Group.NEIGHBOR_LISTS)[1]

    def neighbors_of(self: Guarded, row: int) -> NDArray[np.int32]:
        """int32 (k,): the rows of the neighbors of one row; in the plane counterclockwise, in space ascending."""
        indptr, indices = self._arrays(Group.NEIGHBOR_LISTS)[:2]
        row = as_index("the row", row)
        if not 0 <= row < len(indptr) - 1:
            raise InputIndexError(f"there is no row {row}: they are from 0 to before {len(indptr) - 1}")
        neighbors: NDArray[np.int32] = indices[indptr[row] : indptr[row + 1]]
        return neighbors

    def __len__(self: Guarded) -> int:
        return self.number_of_points

    def __contains__(self: Guarded, id: object) -> bool:
        try:
            integer = operator.index(id)  # type: ignore[arg-type]
        except TypeError:
            return False
        return -(2**63) <= integer < 2**63 and self._has_id(integer)

    def __repr__(self: Guarded) -> str:
        certified = "certified" if self.is_certified else "not certified"
        return f"<{type(self).__name__} of {self.number_of_points} points, {certified}>"


class ScipyNames:
    """Names that ``scipy.spatial.Delaunay`` has."""

    @property
    def npoints(self: Guarded) -> int:
        """The number of rows, as SciPy calls it."""
        return len(self._arrays(Group.POINTS)[0])

    @property
    def vertex_neighbor_vertices(self: Guarded) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """``indptr`` and ``indices``, by the name that SciPy has for them."""
        indptr, indices = self._arrays(Group.NEIGHBOR_LISTS)[:2]
        return indptr, indices
